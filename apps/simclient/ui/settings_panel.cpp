// The shot that is fired next.
#include "physim/names.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/ui/ui.hpp"

namespace physim::client {

void draw_settings_panel(Client& client, const Box& box) {
  if (begin_panel("Next shot###settings", box)) {
    const auto types = client.launcher.types();
    if (ImGui::BeginCombo("type", types[client.launcher.type()].name.c_str())) {
      for (std::size_t i = 0; i < types.size(); ++i)
        if (ImGui::Selectable(types[i].name.c_str(), i == client.launcher.type())) client.launcher.select(i);
      ImGui::EndCombo();
    }
    const Prediction& prediction = client.prediction();
    if (prediction.error) {
      ImGui::PushStyleColor(ImGuiCol_Text, tint(colours::kWarning));
      ImGui::TextWrapped("%s", prediction.error->text().c_str());
      ImGui::PopStyleColor();
    }
    for (const FidelityNote& note : prediction.granted.notes)
      ImGui::TextWrapped("%s: %s instead of %s: %s", note.effect.c_str(), note.granted.c_str(), note.asked.c_str(),
                         note.reason.c_str());
  }
  end_panel();
}

}  // namespace physim::client
