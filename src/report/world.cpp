#include "report/world.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "physim/names.hpp"
#include "report/fidelity_text.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/summary.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kIndent = 2;

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

// -------------------------------------------------------------------------------------------------------- the summary
using Count = std::uint64_t WorldGroup::*;
constexpr std::pair<std::string_view, Count> kCounts[] = {
    {"spawned", &WorldGroup::spawned}, {"refused", &WorldGroup::refused}, {"landed", &WorldGroup::landed},
    {"hits", &WorldGroup::hits},       {"bounces", &WorldGroup::bounces}, {"slept", &WorldGroup::slept},
    {"expired", &WorldGroup::expired}, {"retired", &WorldGroup::retired}, {"alive", &WorldGroup::alive}};

// Counts that are zero everywhere are left out.
std::string counts_table(const std::vector<WorldGroup>& groups) {
  std::vector<Column> columns = {{"what", Align::left}};
  std::vector<Count> shown;
  for (const auto& [name, count] : kCounts) {
    const bool always = count == &WorldGroup::spawned || count == &WorldGroup::alive;
    if (!always && std::ranges::all_of(groups, [part = count](const WorldGroup& g) { return g.*part == 0; })) continue;
    columns.push_back({std::string(name)});
    shown.push_back(count);
  }
  Table table(columns);
  for (const WorldGroup& group : groups) {
    std::vector<std::string> row = {one_line(group.name)};
    for (const Count count : shown) row.push_back(std::to_string(group.*count));
    table.add_row(std::move(row));
  }
  return table.text(kIndent);
}

std::string impacts_table(const std::vector<WorldGroup>& groups) {
  Table table({{"impacts of", Align::left},
               {"count"},
               {"range [m]"},
               {"nearest"},
               {"farthest"},
               {"spread"},
               {"time [s]"},
               {"from"},
               {"to"},
               {"speed [m/s]"},
               {"from"},
               {"to"}});
  for (const WorldGroup& g : groups)
    if (g.range.count > 0)
      table.add_row({one_line(g.name), std::to_string(g.range.count), fixed(g.range.mean, 3), fixed(g.range.low, 3),
                     fixed(g.range.high, 3), fixed(g.range.spread(), 3), fixed(g.time.mean, 4), fixed(g.time.low, 4),
                     fixed(g.time.high, 4), fixed(g.speed.mean, 2), fixed(g.speed.low, 2), fixed(g.speed.high, 2)});
  return table.empty() ? "" : "\n" + table.text(kIndent);
}

std::string wall_table(const std::vector<WorldGroup>& groups, double wall) {
  Table table({{"hits on the wall at " + as_typed(wall) + " m", Align::left},
               {"count"},
               {"height [m]"},
               {"spread"},
               {"to the right [m]"},
               {"spread"}});
  for (const WorldGroup& g : groups)
    if (g.hits > 0)
      table.add_row({one_line(g.name), std::to_string(g.hits), fixed(g.hit_y.mean, 3), fixed(g.hit_y.spread(), 3),
                     fixed(g.hit_z.mean, 3), fixed(g.hit_z.spread(), 3)});
  return table.empty() ? "" : "\n" + table.text(kIndent);
}

std::string alive_table(const std::vector<WorldGroup>& groups, double time) {
  Table table({{"alive at " + as_typed(time) + " s", Align::left},
               {"count"},
               {"x [m]"},
               {"y [m]"},
               {"z [m]"},
               {"speed [m/s]"}});
  for (const WorldGroup& g : groups)
    if (g.alive > 0)
      table.add_row({one_line(g.name), std::to_string(g.alive), fixed(g.position.x, 3), fixed(g.position.y, 3),
                     fixed(g.position.z, 3), fixed(g.mean_speed, 3)});
  return table.empty() ? "" : "\n" + table.text(kIndent);
}

// The rungs of each shot; its groups share them.
std::string fidelities(const WorldLog& log, const Style& style) {
  std::string out;
  std::vector<std::size_t> told;
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
constexpr std::string_view kStateColumns[] = {"x [m]", "y [m]", "z [m]", "vx [m/s]", "vy [m/s]", "vz [m/s]"};

std::vector<std::string> with_state_columns(std::vector<std::string> columns) {
  columns.insert(columns.end(), std::begin(kStateColumns), std::end(kStateColumns));
  return columns;
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

Json samples_json(const WorldLog& log) {
  Json columns = {{"what", Json::array()}, {"number", Json::array()}, {"t [s]", Json::array()}};
  for (const std::string_view column : kStateColumns) columns[std::string(column)] = Json::array();
  for (const WorldSample& sample : log.samples) {
    columns["what"].push_back(log.groups[sample.launched.group].name);
    columns["number"].push_back(sample.launched.number);
    columns["t [s]"].push_back(sample.time);
    const Vec3d &x = sample.state.position, &v = sample.state.velocity;
    const double numbers[] = {x.x, x.y, x.z, v.x, v.y, v.z};
    for (std::size_t i = 0; i < std::size(kStateColumns); ++i)
      columns[std::string(kStateColumns[i])].push_back(numbers[i]);
  }
  return columns;
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
  const auto rows = [&log](const auto& take) {
    for (const WorldSample& sample : log.samples) {
      const auto& [x, v] = sample.state;
      const Cell row[] = {
          log.groups[sample.launched.group].name, sample.launched.number, sample.time, x.x, x.y, x.z, v.x, v.y, v.z};
      take(row);
    }
  };
  return {with_state_columns({"what", "number", "t [s]"}), rows};
}

Content world_events_csv(const WorldLog& log) {
  const auto rows = [&log](const auto& take) {
    for (const LoggedEvent& event : log.events) {
      const auto& [x, v] = event.state;
      const Cell row[] = {event.time,
                          event.kind,
                          event.reason,
                          log.groups[event.launched.group].name,
                          event.launched.number,
                          x.x,
                          x.y,
                          x.z,
                          v.x,
                          v.y,
                          v.z};
      take(row);
    }
  };
  return csv_text({with_state_columns({"t [s]", "event", "reason", "what", "number"}), rows});
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
                  {"trajectories", samples_json(log)}};
  out["expect"] = checks_json(log.checks);
  return json_text(out);
}

}  // namespace physim::report
