// Records: rows of named columns, the common ground of all results. A format that writes records writes every result.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "report/text.hpp"

namespace physim::report {

/// Text, a number, or nothing.
using Cell = std::variant<std::monostate, std::string_view, double, std::uint64_t>;
using Row = std::span<const Cell>;

struct Records {
  std::vector<std::string> columns;  // with their units: "x [m]"
  /// Hands over row after row, the same each time, with a cell for each column: there may be too many to keep them.
  std::function<void(const std::function<void(Row)>& take)> rows;
};

/// A header line and a line for each row: RFC 4180, with a line feed alone at the end of each line.
[[nodiscard]] Text csv_text(Records records);
/// An object with a list for each column.
[[nodiscard]] Text columns_json(Records records);

}  // namespace physim::report
