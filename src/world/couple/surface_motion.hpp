// What surfaces do to the acceleration of what rests, rolls or slides on them.
#pragma once

#include <functional>
#include <optional>

#include "model/body.hpp"
#include "model/rotor.hpp"
#include "physim/flight.hpp"
#include "physim/math.hpp"

namespace physim {

struct Slot;
struct WorldImpl;

/// Acceleration of a projectile by everything but surfaces, in a state [m/s^2].
using FreeAcceleration = std::function<Vec3d(const State<double>&)>;

/// What a projectile feels between steps of its world, by everything but joints and surfaces.
class FreeMotion {
 public:
  FreeMotion(const WorldImpl& world, const Slot& slot);
  /// In a state.
  [[nodiscard]] Accelerations operator()(const State<double>& s) const;
  [[nodiscard]] const Body<double>& body() const { return body_; }

 private:
  const Conditions<double>& conditions_;
  double clock_;
  Body<double> body_;
  Rotor<double> rotor_{};
  Turn<double> turn_{};
};

/// The acceleration of a projectile that lies on the ground or on a thing of the scene, by the surface and everything
/// else: the change of its velocity in a time so short that nothing else happens. None if it flies [m/s^2].
[[nodiscard]] std::optional<Vec3d> acceleration_on_surface(const WorldImpl& world, const Slot& slot,
                                                           const Body<double>& body, const FreeAcceleration& free);

}  // namespace physim
