#include "simclient/ui/open_dialog.hpp"

#include <imgui_stdlib.h>

namespace physim::client {

void OpenDialog::open(Client& client, const std::string& path) {
  client.show.open_dialog = false;
  if (Status status = client.open(path); !status) client.complain(status.error());
}

void OpenDialog::draw(Client& client, const Box& scene, float scale) {
  const bool has_just_opened = client.show.open_dialog && !was_open_;
  if (has_just_opened) files_ = files_at_hand();
  was_open_ = client.show.open_dialog;
  if (!was_open_) return;
  centre_window(scene, 520 * scale, 460 * scale);
  if (ImGui::Begin("Open a scenario or recording", &client.show.open_dialog,
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::SetNextItemWidth(-1);
    if (has_just_opened) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputTextWithHint("##path", "path, then Enter", &path_, ImGuiInputTextFlags_EnterReturnsTrue))
      open(client, path_);
    if (ImGui::BeginChild("files"))
      for (const std::string& file : files_)
        if (ImGui::Selectable(file.c_str())) open(client, file);
    ImGui::EndChild();
  }
  ImGui::End();
}

}  // namespace physim::client
