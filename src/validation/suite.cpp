// What suites of figures share: judging a number, summing up, finding files.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <fstream>

#include "base/assert.hpp"
#include "physim/names.hpp"
#include "scenario/units.hpp"
#include "validation/suite.hpp"

namespace physim::validation {
namespace fs = std::filesystem;

double Figure::error() const { return std::abs(actual - expected); }

bool Figure::pass() const { return error() <= gate; }  // false for NaN

double Figure::badness() const {
  const double e = error();
  if (!std::isfinite(e)) return std::numeric_limits<double>::infinity();
  if (gate > 0) return e / gate;
  return e == 0 ? 0 : std::numeric_limits<double>::infinity();
}

void SuiteResult::compare(std::string case_name, std::string figure, double expected, double actual, double gate,
                          std::string problem) {
  PHYSIM_ASSERT(!figure.empty());
  if (!problem.empty()) actual = kNaN;
  figures.push_back({std::move(case_name), std::move(figure), expected, actual, gate, std::move(problem)});
}

std::size_t SuiteResult::missed() const {
  return static_cast<std::size_t>(
      std::count_if(figures.begin(), figures.end(), [](const Figure& f) { return !f.pass(); }));
}

std::vector<CaseSummary> summarize(const SuiteResult& result) {
  std::vector<CaseSummary> cases;
  for (const Figure& figure : result.figures) {
    auto at =
        std::find_if(cases.begin(), cases.end(), [&](const CaseSummary& c) { return c.name == figure.case_name; });
    if (at == cases.end()) at = cases.insert(cases.end(), CaseSummary{.name = figure.case_name, .worst = &figure});
    ++at->figures;
    if (!figure.pass()) ++at->missed;
    if (figure.badness() > at->worst->badness()) at->worst = &figure;
  }
  PHYSIM_ASSERT(cases.empty() == result.figures.empty());
  return cases;
}

std::span<const Suite* const> all_suites() {
  static constexpr const Suite* kSuites[] = {&kClassicSuite,    &kAnalyticSuite, &kUs76Suite,  &kGravitySuite,
                                             &kBallisticsSuite, &kNescSuite,     &kMccoySuite, &kSportsSuite};
  return kSuites;
}

const Suite* find_suite(std::string_view name) {
  for (const Suite* suite : all_suites())
    if (suite->name == name) return suite;
  return nullptr;
}

std::string format(const char* pattern, ...) {
  va_list arguments, again;
  va_start(arguments, pattern);
  va_copy(again, arguments);
  std::string text(static_cast<std::size_t>(std::max(0, std::vsnprintf(nullptr, 0, pattern, arguments))), '\0');
  std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(arguments);
  va_end(again);
  return text;
}

void compare_tables(const fs::path& folder, std::span<const std::string_view> known, const char* otherwise,
                    SuiteResult& result, const std::function<bool(const CsvFile&, SuiteResult&)>& compare) {
  for (const fs::path& path : files_in(folder, known, ".csv")) {
    const CsvFile file = CsvFile::read(path);
    if (compare(file, result))
      result.sources.push_back({file.name(), file.comments()});
    else
      result.skipped.push_back(file.name() + ": " + otherwise);
  }
}

std::vector<fs::path> files_in(const fs::path& folder, std::span<const std::string_view> known,
                               std::string_view extension) {
  std::vector<fs::path> files, others;
  for (const std::string_view name : known)
    if (fs::is_regular_file(folder / name)) files.push_back(folder / name);
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    const bool is_known = std::find(known.begin(), known.end(), name) != known.end();
    if (!is_known && entry.is_regular_file() && name.ends_with(extension)) others.push_back(entry.path());
  }
  if (code) throw DataError{{.message = code.message(), .place = folder.string()}};
  std::sort(others.begin(), others.end());
  files.insert(files.end(), others.begin(), others.end());
  return files;
}

std::string complaint(const Flight& flight, const Fidelity& asked) {
  if (flight.error()) return flight.error()->text();
  const Outcome outcome = flight.outcome();
  const bool broken = outcome == Outcome::step_limit || outcome == Outcome::left_domain ||
                      outcome == Outcome::non_finite || outcome == Outcome::stalled || outcome == Outcome::refused;
  if (broken) return "the flight ended: " + std::string(name(outcome));
  const Fidelity& granted = flight.fidelity_in_use().fidelity;
  if (granted.motion != asked.motion) return "granted other motion: " + std::string(name(granted.motion));
  const bool steps = asked.motion != Motion::closed_form;
  if (steps && granted.integrator != asked.integrator)
    return "granted other integrator: " + std::string(name(granted.integrator));
  if (granted.drag != asked.drag) return "granted other drag: " + std::string(name(granted.drag));
  if (granted.rotation != asked.rotation) return "granted other rotation: " + std::string(name(granted.rotation));
  if (granted.earth != asked.earth) return "granted other earth: " + std::string(name(granted.earth));
  return {};
}

// -------------------------------------------------------------------------------------------------------------- tables
namespace {

const std::string kNothing;

/// Fields of one line; a field in double quotes may hold commas, "" in it stands for a quote.
std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  for (std::string& field : fields) field = std::string(trimmed(field));
  return fields;
}

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
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
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
  std::ifstream in(path);
  if (!in) throw DataError{{.message = "cannot be read", .place = path.string()}};
  CsvFile file;
  file.path_ = path;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) file.add_line(line, number);
  if (file.columns_.empty())
    throw DataError{{.message = "no header line with column names", .place = path.string() + ":1"}};
  return file;
}

void CsvFile::add_line(std::string line, int number) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (number == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
  const std::string_view content = trimmed(line);
  if (content.empty()) return;
  if (content.front() == '#') {
    if (!comments_.empty()) comments_ += ' ';
    comments_ += trimmed(content.substr(1));
    return;
  }
  std::vector<std::string> fields = split(content);
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
    fail(row, format("%zu fields; the header has %zu columns", row.fields.size(), columns_.size()));
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
                     .place = format("%s:%d", path_.string().c_str(), header_line_),
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
  if (!value) fail(row, format("\"%s\" in column \"%s\" is not a number", field.c_str(), std::string(column).c_str()));
  return value;
}

double CsvFile::needed(const CsvRow& row, std::string_view column) const {
  const auto value = number(row, column);
  if (!value || !std::isfinite(*value)) fail(row, format("column \"%s\" needs a number", std::string(column).c_str()));
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
  throw DataError{{.message = message, .place = format("%s:%d", path_.string().c_str(), row.line)}};
}

}  // namespace physim::validation
