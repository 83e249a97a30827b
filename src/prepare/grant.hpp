// Granting: what of an asked fidelity can be had, and why where it is less.
#pragma once

#include "physim/flight.hpp"

namespace physim {

/// What Integrator::automatic is in a world, whose steps are its frames, and where a step is given.
inline constexpr Integrator kFrameIntegrator = Integrator::semi_implicit_euler;
/// What Integrator::adaptive is for points: corners of their curves end steps before a higher order pays.
inline constexpr Integrator kPointIntegrator = Integrator::rk43;
/// What it is for bodies: they turn within a step, where the higher order takes fewer of their dear evaluations.
inline constexpr Integrator kBodyIntegrator = Integrator::tsit5;

/// Whether grant() chooses the integrator by the rotation.
[[nodiscard]] inline bool is_chosen_by_rotation(Integrator asked) {
  return asked == Integrator::automatic || asked == Integrator::adaptive;
}
/// An automatic integrator is that of frames where steps are given.
[[nodiscard]] inline Fidelity by_steps(Fidelity asked, bool are_given) {
  if (asked.integrator == Integrator::automatic && are_given) asked.integrator = kFrameIntegrator;
  return asked;
}

/// What of the asked fidelity this projectile in this environment can have.
[[nodiscard]] FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile,
                                  const Environment& environment);
/// With notes about the launch, where all of it is checked: a rail that is left out, models that it leads beyond where
/// they hold.
[[nodiscard]] FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile,
                                  const Environment& environment, const Launch& launch);

/// In a world, whose steps are its frames and which shows what flew: drift by a formula is added to whole flights.
[[nodiscard]] FidelityInUse grant_in_world(const Fidelity& asked, const ProjectileDef& projectile,
                                           const Environment& environment);

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
