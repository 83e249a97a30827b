// A column out of a table of measurements, as a distribution: each of them as likely. Empty fields are left out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physim/result.hpp"
#include "physim/units.hpp"
#include "scenario/measured_table.hpp"

namespace physim {

/// The numbers of a column [SI unit of the quantity].
[[nodiscard]] Result<std::vector<double>> read_measured_column(const std::string& file, std::string_view column,
                                                               Quantity quantity, Measured measured);
/// FILE of an input "PATH = column NAME of FILE"; empty: it names no file.
[[nodiscard]] std::string_view file_of_column(std::string_view input);

}  // namespace physim
