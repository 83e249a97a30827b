// A table of aligned text columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace physim::report {

class Table {
 public:
  /// `align` has a letter for each column, l for left or r for right; columns beyond its end stand on the right.
  explicit Table(std::vector<std::string> headers, std::string_view align = {});

  /// One cell for each column; fewer leave the rest empty.
  void add_row(std::vector<std::string> cells);
  [[nodiscard]] bool empty() const { return rows_.empty(); }

  /// Header and rows, each line indented, two spaces between columns.
  [[nodiscard]] std::string text(int indent = 0) const;
  /// Header and rows as a Markdown table.
  [[nodiscard]] std::string markdown() const;

 private:
  [[nodiscard]] bool is_left(std::size_t column) const { return column < align_.size() && align_[column] == 'l'; }

  std::vector<std::string> headers_;
  std::string align_;
  std::vector<std::vector<std::string>> rows_;
};

/// Characters of a UTF-8 text as a terminal counts them.
[[nodiscard]] std::size_t display_width(const std::string& text);

/// A text of someone else's as a single line: control characters, with the spaces around them, become one space. None
/// at its ends.
[[nodiscard]] std::string one_line(const std::string& text);

/// The first characters of a UTF-8 text and "…" if it is longer than `characters`.
[[nodiscard]] std::string shortened(const std::string& text, std::size_t characters);

}  // namespace physim::report
