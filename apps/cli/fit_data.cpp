#include "fit_data.hpp"

#include <array>
#include <cmath>
#include <fstream>

#include "scenario/suggest.hpp"
#include "scenario/units.hpp"

namespace physim::cli {
namespace {

/// A field of a line with the column where it starts, from 1.
struct Field {
  std::string text;
  std::size_t column;
};

std::vector<Field> fields_of(const std::string& line) {
  std::vector<Field> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    const std::string_view raw = std::string_view(line).substr(from, comma - from);
    const std::string_view text = trimmed(raw);
    const std::size_t skipped = text.empty() ? 0 : static_cast<std::size_t>(text.data() - raw.data());
    fields.push_back({std::string(text), from + skipped + 1});
    from = comma + 1;
  }
  return fields;
}

/// What a column holds.
struct DataColumn {
  std::string_view name;
  Quantity quantity;
  std::string unit;  // of the header; empty: SI
};
constexpr std::array<std::string_view, 4> kNames = {"range", "speed", "drop", "time"};
constexpr Quantity kQuantities[] = {Quantity::length, Quantity::speed, Quantity::length, Quantity::time};

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Result<FitData> read() {
    std::ifstream in(file_);
    if (!in) return Error{.message = "the file cannot be read", .place = file_};
    std::string line;
    while (std::getline(in, line)) {
      ++line_;
      if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const std::string_view content = trimmed(line);
      if (content.empty() || content.front() == '#') continue;
      const Status status = columns_.empty() ? read_header(line) : read_row(line);
      if (!status) return status.error();
    }
    if (in.bad()) return Error{.message = "the file cannot be read", .place = file_};
    if (columns_.empty())
      return Error{.message = "there is no header line",
                   .place = file_ + ":1:1",
                   .hint = "write range [m], speed [m/s] above the figures"};
    if (data_.measurements.empty())
      return Error{.message = "there is no figure below the header",
                   .place = file_ + ":" + std::to_string(line_) + ":1"};
    return std::move(data_);
  }

 private:
  [[nodiscard]] std::string place(std::size_t column) const {
    return file_ + ":" + std::to_string(line_) + ":" + std::to_string(column);
  }

  Status read_header(const std::string& line) {
    for (const Field& field : fields_of(line)) {
      const std::size_t bracket = field.text.find('[');
      const std::string name(trimmed(std::string_view(field.text).substr(0, bracket)));
      const auto known = std::find(kNames.begin(), kNames.end(), name);
      if (known == kNames.end())
        return Error{.message = "unknown column " + in_quotes(name),
                     .place = place(field.column),
                     .hint = suggestion(name, kNames, "known columns")};
      DataColumn column{*known, kQuantities[known - kNames.begin()], ""};
      if (bracket != std::string::npos) {
        const std::size_t end = field.text.find(']', bracket);
        if (end == std::string::npos)
          return Error{
              .message = "the unit has no closing bracket", .place = place(field.column), .hint = "write range [m]"};
        column.unit = std::string(trimmed(std::string_view(field.text).substr(bracket + 1, end - bracket - 1)));
        if (const Result<double> one = parse_quantity("1 " + column.unit, column.quantity); !one)
          return Error{.message = one.error().message, .place = place(field.column), .hint = one.error().hint};
      }
      for (const DataColumn& before : columns_)
        if (before.name == column.name)
          return Error{.message = "two columns are named " + in_quotes(name), .place = place(field.column)};
      columns_.push_back(std::move(column));
    }
    const bool has_range =
        std::any_of(columns_.begin(), columns_.end(), [](const auto& c) { return c.name == "range"; });
    if (!has_range || columns_.size() < 2)
      return Error{.message = has_range ? "there is a range and nothing else" : "there is no column \"range\"",
                   .place = place(1),
                   .hint = "as in range [yd], speed [ft/s], drop [in]"};
    return {};
  }

  Status read_row(const std::string& line) {
    const std::vector<Field> fields = fields_of(line);
    if (fields.size() != columns_.size())
      return Error{.message = std::to_string(fields.size()) + " fields",
                   .place = place(1),
                   .hint = "the header has " + std::to_string(columns_.size()) + " columns"};
    Measurement m;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const DataColumn& column = columns_[i];
      if (fields[i].text.empty() && column.name != "range") continue;
      const bool has_unit = fields[i].text.find_first_not_of("0123456789+-.eE") != std::string::npos;
      const std::string text = has_unit || column.unit.empty() ? fields[i].text : fields[i].text + " " + column.unit;
      const Result<double> value = parse_quantity(text, column.quantity);
      if (!value || !std::isfinite(*value))
        return Error{.message = value ? "must be a finite number" : value.error().message,
                     .place = place(fields[i].column),
                     .hint = value ? "" : value.error().hint};
      if (column.name == "range") m.range = *value;
      if (column.name == "speed") m.speed = *value;
      if (column.name == "drop") m.drop = *value;
      if (column.name == "time") m.time = *value;
    }
    data_.measurements.push_back(m);
    data_.places.push_back(place(1));
    return {};
  }

  std::string file_;
  std::size_t line_ = 0;
  std::vector<DataColumn> columns_;
  FitData data_;
};

}  // namespace

Result<FitData> read_fit_data(const std::string& file) { return Reader(file).read(); }

}  // namespace physim::cli
