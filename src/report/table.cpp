#include "report/table.hpp"

#include <algorithm>

namespace physim::report {
namespace {

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string space(width - std::min(width, display_width(text)), ' ');
  return align == Align::left ? text + space : space + text;
}

std::string without_trailing_space(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string markdown_cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

}  // namespace

std::size_t display_width(const std::string& text) {
  bool in_escape = false;  // a colour sequence has no width
  std::size_t width = 0;
  for (const char c : text) {
    if (c == '\033') in_escape = true;
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
    if (!in_escape && !continues) ++width;
    if (in_escape && c == 'm') in_escape = false;
  }
  return width;
}

std::string one_line(const std::string& text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;  // of a run of spaces and control characters
    while (end < text.size() && (text[end] == ' ' || is_control(text[end]))) ++end;
    const bool has_control = std::any_of(text.begin() + static_cast<std::ptrdiff_t>(i),
                                         text.begin() + static_cast<std::ptrdiff_t>(end), is_control);
    const bool is_inside = !out.empty() && end < text.size();
    if (is_inside) out.append(has_control ? 1 : end - i, ' ');
    i = end;
    if (i < text.size()) out += text[i++];
  }
  return out;
}

std::string shortened(const std::string& text, std::size_t characters) {
  if (display_width(text) <= characters) return text;
  std::size_t width = 0, end = 0;
  for (; end < text.size(); ++end) {
    const bool starts = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
    if (starts && ++width >= characters) break;
  }
  return text.substr(0, end) + "…";
}

std::string Table::text(int indent) const {
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::size_t width = display_width(columns_[i].header);
    for (const auto& row : rows_)
      if (i < row.size()) width = std::max(width, display_width(row[i]));
    widths.push_back(width);
  }
  const auto line = [&](const auto& cell_of) {
    std::string out(static_cast<std::size_t>(indent), ' ');
    for (std::size_t i = 0; i < columns_.size(); ++i)
      out += (i == 0 ? "" : "  ") + padded(cell_of(i), widths[i], columns_[i].align);
    return without_trailing_space(out) + "\n";
  };
  std::string out = line([&](std::size_t i) { return columns_[i].header; });
  for (const auto& row : rows_) out += line([&](std::size_t i) { return i < row.size() ? row[i] : std::string(); });
  return out;
}

std::string Table::markdown() const {
  std::string head = "|", rule = "|", body;
  for (const Column& column : columns_) {
    head += " " + markdown_cell(column.header) + " |";
    rule += column.align == Align::right ? "---:|" : "---|";
  }
  for (const auto& row : rows_) {
    body += "|";
    for (const std::string& cell : row) body += " " + markdown_cell(cell) + " |";
    body += "\n";
  }
  return head + "\n" + rule + "\n" + body;
}

}  // namespace physim::report
