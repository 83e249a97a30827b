#include "scenario/measured_column.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/assert.hpp"
#include "scenario/suggest.hpp"
#include "scenario/text_file.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

constexpr std::uintmax_t kLargestFile = 64 << 20;

std::string_view without_quotes(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = trimmed(field.substr(1, field.size() - 2));
  return field;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t at = std::min(line.find(',', from), line.size());
    fields.push_back(without_quotes(line.substr(from, at - from)));
    from = at + 1;
  }
  return fields;
}

/// "speed [ft/s]" in two.
struct Head {
  std::string_view name, unit;
};
Head head_of(std::string_view field) {
  const std::size_t open = field.find('[');
  if (open == field.npos || field.back() != ']') return {field, {}};
  return {trimmed(field.substr(0, open)), trimmed(field.substr(open + 1, field.size() - open - 2))};
}

struct CsvColumn {
  std::size_t index;
  std::string unit;
};
Result<CsvColumn> column_of(const std::vector<std::string_view>& heads, std::string_view column,
                            const std::string& place) {
  std::vector<std::string_view> names;
  for (const std::string_view head : heads) names.push_back(head_of(head).name);
  const auto at = std::ranges::find(names, column);
  if (at == names.end())
    return Error{"no column is called " + in_quotes(column), place, suggestion(column, names, "its columns are")};
  const auto index = static_cast<std::size_t>(at - names.begin());
  PHYSIM_ASSERT(index < heads.size());
  return CsvColumn{index, std::string(head_of(heads[index]).unit)};
}

}  // namespace

Result<std::vector<double>> read_measured_column(const std::string& file, std::string_view column, Quantity quantity) {
  const auto text = read_text_file(file, kLargestFile, "table of measurements");
  if (!text) return text.error();
  std::vector<double> numbers;
  std::optional<CsvColumn> wanted;
  int line_number = 0;
  for (std::size_t from = 0; from < text->size();) {
    const std::size_t at = std::min(text->find('\n', from), text->size());
    const std::string_view line = trimmed(std::string_view(*text).substr(from, at - from));
    from = at + 1;
    const std::string place = file + ":" + std::to_string(++line_number);
    if (line.empty() || line.front() == '#') continue;
    const auto fields = fields_of(line);
    if (!wanted) {
      const auto found = column_of(fields, column, place);
      if (!found) return found.error();
      wanted = *found;
      continue;
    }
    if (wanted->index >= fields.size() || fields[wanted->index].empty()) continue;
    const std::string field(fields[wanted->index]);
    const auto number = parse_quantity(wanted->unit.empty() ? field : field + " " + wanted->unit, quantity);
    if (!number) return Error{number.error().message, place, number.error().hint};
    if (!std::isfinite(*number)) return Error{in_quotes(field) + " is not a finite number", place, ""};
    numbers.push_back(*number);
  }
  if (numbers.empty()) return Error{"the column " + in_quotes(column) + " has no numbers", file, ""};
  return numbers;
}

}  // namespace physim
