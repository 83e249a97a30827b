// The hits of runs of worlds.
#pragma once

#include <vector>

#include "scenario/world_run.hpp"

namespace physim {

/// Takes all steps of a run and keeps all of its hits.
inline std::vector<ThingHit> hits_of(WorldRun& run) {
  std::vector<ThingHit> all;
  for (std::uint64_t i = 0; i < run.steps(); ++i) {
    run.step();
    all.insert(all.end(), run.thing_hits().begin(), run.thing_hits().end());
  }
  return all;
}

}  // namespace physim
