// The report: sections with a table each, printed as text, Markdown or JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace physim::bench {

/// What a table shows, and the number behind it.
struct Cell {
  std::string text;
  std::optional<double> value;

  Cell(std::string words) : text(std::move(words)) {}  // NOLINT: a text is a cell
  Cell(const char* words) : text(words) {}             // NOLINT
  Cell(std::string words, double number) : text(std::move(words)), value(number) {}
};

struct Section {
  std::string title;
  std::string intro;
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
  std::vector<std::string> notes;
};

struct Report {
  std::vector<std::pair<std::string, std::string>> facts;  // "processor", "AMD ..."
  std::vector<Section> sections;
};

[[nodiscard]] Cell fixed(double value, int digits);  ///< 12.3
[[nodiscard]] Cell times(double value);              ///< 12.3x
[[nodiscard]] Cell percent(double part);             ///< 63 %
[[nodiscard]] Cell rate(double per_second);          ///< 2.24 M, 244 k
[[nodiscard]] Cell metres(double value);             ///< 0.98 mm, 0.91 um
[[nodiscard]] Cell power(double value);              ///< 1.8e-07

[[nodiscard]] std::string as_text(const Section& section);
[[nodiscard]] std::string as_text(const Report& report);
[[nodiscard]] std::string as_markdown(const Report& report, const std::string& command);
[[nodiscard]] std::string as_json(const Report& report);

/// Columns of letters as wide as a terminal shows them, not as many bytes.
[[nodiscard]] std::size_t shown_width(const std::string& utf8);

}  // namespace physim::bench
