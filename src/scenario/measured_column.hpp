// A column of measurements out of a CSV file, as a distribution: each of them as likely.
//
// The first line that is no comment names the columns, with their units or without: "speed [ft/s], shot". Lines that
// begin with # are comments; empty fields are left out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physim/result.hpp"
#include "physim/units.hpp"

namespace physim {

/// The kind of file, in errors.
inline constexpr const char* kMeasurements = "table of measurements";

/// What a column is read by.
enum class Measured {
  values,
  differences,  // 2 degC are 2 K
};
/// The numbers of a column [SI unit of the quantity].
[[nodiscard]] Result<std::vector<double>> read_measured_column(const std::string& file, std::string_view column,
                                                               Quantity quantity, Measured measured);
/// FILE of an input "PATH = column NAME of FILE"; empty: it names no file.
[[nodiscard]] std::string_view file_of_column(std::string_view input);

}  // namespace physim
