// Events about things of a scene put together to hits: what met what, and what became of it.
#pragma once

#include <span>

#include "physim/world_run.hpp"
#include "scenario/run_state.hpp"

namespace physim {

/// What a run knows of its scene.
struct SceneOfRun {
  const Scenario* scenario = nullptr;
  std::span<const MaterialId> materials;  // of Scenario::materials

  [[nodiscard]] ThingHit hit(const Launched& launched, const Event& event, const Scene& scene) const;
};

/// Where an event belongs to a hit, the hit that it makes complete, or null: not complete yet, or of no hit.
[[nodiscard]] const ThingHit* take_event(RunState& state, Track& track, const SceneOfRun& run, const Event& event,
                                         const Scene& scene);

/// Drops what became nothing: contacts that go on.
void drop_contacts(RunState& state);

/// Counts a hit.
void count_hit(WorldGroup& group, const ThingHit& hit, const Scenario& scenario);

}  // namespace physim
