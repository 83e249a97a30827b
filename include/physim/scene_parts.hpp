// SceneParts: the scene of a scenario, and by which ids it knows the scenario's parts. Part of physim_scenario.
#pragma once

#include <vector>

#include "physim/scenario.hpp"

namespace physim {

/// The scene of a scenario and the ids of its parts.
struct SceneParts {
  Scene scene{};                        ///< as scene_of() makes it [-]
  std::vector<MaterialId> materials{};  ///< of Scenario::materials, in their order [-]
  std::vector<InstanceId> things{};     ///< of Scenario::things, in their order [-]
};

/// An error names the shape, material or thing that is wrong.
[[nodiscard]] Result<SceneParts> scene_parts(const Scenario& scenario);

}  // namespace physim
