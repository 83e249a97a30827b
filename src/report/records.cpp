#include "report/records.hpp"

#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "report/json.hpp"
#include "report/number.hpp"

namespace physim::report {
namespace {

/// A value of a CSV file, in quotes where it needs them.
std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string csv_cell(const Cell& cell) {
  if (const auto* text = std::get_if<std::string_view>(&cell)) return csv_field(*text);
  if (const auto* number = std::get_if<double>(&cell)) return shortest(*number);
  return std::to_string(std::get<std::uint64_t>(cell));
}

}  // namespace

std::string csv_text(const Records& records) {
  std::string out;
  for (const std::string& column : records.columns) out += (out.empty() ? "" : ", ") + csv_field(column);
  out += "\n";
  records.rows([&](Row row) {
    PHYSIM_ASSERT(row.size() == records.columns.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out += ", ";
      out += csv_cell(row[i]);
    }
    out += "\n";
  });
  return out;
}

nlohmann::ordered_json columns_json(const Records& records) {
  std::vector<nlohmann::ordered_json> lists(records.columns.size(), nlohmann::ordered_json::array());
  records.rows([&](Row row) {
    PHYSIM_ASSERT(row.size() == lists.size());
    for (std::size_t i = 0; i < row.size(); ++i)
      std::visit([&list = lists[i]](const auto& value) { list.push_back(value); }, row[i]);
  });
  nlohmann::ordered_json out;
  for (std::size_t i = 0; i < lists.size(); ++i) out[records.columns[i]] = std::move(lists[i]);
  return out;
}

std::string columns_json_text(const Records& records) { return json_text(columns_json(records)); }

}  // namespace physim::report
