// Measurements of a flight as a CSV file.
#pragma once

#include <string>
#include <vector>

#include "physim/fit.hpp"
#include "physim/result.hpp"

namespace physim::cli {

/// Measurements and where each stands in its file ("data.csv:3").
struct FitData {
  std::vector<Measurement> measurements;
  std::vector<std::string> places;
};

/// Reads a table with a header line: "range [yd], speed [ft/s], drop [in], time [s]" in any order, range and at least
/// one other; SI where no unit is given. Empty fields are not measured; lines that start with '#' are comments. Errors
/// carry file:line:col.
[[nodiscard]] Result<FitData> read_fit_data(const std::string& file);

}  // namespace physim::cli
