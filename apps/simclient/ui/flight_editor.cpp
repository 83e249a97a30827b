#include "simclient/ui/flight_editor.hpp"

#include "physim/names.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

template <class Enum>
void pick(const char* label, Enum& value) {
  if (!ImGui::BeginCombo(label, std::string(name(value)).c_str(), ImGuiComboFlags_HeightLarge)) return;
  for (const RungInfo& rung : rungs_of<Enum>()) {
    if (ImGui::Selectable(std::string(rung.name).c_str(), rung.name == name(value))) value = *value_of<Enum>(rung.name);
    tooltip(std::string(rung.doc));
  }
  ImGui::EndCombo();
}

void pick_preset(Fidelity& fidelity) {
  if (!ImGui::BeginCombo("preset", "choose", ImGuiComboFlags_HeightLarge)) return;
  for (const std::string_view each : fidelity_presets())
    if (ImGui::Selectable(std::string(each).c_str())) fidelity = *fidelity_preset(each);
  ImGui::EndCombo();
}

bool vector_input(const char* label, Vec3d& v) {
  double values[3] = {v.x, v.y, v.z};
  const bool changed = ImGui::InputScalarN(label, ImGuiDataType_Double, values, 3, nullptr, nullptr, "%.3f");
  v = {values[0], values[1], values[2]};
  return changed;
}

template <class Change>
void apply(Client& client, const Track& track, const Change& change) {
  const std::string title = track.title();
  if (Status status = client.session.edit(track.id, change); !status)
    client.complain(status.error());
  else
    client.say(title + " was changed in flight");
}

}  // namespace

FlightEditor::FlightEditor() : rows_(setting_rows("shot")) {
  std::erase_if(rows_, [](const SettingRow& row) { return !row.live; });
}

void FlightEditor::take(const World& world, const Track& track) {
  id_ = track.id;
  editor_.accept();
  const ProjectileView projectile = world[id_];
  fidelity_ = projectile.fidelity_in_use().fidelity;
  position_ = projectile.position();
  velocity_ = projectile.velocity();
  impulse_ = {};
  shot_.body = projectile.body();
  if (const ProjectileDef* what = projectile.definition()) shot_.projectile = *what;
}

void FlightEditor::draw(Client& client) {
  const Track* track = client.selected_track();
  if (track == nullptr || !track->is_flying()) return ImGui::TextWrapped("Nothing is selected that flies.");
  if (track->whole) return ImGui::TextWrapped("Its flight was computed whole, and is played: nothing changes it.");
  if (!(id_ == track->id)) take(client.session.world(), *track);
  coloured_text(track->colour, "This changes " + track->title() + " while it flies, when a button is pressed.");
  if (ImGui::Button("Read its numbers")) take(client.session.world(), *track);
  ImGui::Separator();
  draw_fidelity(client, *track);
  ImGui::Separator();
  draw_state(client, *track);
  ImGui::Separator();
  draw_body(client, *track);
}

void FlightEditor::draw_fidelity(Client& client, const Track& track) {
  ImGui::PushItemWidth(ImGui::GetFontSize() * 11);
  pick_preset(fidelity_);
  pick("motion", fidelity_.motion);
  pick("integrator", fidelity_.integrator);
  pick("gravity", fidelity_.gravity);
  pick("drag", fidelity_.drag);
  pick("air", fidelity_.air);
  pick("wind", fidelity_.wind);
  pick("earth", fidelity_.earth);
  pick("precision", fidelity_.precision);
  ImGui::PopItemWidth();
  if (ImGui::Button("Change its rungs")) apply(client, track, [&](Projectile p) { return p.set_fidelity(fidelity_); });
  for (const FidelityNote& note : client.session.world()[id_].fidelity_in_use().notes)
    coloured_text(colours::kWarning, note.effect + ": granted " + note.granted + ": " + note.reason);
}

void FlightEditor::draw_state(Client& client, const Track& track) {
  ImGui::PushItemWidth(-1);
  ImGui::TextDisabled("position [m]: downrange, up, right");
  vector_input("##position", position_);
  ImGui::TextDisabled("velocity [m/s]");
  vector_input("##velocity", velocity_);
  if (ImGui::Button("Move it there"))
    apply(client, track, [&](Projectile p) { return p.set_state({position_, velocity_}); });
  ImGui::TextDisabled("impulse [N s]");
  vector_input("##impulse", impulse_);
  if (ImGui::Button("Kick it")) apply(client, track, [&](Projectile p) { return p.apply_impulse(impulse_); });
  ImGui::PopItemWidth();
  ImGui::SameLine();
  if (ImGui::Button("Take it out")) apply(client, track, [&](Projectile p) { return p.despawn(); });
}

void FlightEditor::draw_body(Client& client, const Track& track) {
  const ProjectileView now = client.session.world()[id_];
  ScenarioShot was;
  was.body = now.body();
  if (const ProjectileDef* what = now.definition()) was.projectile = *what;
  Scenario scenario;  // none of its settings is live
  for (const SettingRow& row : rows_) {
    ImGui::PushID(row.path.c_str());
    const std::string value = row_text(row, scenario, shot_).value_or("");
    if (const auto entered = editor_.draw(row, value, value != row_text(row, scenario, was).value_or(""))) {
      if (Status status = set_value(row, *entered, scenario, shot_); !status)
        editor_.refuse(row, *entered, status.error()), client.complain(status.error());
      else
        editor_.accept(row);
    }
    ImGui::PopID();
  }
  if (ImGui::Button("Change its settings"))
    apply(client, track, [&](Projectile p) {
      Status status = p.set_body(shot_.body);
      return status ? p.set_projectile(shot_.projectile) : status;
    });
}

}  // namespace physim::client
