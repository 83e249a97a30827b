// Hits of a flight, from its events, as those of a world's run are.
#include "scenario/world_run.hpp"

#include <algorithm>
#include <functional>

#include "base/ieee_mode.hpp"
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
  return out;
}

}  // namespace physim
