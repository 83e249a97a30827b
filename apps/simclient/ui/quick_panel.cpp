#include "simclient/ui/quick_panel.hpp"

#include <algorithm>
#include <cmath>

#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

void tell(Client& client, const Status& status) {
  if (!status) client.complain(status.error());
}

/// Digits that a slider of this reach can tell apart, with its unit.
std::string format_of(const QuickSetting& setting) {
  const double reach = setting.is_logarithmic ? std::abs(setting.value) : setting.high - setting.low;
  const bool is_tiny = reach > 0 && reach < 0.1;  // two digits of it are shown
  const int two = is_tiny ? std::min(1 - static_cast<int>(std::floor(std::log10(reach))), 9) : 2;
  const int digits = reach >= 400 ? 0 : reach >= 20 ? 1 : two;
  return "%." + std::to_string(digits) + "f" + (setting.unit == "\u00b0" ? "" : " ") + setting.unit;
}

void write_label(const std::string& name, float label, bool is_idle) {
  ImGui::AlignTextToFramePadding();
  if (is_idle)
    ImGui::TextDisabled("%s", name.c_str());
  else
    ImGui::TextUnformatted(name.c_str());
  ImGui::SameLine(label);
  ImGui::SetNextItemWidth(-1);
}

/// What was granted instead of what was asked for, and why.
void draw_notes(Client& client) {
  constexpr std::size_t kMost = 2;
  std::size_t told = 0;
  const std::vector<FidelityNote>& notes = client.prediction().granted.notes;
  for (auto note = notes.begin(); note != notes.end() && told < kMost; ++note) {
    const auto has_same_effect = [&](const FidelityNote& later) { return later.effect == note->effect; };
    if (std::any_of(note + 1, notes.end(), has_same_effect)) continue;  // the last one says what flies
    coloured_text(colours::kWarning, note->effect + ": granted " + note->granted + ", " + note->reason);
    ++told;
  }
}

}  // namespace

void QuickPanel::draw(Client& client) {
  const float label = std::min(ImGui::GetFontSize() * 8.4F, ImGui::GetWindowWidth() * 0.5F);
  client.slide = 0;
  draw_accuracy(client, label);
  for (const QuickSetting& setting : quick_settings(client)) draw_slider(client, setting, label);
  draw_notes(client);
  ImGui::Dummy({0, ImGui::GetStyle().ItemSpacing.y});
}

void QuickPanel::note_slide(Client& client) {
  slides_ += ImGui::IsItemActivated();
  if (ImGui::IsItemActive()) client.slide = slides_;
}

void QuickPanel::draw_slider(Client& client, const QuickSetting& setting, float label) {
  ImGui::PushID(static_cast<int>(setting.what));
  write_label(setting.name, label, !setting.idle.empty());
  const std::string note = setting.doc + (setting.idle.empty() ? "" : "\n" + setting.idle);
  tooltip(note);
  if (setting.what == Quick::drag) {
    bool is_on = setting.value > 0.5;
    if (ImGui::Checkbox("##value", &is_on)) tell(client, set_quick(client, setting, is_on ? 1 : 0));
  } else {
    const bool is_wind = setting.what == Quick::wind_along || setting.what == Quick::wind_across;
    double value = held_ == setting.what ? dragged_ : setting.value;
    const ImGuiSliderFlags flags = setting.is_logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    const bool has_moved = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &setting.low, &setting.high,
                                               format_of(setting).c_str(), flags);
    note_slide(client);
    if (has_moved && is_wind) held_ = setting.what, dragged_ = value;
    if (has_moved && !is_wind) tell(client, set_quick(client, setting, value));
    if (held_ == setting.what && !ImGui::IsItemActive()) {
      held_.reset();
      tell(client, set_quick(client, setting, dragged_));
    }
  }
  tooltip(note + (setting.what == Quick::drag ? "" : "\nCtrl and a click: a number"));
  ImGui::PopID();
}

void QuickPanel::draw_accuracy(Client& client, float label) {
  const Accuracy now = accuracy_of(client.launcher.shot().projectile.fidelity);
  const std::span<const AccuracyRung> rungs = accuracy_rungs();
  const bool is_original = client.launcher.is_original();
  write_label("accuracy", label, false);
  int rung = static_cast<int>(now.rung);
  const std::string shown =
      is_original ? "the original" : (now.is_preset ? "" : "~ ") + std::string(rungs[now.rung].label);
  const bool has_moved = ImGui::SliderInt("##accuracy", &rung, 0, static_cast<int>(rungs.size()) - 1, shown.c_str(),
                                          ImGuiSliderFlags_NoInput);
  note_slide(client);
  if (has_moved) tell(client, set_accuracy(client, static_cast<std::size_t>(rung)));
  tooltip("from arcade to simulation\n" + std::string(rungs[now.rung].label) + ": " + std::string(rungs[now.rung].doc) +
          (now.is_preset ? "" : "\nSome settings differ from it: search for fidelity."));
}

}  // namespace physim::client
