// The panels under the scene: plots, the comparison of rungs, what everything costs, and what was hit.
#include <algorithm>

#include "base/text.hpp"
#include "math/angles.hpp"
#include "physim/names.hpp"
#include "report/number.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/ui/fitting_table.hpp"
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

constexpr TableColumn kRungColumns[] = {{"rung", 0},           {"why", 0, true},        {"error [m]", 1},
                                        {"time error [s]", 5}, {"farthest off [m]", 4}, {"time [s]", 6},
                                        {"range [m]", 2},      {"height [m]", 8},       {"windage [m]", 7},
                                        {"at 60 Hz [m]", 9},   {"ns per step", 3},      {"granted instead", 10}};
constexpr std::size_t kWhy = 1, kGranted = std::size(kRungColumns) - 1;

TableRow row_of(const ComparedRung& rung, const ComparedRung& truth) {
  TableRow row{rung.name + (rung.is_truth ? " (truth)" : ""), rung.problem};
  if (rung.problem.empty()) {
    if (truth.problem.empty()) row[kWhy] = rung.why(truth);
    for (const std::string& figure : rung.figures()) row.push_back(figure);
    row.push_back(rung.in_frames ? report::significant(*rung.in_frames, 3) : "-");
    row.push_back(formatted("%.1f", rung.per_step * 1e9));
    std::string granted;
    for (const FidelityNote& note : rung.granted.notes)
      granted += (granted.empty() ? "" : ", ") + note.effect + " " + note.granted;
    row.push_back(granted);
  }
  row.resize(std::size(kRungColumns));
  return row;
}

void draw_rung(const ComparedRung& rung, const FittingTable& table, const TableRow& row) {
  ImGui::TableNextRow();
  for (const std::size_t c : table.shown()) {
    ImGui::TableNextColumn();
    if (c == 0) {
      ImGui::TextColored(tint(rung.colour), "%s", row[0].c_str());
      const std::string more = table.hidden(row);
      tooltip(short_fidelity(rung.granted.fidelity) + (more.empty() ? "" : "\n" + more));
    } else if (c == kWhy) {
      if (rung.problem.empty())
        ImGui::TextWrapped("%s", row[c].c_str());
      else
        coloured_text(colours::kWarning, row[c]);
    } else if (c == kGranted) {
      ImGui::TextColored(tint(colours::kWarning), "%s", row[c].c_str());
      std::string reasons;
      for (const FidelityNote& note : rung.granted.notes)
        reasons += (reasons.empty() ? "" : "\n") + note.effect + " " + note.granted + ": " + note.reason;
      tooltip(reasons);
    } else {
      ImGui::TextUnformatted(row[c].c_str());
    }
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
  const std::vector<ComparedRung>& rungs = client.comparison();
  if (client.is_comparison_old()) ImGui::TextDisabled("of the shot before; this one is computed");
  std::vector<TableRow> rows;
  for (const ComparedRung& rung : rungs) rows.push_back(row_of(rung, rungs.back()));
  const FittingTable table(kRungColumns, rows);
  if (!table.begin("rungs")) return;
  for (std::size_t i = 0; i < rungs.size(); ++i) draw_rung(rungs[i], table, rows[i]);
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

constexpr TableColumn kHitColumns[] = {{"time [s]", 0},    {"shot", 0},
                                       {"thing", 0},       {"material", 5},
                                       {"what", 0},        {"speed [m/s]", 1},
                                       {"after [m/s]", 2}, {"off normal [\u00b0]", 4},
                                       {"depth [mm]", 6},  {"energy lost [J]", 7},
                                       {"place [m]", 3}};

TableRow row_of(const Session& session, const Hit& hit) {
  return {formatted("%.4f", hit.time),
          session.title_of(hit),
          hit.thing,
          hit.material,
          std::string(name(hit.outcome)),
          formatted("%.5g", hit.speed()),
          formatted("%.5g", hit.speed_after()),
          formatted("%.2f", hit.obliquity / kDegree),
          hit.depth > 0 ? formatted("%.4g", 1000 * hit.depth) : "",
          hit.energy > 0 ? formatted("%.4g", hit.energy) : "",
          formatted("%.4g, %.4g, %.4g", hit.position.x, hit.position.y, hit.position.z)};
}

void draw_hit(Client& client, const Hit& hit, const FittingTable& table, const TableRow& row) {
  constexpr std::size_t kInItsColour = 2;  // of the first columns
  ImGui::TableNextRow();
  ImGui::PushID(&hit);
  for (const std::size_t c : table.shown()) {
    ImGui::TableNextColumn();
    if (c < kInItsColour) ImGui::PushStyleColor(ImGuiCol_Text, tint(client.session.colour_of(hit)));
    if (c > 0)
      ImGui::TextUnformatted(row[c].c_str());
    else if (ImGui::Selectable(row[c].c_str(), client.selected == hit.id, ImGuiSelectableFlags_SpanAllColumns))
      client.selected = hit.id;
    if (c < kInItsColour) ImGui::PopStyleColor();
    if (c == 0) tooltip(table.hidden(row));
  }
  ImGui::PopID();
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
  std::vector<const Hit*> hits;
  std::vector<TableRow> rows;
  for (auto hit = log.hits().rbegin(); hit != log.hits().rend(); ++hit)
    hits.push_back(&*hit), rows.push_back(row_of(client.session, *hit));
  const FittingTable table(kHitColumns, rows);
  if (!table.begin("hits")) return;
  for (std::size_t i = 0; i < hits.size(); ++i) draw_hit(client, *hits[i], table, rows[i]);
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
