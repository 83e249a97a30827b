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
Result<CsvColumn> column_of(const std::vector<CsvField>& heads, std::string_view column, const std::string& place) {
  std::vector<std::string_view> names;
  for (const CsvField& head : heads) names.push_back(head_of(head.text).name);
  const auto at = std::ranges::find(names, column);
  if (at == names.end())
    return Error{"no column is called " + in_quotes(column), place, suggestion(column, names, "its columns are")};
  const auto index = static_cast<std::size_t>(at - names.begin());
  PHYSIM_ASSERT(index < heads.size());
  return CsvColumn{index, std::string(head_of(heads[index].text).unit)};
}

/// A number with its unit, which stands behind it or in the head of its column.
Result<double> number_of(const std::string& field, const std::string& unit, Quantity quantity, Measured measured) {
  const std::string text = unit.empty() ? field : field + " " + unit;
  const auto number = parse_quantity(text, quantity);
  if (!number || measured == Measured::values || quantity != Quantity::temperature) return number;
  const std::size_t own = text.find_first_not_of("0123456789.+-eE \t");
  if (own == text.npos) return number;
  const auto zero = parse_quantity("0 " + text.substr(own), quantity);
  return zero ? Result<double>(*number - *zero) : zero;
}

}  // namespace

Result<std::vector<double>> read_measured_column(const std::string& file, std::string_view column, Quantity quantity,
                                                 Measured measured) {
  const auto text = read_text_file(file, kLargestFile, kMeasurements);
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
    const auto fields = csv_fields(line);
    if (!wanted) {
      const auto found = column_of(fields, column, place);
      if (!found) return found.error();
      wanted = *found;
      continue;
    }
    if (wanted->index >= fields.size() || fields[wanted->index].text.empty()) continue;
    const std::string field(fields[wanted->index].text);
    const auto number = number_of(field, wanted->unit, quantity, measured);
    if (!number) return Error{number.error().message, place, number.error().hint};
    if (!std::isfinite(*number)) return Error{in_quotes(field) + " is not a finite number", place, ""};
    numbers.push_back(*number);
  }
  if (numbers.empty()) return Error{"the column " + in_quotes(column) + " has no numbers", file, ""};
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
