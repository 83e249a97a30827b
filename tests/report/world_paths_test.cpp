// Paths that a run's picture draws: evenly out of all launches, few enough to be seen, and dots where particles are.
#include <algorithm>
#include <map>

#include "must.hpp"
#include "report/world_log.hpp"
#include "scenario/scenario.hpp"

namespace physim::report::report_world_paths_test {

/// 1000 a second from a muzzle that moves along z at 10 m/s: where a path begins tells when.
const std::string kMoving = R"(physim = 1
[environment]
gravity = "off"
atmosphere = "vacuum"
[[shot]]
name = "dot"
fidelity = { preset = "arcade", precision = "float64" }
[[emitter]]
name = "sweep"
shot = "dot"
motion = { velocity = [0, 0, "10 m/s"] }
per_second = 1000
maximum = 5000
start = { speed = "1 m/s", lifetime = "0.5 s", colour = "#112233" }
[world]
step = "10 ms"
duration = "3.005 s"
ground = "none"
)";

WorldLog logged(const std::string& text) {
  const Scenario scenario = must(parse_scenario(text, "f.toml"));
  return run_world(scenario, {.parts = {.paths = true}}).value();
}

TEST(WorldPaths, AreEvenlyOutOfAllLaunches) {
  const WorldLog log = logged(kMoving);
  ASSERT_EQ(log.groups.at(0).spawned, 3005u) << "in 3.005 s, whatever the steps are";
  ASSERT_GT(log.paths.size(), 150u);
  EXPECT_LE(log.paths.size(), 400u);
  const double gap = log.paths[1].points.at(0).z - log.paths[0].points.at(0).z;
  EXPECT_NEAR(gap, 0.08, 0.04) << "every eighth, or one of its neighbours among powers of two";
  for (std::size_t i = 1; i < log.paths.size(); ++i) {
    EXPECT_NEAR(log.paths[i].points.at(0).z - log.paths[i - 1].points.at(0).z, gap, 1e-9) << i;
    EXPECT_NEAR(log.paths[i].points.back().x, 0.5, 0.011) << "a whole life at 1 m/s, but for those at the end" << i;
    if (log.paths[i].points.at(0).z > 25) break;
  }
  EXPECT_GT(log.paths.back().points.at(0).z, 29);
}

TEST(WorldPaths, DotsStandWhereParticlesAre) {
  const WorldLog log = logged(kMoving);
  ASSERT_EQ(log.alive.size(), 1u);
  EXPECT_EQ(log.alive[0].size(), log.groups[0].alive);
  for (const Vec3d& place : log.alive[0]) EXPECT_NEAR(place.z / 10 + place.x, log.time, 1e-9);
}

TEST(WorldPaths, AreAllThereWhereTheyAreFew) {
  std::string text = kMoving;
  text.replace(text.find("per_second = 1000"), 17, "per_second = 100 ");
  const WorldLog log = logged(text);
  EXPECT_EQ(log.paths.size(), 300u);
}

// ------------------------------------------------------------------------------------------------- samples in files
const std::string kBalls = R"(physim = 1
[[shape]]
name = "slab"
box = ["0.2 m", "20 m", "20 m"]
[[thing]]
name = "wall"
shape = "slab"
position = ["7.1 m", "5 m", 0]
[[shot]]
name = "ball"
mass = "0.1 kg"
diameter = "4 cm"
speed = "9 m/s"
elevation = "30 deg"
position = [0, "1 m", 0]
body = { collision = { on_hit = "bounce", radius = "2 cm" } }
fidelity = "game"
[[volley]]
name = "balls"
shot = "ball"
count = 5
rate = "3 Hz"
[world]
duration = "4 s"
ground = "bounce"
apex_events = true
)";

TEST(FilesForOthers, PathsOfWorldsHaveASampleAtEveryCorner) {
  const Scenario scenario = must(parse_scenario(kBalls, "f.toml"));
  const WorldLog log = run_world(scenario, {.parts = {.samples = true, .events = true}, .interval = 0.5}).value();
  std::map<std::uint64_t, std::vector<WorldSample>> paths;
  log.each_sample([&](const WorldSample& sample, bool) { paths[sample.launched.number].push_back(sample); });
  ASSERT_EQ(paths.size(), 5u);
  int hits = 0, corners = 0;
  for (const LoggedEvent& event : log.events) {
    if (event.kind == EventKind::apex) continue;
    hits += event.kind == EventKind::hit, ++corners;
    const auto is_there = [&](const WorldSample& s) { return s.time == event.time && s.state == event.state; };
    EXPECT_EQ(std::ranges::count_if(paths[event.launched.number], is_there), 1)
        << name(event.kind) << " at " << event.time;
  }
  EXPECT_EQ(hits, 5);
  EXPECT_GT(corners, 20);
  for (const auto& [number, path] : paths) {
    EXPECT_GE(path.size(), 5u) << "the regular ones are there, too";
    EXPECT_TRUE(std::ranges::is_sorted(path, {}, &WorldSample::time)) << number;
  }
}

TEST(FilesForOthers, EventsOfWorldsAreInOrderOfTimeWithThoseOfTheWall) {
  std::string text = kBalls;
  text.replace(text.find("ground = \"bounce\""), 17, "ground = \"bounce\"\nwall = \"5 m\"\nstep = \"50 ms\"");
  const Scenario scenario = must(parse_scenario(text, "f.toml"));
  const WorldLog log = run_world(scenario, {.parts = {.events = true}}).value();
  EXPECT_EQ(std::ranges::count(log.events, true, &LoggedEvent::at_wall), 5);
  EXPECT_TRUE(std::ranges::is_sorted(log.events, {}, &LoggedEvent::time));
}

}  // namespace physim::report::report_world_paths_test
