// How shots of a study come to what they meet first: its figures are quantities of the study.
#pragma once

#include <limits>
#include <vector>

#include "model/body.hpp"
#include "model/conditions.hpp"
#include "physim/study.hpp"

namespace physim {

/// As the surface sees it.
struct ShotImpact {
  double speed;      // [m/s]
  double obliquity;  // between the velocity and the inward normal; 0 straight on [rad]
  double energy;     // kinetic [J]
};
/// A shot that meets nothing.
inline constexpr ShotImpact kNoImpact = {std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::quiet_NaN()};

[[nodiscard]] double part_of(const ShotImpact& impact, StudyQuantity quantity);

/// The mass of a projectile over its flight.
class MassInFlight {
 public:
  MassInFlight(const ProjectileDef& projectile, const Fidelity& granted);
  [[nodiscard]] double at(double time) const;

 private:
  double mass_;
  std::vector<Burn<double>> pieces_{};  // of the motor; none: it burns nothing
};

/// Finds impacts over an Earth and among things.
class Impacts {
 public:
  Impacts(const Study& study, const Fidelity& granted);

  /// On the ground, which stands still in W.
  [[nodiscard]] ShotImpact on_ground(const Vec3d& place, const Vec3d& velocity, double mass) const;
  /// The first of a flight: on a thing that it hits, else on the ground; kNoImpact where it meets nothing.
  [[nodiscard]] ShotImpact first_of(const Flight& flight) const;

 private:
  Conditions<double> earth_;  // its shape alone
  std::shared_ptr<const Scene> scene_;
  double scene_time_;  // at launch [s]
  double radius_;      // of a ball [m]
};

}  // namespace physim
