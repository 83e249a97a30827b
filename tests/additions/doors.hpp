// What an addition must do at every door of a world: it is recorded and replayed, and a snapshot brings it back.
#pragma once

#include <gtest/gtest.h>

#include "physim/scenario.hpp"
#include "physim/world.hpp"
#include "scenario/world_run.hpp"

namespace physim::test {

inline Scenario parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Result<Scenario> scenario = parse_scenario("physim = 1\n" + text, "f.toml", overrides);
  EXPECT_TRUE(scenario.ok()) << scenario.error().text();
  return scenario.ok() ? *scenario : Scenario{};
}

/// Whether the text of a setting's range or the list of settings names something.
inline bool is_listed(std::string_view path, std::string_view choice = "") {
  for (const Setting& setting : settings())
    if (setting.path == path && setting.range.find(choice) != std::string::npos) return true;
  return false;
}

/// The hash of a scenario's world after its steps.
inline std::uint64_t hash_of(const Scenario& scenario) {
  WorldRun run = WorldRun::create(scenario).value();
  for (std::uint64_t i = 0; i < run.steps(); ++i) run.step();
  return run.world().hash();
}

/// A file written and read again, a snapshot restored and a recording replayed give the same world.
inline void expect_kept_at_every_door(const Scenario& scenario) {
  const std::uint64_t hash = hash_of(scenario);
  const Result<Scenario> again = parse_scenario(scenario_text(scenario), "again.toml");
  ASSERT_TRUE(again.ok()) << again.error().text();
  EXPECT_EQ(hash_of(*again), hash);

  WorldRun run = WorldRun::create(scenario).value();
  run.step();
  const RunSnapshot start = run.snapshot();
  for (std::uint64_t i = 1; i < run.steps(); ++i) run.step();
  EXPECT_EQ(run.world().hash(), hash);
  ASSERT_TRUE(run.restore(start));
  EXPECT_NE(run.world().hash(), hash);

  const std::string file = testing::TempDir() + "physim_addition.rec";
  WorldRun recorded = WorldRun::create(scenario, file).value();
  for (std::uint64_t i = 0; i < recorded.steps(); ++i) recorded.step();
  ASSERT_TRUE(recorded.world().stop_recording());
  EXPECT_EQ(recorded.world().hash(), hash);
  const auto bytes = load_recording(file);
  ASSERT_TRUE(bytes.ok()) << bytes.error().text();
  const Result<ReplayReport> report = replay(*bytes);
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_TRUE(report->complete);
  EXPECT_FALSE(report->difference);
}

}  // namespace physim::test
