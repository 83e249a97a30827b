#include "simclient/ui/gallery_panel.hpp"

#include <imgui_stdlib.h>

#include <algorithm>

#include "simclient/core/actions.hpp"
#include "simclient/ui/painter.hpp"

namespace physim::client {
namespace {

constexpr const char* kTitle = "Gallery: choose what flies";

void choose(Client& client, const GalleryItem& item) {
  client.dialog = Dialog::none;
  ImGui::CloseCurrentPopup();
  run_action(client, *find_action("gallery"), std::string(item.scenario));
}

}  // namespace

void GalleryPanel::draw(Client& client, const Box& box, float scale) {
  const bool is_wanted = client.dialog == Dialog::gallery;
  if (!is_wanted && !shown_) return;
  const bool has_just_opened = is_wanted && !shown_;
  shown_ = is_wanted;
  if (has_just_opened) filter_.clear(), ImGui::OpenPopup(kTitle);
  const float margin = 24 * scale;
  centre_window(box, box.width - 2 * margin, box.height - 2 * margin);
  bool stays = true;
  if (!ImGui::BeginPopupModal(kTitle, &stays, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings)) {
    if (!has_just_opened && is_wanted) client.dialog = Dialog::none, shown_ = false;
    return;
  }
  if (!stays || !is_wanted) {
    if (is_wanted) client.dialog = Dialog::none;
    shown_ = false;
    ImGui::CloseCurrentPopup();
    return ImGui::EndPopup();
  }
  const float button = ImGui::CalcTextSize("Open range (Esc)").x + 3 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(-1 - button);
  if (has_just_opened) ImGui::SetKeyboardFocusHere();
  const bool is_entered = ImGui::InputTextWithHint("##search", "search: golf, rocket, rain; Enter takes the first",
                                                   &filter_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  const bool is_left = ImGui::Button(client.file().empty() ? "Open range (Esc)" : "Close (Esc)", {-1, 0});
  if (is_left)
    client.dialog = Dialog::none;
  else
    draw_tabs(client, scale, is_entered);
  ImGui::EndPopup();
}

void GalleryPanel::draw_tabs(Client& client, float scale, bool is_entered) {
  const std::vector<const GalleryItem*> found = gallery_items("", filter_);
  if (is_entered && !found.empty()) return choose(client, *found.front());
  const GalleryItem* chosen = nullptr;
  if (!ImGui::BeginTabBar("groups")) return;
  if (ImGui::BeginTabItem("All")) {
    if (ImGui::BeginChild("cards")) {
      for (const GalleryGroup& group : gallery()) {
        const std::vector<const GalleryItem*> items = gallery_items(group.name, filter_);
        if (items.empty()) continue;
        ImGui::TextUnformatted(std::string(group.name).c_str());
        ImGui::SameLine();
        ImGui::TextDisabled("%s", std::string(group.doc).c_str());
        if (const GalleryItem* item = draw_cards(items, scale)) chosen = item;
      }
      if (found.empty()) ImGui::TextDisabled("Nothing in the gallery has this in its name.");
    }
    ImGui::EndChild();
    ImGui::EndTabItem();
  }
  for (const GalleryGroup& group : gallery()) {
    if (!ImGui::BeginTabItem(std::string(group.name).c_str())) continue;
    ImGui::TextDisabled("%s", std::string(group.doc).c_str());
    if (ImGui::BeginChild("cards")) {
      const std::vector<const GalleryItem*> items = gallery_items(group.name, filter_);
      if (items.empty()) ImGui::TextDisabled("Nothing in this group has this in its name.");
      if (const GalleryItem* item = draw_cards(items, scale)) chosen = item;
    }
    ImGui::EndChild();
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
  if (chosen != nullptr) choose(client, *chosen);
}

const GalleryItem* GalleryPanel::draw_cards(std::span<const GalleryItem* const> items, float scale) {
  const GalleryItem* chosen = nullptr;
  const float gap = 8 * scale, room = ImGui::GetContentRegionAvail().x;
  const float wished = static_cast<float>(Thumbnails::kWidth) * scale;
  const int columns = std::max(1, static_cast<int>((room + gap) / (0.85F * wished + gap)));
  const float width = std::min((room + gap) / static_cast<float>(columns) - gap, 1.1F * wished);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine(0, gap);
    if (draw_card(*items[i], width, scale)) chosen = items[i];
  }
  ImGui::Dummy({0, 4 * scale});
  return chosen;
}

bool GalleryPanel::draw_card(const GalleryItem& item, float width, float scale) {
  const float picture = width * static_cast<float>(Thumbnails::kHeight) / static_cast<float>(Thumbnails::kWidth);
  const float line = ImGui::GetTextLineHeight(), pad = 4 * scale;
  const ImVec2 at = ImGui::GetCursorScreenPos(), end{at.x + width, at.y + picture + line + 2 * pad};
  const bool is_chosen = ImGui::InvisibleButton(std::string(item.scenario).c_str(), {width, end.y - at.y});
  const bool is_hovered = ImGui::IsItemHovered();
  tooltip(std::string(item.title) + "\n" + std::string(item.scenario) + ".toml");
  if (!ImGui::IsRectVisible(at, end)) return is_chosen;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Theme& theme = theme_in_use();
  list.AddRectFilled(at, end, exact(is_hovered ? theme.hovered : theme.field), 3 * scale);
  const ImVec2 corner{at.x + width, at.y + picture};
  if (const GLuint texture = thumbnails_.of(item.scenario))
    list.AddImage(texture_id(texture), at, corner);
  else
    list.AddRectFilled(at, corner, exact(theme.bar));
  list.PushClipRect({at.x + pad, corner.y}, {end.x - pad, end.y}, true);
  const std::string title(item.title);
  const float room = width - 2 * pad, fit = std::min(1.0F, room / ImGui::CalcTextSize(title.c_str()).x);
  const float size = ImGui::GetFontSize() * std::max(fit, 0.7F);
  list.AddText(ImGui::GetFont(), size, {at.x + pad, end.y - pad - line / 2 - size / 2}, shade(colours::kText),
               title.c_str());
  list.PopClipRect();
  if (is_hovered || ImGui::IsItemFocused()) list.AddRect(at, end, exact(theme.accent), 3 * scale, 0, 2 * scale);
  return is_chosen;
}

}  // namespace physim::client
