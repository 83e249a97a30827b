#include "simclient/ui/fitting_table.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {

FittingTable::FittingTable(std::span<const TableColumn> columns, const std::vector<TableRow>& rows)
    : columns_(columns) {
  constexpr std::size_t kMeasured = 64;
  const ImGuiStyle& style = ImGui::GetStyle();
  std::vector<float> widths;
  std::vector<int> ranks;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    float wide = ImGui::CalcTextSize(columns[c].title).x;
    for (std::size_t i = 0; i < std::min(rows.size(), kMeasured); ++i)
      wide = std::max(wide, ImGui::CalcTextSize(rows[i].at(c).c_str()).x);
    widths.push_back(wide + 2 * style.CellPadding.x + 1);
    ranks.push_back(columns[c].rank);
  }
  shown_ = columns_that_fit(widths, ranks, ImGui::GetContentRegionAvail().x - style.ScrollbarSize);
}

bool FittingTable::begin(const char* id) const {
  const ImGuiTableFlags flags =
      ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable(id, static_cast<int>(shown_.size()), flags)) return false;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const std::size_t c : shown_)
    ImGui::TableSetupColumn(columns_[c].title,
                            columns_[c].wraps ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_None);
  ImGui::TableHeadersRow();
  return true;
}

std::string FittingTable::hidden(const TableRow& row) const {
  std::string text;
  for (std::size_t c = 0; c < columns_.size(); ++c)
    if (!row.at(c).empty() && std::ranges::find(shown_, c) == shown_.end())
      text += (text.empty() ? "" : "\n") + std::string(columns_[c].title) + ": " + row[c];
  return text;
}

}  // namespace physim::client
