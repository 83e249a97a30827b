#include "report/world_hits.hpp"

#include <nlohmann/json.hpp>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "physim/names.hpp"
#include "report/json.hpp"
#include "report/number.hpp"
#include "report/table.hpp"

namespace physim::report {
namespace {

constexpr int kHitsIndent = 2;

std::string_view thing_name(const WorldLog& log, const ThingHit& hit) {
  return hit.thing < log.scenario.things.size() ? std::string_view(log.scenario.things[hit.thing].name) : "";
}
std::string_view material_name(const WorldLog& log, const ThingHit& hit) {
  return hit.material < log.scenario.materials.size() ? std::string_view(log.scenario.materials[hit.material].name)
                                                      : "";
}

/// A group, and which of its launches where there were several.
std::string who(const WorldLog& log, const ThingHit& hit) {
  PHYSIM_ASSERT(hit.launched.group < log.groups.size());
  const WorldGroup& group = log.groups[hit.launched.group];
  const std::string number = group.spawned > 1 ? " " + std::to_string(hit.launched.number) : "";
  return one_line(group.name) + number;
}

}  // namespace

bool has_scene(const Scenario& scenario) { return !scenario.things.empty(); }

std::string hits_table(const WorldLog& log) {
  Table table({"hit at [s]", "what", "thing", "material", "x [m]", "y [m]", "z [m]", "before [m/s]", "obliquity [deg]",
               "then", "depth [mm]", "after [m/s]"},
              "rlllrrrrrl");
  PHYSIM_ASSERT(log.thing_hits.size() <= log.thing_hit_count);
  const std::size_t shown = std::min(log.thing_hits.size(), kShownHits);
  for (std::size_t i = 0; i < shown; ++i) {
    const ThingHit& hit = log.thing_hits[i];
    table.add_row({fixed(hit.time, 5), who(log, hit), one_line(std::string(thing_name(log, hit))),
                   one_line(std::string(material_name(log, hit))), fixed(hit.position.x, 3), fixed(hit.position.y, 3),
                   fixed(hit.position.z, 3), fixed(length(hit.velocity), 2), fixed(hit.obliquity / kDegree, 2),
                   std::string(name(hit.outcome)), hit.depth > 0 ? fixed(hit.depth * 1000, 1) : "",
                   fixed(length(hit.velocity_after), 2)});
  }
  if (table.empty()) return "";
  const std::uint64_t more = log.thing_hit_count - shown;
  const std::string rest = more > 0 ? "  and " + std::to_string(more) + " more, which --hits FILE writes\n" : "";
  return "\n" + table.text(kHitsIndent) + rest;
}

Records hit_records(const WorldLog& log) {
  return {
      {"t [s]", "what", "number", "thing", "material", "x [m]", "y [m]", "z [m]", "vx [m/s]", "vy [m/s]", "vz [m/s]",
       "obliquity [deg]", "then", "depth [m]", "energy [J]", "vx after [m/s]", "vy after [m/s]", "vz after [m/s]"},
      [&log](const auto& take) {
        for (const ThingHit& hit : log.thing_hits) {
          PHYSIM_ASSERT(hit.launched.group < log.groups.size());
          const std::string_view group = log.groups[hit.launched.group].name;
          const Vec3d &x = hit.position, &v = hit.velocity, &after = hit.velocity_after;
          const Cell row[] = {hit.time,
                              group,
                              hit.launched.number,
                              thing_name(log, hit),
                              material_name(log, hit),
                              x.x,
                              x.y,
                              x.z,
                              v.x,
                              v.y,
                              v.z,
                              hit.obliquity / kDegree,
                              name(hit.outcome),
                              hit.depth,
                              hit.energy,
                              after.x,
                              after.y,
                              after.z};
          take(row);
        }
      }};
}

Content world_hits_csv(const WorldLog& log) { return csv_text(hit_records(log)); }

nlohmann::ordered_json hit_json(const WorldLog& log, const ThingHit& hit) {
  PHYSIM_ASSERT(hit.launched.group < log.groups.size());
  return {{"time [s]", hit.time},
          {"what", log.groups[hit.launched.group].name},
          {"number", hit.launched.number},
          {"thing", thing_name(log, hit)},
          {"material", material_name(log, hit)},
          {"position [m]", vector_json(hit.position)},
          {"velocity [m/s]", vector_json(hit.velocity)},
          {"obliquity [deg]", hit.obliquity / kDegree},
          {"then", name(hit.outcome)},
          {"depth [m]", hit.depth},
          {"energy [J]", hit.energy},
          {"velocity_after [m/s]", vector_json(hit.velocity_after)}};
}

}  // namespace physim::report
