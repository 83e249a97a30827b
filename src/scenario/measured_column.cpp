#include "scenario/measured_column.hpp"

#include <algorithm>
#include <optional>

#include "base/assert.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

struct ColumnOfTable {
  std::size_t index;
  std::string unit, place;
};
Result<ColumnOfTable> column_of(const MeasuredLine& heads, std::string_view column, Quantity quantity) {
  std::vector<std::string_view> names;
  for (const CsvField& head : heads.fields) names.push_back(head_of(head.text).name);
  const auto at = std::ranges::find(names, column);
  if (at == names.end())
    return Error{"no column is called " + in_quotes(column), heads.place(),
                 suggestion(column, names, "its columns are")};
  const auto index = static_cast<std::size_t>(at - names.begin());
  if (Status status = check_head(heads, index, quantity); !status) return status.error();
  return ColumnOfTable{index, std::string(head_of(heads.fields[index].text).unit), heads.place(index)};
}

}  // namespace

Result<std::vector<double>> read_measured_column(const std::string& file, std::string_view column, Quantity quantity,
                                                 Measured measured) {
  std::vector<double> numbers;
  std::optional<ColumnOfTable> wanted;
  const auto take_head = [&](const MeasuredLine& heads) -> Status {
    auto found = column_of(heads, column, quantity);
    if (!found) return found.error();
    wanted = *std::move(found);
    return {};
  };
  const auto take_row = [&](const MeasuredLine& row) -> Status {
    PHYSIM_ASSERT(wanted.has_value());
    if (row.fields[wanted->index].text.empty()) return {};
    const auto number = number_in(row, wanted->index, wanted->unit, quantity, measured);
    if (!number) return number.error();
    numbers.push_back(*number);
    return {};
  };
  if (Status status = read_measured_table(file, take_head, take_row); !status) return status.error();
  if (numbers.empty()) return Error{"the column " + in_quotes(column) + " has no numbers", wanted->place, ""};
  return numbers;
}

std::string_view file_of_column(std::string_view input) {
  constexpr std::string_view kOf = " of ", kPerOccasion = "per occasion";
  const std::size_t of = input.find(kOf, input.find("column "));
  if (of == input.npos) return {};
  std::string_view file = trimmed(input.substr(of + kOf.size()));
  if (file.ends_with(kPerOccasion)) file.remove_suffix(kPerOccasion.size());
  return trimmed(file);
}

}  // namespace physim
