// Live numbers of every projectile, in its own colour.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "physim/names.hpp"
#include "simclient/core/scene.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

/// A narrow row is named by its unit.
void vector_row(const char* what, const char* unit, const Vec3d& v, bool is_narrow) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", is_narrow ? unit : what);
  tooltip(what);
  for (const double x : {v.x, v.y, v.z}) cell("%s", fitting_text(x, is_narrow ? 6 : 8).c_str());
  if (is_narrow) return;
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", unit);
}

void position_row(const Vec3d& at, bool is_narrow) {
  constexpr double kFar = 1e5;  // the least coordinate of a position in km [m]
  const bool is_far = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)}) >= kFar;
  vector_row("position", is_far ? "km" : "m", is_far ? at * 1e-3 : at, is_narrow);
}

/// In two lines where one is too narrow: wrapped, it would be parted at the point of a number.
void write_hit(std::string text) {
  const std::size_t colon = text.find(": ");
  const bool fits = ImGui::CalcTextSize(text.c_str()).x <= ImGui::GetContentRegionAvail().x;
  if (!fits && colon != std::string::npos) text.replace(colon, 2, ":\n  ");
  ImGui::TextUnformatted(text.c_str());
}

/// The last ones, the first of them on top.
void draw_hits_of(const Session& session, const Track& track) {
  constexpr std::size_t kMost = 3;
  std::vector<const Hit*> last;
  const auto& hits = session.hits().hits();
  for (auto hit = hits.rbegin(); hit != hits.rend() && last.size() < kMost; ++hit)
    if (hit->id == track.id) last.push_back(&*hit);
  for (auto hit = last.rbegin(); hit != last.rend(); ++hit)
    write_hit(formatted("%.3f s  %s", (*hit)->time - track.born, hit_text(**hit).c_str()));
}

void draw_track(Client& client, const Track& track, bool is_selected) {
  const TrackSample& s = track.samples.back();
  ImGui::PushID(static_cast<int>(track.number));
  ImGui::PushStyleColor(ImGuiCol_Text, tint(track.colour));
  const bool is_narrow = ImGui::GetContentRegionAvail().x < ImGui::GetFontSize() * 17.5F;
  const std::string when = is_narrow ? "" : formatted("   %.2f s", s.time);  // else beside the mass
  const std::string fate = client.session.fate_of(track) + (track.edited ? ", edited" : "") + when;
  std::string title = track.title() + (is_narrow ? "  " : "   ") + fate;
  if (ImGui::CalcTextSize(title.c_str()).x > ImGui::GetContentRegionAvail().x) title = track.title() + "\n  " + fate;
  if (ImGui::Selectable((title + "###title").c_str(), is_selected)) client.selected = track.id;
  tooltip(title);
  if (ImGui::BeginTable("numbers", is_narrow ? 4 : 5, ImGuiTableFlags_SizingStretchProp)) {
    for (const float width : {is_narrow ? 0.8F : 1.1F, 1.2F, 1.2F, 1.2F})
      ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, width);
    if (!is_narrow) ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, 0.7F);
    position_row(s.position, is_narrow);
    vector_row("velocity", "m/s", s.velocity, is_narrow);
    vector_row(is_narrow ? "acceleration" : "accel.", "m/s\u00b2", s.acceleration, is_narrow);
    ImGui::EndTable();
  }
  if (is_narrow)
    ImGui::Text("%.2f m/s  Mach %.3f\n%.4g kg  %.2f s", length(s.velocity), s.mach, s.mass, s.time);
  else
    ImGui::Text("speed %.2f m/s  Mach %.3f  %.4g kg", length(s.velocity), s.mach, s.mass);
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
