#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace physim::bench {
namespace {

std::string print(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string three_digits(double value) { return print(value >= 100 ? "%.0f" : value >= 10 ? "%.1f" : "%.2f", value); }

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, shown_width(text)), ' ');
  return right ? space + text : text + space;
}

std::vector<std::size_t> widths(const Section& s) {
  std::vector<std::size_t> width;
  for (std::size_t column = 0; column < s.columns.size(); ++column) {
    std::size_t w = shown_width(s.columns[column]);
    for (const auto& row : s.rows) w = std::max(w, shown_width(row[column].text));
    width.push_back(w);
  }
  return width;
}

/// Columns of numbers are flushed right.
bool is_number(const Section& s, std::size_t column) {
  return std::any_of(s.rows.begin(), s.rows.end(), [&](const auto& row) { return row[column].value.has_value(); });
}

std::string markdown_table(const Section& s) {
  const auto width = widths(s);
  std::string out = "|";
  for (std::size_t i = 0; i < s.columns.size(); ++i) out += " " + padded(s.columns[i], width[i], false) + " |";
  out += "\n|";
  for (std::size_t i = 0; i < s.columns.size(); ++i)
    out += std::string(width[i] + 1, '-') + (is_number(s, i) ? ":|" : "-|");
  out += "\n";
  for (const auto& row : s.rows) {
    out += "|";
    for (std::size_t i = 0; i < row.size(); ++i) out += " " + padded(row[i].text, width[i], is_number(s, i)) + " |";
    out += "\n";
  }
  return out;
}

}  // namespace

Cell fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return {text, value};
}
Cell times(double value) { return {three_digits(value) + "x", value}; }
Cell percent(double part) { return {print("%.0f %%", 100 * part), part}; }
Cell rate(double per_second) {
  if (per_second >= 1e6) return {three_digits(per_second * 1e-6) + " M", per_second};
  return {three_digits(per_second * 1e-3) + " k", per_second};
}
Cell metres(double value) {
  if (value >= 1) return {three_digits(value) + " m", value};
  if (value >= 1e-4) return {three_digits(value * 1e3) + " mm", value};
  if (value >= 1e-7) return {three_digits(value * 1e6) + " um", value};
  return {three_digits(value * 1e9) + " nm", value};
}
Cell power(double value) { return {print("%.1e", value), value}; }

std::size_t shown_width(const std::string& utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string as_text(const Section& s) {
  const auto width = widths(s);
  std::string out = "\n" + s.title + "\n" + (s.intro.empty() ? "" : s.intro + "\n");
  for (std::size_t i = 0; i < s.columns.size(); ++i) out += padded(s.columns[i], width[i], is_number(s, i)) + "  ";
  out += "\n";
  for (const auto& row : s.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out += padded(row[i].text, width[i], is_number(s, i)) + "  ";
    out += "\n";
  }
  for (const std::string& note : s.notes) out += "  " + note + "\n";
  return out;
}

std::string as_text(const Report& report) {
  std::string out;
  for (const auto& [name, value] : report.facts) out += padded(name, 12, false) + value + "\n";
  for (const Section& section : report.sections) out += as_text(section);
  return out;
}

std::string as_markdown(const Report& report, const std::string& command) {
  std::string out = "# Benchmarks\n\nMade by `" + command + "`; do not edit.\n\n";
  for (const auto& [name, value] : report.facts) out += "- " + name + ": " + value + "\n";
  for (const Section& s : report.sections) {
    out += "\n## " + s.title + "\n\n";
    if (!s.intro.empty()) out += s.intro + "\n\n";
    out += markdown_table(s);
    if (!s.notes.empty()) out += "\n";
    for (const std::string& note : s.notes) out += "- " + note + "\n";
  }
  return out;
}

std::string as_json(const Report& report) {
  std::string out = "{\n";
  for (const auto& [name, value] : report.facts) out += "  " + quoted(name) + ": " + quoted(value) + ",\n";
  out += "  \"sections\": [";
  for (std::size_t k = 0; k < report.sections.size(); ++k) {
    const Section& s = report.sections[k];
    out += (k ? ",\n    {" : "\n    {") + ("\"title\": " + quoted(s.title)) + ", \"rows\": [";
    for (std::size_t i = 0; i < s.rows.size(); ++i) {
      out += i ? ",\n      {" : "\n      {";
      for (std::size_t j = 0; j < s.rows[i].size(); ++j) {
        const Cell& cell = s.rows[i][j];
        const bool number = cell.value && std::isfinite(*cell.value);
        out +=
            (j ? ", " : "") + quoted(s.columns[j]) + ": " + (number ? print("%.9g", *cell.value) : quoted(cell.text));
      }
      out += "}";
    }
    out += "]}";
  }
  return out + "\n  ]\n}\n";
}

}  // namespace physim::bench
