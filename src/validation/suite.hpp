// What the suites share: what a suite is, and tools to judge its figures.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physim/flight.hpp"
#include "physim/result.hpp"
#include "validation/validate.hpp"

namespace physim::validation {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180;  ///< [rad]

/// Data that cannot be read, with its place: "file:line".
struct DataError {
  Error error;
};

/// A row of a table.
struct CsvRow {
  int line = 0;  ///< in the file, from 1
  std::vector<std::string> fields;
};

/// A table of figures: CSV with a header, '#' comments, and errors that name file and line.
class CsvFile {
 public:
  /// Reads a file; throws DataError.
  [[nodiscard]] static CsvFile read(const std::filesystem::path& path);

  [[nodiscard]] const std::vector<CsvRow>& rows() const { return rows_; }
  /// All comments, a space between lines, without '#'.
  [[nodiscard]] const std::string& comments() const { return comments_; }
  [[nodiscard]] std::string name() const { return path_.filename().string(); }
  /// Its name without the ending.
  [[nodiscard]] std::string stem() const { return path_.stem().string(); }

  [[nodiscard]] bool has(std::string_view column) const { return index_of(column).has_value(); }
  /// Throws DataError where a column is missing.
  void require(std::initializer_list<std::string_view> columns) const;

  /// A field as it stands; empty where there is none.
  [[nodiscard]] const std::string& text(const CsvRow& row, std::string_view column) const;
  /// A number; nothing where the field is empty or missing. Throws DataError where it is not a number.
  [[nodiscard]] std::optional<double> number(const CsvRow& row, std::string_view column) const;
  /// A finite number that must be there.
  [[nodiscard]] double needed(const CsvRow& row, std::string_view column) const;
  /// A constant that the comments state, as in "g=9.80665".
  [[nodiscard]] double constant(std::string_view name, double otherwise) const;
  /// Throws DataError with the place of the row.
  [[noreturn]] void fail(const CsvRow& row, const std::string& message) const;

 private:
  [[nodiscard]] std::optional<std::size_t> index_of(std::string_view column) const;
  void add_line(std::string line, int number);
  void add_row(std::vector<std::string> fields, int number);

  std::filesystem::path path_;
  std::string comments_;
  std::vector<std::string> columns_;
  int header_line_ = 0;
  std::vector<CsvRow> rows_;
};

[[nodiscard]] std::string lower(std::string text);
/// The first number behind a word in a text, as in "QE45": digits and a point.
[[nodiscard]] std::optional<double> number_after(const std::string& text, const std::string& word);
/// A whole text as a number, in the C locale.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);
/// One unit of the last digit that a number shows: "1.250" 0.001, "38" 1, "1.2e-5" 1e-6.
[[nodiscard]] double last_digit_unit(std::string_view text);

/// A suite: its name, what it shows, the folder it lives in, the files that tell such a folder, and how to run it.
struct Suite {
  std::string_view name;
  std::string_view title;
  std::string_view gate;    ///< in words
  std::string_view folder;  ///< in the reference collection
  std::span<const std::string_view> files;
  void (*run)(const std::filesystem::path& folder, SuiteResult& result);
};

extern const Suite kClassicSuite;
extern const Suite kAnalyticSuite;
extern const Suite kUs76Suite;
extern const Suite kGravitySuite;
extern const Suite kBallisticsSuite;
extern const Suite kNescSuite;
extern const Suite kMccoySuite;
extern const Suite kSportsSuite;

/// All suites, in the order they run.
[[nodiscard]] std::span<const Suite* const> all_suites();
/// The suite of a name, or none.
[[nodiscard]] const Suite* find_suite(std::string_view name);

/// printf into a string.
[[nodiscard]] [[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);
/// Reads the tables of a folder. Those that `compare` does not know, for which it gives false, are skipped; `otherwise`
/// says why.
void compare_tables(const std::filesystem::path& folder, std::span<const std::string_view> known, const char* otherwise,
                    SuiteResult& result, const std::function<bool(const CsvFile&, SuiteResult&)>& compare);
/// Files of a folder with an extension, by name; those of `known` that are there come first, in that order.
[[nodiscard]] std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder,
                                                          std::span<const std::string_view> known,
                                                          std::string_view extension);
/// Why a flight cannot be judged: refused, ended otherwise than it should, or not flown the way that was asked for.
/// Empty: it can.
[[nodiscard]] std::string complaint(const Flight& flight, const Fidelity& asked);

}  // namespace physim::validation
