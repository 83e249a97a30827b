// Runs of scenarios with emitters: what they fired is counted as a group, judged by expectations, saved and gone on
// with.
#include <algorithm>
#include <cmath>

#include "scenario/run_support.hpp"
#include "scenario/slope_scene.hpp"

namespace physim::scenario_emitter_run_test {

constexpr double kGravity = 9.80665;

/// 10 drops a second for 2.05 s, 1 m above the ground, 5 m/s upwards: 20 of them, each for as long as Galileo says.
const std::string kDrops = kVacuum + R"(
[[shot]]
name = "drop"
speed = "99 m/s"
fidelity = { preset = "arcade", precision = "float64" }
[[emitter]]
name = "jet"
shot = "drop"
position = [0, "1 m", 0]
rotation = { pitch = "90 deg" }
cycle = { duration = "2.05 s", looping = false }
start = { speed = "5 m/s" }
[world]
duration = "4 s"
step = "10 ms"
)";

WorldRun run_to_end(const Scenario& scenario) {
  WorldRun run = run_of(scenario);
  finish(run);
  return run;
}

double figure_of(const WorldGroup& group, const std::string& quantity) {
  Expectation asked{.quantity = quantity};
  return must(measure(group, asked));
}

TEST(EmitterRun, TellsPathsByTheirClosedForm) {
  const WorldRun run = run_to_end(parsed(kDrops));
  const auto groups = run.groups();
  ASSERT_EQ(groups.size(), 1u) << "a shot that only an emitter names is not fired by itself";
  const WorldGroup& jet = groups[0];
  EXPECT_EQ(jet.name, "jet");
  EXPECT_EQ(jet.spawned, 20u);
  EXPECT_EQ(jet.counts.born, 20u);
  EXPECT_EQ(jet.landed, 20u);
  EXPECT_EQ(jet.counts.landed, 20u);
  EXPECT_EQ(jet.alive, 0u);
  EXPECT_EQ(jet.time.count, 20u) << "every impact is told";
  const double time = (5 + std::sqrt(25 + 2 * kGravity)) / kGravity;
  EXPECT_NEAR(jet.time.low, time, 1e-9);
  EXPECT_NEAR(jet.time.high, time, 1e-9);
  EXPECT_NEAR(jet.speed.mean, std::sqrt(25 + 2 * kGravity), 1e-9);
}

TEST(EmitterRun, FiguresAreThoseOfItsCounts) {
  const Scenario scenario =
      parsed(kDrops, {"emitter.start.lifetime=0.5 s", "emitter.maximum=3", "world.duration=1.05 s"});
  const WorldGroup jet = run_to_end(scenario).groups().at(0);
  EXPECT_EQ(figure_of(jet, "born") + figure_of(jet, "refused"), 10);
  EXPECT_EQ(figure_of(jet, "born"), figure_of(jet, "alive") + figure_of(jet, "aged"));
  EXPECT_EQ(figure_of(jet, "alive"), 3);
  EXPECT_GT(figure_of(jet, "refused"), 0);
  EXPECT_EQ(figure_of(jet, "replaced"), 0);
  EXPECT_EQ(figure_of(jet, "taken"), 0);
  const WorldGroup newest =
      run_to_end(parsed(kDrops, {"emitter.when_full=replace_oldest", "emitter.maximum=3", "world.duration=1.05 s"}))
          .groups()
          .at(0);
  EXPECT_EQ(figure_of(newest, "born"), 10);
  EXPECT_EQ(figure_of(newest, "replaced"), 7);
  EXPECT_EQ(figure_of(newest, "refused"), 0);
}

/// Those born in a step have the indices of those that leave later in it.
TEST(EmitterRun, TellsEveryImpactWhereIndicesAreUsedAgain) {
  const WorldGroup jet = run_to_end(parsed(kDrops, {"emitter.per_second=500", "world.step=20 ms"})).groups().at(0);
  EXPECT_EQ(jet.landed, 1025u);
  EXPECT_EQ(jet.time.count, 1025u);
  EXPECT_LT(jet.time.spread(), 1e-9);
}

/// What flies for less than a step is told too, and of the right emitter.
TEST(EmitterRun, TellsShortLivesOfSeveralEmitters) {
  const Scenario scenario = parsed(kDrops + R"(
[[shape]]
name = "slab"
box = [0.1, 10, 10]
[[thing]]
name = "wall"
shape = "slab"
position = [1, 0, 0]
[[shot]]
name = "round"
fidelity = { preset = "arcade", precision = "float64" }
body = { collision = { on_hit = "stop" } }
[[emitter]]
name = "near"
shot = "round"
position = [0, 5, 0]
start = { speed = "800 m/s" }
per_second = 100
cycle = { duration = "1 s", looping = false }
[[emitter]]
name = "nearer"
shot = "round"
position = [0.5, 5, 0]
start = { speed = "800 m/s" }
per_second = 50
cycle = { duration = "1 s", looping = false }
)");
  const auto groups = run_to_end(scenario).groups();
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[1].hits, 100u);
  EXPECT_EQ(groups[2].hits, 50u);
  EXPECT_NEAR(groups[1].range.mean, 0.9, 1e-9);
  EXPECT_NEAR(groups[2].range.mean, 0.4, 1e-9);
  EXPECT_EQ(groups[1].on_things.stops, 100u);
}

/// What is fired at something of a particle is of the emitter that fires.
TEST(EmitterRun, SubEmittersHaveGroupsOfTheirOwn) {
  const Scenario scenario = parsed(kDrops + R"(
[[shot]]
name = "drip"
fidelity = { preset = "arcade", precision = "float64" }
[[emitter]]
name = "splash"
shot = "drip"
per_second = 0
from = "sphere"
start = { speed = 1, lifetime = "0.2 s" }
)",
                                   {"emitter.sub=[]"});
  Scenario with_sub = scenario;
  with_sub.emitters[0].subs.push_back({"splash", {.on = SubEvent::landing, .count = {3}}});
  with_sub.emitters[1].def.start.gravity = {0};
  const auto groups = run_to_end(with_sub).groups();
  EXPECT_EQ(groups.at(1).counts.born, 60u);
  EXPECT_EQ(run_to_end(scenario).groups().at(1).counts.born, 0u);
}

TEST(EmitterRun, FollowsAShotAndFiresTracers) {
  const std::string text = kVacuum + R"(
[[shot]]
name = "carrier"
velocity = [10, 0, 0]
fidelity = { preset = "arcade", precision = "float64" }
body = { gravity_scale = 0 }
[[shot]]
name = "round"
mass = "1 g"
fidelity = { preset = "arcade", precision = "float64" }
[[shot]]
name = "tracer"
mass = "2 g"
fidelity = { preset = "arcade", precision = "float64" }
[[emitter]]
name = "gun"
shot = "round"
follows = "carrier"
inherit_velocity = 1
per_second = 0
start = { speed = "100 m/s", gravity = 0 }
gun = { rounds_per_minute = 600, tracer_every = 2, tracer = "tracer" }
[world]
duration = "0.95 s"
step = "10 ms"
ground = "none"
)";
  WorldRun run = run_to_end(parsed(text));
  const auto groups = run.groups();
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].name, "carrier");
  EXPECT_EQ(groups[1].counts.born, 10u);
  EXPECT_NEAR(groups[1].mean_speed, 110, 1e-9);
  std::size_t tracers = 0;
  for (const ProjectileId id : run.world().ids()) tracers += run.world()[id].mass() == 0.002;
  EXPECT_EQ(tracers, 5u);
}

TEST(EmitterRun, GoesOnFromASave) {
  const Scenario scenario = parsed(kDrops, {"emitter.start.speed=[3, 6]", "emitter.seed=5"});
  WorldRun whole = WorldRun::create(scenario).value(), parts = WorldRun::create(scenario).value();
  for (std::uint64_t i = 0; i < whole.steps(); ++i) {
    if (i % 77 == 50) parts = WorldRun::load(scenario, parts.save().value()).value();
    whole.step(), parts.step();
  }
  EXPECT_EQ(whole.world().hash(), parts.world().hash());
  const WorldGroup a = whole.groups().at(0), b = parts.groups().at(0);
  EXPECT_EQ(a.counts, b.counts);
  EXPECT_EQ(a.counts.born, 20u);
  EXPECT_EQ(a.time.mean, b.time.mean);
  EXPECT_EQ(a.range.spread(), b.range.spread());
  const auto other = WorldRun::load(parsed(kDrops, {"emitter.seed=6"}), whole.save().value());
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().place, "save");
}

TEST(EmitterRun, GoesBackToASnapshot) {
  WorldRun run = WorldRun::create(parsed(kDrops)).value();
  for (int i = 0; i < 150; ++i) run.step();
  const RunSnapshot then = run.snapshot();
  const EmitterCounts counts = run.groups().at(0).counts;
  for (int i = 0; i < 100; ++i) run.step();
  EXPECT_NE(run.groups().at(0).counts, counts);
  ASSERT_TRUE(run.restore(then));
  EXPECT_EQ(run.groups().at(0).counts, counts);
}

/// Particles of before the start are those of a cycle that was played.
TEST(EmitterRun, CountsWhatWasWarmedUp) {
  const Scenario scenario = parsed(kDrops, {"emitter.cycle={ duration = \"1 s\", prewarm = true }"});
  const WorldRun run = WorldRun::create(scenario).value();
  const WorldGroup jet = run.groups().at(0);
  EXPECT_EQ(jet.counts.born, 10u);
  EXPECT_EQ(jet.alive, 10u);
  for (const ProjectileId id : run.world().ids()) EXPECT_TRUE(run.launched(id)) << "it is somebody's";
}

TEST(EmitterRun, AnExpectationOfEmittersNeedsOne) {
  WorldGroup group{.name = "gun"};
  Expectation born;
  born.quantity = "born";
  born.place = "f.toml:9:1";
  const Result<double> value = measure(group, born);
  ASSERT_FALSE(value);
  EXPECT_EQ(value.error().text(), "f.toml:9:1: error: \"gun\" is no emitter; name one as expect.shot");
}

}  // namespace physim::scenario_emitter_run_test
