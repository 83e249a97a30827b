// Scenarios out of texts, and their runs, as tests of scenarios share them.
#pragma once

#include <vector>

#include "must.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"

namespace physim {

/// The scenario of a text, which may leave its first line out; an empty one, and a failure, if it cannot be read.
inline Scenario parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const std::string head = text.starts_with("physim = 1") ? "" : "physim = 1\n";
  return must(parse_scenario(head + text, "f.toml", overrides));
}

inline WorldRun run_of(const Scenario& scenario) { return WorldRun::create(scenario).value(); }
inline WorldRun run_of(const std::string& text) { return run_of(parsed(text)); }

/// Takes the steps that are left.
inline void finish(WorldRun& run) {
  for (std::uint64_t step = run.world().counters().steps; step < run.steps(); ++step) run.step();
}

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
