// Granting: what of an asked fidelity can be had, and why where it is less.
#pragma once

#include "physim/flight.hpp"

namespace physim {

/// What of the asked fidelity this projectile in this environment can have.
[[nodiscard]] FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile,
                                  const Environment& environment);
/// With notes about the launch: a rail that is left out, models that it leads beyond where they hold.
[[nodiscard]] FidelityInUse grant(const Fidelity& asked, const ProjectileDef& projectile,
                                  const Environment& environment, const Launch& launch);

[[nodiscard]] bool has_motor(const ProjectileDef& projectile);
/// It has data of lift by spin.
[[nodiscard]] bool has_magnus(const ProjectileDef& projectile);
/// Whether motors and launch rails are part of a fidelity.
[[nodiscard]] bool flies_motors(const Fidelity& granted);

}  // namespace physim
