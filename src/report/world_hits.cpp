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

std::string_view thing_name(const HitList& list, const ThingHit& hit) {
  return hit.thing < list.scenario.things.size() ? std::string_view(list.scenario.things[hit.thing].name) : "";
}
std::string_view material_name(const HitList& list, const ThingHit& hit) {
  return hit.material < list.scenario.materials.size() ? std::string_view(list.scenario.materials[hit.material].name)
                                                       : "";
}

const HitList::Group& group_of(const HitList& list, const ThingHit& hit) {
  PHYSIM_ASSERT(hit.launched.group < list.groups.size());
  return list.groups[hit.launched.group];
}

/// A group, and which of its launches where there were several.
std::string who(const HitList& list, const ThingHit& hit) {
  const HitList::Group& group = group_of(list, hit);
  const std::string number = group.launches > 1 ? " " + std::to_string(hit.launched.number) : "";
  return one_line(group.name) + number;
}

Records hit_records(HitList list) {
  std::vector<std::string> columns = {"t [s]",          "what",           "number",      "thing",
                                      "material",       "x [m]",          "y [m]",       "z [m]",
                                      "vx [m/s]",       "vy [m/s]",       "vz [m/s]",    "obliquity [deg]",
                                      "then",           "depth [m]",      "energy [J]",  "vx after [m/s]",
                                      "vy after [m/s]", "vz after [m/s]", "speed [m/s]", "speed after [m/s]"};
  return {std::move(columns), [list = std::move(list)](const auto& take) {
            for (const ThingHit& hit : list.hits) {
              const Vec3d &x = hit.position, &v = hit.velocity, &after = hit.velocity_after;
              const std::string_view what = group_of(list, hit).name;
              const Cell row[] = {hit.time,
                                  what,
                                  hit.launched.number,
                                  thing_name(list, hit),
                                  material_name(list, hit),
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
                                  after.z,
                                  hit.speed(),
                                  hit.speed_after()};
              take(row);
            }
          }};
}

nlohmann::ordered_json hit_json(const HitList& list, const ThingHit& hit) {
  return {{"time [s]", hit.time},
          {"what", group_of(list, hit).name},
          {"number", hit.launched.number},
          {"thing", thing_name(list, hit)},
          {"material", material_name(list, hit)},
          {"position [m]", vector_json(hit.position)},
          {"velocity [m/s]", vector_json(hit.velocity)},
          {"speed [m/s]", hit.speed()},
          {"obliquity [deg]", hit.obliquity / kDegree},
          {"then", name(hit.outcome)},
          {"depth [m]", hit.depth},
          {"energy [J]", hit.energy},
          {"velocity_after [m/s]", vector_json(hit.velocity_after)},
          {"speed_after [m/s]", hit.speed_after()}};
}

}  // namespace

HitList hits_of(const WorldLog& log) {
  HitList list{log.scenario, log.thing_hits, log.thing_hit_count, {}};
  for (const WorldGroup& group : log.groups) list.groups.push_back({group.name, group.spawned});
  return list;
}

HitList hits_of(const FlownScenario& flown) {
  HitList list{flown.scenario, flown.hits, flown.hits.size(), {}};
  for (const FlownShot& shot : flown.shots) list.groups.push_back({shot.name, 1});
  return list;
}

bool has_scene(const Scenario& scenario) { return !scenario.things.empty(); }

std::string hits_table(const HitList& list) {
  Table table({"hit at [s]", "what", "thing", "material", "x [m]", "y [m]", "z [m]", "before [m/s]", "obliquity [deg]",
               "then", "depth [mm]", "after [m/s]"},
              "rlllrrrrrl");
  PHYSIM_ASSERT(list.hits.size() <= list.count);
  const std::size_t shown = std::min(list.hits.size(), kShownHits);
  for (std::size_t i = 0; i < shown; ++i) {
    const ThingHit& hit = list.hits[i];
    table.add_row({fixed(hit.time, 5), who(list, hit), one_line(std::string(thing_name(list, hit))),
                   one_line(std::string(material_name(list, hit))), fixed(hit.position.x, 3), fixed(hit.position.y, 3),
                   fixed(hit.position.z, 3), fixed(hit.speed(), 2), fixed(hit.obliquity / kDegree, 2),
                   std::string(name(hit.outcome)), hit.depth > 0 ? fixed(hit.depth * 1000, 1) : "",
                   fixed(hit.speed_after(), 2)});
  }
  if (table.empty()) return "";
  const std::uint64_t more = list.count - shown;
  const std::string rest = more > 0 ? "  and " + std::to_string(more) + " more, which --hits FILE writes\n" : "";
  return "\n" + table.text(kHitsIndent) + rest;
}

Content world_hits_csv(const WorldLog& log) { return csv_text(hit_records(hits_of(log))); }

Content flight_hits_csv(const Flights& flights) { return csv_text(hit_records(hits_of(flights.flown))); }

void add_hits(JsonStream& out, const HitList& list) {
  out.list("hits");
  for (const ThingHit& hit : list.hits) out.push(hit_json(list, hit));
  out.close();
}

}  // namespace physim::report
