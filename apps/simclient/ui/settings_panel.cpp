#include "simclient/ui/settings_panel.hpp"

#include <imgui_stdlib.h>

#include <algorithm>

#include "simclient/core/folder.hpp"

namespace physim::client {
namespace {

const FidelityNote* note_of(const Prediction& prediction, const std::string& effect) {
  for (const FidelityNote& note : prediction.granted.notes)
    if (note.effect == effect) return &note;
  return nullptr;
}

std::string title_of(const std::string& group, bool is_shot) {
  if (!group.empty()) return group;
  return is_shot ? "projectile and launch" : "place";
}

}  // namespace

SettingsPanel::SettingsPanel() {
  shot_.rows = setting_rows("shot");
  environment_.rows = setting_rows("environment");
}

void SettingsPanel::draw(Client& client, const Box& box) {
  client.settings_height = 0;
  const bool is_drawn = begin_panel("Settings###settings", box);
  const bool is_narrow = ImGui::GetContentRegionAvail().x < ImGui::GetFontSize() * 17;
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {is_narrow ? padding.x / 3 : padding.x, padding.y});
  const bool has_tabs = is_drawn && ImGui::BeginTabBar("what");
  ImGui::PopStyleVar();
  if (has_tabs) {
    if (ImGui::BeginTabItem(is_narrow ? "Shot###shot" : "Next shot###shot")) {
      draw_shot(client);
      ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Environment")) {
      ImGui::TextWrapped("Changes hold at once, for all in flight too.");
      draw_sheet(client, environment_, false);
      ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("In flight")) {
      flight_.draw(client);
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  end_panel();
}

void SettingsPanel::draw_shot(Client& client) {
  if (client.session.is_replay()) return ImGui::TextWrapped("A replay fires by itself.");
  draw_type(client);
  const Prediction& prediction = client.prediction();
  if (prediction.error) coloured_text(colours::kWarning, prediction.error->text());
  draw_sheet(client, shot_, true);
}

void SettingsPanel::draw_type(Client& client) {
  const auto types = client.launcher.types();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##type", types[client.launcher.type()].name.c_str(), ImGuiComboFlags_HeightLarge)) {
    for (std::size_t i = 0; i < types.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (ImGui::Selectable(types[i].name.c_str(), i == client.launcher.type())) client.launcher.select(i);
      tooltip(types[i].doc);
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  tooltip(types[client.launcher.type()].doc + "\nSettings hold for this shot only, from the moment it is fired.");
}

// ---------------------------------------------------------------------------------------------------------------- rows
void SettingsPanel::draw_sheet(Client& client, Sheet& sheet, bool is_shot) {
  const Launcher& launcher = client.launcher;
  if (sheet.version != launcher.version()) {
    sheet.version = launcher.version();
    editor_.accept();
    sheet.values.clear();
    sheet.usual.clear();
    for (const SettingRow& row : sheet.rows) {
      const Scenario& scenario = client.session.scenario();
      sheet.values.push_back(row_text(row, scenario, launcher.shot(), client.units()).value_or(""));
      const ScenarioShot& usual = launcher.types()[launcher.type()].shot;
      sheet.usual.push_back(is_shot ? row_text(row, scenario, usual, client.units()).value_or("")
                                    : sheet.values.back());
    }
  }
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##filter", is_shot ? "search all settings" : "search settings", &filter_);
  const float above = ImGui::GetCursorScreenPos().y - ImGui::GetWindowPos().y;
  if (ImGui::BeginChild("rows")) {
    const bool is_brief = is_shot && filter_.empty();
    if (is_brief) quick_.draw(client);
    if (!is_brief || ImGui::CollapsingHeader("All settings")) draw_groups(client, sheet, is_shot);
    client.settings_height = above + ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
  }
  ImGui::EndChild();
}

void SettingsPanel::draw_groups(Client& client, const Sheet& sheet, bool is_shot) {
  if (std::ranges::none_of(sheet.rows, [&](const SettingRow& row) { return passes(row); }))
    ImGui::TextWrapped("No setting has this in its name or in what it says.");
  std::vector<std::string> groups;
  for (const SettingRow& row : sheet.rows)
    if (std::find(groups.begin(), groups.end(), row.group) == groups.end()) groups.push_back(row.group);
  std::stable_partition(groups.begin(), groups.end(), [](const std::string& g) { return g == "fidelity"; });
  for (const std::string& group : groups) draw_group(client, sheet, group, is_shot);
}

bool SettingsPanel::passes(const SettingRow& row) const { return passes_filter(row.path + " " + row.doc, filter_); }

void SettingsPanel::draw_group(Client& client, const Sheet& sheet, const std::string& group, bool is_shot) {
  const bool is_filled = std::any_of(sheet.rows.begin(), sheet.rows.end(),
                                     [&](const SettingRow& row) { return row.group == group && passes(row); });
  const bool starts_open = group.empty() || group == "fidelity" || group == "drag";
  if (!is_filled) return;
  if (!filter_.empty()) ImGui::SetNextItemOpen(true);
  if (!ImGui::CollapsingHeader(title_of(group, is_shot).c_str(), starts_open ? ImGuiTreeNodeFlags_DefaultOpen : 0))
    return;
  for (std::size_t i = 0; i < sheet.rows.size(); ++i)
    if (sheet.rows[i].group == group && passes(sheet.rows[i]))
      draw_row(client, sheet.rows[i], sheet.values[i], sheet.values[i] != sheet.usual[i]);
}

void SettingsPanel::draw_row(Client& client, const SettingRow& row, const std::string& value, bool is_changed) {
  ImGui::PushID(row.path.c_str());
  if (const auto entered = editor_.draw(row, value, is_changed)) {
    if (Status status = client.set(row, *entered); !status)
      editor_.refuse(row, *entered, status.error()), client.complain(status.error());
    else
      editor_.accept(row);
  }
  const FidelityNote* note = row.group == "fidelity" ? note_of(client.prediction(), row.name) : nullptr;
  if (note != nullptr) coloured_text(colours::kWarning, "granted " + note->granted + ": " + note->reason);
  ImGui::PopID();
}

}  // namespace physim::client
