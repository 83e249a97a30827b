// The bore elevation of a launch.
#pragma once

#include "physim/flight.hpp"

namespace physim {

/// Its own, or that of its zero range.
[[nodiscard]] Result<double> elevation_of(const ProjectileDef& projectile, const Launch& launch,
                                          const Environment& environment, const Fidelity& fidelity);

/// The elevation of a velocity above the horizon [rad].
[[nodiscard]] double elevation_of(const Vec3d& velocity);

/// A launch with its bore where its zero range, if it has one, puts it: no search is left.
[[nodiscard]] Result<Launch> aimed_launch(const ProjectileDef& projectile, Launch launch,
                                          const Environment& environment, const Fidelity& fidelity);

}  // namespace physim
