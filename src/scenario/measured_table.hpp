// Tables of measurements: CSV files whose first line names the columns, with their units or without: "speed [ft/s],
// shot". Lines that begin with # are comments; lines without anything in their fields are blank. Each other line has a
// field for each column.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "physim/result.hpp"
#include "physim/units.hpp"
#include "scenario/text_file.hpp"

namespace physim {

/// The kind of file, in errors.
inline constexpr const char* kMeasurements = "table of measurements";

/// A line of a table.
struct MeasuredLine {
  const std::string& file;
  std::size_t number = 0;  // from 1
  std::vector<CsvField> fields{};

  /// "file:line:column" of a field.
  [[nodiscard]] std::string place(std::size_t field = 0) const;
};
using TakeMeasuredLine = std::function<Status(const MeasuredLine&)>;
/// Reads a file: first the line that names the columns, then each row. Ends with the first error.
[[nodiscard]] Status read_measured_table(const std::string& file, const TakeMeasuredLine& take_head,
                                         const TakeMeasuredLine& take_row);

/// "speed [ft/s]" in two.
struct MeasuredHead {
  std::string_view name, unit;  // without a unit: SI
};
[[nodiscard]] MeasuredHead head_of(std::string_view field);
/// An error if the head of a column has another's name, or a unit of another quantity.
[[nodiscard]] Status check_head(const MeasuredLine& heads, std::size_t column, Quantity quantity);

/// What a column is read by.
enum class Measured {
  values,
  differences,  // 2 degC are 2 K
};
/// The finite number in a field [SI unit of the quantity], in a unit of its own or else in that of its column.
[[nodiscard]] Result<double> number_in(const MeasuredLine& row, std::size_t field, std::string_view unit,
                                       Quantity quantity, Measured measured = Measured::values);

}  // namespace physim
