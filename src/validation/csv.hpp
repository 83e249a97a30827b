// Tables of published figures: CSV, and numbers as they are printed.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physim/result.hpp"

namespace physim::validation {

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

  /// The text of a field; empty if the file has no such column.
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
  void add_line(std::string_view line, int number);
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

}  // namespace physim::validation
