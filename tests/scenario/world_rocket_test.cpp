// Rockets keep their direction at every door: a launch from rest has none in its velocity.

#include <cmath>
#include <fstream>
#include <iterator>

#include "must.hpp"
#include "physim/solve.hpp"
#include "scenario/volley.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_world_rocket_test {

const std::string kRocket = PHYSIM_SOURCE_DIR "/scenarios/model_rocket.toml";

/// The shipped scenario without what it expects at events of the flight, which worlds refuse.
Scenario rocket(const std::vector<std::string>& overrides) {
  std::ifstream file(kRocket);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return must(parse_scenario(text.substr(0, text.find("[[expect]]")), kRocket, overrides));
}

Flight alone() {
  const Scenario s = rocket({});
  const ScenarioShot& shot = s.shots[0];
  return fly(shot.projectile, shot.launch, s.environment, shot.projectile.fidelity, s.tolerance, s.until);
}

TEST(WorldRocket, FliesInAWorldAsItDoesAlone) {
  const Flight flight = alone();
  for (const char* const step : {"world.step=0.01 s", "world.step=0.1 s"}) {
    WorldRun run = WorldRun::create(rocket({"world.duration=40 s", step, "world.apex_events=true"})).value();
    bool lit = false;
    for (std::uint64_t i = 0; i < run.steps(); ++i) {
      run.step();
      for (const RunEvent& e : run.events()) lit = lit || e.event.kind == EventKind::ignition;
    }
    const WorldGroup group = run.groups()[0];
    EXPECT_TRUE(lit);
    EXPECT_EQ(group.spawned, 1u) << "although its motor lights in the moment of its launch";
    EXPECT_EQ(group.landed, 1u);
    EXPECT_NEAR(group.apex.mean, 321.161, 0.02) << step;
    EXPECT_NEAR(group.time.mean, flight.duration(), 1e-3);
    EXPECT_NEAR(group.range.mean, flight.end().position.x, 1e-2);
  }
}

TEST(WorldRocket, AVolleyOfThemScattersAboutTheRail) {
  Scenario scenario = rocket({"world.duration=40 s", "world.step=0.02 s", "world.apex_events=true"});
  Volley volley{.name = "salvo", .shot = "rocket", .count = 20};
  volley.spread.horizontal = volley.spread.vertical = 0.02;
  scenario.volleys.push_back(volley);
  WorldRun run = WorldRun::create(scenario).value();
  for (std::uint64_t i = 0; i < run.steps(); ++i) run.step();
  const WorldGroup group = run.groups()[0];
  EXPECT_EQ(group.spawned, 20u);
  EXPECT_EQ(group.landed, 20u);
  EXPECT_GT(group.apex.low, 300);
  EXPECT_GT(group.range.spread(), 1);
  const Launch launch = scattered(scenario.shots[0].launch, volley, 3);
  EXPECT_EQ(*launch.velocity, Vec3d{});
  EXPECT_NEAR(launch.elevation, scenario.shots[0].launch.elevation, 0.1);
  EXPECT_NE(launch.elevation, scenario.shots[0].launch.elevation);
}

TEST(WorldRocket, IsComparedWithItsOwnPath) {
  const Scenario s = rocket({});
  const ScenarioShot& shot = s.shots[0];
  const FlightSetting setting{shot.projectile.fidelity, s.tolerance};
  const auto compared = must(compare(shot.projectile, shot.launch, s.environment, {&setting, 1}));
  EXPECT_NEAR(compared.reference.end().position.x, alone().end().position.x, 5);
  EXPECT_LT(compared.flights[0].largest_distance, 5);
}

}  // namespace physim::scenario_world_rocket_test
