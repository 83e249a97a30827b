// Scenarios with a [world]: what its tables cannot say about themselves, and contradictions.
#pragma once

#include "physim/scenario.hpp"
#include "scenario/document.hpp"

namespace physim {

/// Default names, laws without numbers, and whether there is a world at all.
void complete_world(Scenario& scenario, const Value& document);
[[nodiscard]] Status check_world(const Scenario& scenario, const Value& document);

/// Names of what is counted together: volleys, and shots that are in none.
[[nodiscard]] std::vector<std::string_view> group_names(const Scenario& scenario);

}  // namespace physim
