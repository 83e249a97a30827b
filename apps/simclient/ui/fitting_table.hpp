// A table that is no wider than its window. If the columns do not fit, those of the lowest rank are hidden, and a
// tooltip shows their values.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace physim::client {

struct TableColumn {
  const char* title;
  int rank;            // 0: stays; the highest gives way first
  bool wraps = false;  // its lines break where there is no room
};
using TableRow = std::vector<std::string>;

class FittingTable {
 public:
  /// Measures the first rows.
  FittingTable(std::span<const TableColumn> columns, const std::vector<TableRow>& rows);
  /// False: there is no room for a table. Else ImGui::EndTable() follows.
  [[nodiscard]] bool begin(const char* id) const;
  /// The numbers of the columns that are there.
  [[nodiscard]] const std::vector<std::size_t>& shown() const { return shown_; }
  /// The cells of a row that gave way, a line each: "range [m]: 253.03".
  [[nodiscard]] std::string hidden(const TableRow& row) const;

 private:
  std::span<const TableColumn> columns_;
  std::vector<std::size_t> shown_;
};

}  // namespace physim::client
