// Hits of a flight, from its events, as those of a world's run are.
#include "scenario/world_run.hpp"

#include <algorithm>
#include <functional>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "scenario/suggest.hpp"
#include "scenario/thing_hits.hpp"

namespace physim {
namespace {

/// Which of a scenario's shots it is; of a copy, the first of its name.
std::size_t number_of(const Scenario& scenario, const ScenarioShot& shot) {
  const std::less<> before;
  const ScenarioShot *const first = scenario.shots.data(), *const end = first + scenario.shots.size();
  if (!before(&shot, first) && before(&shot, end)) return static_cast<std::size_t>(&shot - first);
  const auto own = std::ranges::find(scenario.shots, shot.projectile.name,
                                     [](const ScenarioShot& each) { return each.projectile.name; });
  return own != scenario.shots.end() ? static_cast<std::size_t>(own - scenario.shots.begin()) : 0;
}

/// The solid that a point lies inside of, a micrometre deep at least; none: it is outside, or on a surface.
InstanceId around(const Scene& scene, const Vec3d& point, const SceneFilter& solid, double time) {
  constexpr double kDeep = 1e-6;
  InstanceId found{};
  for (const Vec3d& way : {Vec3d{kDeep, 0, 0}, Vec3d{0, kDeep, 0}, Vec3d{0, 0, kDeep}})
    for (const Vec3d& near : {point + way, point - way}) {
      const SceneNearest nearest = scene.nearest(near, 0, solid, time);
      if (!nearest || nearest.away != Vec3d{}) return {};
      found = nearest.instance;
    }
  return found;
}

}  // namespace

FlightHits flight_hits(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight,
                       const SceneParts& parts) {
  const IeeeMode mode;
  FlightHits out;
  const auto is_of_thing = [](const Event& event) { return static_cast<bool>(event.instance); };
  if (std::ranges::none_of(flight.events(), is_of_thing)) return out;
  const SceneOfRun run{&scenario, parts.materials};
  Track track;
  track.launched = {number_of(scenario, shot), 1};
  for (const Event& event : flight.events()) {
    const ThingHit* hit = take_event(out.all, track, shot.body.collision, run, event, parts.scene);
    if (hit != nullptr) count_hit(out.on_things, out.by_thing, *hit, scenario);
  }
  drop_contacts(out.all);
  for (const ThingHit& hit : out.all) count_passage(out.passages, hit, scenario);
  return out;
}

std::vector<std::string> notes_of_beginnings(const Scenario& scenario, const Scene& scene,
                                             std::span<const InstanceId> things) {
  PHYSIM_ASSERT(things.size() == scenario.things.size());
  const IeeeMode mode;
  std::vector<std::string> notes;
  for (const ScenarioShot& shot : scenario.shots) {
    const std::string& name = shot.projectile.name;
    if (scenario.world.given && emitter_alone_of(scenario, name)) continue;
    const auto volley = std::ranges::find(scenario.volleys, name, &Volley::shot);
    const bool is_of_volley = scenario.world.given && volley != scenario.volleys.end();
    const CollisionDef& collision = shot.body.collision;
    if (collision.on_hit == OnHit::pass) continue;
    const SceneFilter solid{.layers = collision.layers, .sensors = false};
    const double time = is_of_volley ? volley->start : 0;
    const auto thing = std::ranges::find(things, around(scene, shot.launch.position, solid, time));
    if (thing == things.end()) continue;
    const std::string& met = scenario.things[static_cast<std::size_t>(thing - things.begin())].name;
    notes.push_back("shot " + in_quotes(name) + " begins inside of the thing " + in_quotes(met));
  }
  return notes;
}

}  // namespace physim
