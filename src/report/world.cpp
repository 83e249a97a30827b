#include "report/world_log.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "report/fidelity_text.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/summary.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kIndent = 2;

std::string hash_text(std::uint64_t value) { return hex(value).substr(2); }

// -------------------------------------------------------------------------------------------------------- the summary
using Count = std::uint64_t WorldGroup::*;
constexpr std::pair<std::string_view, Count> kCounts[] = {
    {"spawned", &WorldGroup::spawned}, {"refused", &WorldGroup::refused}, {"landed", &WorldGroup::landed},
    {"hits", &WorldGroup::hits},       {"bounces", &WorldGroup::bounces}, {"slept", &WorldGroup::slept},
    {"expired", &WorldGroup::expired}, {"retired", &WorldGroup::retired}, {"alive", &WorldGroup::alive}};

// Counts that are zero everywhere are left out.
std::string counts_table(const std::vector<WorldGroup>& groups) {
  std::vector<std::string> columns = {"what"};
  std::vector<Count> shown;
  for (const auto& [name, count] : kCounts) {
    const bool always = count == &WorldGroup::spawned || count == &WorldGroup::alive;
    if (!always && std::ranges::all_of(groups, [part = count](const WorldGroup& g) { return g.*part == 0; })) continue;
    columns.emplace_back(name);
    shown.push_back(count);
  }
  Table table(columns, "l");
  for (const WorldGroup& group : groups) {
    std::vector<std::string> row = {one_line(group.name)};
    for (const Count count : shown) row.push_back(std::to_string(group.*count));
    table.add_row(std::move(row));
  }
  return table.text(kIndent);
}

std::string below(const Table& table) { return table.empty() ? "" : "\n" + table.text(kIndent); }

std::string impacts_table(const std::vector<WorldGroup>& groups) {
  Table table({"impacts of", "count", "range [m]", "nearest", "farthest", "spread", "time [s]", "from", "to",
               "speed [m/s]", "from", "to"},
              "l");
  for (const WorldGroup& g : groups)
    if (g.range.count > 0)
      table.add_row({one_line(g.name), std::to_string(g.range.count), fixed(g.range.mean, 3), fixed(g.range.low, 3),
                     fixed(g.range.high, 3), fixed(g.range.spread(), 3), fixed(g.time.mean, 4), fixed(g.time.low, 4),
                     fixed(g.time.high, 4), fixed(g.speed.mean, 2), fixed(g.speed.low, 2), fixed(g.speed.high, 2)});
  return below(table);
}

std::string wall_table(const std::vector<WorldGroup>& groups, double wall) {
  Table table(
      {"hits on the wall at " + as_typed(wall) + " m", "count", "height [m]", "spread", "to the right [m]", "spread"},
      "l");
  for (const WorldGroup& g : groups)
    if (g.hits > 0)
      table.add_row({one_line(g.name), std::to_string(g.hits), fixed(g.hit_y.mean, 3), fixed(g.hit_y.spread(), 3),
                     fixed(g.hit_z.mean, 3), fixed(g.hit_z.spread(), 3)});
  return below(table);
}

std::string alive_table(const std::vector<WorldGroup>& groups, double time) {
  Table table({"alive at " + as_typed(time) + " s", "count", "x [m]", "y [m]", "z [m]", "speed [m/s]"}, "l");
  for (const WorldGroup& g : groups)
    if (g.alive > 0)
      table.add_row({one_line(g.name), std::to_string(g.alive), fixed(g.position.x, 3), fixed(g.position.y, 3),
                     fixed(g.position.z, 3), fixed(g.mean_speed, 3)});
  return below(table);
}

// The rungs of each shot; its groups share them.
std::string fidelities(const WorldLog& log, const Style& style) {
  std::string out;
  std::vector<std::size_t> told;
  PHYSIM_ASSERT(log.in_use.size() == log.groups.size());
  for (std::size_t i = 0; i < log.groups.size(); ++i) {
    const std::size_t shot = log.groups[i].shot;
    if (log.groups[i].spawned == 0 || std::ranges::count(told, shot) > 0) continue;
    told.push_back(shot);
    const ProjectileDef& projectile = log.scenario.shots[shot].projectile;
    out += std::string(told.size() == 1 ? "\n" : "") + "  " + style.bold(one_line(projectile.name)) + " " +
           preset_name(projectile.fidelity) + ": " + in_words(log.in_use[i].fidelity) + "\n";
    for (const FidelityNote& note : log.in_use[i].notes)
      out += "    " + style.warn("note") + " " + note_text(note) + "\n";
  }
  return out;
}

// ---------------------------------------------------------------------------------------------------------- the files
/// Records with a state at the end of each row.
using Cells = std::vector<Cell>;
template <class Entry, class Head>
Records records_with_states(std::vector<std::string> columns, const std::vector<Entry>& entries, const Head& head_of) {
  columns.insert(columns.end(), {"x [m]", "y [m]", "z [m]", "vx [m/s]", "vy [m/s]", "vz [m/s]"});
  return {std::move(columns), [&entries, head_of](const auto& take) {
            for (const Entry& entry : entries) {
              const auto& [x, v] = entry.state;
              Cells row = head_of(entry);
              row.insert(row.end(), {x.x, x.y, x.z, v.x, v.y, v.z});
              take(row);
            }
          }};
}

Json series_json(const Series& series) {
  if (series.count == 0) return nullptr;
  return {{"count", series.count},
          {"mean", series.mean},
          {"min", series.low},
          {"max", series.high},
          {"spread", series.spread()}};
}

Json group_json(const WorldLog& log, std::size_t index) {
  const WorldGroup& g = log.groups[index];
  PHYSIM_ASSERT(g.shot < log.scenario.shots.size());
  PHYSIM_ASSERT(g.alive <= g.spawned);
  Json out = {{"name", g.name}, {"shot", log.scenario.shots[g.shot].projectile.name}};
  for (const auto& [name, count] : kCounts) out[std::string(name)] = g.*count;
  out["impact_range [m]"] = series_json(g.range);
  out["impact_time [s]"] = series_json(g.time);
  out["impact_speed [m/s]"] = series_json(g.speed);
  out["apex [m]"] = series_json(g.apex);
  out["hit_y [m]"] = series_json(g.hit_y);
  out["hit_z [m]"] = series_json(g.hit_z);
  out["fidelity_granted"] = g.spawned > 0 ? Json(in_words(log.in_use[index].fidelity)) : Json();
  return out;
}

}  // namespace

std::string world_text(const WorldLog& log, const Style& style) {
  const double step = log.scenario.world.def.step;
  std::string out = style.bold(one_line(title_of(log.scenario))) + "\n\n";
  out += counts_table(log.groups) + impacts_table(log.groups);
  if (log.scenario.world.wall) out += wall_table(log.groups, *log.scenario.world.wall);
  out += alive_table(log.groups, log.time) + fidelities(log, style);
  out += "\n  steps " + std::to_string(log.steps) + " of " + significant(step, 6) + " s, projectile-steps " +
         std::to_string(log.counters.projectile_steps) + ", hash " + hash_text(log.hash) + "\n";
  if (!log.checks.empty()) out += "\n" + checks_text(log.checks, style);
  return out;
}

Records records_of(const WorldLog& log) {
  return records_with_states({"what", "number", "t [s]"}, log.samples, [&log](const WorldSample& sample) -> Cells {
    const auto& [group, number] = sample.launched;
    PHYSIM_ASSERT(group < log.groups.size());
    return {log.groups[group].name, number, sample.time};
  });
}

Content world_events_csv(const WorldLog& log) {
  const std::vector<std::string> columns = {"t [s]", "event", "reason", "what", "number"};
  return csv_text(records_with_states(columns, log.events, [&log](const LoggedEvent& event) -> Cells {
    const auto& [group, number] = event.launched;
    PHYSIM_ASSERT(group < log.groups.size());
    return {event.time, event.kind, event.reason, log.groups[group].name, number};
  }));
}

Content world_json(const WorldLog& log) {
  Json out = provenance(log.scenario);
  Json groups = Json::array(), events = Json::array();
  for (std::size_t i = 0; i < log.groups.size(); ++i) groups.push_back(group_json(log, i));
  for (const LoggedEvent& event : log.events)
    events.push_back({{"time [s]", event.time},
                      {"kind", event.kind},
                      {"reason", event.reason},
                      {"what", log.groups[event.launched.group].name},
                      {"number", event.launched.number},
                      {"position [m]", vector_json(event.state.position)},
                      {"velocity [m/s]", vector_json(event.state.velocity)}});
  out["world"] = {{"steps", log.steps},
                  {"time [s]", log.time},
                  {"projectile_steps", log.counters.projectile_steps},
                  {"hash", hash_text(log.hash)},
                  {"groups", std::move(groups)},
                  {"events", std::move(events)},
                  {"trajectories", columns_json(records_of(log))}};
  out["expect"] = checks_json(log.checks);
  return json_text(out);
}

}  // namespace physim::report
