// Hits of a run: told once each, with what became of them, counted by thing, and judged by expectations.
#include "scenario/run_support.hpp"
#include "scenario/slope_scene.hpp"
#include "support.hpp"

namespace physim::scenario_thing_hits_test {

constexpr double kG = 9.80665;

Expectation expected(const std::string& quantity, const std::string& thing = "") {
  return {.thing = thing, .quantity = quantity};
}

/// A ball that falls on a plane, turned by 30 degrees: it moves with the speed of the fall, and comes off the slope
/// under the angle that restitution and no friction leave.
TEST(ThingHits, TellAFallByItsClosedForm) {
  WorldRun run = run_of(kVacuum + ball_over_slope("30 deg") + R"(
[world]
duration = "1.1 s"
ground = "none"
)");
  const auto hits = hits_of(run);
  ASSERT_EQ(hits.size(), 1u);
  const ThingHit& hit = hits[0];
  const double time = std::sqrt(2 * 5 / kG), speed = kG * time, tilt = 3.14159265358979323846 / 6;
  EXPECT_NEAR(hit.time, time, 1e-9);
  EXPECT_NEAR(hit.obliquity, tilt, 1e-12);
  EXPECT_NEAR(length(hit.velocity), speed, 1e-9);
  const double along = speed * std::sin(tilt), off = 0.5 * speed * std::cos(tilt);
  EXPECT_NEAR(length(hit.velocity_after), std::hypot(along, off), 1e-9);
  EXPECT_EQ(hit.outcome, EventKind::bounced);
  EXPECT_EQ(hit.thing, 0u);
  EXPECT_EQ(hit.material, 0u);
  const WorldGroup group = run.groups()[0];
  EXPECT_EQ(group.hits, 1u);
  EXPECT_EQ(group.time.count, 1u);
  EXPECT_NEAR(group.time.mean, time, 1e-9);
}

/// A wall that comes at 10 m/s: obliquity is as seen from it.
TEST(ThingHits, SeeFromTheSurfaceThatMoves) {
  WorldRun run = run_of(kVacuum + R"(
[[shape]]
name = "wall"
box = [0.1, 50, 50]
[[thing]]
name = "wall"
shape = "wall"
position = [20, 0, 0]
velocity = ["-10 m/s", "20 m/s", 0]
[[shot]]
speed = "10 m/s"
fidelity = { preset = "game", precision = "float64", drag = "off" }
body = { gravity_scale = 0, collision = { on_hit = "stop" } }
[world]
duration = "2 s"
ground = "none"
)");
  const auto hits = hits_of(run);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].time, 19.9 / 20, 1e-9);
  EXPECT_NEAR(hits[0].obliquity, std::atan2(20.0, 20.0), 1e-9);
  EXPECT_EQ(hits[0].surface_velocity, (Vec3d{-10, 20, 0}));
  EXPECT_NEAR(hits[0].speed(), std::hypot(20.0, 20.0), 1e-9);
  EXPECT_EQ(hits[0].speed_after(), 0);
  EXPECT_EQ(hits[0].outcome, EventKind::stopped);
  EXPECT_EQ(hits[0].material, ThingHit::kNone);
  EXPECT_NEAR(measure(run.groups()[0], expected("hit_speed")).value(), std::hypot(20.0, 20.0), 1e-9);
  EXPECT_EQ(measure(run.groups()[0], expected("hit_speed_after")).value(), 0);
}

/// A ball of 0.5 m that comes straight at a drum of 1 m that turns at 6 rad/s: its surface goes by at 6 m/s where the
/// ball touches it, and would at 9 m/s where the middle of the ball is. What neither grips nor gives leaves it at that.
TEST(ThingHits, OfABallGoByTheSurfaceWhereItIsTouched) {
  WorldRun run = run_of(kVacuum + R"(
[[material]]
name = "ice"
restitution = 1
friction = 0
[[shape]]
sphere = { radius = "1 m" }
[[thing]]
shape = "shape-1"
name = "drum"
material = "ice"
position = [20, 0, 0]
angular_velocity = [0, 0, "6 rad/s"]
[[shot]]
speed = "8 m/s"
fidelity = { preset = "game", precision = "float64", drag = "off" }
body = { gravity_scale = 0, restitution = 1, friction = 0, collision = { on_hit = "bounce", radius = "50 cm" } }
[world]
duration = "3 s"
ground = "none"
)");
  const auto hits = hits_of(run);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].time, 18.5 / 8, 1e-9);
  EXPECT_NEAR(length(hits[0].surface_velocity - Vec3d{0, -6, 0}), 0, 1e-6);
  EXPECT_NEAR(hits[0].speed(), 10, 1e-6);
  EXPECT_NEAR(hits[0].obliquity, std::atan2(6.0, 8.0), 1e-6);
  EXPECT_NEAR(length(hits[0].velocity_after - Vec3d{-8, 0, 0}), 0, 1e-6);
  EXPECT_NEAR(hits[0].speed_after(), 10, 1e-6);
}

/// What slides, rolls and rests touches its floor in every step, and hits it only where it falls on it.
TEST(ThingHits, AreNoContactsThatGoOn) {
  WorldRun run = run_of(kVacuum + R"(
[[material]]
name = "stone"
restitution = 1
[[shape]]
kind = "plane"
[[thing]]
name = "floor"
shape = "shape-1"
material = "stone"
[[shot]]
position = [0, "1 m", 0]
speed = "2 m/s"
fidelity = { preset = "game", precision = "float64", drag = "off" }
body = { restitution = 0.5, friction = 0.3, collision = { on_hit = "bounce", radius = "5 cm" } }
[world]
duration = "20 s"
ground = "none"
)");
  const auto hits = hits_of(run);
  EXPECT_GT(hits.size(), 2u);
  EXPECT_LT(hits.size(), 12u);
  for (const ThingHit& hit : hits) EXPECT_EQ(hit.outcome, EventKind::bounced);
  EXPECT_EQ(run.groups()[0].bounces, hits.size());
  EXPECT_EQ(run.groups()[0].slept, 1u);
}

const std::string kThrough = R"(
[[material]]
name = "paper"
poncelet = { strength = "10 MPa" }
[[shape]]
name = "sheet"
box = ["5 mm", 1, 1]
[[shape]]
name = "gate"
box = [0.5, 2, 2]
[[thing]]
name = "gate"
shape = "gate"
position = [5, 0, 0]
sensor = true
[[thing]]
name = "first"
shape = "sheet"
material = "paper"
position = [10, 0, 0]
[[thing]]
name = "second"
shape = "sheet"
material = "paper"
position = [20, 0, 0]
[[shot]]
name = "dart"
mass = "5 g"
diameter = "8 mm"
speed = "100 m/s"
fidelity = { preset = "game", precision = "float64", drag = "off" }
body = { gravity_scale = 0, collision = { on_hit = "impact" } }
[[volley]]
name = "darts"
shot = "dart"
count = 3
interval = "0.1 s"
[world]
duration = "1 s"
ground = "none"
)";

/// A constant resistance takes the energy strength * area * thickness, so two sheets are passed and how fast is known.
/// Ways through things take no time: all of a stack are hit at one, and each has its outcome.
TEST(ThingHits, KeepTheOutcomesOfManyThatAreMetAtOneTime) {
  std::string text = R"(
[[shape]]
name = "board"
box = ["1 mm", "1 m", "1 m"]
[[shot]]
preset = "rifle_bullet"
body = { gravity_scale = 0, collision = { on_hit = "impact" } }
[world]
duration = "0.1 s"
ground = "none"
)";
  constexpr std::size_t kBoards = 20;
  for (std::size_t i = 0; i < kBoards; ++i)
    text += "[[thing]]\nshape = \"board\"\nmaterial = \"fir\"\nposition = [" +
            std::to_string(20 + 0.002 * static_cast<double>(i)) + ", 0, 0]\n";
  WorldRun run = run_of(kVacuum + text);
  const auto hits = hits_of(run);
  ASSERT_EQ(hits.size(), kBoards);
  for (std::size_t i = 0; i < kBoards; ++i) {
    EXPECT_EQ(hits[i].outcome, EventKind::penetrated) << i;
    EXPECT_EQ(hits[i].time, hits[0].time);
    EXPECT_EQ(hits[i].thing, i);
    EXPECT_NEAR(hits[i].depth, 0.002, 1e-9);
    EXPECT_EQ(hits[i].velocity, i == 0 ? hits[0].velocity : hits[i - 1].velocity_after);
  }
}

TEST(ThingHits, CountPassagesByThing) {
  WorldRun run = run_of(kVacuum + kThrough);
  const auto hits = hits_of(run);
  const double area = 3.14159265358979323846 / 4 * 0.008 * 0.008, loss = 10e6 * area * 0.01;
  const auto left = [&](int sheets) { return std::sqrt(100 * 100 - 2 * sheets * loss / 0.005); };
  const WorldGroup group = run.groups()[0];
  EXPECT_EQ(measure(group, expected("hits")).value(), 6);
  EXPECT_EQ(measure(group, expected("penetrations")).value(), 6);
  EXPECT_EQ(measure(group, expected("hits", "second")).value(), 3);
  EXPECT_NEAR(measure(group, expected("hit_speed_after", "first")).value(), left(1), 1e-9);
  EXPECT_NEAR(measure(group, expected("hit_speed", "second")).value(), left(1), 1e-9);
  EXPECT_NEAR(measure(group, expected("hit_speed_after", "second")).value(), left(2), 1e-9);
  EXPECT_NEAR(measure(group, expected("hit_depth", "second")).value(), 0.01, 1e-9);
  EXPECT_NEAR(measure(group, expected("hit_x", "second")).value(), 19.995, 1e-9);
  EXPECT_EQ(measure(group, expected("hits", "gate")).value(), 0) << "a sensor is not hit";
  EXPECT_FALSE(measure(group, expected("hit_speed", "gate")));
  EXPECT_FALSE(measure(group, expected("spawned", "first"))) << "no figure of hits";
  EXPECT_FALSE(measure(group, expected("hit_x", "nothing")));
  const auto told = [&](EventKind kind) { return std::ranges::count(hits, kind, &ThingHit::outcome); };
  EXPECT_EQ(told(EventKind::sensed), 3);
  EXPECT_EQ(told(EventKind::left), 3);
  EXPECT_EQ(told(EventKind::penetrated), 6);
  for (const ThingHit& hit : hits) EXPECT_NEAR(hit.obliquity, 0, 1e-9) << name(hit.outcome);
}

TEST(ThingHits, AreJudgedByExpectations) {
  const std::string expect = "[[expect]]\nthing = \"second\"\nquantity = \"hits\"\nequals = 3\nwithin = 0\n";
  const auto scenario = must(parse_scenario(kVacuum + kThrough + expect, "f.toml"));
  EXPECT_EQ(scenario.expect[0].thing, "second");
  const auto error_of = [&](const std::string& keys) {
    return parse_scenario(kVacuum + kThrough + "[[expect]]\n" + keys + "\nequals = 3\nwithin = 0\n", "f")
        .error()
        .text();
  };
  EXPECT_NE(error_of("thing = \"secnd\"\nquantity = \"hits\"")
                .find("expect.thing: no thing is named \"secnd\"; did you mean \"second\"?"),
            std::string::npos);
  EXPECT_NE(error_of("thing = \"second\"\nquantity = \"spawned\"").find("\"spawned\" is no figure of hits"),
            std::string::npos);
  const auto flight = parse_scenario(
      "physim = 1\n[[shot]]\n[[expect]]\nthing = \"a\"\nquantity = \"drop\"\nequals = "
      "1\nwithin = 1\n",
      "f.toml");
  EXPECT_EQ(flight.error().text(), "f.toml:4:9: error: expect.thing: there is no [world] for it");
}

TEST(ThingHits, GoOnInASaveAndARestoredRun) {
  WorldRun run = run_of(kVacuum + kThrough);
  for (int i = 0; i < 8; ++i) run.step();
  const RunSnapshot snapshot = run.snapshot();
  const auto bytes = must(run.save());
  const auto finish = [](WorldRun& r) {
    while (r.world().time() < 1 - 1e-9) r.step();
    return r.groups()[0];
  };
  const WorldGroup once = finish(run);
  ASSERT_TRUE(run.restore(snapshot));
  const WorldGroup again = finish(run);
  EXPECT_EQ(again.hits, once.hits);
  EXPECT_EQ(again.by_thing[1].speed_after.mean, once.by_thing[1].speed_after.mean);
  WorldRun loaded = must(WorldRun::load(run.scenario(), bytes));
  const WorldGroup later = finish(loaded);
  EXPECT_EQ(later.hits, once.hits);
  EXPECT_EQ(later.by_thing[1].speed_after.mean, once.by_thing[1].speed_after.mean);
}

/// A save knows the scene that its world met.
TEST(ThingHits, AreOfTheSceneThatASaveIsOf) {
  WorldRun run = run_of(kVacuum + kThrough);
  run.step();
  const auto bytes = must(run.save());
  Scenario other = run.scenario();
  other.things[2].position.x = 21;
  EXPECT_FALSE(WorldRun::load(other, bytes));
}

}  // namespace physim::scenario_thing_hits_test
