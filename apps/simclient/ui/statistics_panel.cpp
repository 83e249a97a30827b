// Live numbers of every projectile, in its own colour.
#include "base/text.hpp"
#include "physim/names.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

void vector_row(const char* what, const char* unit, const Vec3d& v, bool is_narrow) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", what);
  for (const double x : {v.x, v.y, v.z}) cell("%s", fitting_text(x, is_narrow ? 7 : 8).c_str());
  if (is_narrow) return tooltip(unit);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", unit);
}

/// The last ones, the first of them on top.
void draw_hits_of(const Session& session, const Track& track) {
  constexpr std::size_t kMost = 3;
  std::vector<const Hit*> last;
  const auto& hits = session.hits().hits();
  for (auto hit = hits.rbegin(); hit != hits.rend() && last.size() < kMost; ++hit)
    if (hit->id == track.id) last.push_back(&*hit);
  for (auto hit = last.rbegin(); hit != last.rend(); ++hit)
    ImGui::TextWrapped("%.3f s  %s", (*hit)->time - track.born, hit_text(**hit).c_str());
}

void draw_track(Client& client, const Track& track, bool is_selected) {
  const TrackSample& s = track.samples.back();
  ImGui::PushID(static_cast<int>(track.number));
  ImGui::PushStyleColor(ImGuiCol_Text, tint(track.colour));
  const std::string title = formatted("%s   %s%s   %.2f s###title", track.title().c_str(),
                                      client.session.fate_of(track).c_str(), track.edited ? ", edited" : "", s.time);
  if (ImGui::Selectable(title.c_str(), is_selected)) client.selected = track.id;
  const bool is_narrow = ImGui::GetContentRegionAvail().x < ImGui::GetFontSize() * 17.5F;
  if (ImGui::BeginTable("numbers", is_narrow ? 4 : 5, ImGuiTableFlags_SizingStretchProp)) {
    for (const float width : {1.1F, 1.2F, 1.2F, 1.2F})
      ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, width);
    if (!is_narrow) ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 0.7F);
    vector_row("position", "m", s.position, is_narrow);
    vector_row("velocity", "m/s", s.velocity, is_narrow);
    vector_row("accel.", "m/s\u00b2", s.acceleration, is_narrow);
    ImGui::EndTable();
  }
  ImGui::Text(is_narrow ? "%.2f m/s  Mach %.3f\n%.4g kg" : "speed %.2f m/s  Mach %.3f  %.4g kg", length(s.velocity),
              s.mach, s.mass);
  draw_hits_of(client.session, track);
  ImGui::PopStyleColor();
  ImGui::Separator();
  ImGui::PopID();
}

}  // namespace

void draw_statistics_panel(Client& client, const Box& box) {
  if (begin_panel("Flights: downrange, up, right###statistics", box)) {
    const auto tracks = client.session.tracks();
    const Track* selected = client.selected_track();
    if (tracks.empty()) ImGui::TextDisabled("Nothing has been fired yet.\nClick on the scene, or press Enter.");
    for (std::size_t i = tracks.size(); i-- > 0;) draw_track(client, tracks[i], &tracks[i] == selected);
  }
  end_panel();
}

}  // namespace physim::client
