#include "report/table.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace physim::report {
namespace {

std::string padded(const std::string& text, std::size_t width, bool is_left) {
  PHYSIM_ASSERT(display_width(text) <= width);
  const std::string space(width - display_width(text), ' ');
  return is_left ? text + space : space + text;
}

std::string markdown_cell(const std::string& text) {
  std::string out = " ";
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out + " |";
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

}  // namespace

std::size_t display_width(const std::string& text) {
  bool in_escape = false;  // a colour sequence has no width
  std::size_t width = 0;
  for (const char c : text) {
    if (c == '\033') in_escape = true;
    if (!in_escape && !continues_character(c)) ++width;
    if (in_escape && c == 'm') in_escape = false;
  }
  return width;
}

std::string one_line(const std::string& text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  std::string out, space;
  for (const char c : text) {
    if (is_control(c)) {
      space = '\n';  // the run of spaces that it is in becomes one
    } else if (c == ' ') {
      space += space == "\n" ? "" : " ";
    } else {
      if (!out.empty()) out += space == "\n" ? " " : space;
      space.clear();
      out += c;
    }
  }
  return out;
}

std::string shortened(const std::string& text, std::size_t characters) {
  if (display_width(text) <= characters) return text;
  std::size_t width = 0, end = 0;
  for (; end < text.size(); ++end)
    if (!continues_character(text[end]) && ++width >= characters) break;
  PHYSIM_ASSERT(end < text.size());
  return text.substr(0, end) + "…";
}

Table::Table(std::vector<std::string> headers, std::string_view align) : headers_(std::move(headers)), align_(align) {
  PHYSIM_ASSERT(align_.size() <= headers_.size());
  PHYSIM_ASSERT(align_.find_first_not_of("lr") == std::string::npos);
}

void Table::add_row(std::vector<std::string> cells) {
  PHYSIM_ASSERT(cells.size() <= headers_.size());
  rows_.push_back(std::move(cells));
}

std::string Table::text(int indent) const {
  std::vector<std::size_t> widths(headers_.size());
  // The last cell of a row that ends early runs over the columns behind it.
  const auto spans = [&](const std::vector<std::string>& cells, std::size_t i) {
    return i + 1 == cells.size() && cells.size() < headers_.size();
  };
  const auto widen = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (!spans(cells, i)) widths[i] = std::max(widths[i], display_width(cells[i]));
  };
  widen(headers_);
  for (const auto& row : rows_) widen(row);
  std::string out;
  const auto add_line = [&](const std::vector<std::string>& cells) {
    std::string line(static_cast<std::size_t>(indent), ' ');
    for (std::size_t i = 0; i < cells.size(); ++i)
      line += (i == 0 ? "" : "  ") + (spans(cells, i) ? cells[i] : padded(cells[i], widths[i], is_left(i)));
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  add_line(headers_);
  for (const auto& row : rows_) add_line(row);
  return out;
}

std::string Table::markdown() const {
  std::string head = "|", rule = "|", body;
  for (std::size_t i = 0; i < headers_.size(); ++i) {
    head += markdown_cell(headers_[i]);
    rule += is_left(i) ? "---|" : "---:|";
  }
  for (const auto& row : rows_) {
    body += "|";
    for (const std::string& cell : row) body += markdown_cell(cell);
    body += "\n";
  }
  return head + "\n" + rule + "\n" + body;
}

}  // namespace physim::report
