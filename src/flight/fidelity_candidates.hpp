// The fidelities that cheapest_within() chooses from: models below those of the truth, and ways to step them.
#pragma once

#include <string>
#include <vector>

#include "model/earth.hpp"
#include "physim/solve.hpp"
#include "prepare/grant.hpp"

namespace physim {

/// The truth with one rung lowered.
struct Lowered {
  std::string effect;  // field of Fidelity
  Fidelity fidelity;
};

/// A way to step through a flight.
struct Stepper {
  Motion motion = Motion::force;
  Integrator integrator = Integrator::semi_implicit_euler;
  Precision precision = Precision::float64;
  double step = 0;  // fixed [s]; 0: none
};

/// The models of a truth, and all that are no higher.
class FidelityLadder {
 public:
  FidelityLadder(const ProjectileDef& projectile, const Environment& environment, const Purpose& purpose);

  /// Dop853 in float64, as granted.
  [[nodiscard]] const Fidelity& truth() const { return truth_; }
  /// The truth with each effect on each lower rung, alone.
  [[nodiscard]] std::vector<Lowered> lowered() const;
  /// Every combination of models no higher than the truth's, low ones first. Equal ones occur once.
  [[nodiscard]] std::vector<Fidelity> models() const;
  /// Cheap ones first; fixed steps are frames, or where those are free, `longest` [s] halved again and again.
  [[nodiscard]] std::vector<Stepper> steppers(double longest) const;
  /// Models stepped in a way; nothing where they do not go together.
  [[nodiscard]] std::optional<Fidelity> combine(const Fidelity& models, const Stepper& stepper) const;
  /// Whether a fidelity has the rung that was lowered.
  [[nodiscard]] bool shares(const Fidelity& fidelity, const Lowered& lowered) const;

 private:
  [[nodiscard]] bool granted_as_asked(const Fidelity& fidelity) const;
  [[nodiscard]] Fidelity without_idle_rungs(Fidelity fidelity) const;

  const ProjectileDef& projectile_;
  const Environment& environment_;
  const Purpose& purpose_;
  Fidelity truth_;
};

}  // namespace physim
