// Placing: walls and targets that a hand puts into the scene, as shapes and things of the scenario.
#pragma once

#include <string>
#include <vector>

#include "scenario/scenario.hpp"

namespace physim::client {

/// What the next wall or target is like.
struct Placing {
  std::string material = "concrete";  // published, or of the scenario; empty: that of every scene
  double height = 2;                  // of a wall [m]
  double thickness = 0.2;             // of a wall; targets have a fifth of it [m]
  double radius = 0.5;                // of a target [m]
};

/// Sizes that fit a view from a distance [m], round numbers.
void fit_sizes(Placing& placing, double distance);

/// The names of materials that can be chosen: those of the scenario, then the published ones.
[[nodiscard]] std::vector<std::string> materials_to_choose(const Scenario& scenario);

/// A scenario with something more in it.
struct Placed {
  Scenario scenario;
  std::string name;  // of the thing
};
/// A wall that stands between two feet, upright, as high above the lower of them as it was asked for. An error for one
/// that has no size.
[[nodiscard]] Result<Placed> with_wall(const Scenario& scenario, const Vec3d& from, const Vec3d& to,
                                       const Placing& placing);
/// A round target about a place, upright, facing where it is shot from.
[[nodiscard]] Result<Placed> with_target(const Scenario& scenario, const Vec3d& middle, const Vec3d& shot_from,
                                         const Placing& placing);
}  // namespace physim::client
