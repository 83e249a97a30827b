// A table of aligned text columns.
#pragma once

#include <string>
#include <vector>

namespace physim::report {

enum class Align { left, right };

struct Column {
  std::string header;
  Align align = Align::right;
};

class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// One cell for each column; fewer leave the rest empty.
  void add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
  [[nodiscard]] bool empty() const { return rows_.empty(); }

  /// Header and rows, each line indented, two spaces between columns.
  [[nodiscard]] std::string text(int indent = 0) const;
  /// Header and rows as a Markdown table.
  [[nodiscard]] std::string markdown() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Characters of a UTF-8 text as a terminal counts them.
[[nodiscard]] std::size_t display_width(const std::string& text);

/// A text of someone else's as a single line: control characters, with the spaces around them, become one space. None
/// at its ends.
[[nodiscard]] std::string one_line(const std::string& text);

/// The first characters of a UTF-8 text and "…" where it is longer than so many.
[[nodiscard]] std::string shortened(const std::string& text, std::size_t characters);

}  // namespace physim::report
