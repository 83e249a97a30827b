#include "scenario/measured_table.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

constexpr std::uintmax_t kLargestTable = 64 << 20;  // [bytes]
constexpr const char* kCommas = "commas part columns, and numbers have a decimal point";

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

/// A table whose columns something else parts looks as if it had one.
Status check_commas(const MeasuredLine& heads) {
  PHYSIM_ASSERT(!heads.fields.empty());
  const std::string_view first = heads.fields[0].text;
  const std::size_t at = heads.fields.size() == 1 ? first.find_first_of(";\t") : first.npos;
  if (at == first.npos) return {};
  const char* what = first[at] == ';' ? "semicolons" : "tabs";
  return Error{std::string(what) + " part the columns", heads.place(), std::string("save it as CSV where ") + kCommas};
}

Status check_count(const MeasuredLine& row, std::size_t columns) {
  if (row.fields.size() == columns) return {};
  const std::string hint = "the header has " + counted(columns, "column");
  return Error{counted(row.fields.size(), "field"), row.place(),
               row.fields.size() > columns ? hint + "; " + kCommas : hint};
}

}  // namespace

std::string MeasuredLine::place(std::size_t field) const {
  PHYSIM_ASSERT(field < fields.size());
  return file + ':' + std::to_string(number) + ':' + std::to_string(fields[field].column);
}

Status read_measured_table(const std::string& file, const TakeMeasuredLine& take_head,
                           const TakeMeasuredLine& take_row) {
  const Result<std::string> text = read_text_file(file, kLargestTable, kMeasurements);
  if (!text) return text.error();
  std::size_t columns = 0;
  std::string_view rest = *text;
  for (MeasuredLine line{file, 1}; !rest.empty(); ++line.number) {
    const std::string_view content = take_line(rest);
    if (trimmed(content).starts_with('#')) continue;
    line.fields = csv_fields(content);
    if (std::ranges::all_of(line.fields, [](const CsvField& field) { return field.text.empty(); })) continue;
    const bool is_head = columns == 0;
    if (is_head) columns = line.fields.size();
    if (Status status = is_head ? check_commas(line) : check_count(line, columns); !status) return status;
    if (Status status = is_head ? take_head(line) : take_row(line); !status) return status;
  }
  if (columns > 0) return {};
  return Error{"there is no header line", file + ":1:1", "write range [m], speed [m/s] above the figures"};
}

MeasuredHead head_of(std::string_view field) {
  const std::size_t open = field.find('[');
  if (open == field.npos || field.back() != ']') return {field, {}};
  return {trimmed(field.substr(0, open)), trimmed(field.substr(open + 1, field.size() - open - 2))};
}

Status check_head(const MeasuredLine& heads, std::size_t column, Quantity quantity) {
  PHYSIM_ASSERT(column < heads.fields.size());
  const MeasuredHead head = head_of(heads.fields[column].text);
  for (std::size_t i = 0; i < heads.fields.size(); ++i)
    if (i != column && head_of(heads.fields[i].text).name == head.name)
      return Error{"two columns are named " + in_quotes(head.name), heads.place(std::max(i, column)), ""};
  const auto one = parse_quantity("1 " + std::string(head.unit), quantity);
  return one ? Status() : Error{one.error().message, heads.place(column), one.error().hint};
}

Result<double> number_in(const MeasuredLine& row, std::size_t field, std::string_view unit, Quantity quantity,
                         Measured measured) {
  PHYSIM_ASSERT(field < row.fields.size());
  std::string text(row.fields[field].text);
  if (!unit.empty() && finite_number(text)) text += " " + std::string(unit);
  const auto number = parse_quantity(text, quantity);
  if (!number) return Error{number.error().message, row.place(field), number.error().hint};
  if (!std::isfinite(*number)) return Error{in_quotes(text) + " is not a finite number", row.place(field), ""};
  const std::string_view own = behind_number(text);
  if (measured == Measured::values || quantity != Quantity::temperature || own.empty()) return number;
  const auto zero = parse_quantity("0" + std::string(own), quantity);
  return zero ? Result<double>(*number - *zero) : zero;
}

}  // namespace physim
