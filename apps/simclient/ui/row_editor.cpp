#include "simclient/ui/row_editor.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

std::optional<std::string> draw_choice(const SettingRow& row, const std::string& value) {
  std::optional<std::string> chosen;
  if (!ImGui::BeginCombo("##value", value.empty() ? "choose" : value.c_str(), ImGuiComboFlags_HeightLarge))
    return chosen;
  for (std::size_t i = 0; i < row.choices.size(); ++i) {
    const std::string name(row.choices[i]);
    if (ImGui::Selectable(name.c_str(), name == value)) chosen = name;
    if (!row.choice_docs.empty()) tooltip(std::string(row.choice_docs[i]));
  }
  ImGui::EndCombo();
  return chosen;
}

std::optional<std::string> draw_box(const std::string& value) {
  bool on = value == "true";
  if (!ImGui::Checkbox("##value", &on)) return std::nullopt;
  return on ? "true" : "false";
}

}  // namespace

std::optional<std::string> RowEditor::draw(const SettingRow& row, const std::string& value, bool is_changed) {
  const float label = std::min(ImGui::GetFontSize() * 8.4F, ImGui::GetWindowWidth() * 0.5F);
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(tint(is_changed ? colours::kForce : colours::kText), "%s", row.name.c_str());
  tooltip(row.tooltip());
  if (ImGui::CalcTextSize(row.name.c_str()).x < label - ImGui::GetFontSize() * 0.5F) ImGui::SameLine(label);
  ImGui::SetNextItemWidth(-1);
  const auto refused = refused_.find(row.path);
  const bool is_refused = refused != refused_.end();
  const std::string why = is_refused ? refused->second.why + "\n\n" : "";
  if (is_refused) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 2);
    ImGui::PushStyleColor(ImGuiCol_Border, tint(colours::kAcceleration));
    ImGui::PushStyleColor(ImGuiCol_Text, tint(colours::kAcceleration));
  }
  const auto entered = row.kind == SettingRow::Kind::choice    ? draw_choice(row, value)
                       : row.kind == SettingRow::Kind::boolean ? draw_box(value)
                                                               : draw_text(row, value);
  if (is_refused) {
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar();
  }
  tooltip(why + row.tooltip());
  return entered;
}

void RowEditor::refuse(const SettingRow& row, const std::string& entered, const Error& why) {
  refused_[row.path] = {entered, why.message + (why.hint.empty() ? "" : "; " + why.hint)};
}

std::optional<std::string> RowEditor::draw_text(const SettingRow& row, const std::string& value) {
  const auto refused = refused_.find(row.path);
  const std::string at_rest = refused != refused_.end() ? refused->second.entered : value;
  std::string shown = editing_ == row.path ? typed_ : at_rest;
  ImGui::InputText("##value", &shown);
  if (ImGui::IsItemActivated()) editing_ = row.path;
  if (editing_ == row.path) typed_ = shown;
  if (!ImGui::IsItemDeactivated() || editing_ != row.path) return std::nullopt;
  editing_.clear();
  if (typed_ == value) refused_.erase(row.path);  // as it was
  return typed_ != at_rest && typed_ != value ? std::optional(typed_) : std::nullopt;
}

}  // namespace physim::client
