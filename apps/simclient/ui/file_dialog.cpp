#include "simclient/ui/file_dialog.hpp"

#include <imgui_stdlib.h>

#include <filesystem>

#include "simclient/core/actions.hpp"
#include "simclient/core/folder.hpp"

namespace physim::client {
namespace {

namespace fs = std::filesystem;

constexpr int kStays = ImGuiSelectableFlags_DontClosePopups;
constexpr const char *kOpen = "Open a scenario or recording", *kSave = "Save the scenario as";

std::string here() {
  std::error_code unknown;
  return fs::current_path(unknown).string();
}

}  // namespace

/// Opens where the scenario at hand lies, or among those that ship; saves beside it, or where the client was started.
void FileDialog::begin(const Client& client) {
  const fs::path file = client.file();
  std::error_code unknown;
  const std::string beside = file.empty() ? "" : fs::absolute(file, unknown).parent_path().string();
  const bool saves = client.dialog == Dialog::save;
  folder_ = !beside.empty() ? beside : saves ? here() : folder_of_scenarios();
  text_ = !saves ? "" : file.empty() ? free_name("scenario", ".toml") : file.filename().string();
  shows_recent_ = false;
}

void FileDialog::choose(Client& client, const std::string& path) {
  const bool saves = client.dialog == Dialog::save;
  client.dialog = Dialog::none;
  ImGui::CloseCurrentPopup();
  run_action(client, *find_action(saves ? "save-as" : "open"), path);
}

void FileDialog::draw(Client& client, const Box& box, float scale) {
  const bool is_wanted = client.dialog == Dialog::open || client.dialog == Dialog::save;
  const bool has_just_opened = client.dialog != shown_ && is_wanted;
  const char* title = (is_wanted ? client.dialog : shown_) == Dialog::save ? kSave : kOpen;
  if (!is_wanted && shown_ == Dialog::none) return;
  if (client.dialog == Dialog::gallery) return void(shown_ = Dialog::none);
  shown_ = client.dialog;
  if (has_just_opened) begin(client), ImGui::OpenPopup(title);
  centre_window(box, 560 * scale, 460 * scale);
  bool stays = true;
  if (!ImGui::BeginPopupModal(title, &stays, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings)) {
    if (!has_just_opened) client.dialog = shown_ = Dialog::none;
    return;
  }
  if (!stays || client.dialog == Dialog::none) {
    client.dialog = shown_ = Dialog::none;
    ImGui::CloseCurrentPopup();
    return ImGui::EndPopup();
  }
  const bool saves = client.dialog == Dialog::save;
  draw_places(client);
  const float button = saves ? ImGui::CalcTextSize("Save").x + 4 * ImGui::GetStyle().FramePadding.x : 0;
  ImGui::SetNextItemWidth(-1 - button);
  if (has_just_opened) ImGui::SetKeyboardFocusHere();
  bool is_entered = ImGui::InputTextWithHint("##path", saves ? "name" : "filter or path, then Enter", &text_,
                                             ImGuiInputTextFlags_EnterReturnsTrue);
  if (saves) ImGui::SameLine();
  is_entered |= saves && ImGui::Button("Save");
  const std::string path = text_.empty() ? "" : saves ? path_in(folder_, text_) : meant_by(text_, folder_);
  if (is_entered && !text_.empty())
    choose(client, path.empty() ? text_ : path);  // a path to nowhere: the action says so
  else
    draw_entries(client);
  ImGui::EndPopup();
}

void FileDialog::draw_places(Client& client) {
  const auto place = [&](const char* name, const std::string& folder) {
    if (ImGui::Button(name)) folder_ = folder, shows_recent_ = false;
    tooltip(folder);
    ImGui::SameLine();
  };
  place("scenarios", folder_of_scenarios());
  place("here", here());
  if (client.dialog == Dialog::open && !client.recent.files().empty()) {
    if (ImGui::Button("recent")) shows_recent_ = true;
    tooltip("files that were opened or saved lately");
    ImGui::SameLine();
  }
  ImGui::TextDisabled("%s", shows_recent_ ? "recent files" : folder_.c_str());
}

void FileDialog::draw_entries(Client& client) {
  const bool saves = client.dialog == Dialog::save;
  if (!ImGui::BeginChild("files")) return ImGui::EndChild();
  std::string chosen;
  std::size_t shown = 0;
  if (shows_recent_) {
    for (const std::string& file : client.recent.files())
      if (passes_filter(file, text_) && ++shown > 0 && ImGui::Selectable(file.c_str(), false, kStays)) chosen = file;
  } else {
    for (const FolderEntry& entry : entries_of(folder_, saves ? "" : text_)) {
      shown += !entry.is_folder;
      const std::string name = entry.is_folder ? entry.name + "/" : entry.name;
      if (!ImGui::Selectable(name.c_str(), false, kStays)) continue;
      if (entry.is_folder)
        folder_ = entry.path;
      else if (saves)
        text_ = entry.name;
      else
        chosen = entry.path;
    }
  }
  if (shown == 0 && !text_.empty() && !saves) ImGui::TextDisabled("Nothing here has this in its name.");
  ImGui::EndChild();
  if (!chosen.empty()) choose(client, chosen);
}

}  // namespace physim::client
