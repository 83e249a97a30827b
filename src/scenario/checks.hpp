// Checks that need more than one setting.
#pragma once

#include "physim/scenario.hpp"
#include "scenario/document.hpp"

namespace physim {

/// The first contradiction within a scenario; the document tells where its settings stand.
[[nodiscard]] Status check_scenario(const Scenario& scenario, const Value& document);

}  // namespace physim
