// Rows of reports as columns of Python.
#pragma once

#include <limits>

#include "common.hpp"
#include "report/records.hpp"

namespace physim::python {

/// A list for each column; empty cells among numbers are NaN.
[[nodiscard]] inline nb::dict columns_of(const report::Records& records) {
  std::vector<nb::list> columns(records.columns.size());
  records.rows([&](report::Row row) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i >= row.size() || std::holds_alternative<std::monostate>(row[i]))
        columns[i].append(std::numeric_limits<double>::quiet_NaN());
      else if (const auto* text = std::get_if<std::string_view>(&row[i]))
        columns[i].append(nb::str(text->data(), text->size()));
      else if (const auto* number = std::get_if<double>(&row[i]))
        columns[i].append(*number);
      else
        columns[i].append(std::get<std::uint64_t>(row[i]));
    }
  });
  nb::dict out;
  for (std::size_t i = 0; i < columns.size(); ++i) out[records.columns[i].c_str()] = columns[i];
  return out;
}

}  // namespace physim::python
