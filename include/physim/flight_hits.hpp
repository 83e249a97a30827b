// FlightHits: what the flight of a scenario's shot did with the scenario's things. Part of the library physim_scenario.
#pragma once

#include <vector>

#include "physim/scene_parts.hpp"
#include "physim/world_run.hpp"

namespace physim {

/// Hits of one flight. A contact that goes on, of what slides, rolls or rests on a thing, is none.
struct FlightHits {
  /// In order of time, with what is passed or left; ThingHit::time is since launch, Launched::group the index of the
  /// shot in Scenario::shots, 0 where it is none of them, Launched::number 1, and there is no ThingHit::id [-]
  std::vector<ThingHit> all{};
  ThingHits on_things{};              ///< those that hit something [-]
  std::vector<ThingHits> by_thing{};  ///< ... of each thing, in the order of its first [-]
};

/// Puts the events of a flight together to hits: of a shot of a scenario that flew through the scenario's scene, as
/// fly_shot() flies it.
[[nodiscard]] FlightHits flight_hits(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight,
                                     const SceneParts& parts);

/// The value of an expectation on a flown shot and its hits [SI unit of the quantity], or why there is none: figures of
/// hits ("hits", "hit_depth", ...) on Expectation::thing, or on all things; all others as measure() of the flight.
[[nodiscard]] Result<double> measure(const Flight& flight, const FlightHits& hits, const Expectation& expectation);

}  // namespace physim
