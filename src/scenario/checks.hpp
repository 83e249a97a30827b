// Checks that need more than one setting; of scenarios with a [world], what its tables cannot say about themselves.
#pragma once

#include "physim/scenario.hpp"
#include "scenario/document.hpp"

namespace physim {

/// The first contradiction within a scenario; the document tells where its settings stand.
[[nodiscard]] Status check_scenario(const Scenario& scenario, const Value& document);

/// Contradictions of a [world], or of what there is without one.
[[nodiscard]] Status check_world(const Scenario& scenario, const Value& document);

/// Contradictions of what there is for projectiles to hit; it makes the scene to see whether it can be made.
[[nodiscard]] Status check_scene(const Scenario& scenario, const Value& document);
/// Whether there is the thing that an expectation asks about, and a figure of hits on it.
[[nodiscard]] Status check_thing_expectation(const Scenario& scenario, const Expectation& expect, const Value& table);

/// Default names of a scene's parts, published materials that things name, and meshes out of files.
[[nodiscard]] Status complete_scene(Scenario& scenario, const Value& document);

/// Default names, laws without numbers, and whether there is a world at all.
void complete_world(Scenario& scenario, const Value& document);

/// Names of what is counted together: volleys, and shots that are in none.
[[nodiscard]] std::vector<std::string_view> group_names(const Scenario& scenario);

}  // namespace physim
