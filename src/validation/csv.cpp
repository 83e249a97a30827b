#include "validation/csv.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "scenario/text_file.hpp"
#include "scenario/units.hpp"

namespace physim::validation {
namespace {

const std::string kNothing;

}  // namespace

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::optional<double> number_after(const std::string& text, const std::string& word) {
  PHYSIM_ASSERT(!word.empty());
  const std::size_t at = text.find(word);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t first = std::min(text.find_first_not_of(' ', at + word.size()), text.size());
  return parse_number(text.substr(first, text.find_first_not_of("0123456789.", first) - first));
}

std::optional<double> parse_number(std::string_view text) {
  text = trimmed(text);
  double value = 0;
  const auto [end, code] = number_at_start(text, value);
  if (code == std::errc::result_out_of_range) {  // below the smallest double
    const auto exponent = text.find_first_of("eE");
    if (exponent != std::string_view::npos && text.substr(exponent + 1, 1) == "-") return 0.0;
    return std::nullopt;
  }
  if (code != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

double last_digit_unit(std::string_view text) {
  const auto e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, e);
  const auto point = mantissa.find('.');
  double power = point == std::string_view::npos ? 0.0 : -static_cast<double>(mantissa.size() - point - 1);
  if (e != std::string_view::npos) power += parse_number(text.substr(e + 1)).value_or(0);
  return std::pow(10.0, power);
}

CsvFile CsvFile::read(const std::filesystem::path& path) {
  constexpr std::uintmax_t kLargestFile = 256 << 20;  // [bytes]
  const Result<std::string> text = read_text_file(path.string(), kLargestFile, "file of figures");
  if (!text) throw DataError{text.error()};
  CsvFile file;
  file.path_ = path;
  std::string_view rest = *text;
  for (int number = 1; !rest.empty(); ++number) file.add_line(take_line(rest), number);
  if (file.columns_.empty())
    throw DataError{{.message = "no header line with column names", .place = path.string() + ":1"}};
  return file;
}

void CsvFile::add_line(std::string_view line, int number) {
  const std::string_view content = trimmed(line);
  if (content.empty()) return;
  if (content.front() == '#') {
    if (!comments_.empty()) comments_ += ' ';
    comments_ += trimmed(content.substr(1));
    return;
  }
  std::vector<std::string> fields;
  for (const CsvField& field : csv_fields(content)) fields.emplace_back(field.text);
  if (columns_.empty()) {
    columns_ = std::move(fields);
    header_line_ = number;
  } else {
    add_row(std::move(fields), number);
  }
}

void CsvFile::add_row(std::vector<std::string> fields, int number) {
  PHYSIM_ASSERT(!columns_.empty());
  PHYSIM_ASSERT(number > header_line_);
  if (columns_.back() == "note") {  // words: they may hold commas
    while (fields.size() > columns_.size()) {
      const std::string tail = std::move(fields.back());
      fields.pop_back();
      fields.back() += "," + tail;
    }
    if (fields.size() + 1 == columns_.size()) fields.emplace_back();
  }
  CsvRow row{number, std::move(fields)};
  if (row.fields.size() != columns_.size())
    fail(row, formatted("%zu fields; the header has %zu columns", row.fields.size(), columns_.size()));
  rows_.push_back(std::move(row));
}

std::optional<std::size_t> CsvFile::index_of(std::string_view column) const {
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i] == column) return i;
  return std::nullopt;
}

void CsvFile::require(std::initializer_list<std::string_view> columns) const {
  for (const std::string_view column : columns) {
    if (has(column)) continue;
    std::string found;
    for (const std::string& c : columns_) found += (found.empty() ? "" : ", ") + c;
    throw DataError{{.message = "no column \"" + std::string(column) + "\"",
                     .place = formatted("%s:%d", path_.string().c_str(), header_line_),
                     .hint = "the header has: " + found}};
  }
}

const std::string& CsvFile::text(const CsvRow& row, std::string_view column) const {
  const auto index = index_of(column);
  PHYSIM_ASSERT(row.fields.size() == columns_.size());
  return index ? row.fields[*index] : kNothing;
}

std::optional<double> CsvFile::number(const CsvRow& row, std::string_view column) const {
  const std::string& field = text(row, column);
  if (field.empty()) return std::nullopt;
  const auto value = parse_number(field);
  if (!value)
    fail(row, formatted("\"%s\" in column \"%s\" is not a number", field.c_str(), std::string(column).c_str()));
  return value;
}

double CsvFile::needed(const CsvRow& row, std::string_view column) const {
  const auto value = number(row, column);
  if (!value || !std::isfinite(*value)) fail(row, "column \"" + std::string(column) + "\" needs a number");
  return *value;
}

double CsvFile::constant(std::string_view name, double otherwise) const {
  const std::string key = std::string(name) + "=";
  for (auto at = comments_.find(key); at != std::string::npos; at = comments_.find(key, at + 1)) {
    if (at > 0 && (std::isalnum(static_cast<unsigned char>(comments_[at - 1])) || comments_[at - 1] == '_')) continue;
    double value = 0;
    const char* first = comments_.data() + at + key.size();
    if (std::from_chars(first, comments_.data() + comments_.size(), value).ec == std::errc{}) return value;
  }
  return otherwise;
}

void CsvFile::fail(const CsvRow& row, const std::string& message) const {
  throw DataError{{.message = message, .place = formatted("%s:%d", path_.string().c_str(), row.line)}};
}

}  // namespace physim::validation
