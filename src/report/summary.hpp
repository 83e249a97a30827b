// What people read of flights: for each shot its fidelity, range card, end, apex and cost; then the checks.
#pragma once

#include <string>
#include <vector>

#include "report/flown.hpp"
#include "report/style.hpp"

namespace physim::report {

[[nodiscard]] std::string summary_text(const FlownScenario& flown, const Style& style);

/// The verdicts, a line for each.
[[nodiscard]] std::string checks_text(const std::vector<Check>& checks, const Style& style);

/// Round ranges [m] for a range card of a flight that ends at this range [m].
[[nodiscard]] std::vector<double> default_ranges(double end_range);

}  // namespace physim::report
