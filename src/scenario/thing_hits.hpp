// Events about things of a scene put together to hits: what met what, and what became of it.
#pragma once

#include <span>

#include "scenario/run_state.hpp"
#include "scenario/world_run.hpp"

namespace physim {

/// The scene of a run, or of a flight.
struct SceneOfRun {
  const Scenario* scenario = nullptr;
  std::span<const MaterialId> materials;  // of Scenario::materials

  /// `radius`: of a ball [m].
  [[nodiscard]] ThingHit hit(const Launched& launched, const Event& event, double radius, const Scene& scene) const;
};

/// Where an event belongs to a hit, the hit that it makes complete, or null: not complete yet, or of no hit.
/// `collision`: the projectile's.
[[nodiscard]] const ThingHit* take_event(std::vector<ThingHit>& hits, Track& track, const CollisionDef& collision,
                                         const SceneOfRun& run, const Event& event, const Scene& scene);

/// Drops what became nothing: contacts that go on.
void drop_contacts(std::vector<ThingHit>& hits);

/// Counts what is a passage: the way into a sensor, or into a thing that lets a projectile pass.
void count_passage(Passages& passages, const ThingHit& hit, const Scenario& scenario);

/// Counts a hit: on all things, and on its own.
void count_hit(ThingHits& on_things, std::vector<ThingHits>& by_thing, const ThingHit& hit, const Scenario& scenario);

}  // namespace physim
