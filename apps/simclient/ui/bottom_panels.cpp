// The panels under the scene: plots, the comparison of rungs, what everything costs, and what was hit.
#include <algorithm>

#include "base/text.hpp"
#include "math/angles.hpp"
#include "physim/names.hpp"
#include "report/number.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/ui/panel.hpp"

namespace physim::client {
namespace {

std::string short_fidelity(const Fidelity& f) {
  std::string text(name(f.motion));
  for (const std::string_view part :
       {name(f.integrator), name(f.gravity), name(f.drag), name(f.air), name(f.wind), name(f.earth), name(f.precision)})
    text += ", " + std::string(part);
  return text;
}

void draw_rung(const ComparedRung& rung, const ComparedRung& truth) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextColored(tint(rung.colour), "%s%s", rung.name.c_str(), rung.is_truth ? " (truth)" : "");
  tooltip(short_fidelity(rung.granted.fidelity));
  if (!rung.problem.empty()) {
    ImGui::TableNextColumn();
    return coloured_text(colours::kWarning, rung.problem);
  }
  cell("%s", truth.problem.empty() ? rung.why(truth).c_str() : "");
  for (const std::string& figure : rung.figures()) cell("%s", figure.c_str());
  cell("%s", rung.in_frames ? report::significant(*rung.in_frames, 3).c_str() : "-");
  cell("%.1f", rung.per_step * 1e9);
  ImGui::TableNextColumn();
  for (const FidelityNote& note : rung.granted.notes) {
    ImGui::TextColored(tint(colours::kWarning), "%s %s", note.effect.c_str(), note.granted.c_str());
    tooltip(note.reason);
    ImGui::SameLine();
  }
}

void pick_rungs(Client& client) {
  std::vector<std::string> picked;  // in the order of the ladder
  bool is_changed = false;
  for (const std::string_view preset : fidelity_presets()) {
    if (preset == "reference") continue;  // the truth is always there
    const std::string name(preset);
    bool on = std::find(client.compared.begin(), client.compared.end(), name) != client.compared.end();
    if (preset != fidelity_presets().front()) go_beside(name.c_str(), ImGui::GetFrameHeight());
    is_changed |= ImGui::Checkbox(name.c_str(), &on);
    if (on) picked.push_back(name);
  }
  if (is_changed) client.compared = picked;
  go_beside("fire all");
  if (ImGui::Button("fire all")) run_action(client, *find_action("fire-compared"));
  tooltip("fires the next shot on all of them at once (F6)");
}

void draw_comparison(Client& client) {
  if (client.session.is_replay()) return ImGui::TextWrapped("A replay fires by itself.");
  pick_rungs(client);
  const Scenario& scenario = client.session.scenario();
  if (!scenario.forces.empty() || !scenario.things.empty())
    ImGui::TextDisabled("without the %s of the scenario", scenario.things.empty()   ? "forces"
                                                          : scenario.forces.empty() ? "things"
                                                                                    : "forces and things");
  const ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollX |
                                ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable("rungs", 12, flags)) return;
  ImGui::TableSetupScrollFreeze(1, 1);  // the name of a rung stays beside its figures
  headings({"rung", "why", "error [m]", "time error [s]", "farthest off [m]", "time [s]", "range [m]", "height [m]",
            "windage [m]", "at 60 Hz [m]", "ns per step", "granted instead"});
  const std::vector<ComparedRung>& rungs = client.comparison();
  for (const ComparedRung& rung : rungs) draw_rung(rung, rungs.back());
  ImGui::EndTable();
}

void draw_performance(Client& client) {
  const Session& session = client.session;
  const StepCost& cost = session.cost();
  const std::vector<float> times(client.frame_times.begin(), client.frame_times.end());
  float mean = 0, worst = 0;
  for (const float t : times) mean += t / static_cast<float>(times.size()), worst = std::max(worst, t);
  const float wide = ImGui::GetFontSize() * 26;
  ImGui::BeginChild("numbers", {wide, 0});
  const auto row = [wide](const char* what, const char* format, auto... values) {
    ImGui::TextDisabled("%s", what);
    ImGui::SameLine(wide * 0.34F);
    ImGui::Text(format, values...);
  };
  row("frame", "%.2f ms, the worst of %d: %.2f ms", 1e3 * mean, static_cast<int>(times.size()), 1e3 * worst);
  row("quality", "%s", client.quality.text().c_str());
  row("step", "%.3f ms", 1e3 * cost.seconds);
  if (const auto each = cost.per_projectile_step())
    row("projectile-step", "%.1f ns", 1e9 * *each);
  else
    row("projectile-step", "nothing has moved");
  row("projectiles", "%zu, of which %llu moved", session.world().size(), static_cast<unsigned long long>(cost.moved));
  row("memory", "%.2f MB", static_cast<double>(session.world().memory()) / 1e6);
  row("steps", "%llu of %.4g s", static_cast<unsigned long long>(session.step()), session.step_length());
  if (!times.empty())
    ImGui::PlotLines("##frames", times.data(), static_cast<int>(times.size()), 0, "frame times", 0, worst * 1.1F,
                     {wide * 0.95F, std::max(ImGui::GetContentRegionAvail().y - 2, 40.0F)});
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("cohorts");
  if (ImGui::BeginTable("cohorts", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
    headings({"projectiles", "", "cohort"});
    for (const CohortInfo& cohort : session.world().cohorts()) {
      if (cohort.count == 0) continue;
      cell("%u", cohort.count);
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s%s", cohort.moving ? "moving" : "at rest", cohort.forced ? ", forced" : "");
      cell("%s", short_fidelity(cohort.fidelity).c_str());
    }
    ImGui::EndTable();
  }
  ImGui::EndChild();
}

void draw_hit(Client& client, const Hit& hit) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, tint(client.session.colour_of(hit)));
  ImGui::PushID(&hit);
  const bool is_selected = client.selected == hit.id;
  if (ImGui::Selectable(formatted("%.4f", hit.time).c_str(), is_selected, ImGuiSelectableFlags_SpanAllColumns))
    client.selected = hit.id;
  ImGui::PopID();
  cell("%s", client.session.title_of(hit).c_str());
  ImGui::PopStyleColor();
  cell("%s", hit.thing.c_str());
  cell("%s", hit.material.c_str());
  cell("%s", std::string(name(hit.outcome)).c_str());
  cell("%.5g", hit.speed());
  cell("%.5g", hit.speed_after());
  cell("%.2f", hit.obliquity / kDegree);
  cell("%s", hit.depth > 0 ? formatted("%.4g", 1000 * hit.depth).c_str() : "");
  cell("%s", hit.energy > 0 ? formatted("%.4g", hit.energy).c_str() : "");
  cell("%.4g, %.4g, %.4g", hit.position.x, hit.position.y, hit.position.z);
}

/// The last one on top.
void draw_hits(Client& client) {
  const HitLog& log = client.session.hits();
  if (log.hits().empty())
    return ImGui::TextDisabled(client.session.world().scene() == nullptr
                                   ? "There is nothing to hit. Tools put up walls (I) and targets (O)."
                                   : "Nothing has been hit yet.");
  if (log.count() > log.hits().size())
    ImGui::TextDisabled("the last %zu of %llu", log.hits().size(), static_cast<unsigned long long>(log.count()));
  const ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollX |
                                ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable("hits", 11, flags)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  headings({"time [s]", "shot", "thing", "material", "what", "speed [m/s]", "after [m/s]", "off normal [\u00b0]",
            "depth [mm]", "energy lost [J]", "place [m]"});
  const auto& hits = log.hits();
  for (auto hit = hits.rbegin(); hit != hits.rend(); ++hit) draw_hit(client, *hit);
  ImGui::EndTable();
}

}  // namespace

void draw_bottom_panel(Client& client, const Box& box, bool bare) {
  static constexpr const char* kTitles[] = {"", "Plots", "Comparison", "Performance", "Hits", "Study"};
  const std::string title = std::string(kTitles[static_cast<int>(client.bottom)]) + "###bottom";
  if (begin_panel(title.c_str(), box, !bare)) {
    if (client.bottom == BottomPanel::plots) draw_plots(client, bare);
    if (client.bottom == BottomPanel::compare) draw_comparison(client);
    if (client.bottom == BottomPanel::performance) draw_performance(client);
    if (client.bottom == BottomPanel::hits) draw_hits(client);
    if (client.bottom == BottomPanel::study) draw_study(client);
  }
  end_panel();
}

}  // namespace physim::client
