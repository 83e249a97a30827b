// The ladder of fidelity as a table for people, and as CSV and JSON.
#pragma once

#include <string>

#include "ladder.hpp"
#include "terminal.hpp"

namespace physim::cli {

[[nodiscard]] std::string ladder_text(const Scenario& scenario, const Ladder& ladder, const Style& style);
[[nodiscard]] std::string ladder_csv(const Ladder& ladder);
[[nodiscard]] std::string ladder_json(const Scenario& scenario, const Ladder& ladder);

}  // namespace physim::cli
