// Orbit: how long a revolution about a round Earth takes, and the highest and the lowest place of a path about it.
#pragma once

#include <optional>
#include <vector>

#include "physim/environment.hpp"
#include "physim/fidelity.hpp"
#include "simclient/core/track.hpp"

namespace physim::client {

/// The time of a revolution in the field of a point mass, through a state at launch [s]; nothing over a flat Earth,
/// where gravity does not fall with height, and for what never comes back.
[[nodiscard]] std::optional<double> revolution_time(const Environment& environment, const Fidelity& fidelity,
                                                    const Vec3d& position, const Vec3d& velocity);

/// A place of a path with its height above the Earth.
struct Apsis {
  Vec3d at;
  double altitude = 0;  // [m]
};
struct Apsides {
  std::optional<Apsis> highest, lowest;
};
/// The highest place of a path, unless it is an end of a path that does not go all around; the lowest place of a path
/// that does. Neither over a flat Earth.
[[nodiscard]] Apsides apsides_of(const std::vector<TrackSample>& path, const Environment& environment,
                                 const Fidelity& fidelity);

}  // namespace physim::client
