// Hits of a flight, from its events, as those of a world's run are.
#include "physim/flight_hits.hpp"

#include <algorithm>

#include "base/ieee_mode.hpp"
#include "scenario/thing_hits.hpp"

namespace physim {

FlightHits flight_hits(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight,
                       const SceneParts& parts) {
  const IeeeMode mode;
  const SceneOfRun run{&scenario, parts.materials};
  const auto own = std::ranges::find(scenario.shots, shot.projectile.name,
                                     [](const ScenarioShot& each) { return each.projectile.name; });
  Track track;
  if (own != scenario.shots.end()) track.launched.group = static_cast<std::size_t>(own - scenario.shots.begin());
  track.launched.number = 1;
  FlightHits out;
  for (const Event& event : flight.events()) {
    const ThingHit* hit = take_event(out.all, track, shot.body.collision, run, event, parts.scene);
    if (hit != nullptr) count_hit(out.on_things, out.by_thing, *hit, scenario);
  }
  drop_contacts(out.all);
  return out;
}

}  // namespace physim
