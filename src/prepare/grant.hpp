// Granting: what of an asked fidelity can be had, and why where it is less.
#pragma once

#include "physim/flight.hpp"

namespace physim {

/// What Integrator::automatic is: a flight chooses its steps, a world's steps are its frames, and so is a given step.
inline constexpr Integrator kFlightIntegrator = Integrator::rk43;
inline constexpr Integrator kFrameIntegrator = Integrator::semi_implicit_euler;
[[nodiscard]] inline Fidelity by_steps(Fidelity asked, bool are_given) {
  if (asked.integrator == Integrator::automatic) asked.integrator = are_given ? kFrameIntegrator : kFlightIntegrator;
  return asked;
}

/// What of the asked fidelity this projectile in this environment can have.
[[nodiscard]] FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile,
                                  const Environment& environment);
/// With notes about the launch: a rail that is left out, models that it leads beyond where they hold.
[[nodiscard]] FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile,
                                  const Environment& environment, const Launch& launch);

/// Whether a fidelity may be granted a rotation that is flown.
[[nodiscard]] inline bool may_turn(const Fidelity& asked) {
  const RotationModel r = asked.rotation;
  return turns(asked) || r == RotationModel::automatic || r == RotationModel::automatic_point;
}
[[nodiscard]] bool has_motor(const ProjectileDef& projectile);
/// It has data of lift by spin.
[[nodiscard]] bool has_magnus(const ProjectileDef& projectile);
/// Whether motors and launch rails are part of a fidelity.
[[nodiscard]] bool flies_motors(const Fidelity& granted);

}  // namespace physim
