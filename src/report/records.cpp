#include "report/records.hpp"

#include "base/assert.hpp"
#include "report/json_stream.hpp"
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
  if (std::holds_alternative<std::monostate>(cell)) return {};
  if (const auto* text = std::get_if<std::string_view>(&cell)) return csv_field(*text);
  if (const auto* number = std::get_if<double>(&cell)) return shortest(*number);
  return std::to_string(std::get<std::uint64_t>(cell));
}

}  // namespace

Text csv_text(Records records) {
  return [records = std::move(records)](const Sink& sink) {
    std::string line;
    for (const std::string& column : records.columns) line += (line.empty() ? "" : ",") + csv_field(column);
    sink(line + "\n");
    records.rows([&](Row row) {
      PHYSIM_ASSERT(row.size() == records.columns.size());
      line.clear();
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (i > 0) line += ',';
        line += csv_cell(row[i]);
      }
      sink(line += "\n");
    });
  };
}

Text columns_json(Records records) {
  return [records = std::move(records)](const Sink& sink) {
    JsonStream out(sink);
    out.object();
    add_columns(out, records);
    out.close();
  };
}

}  // namespace physim::report
