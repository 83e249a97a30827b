// Scenarios with a [world]: what they make, how volleys fire and scatter, what is counted.
#include "scenario/world_run.hpp"

#include <cmath>
#include <set>

#include "scenario/run_support.hpp"
#include "scenario/volley.hpp"

namespace physim::scenario_world_run_test {

const std::string kGun = R"(
[[shot]]
name = "gun"
speed = "100 m/s"
position = [0, "2 m", 0]
fidelity = "game"
[[volley]]
name = "burst"
shot = "gun"
count = 50
rate = "120 rpm"
start = "1 s"
spread = { horizontal = "5 mrad", vertical = "5 mrad", speed = "1 m/s" }
[world]
duration = "30 s"
)";

const std::string kEverything = R"(
[environment]
gravity = "constant"
[[shot]]
name = "a"
preset = "grenade"
mass = "500 g"
[shot.body]
gravity_scale = 0.5
drag_scale = 2
frozen = "xz"
angular_velocity = ["60 rpm", 0, 0]
angular_drag = "2 1/s"
kinematic = true
can_sleep = false
restitution = "25 %"
rolling_resistance = 0.02
pool = "second"
colour = 0xff8000ff
label = "red"
layers = 6
smoothing = "extrapolate"
[shot.body.despawn]
below = "-inf"
farther = "100 ft"
older = "inf"
outside_box = true
box_low = [-1, -1, -1]
box_high = [1, 1, 1]
[[shot]]
name = "b"
[[volley]]
shot = "b"
interval = "0.1 s"
count = 7
seed = 123456789012
spread = { shape = "uniform", position = ["1 m", 0, "2 ft"] }
[[force]]
shots = ["a", "b"]
wind_zone = { velocity = [1, 2, 3], low = ["-inf", 0, 0], high = [1, "inf", 2] }
delay = "1 s"
duration = "2 s"
[[force]]
layers = 4
thrust = { curve = [{ time = 0, force = "10 N" }, { time = "1 s", force = 0 }] }
[[force]]
spring = { other = "a", stiffness = "3 N/mm" }
shots = "b"
[[force]]
gravity_force = {}
[world]
step = "10 ms"
duration = "1 min"
ground = { mode = "bounce", height = "-1 m", restitution = 0.9, friction = 0.3 }
wall = "50 m"
apex_events = true
pools = [{ name = "first", maximum = 5 }, { name = "second", maximum = 3, when_full = "replace_oldest" }]
threads = 3
detail = { rungs = [{ fidelity = "simulation", within = "10 m" }, { fidelity = "game" }], hysteresis = 0.2, layers = 2 }
observer = [1, 2, 3]
)";

TEST(WorldScenario, ReadsEverySetting) {
  const Scenario s = parsed(kEverything);
  EXPECT_TRUE(s.world.given);
  const BodyDef& a = s.shots.at(0).body;
  EXPECT_EQ(s.shots[0].projectile.mass, 0.5) << "keys change a preset";
  EXPECT_EQ(s.shots[0].projectile.name, "a");
  EXPECT_EQ(s.shots[0].launch.speed, 18.5);
  EXPECT_EQ(a.gravity_scale, 0.5);
  EXPECT_EQ(a.frozen, Axes::x | Axes::z);
  EXPECT_NEAR(a.angular_velocity.x, 6.283185307179586, 1e-15);
  EXPECT_EQ(a.restitution, 0.25);
  EXPECT_EQ(a.colour, 0xff8000ffu);
  EXPECT_EQ(a.smoothing, Smoothing::extrapolate);
  EXPECT_EQ(a.despawn.below, -INFINITY);
  EXPECT_NEAR(a.despawn.farther, 30.48, 1e-12);
  EXPECT_EQ(a.despawn.older, INFINITY) << "the preset's fuze is taken out";
  const WorldDef& def = s.world.def;
  EXPECT_EQ(def.step, 0.01);
  EXPECT_EQ(s.world.duration, 60);
  EXPECT_EQ(def.ground.mode, GroundMode::bounce);
  EXPECT_EQ(s.world.wall, 50.0);
  EXPECT_EQ(def.pools.at(1).when_full, WhenFull::replace_oldest);
  EXPECT_EQ(def.threading.threads, 3u);
  EXPECT_EQ(def.detail.rungs.at(0).fidelity, Fidelity::simulation());
  EXPECT_EQ(s.world.observer, (Vec3d{1, 2, 3}));
  ASSERT_EQ(s.volleys.size(), 1u);
  EXPECT_EQ(s.volleys[0].name, "volley-1");
  EXPECT_EQ(s.volleys[0].seed, 123456789012);
  ASSERT_EQ(s.forces.size(), 4u);
  EXPECT_EQ(std::get<WindZone>(s.forces[0].law).high.y, INFINITY);
  EXPECT_EQ(std::get<Thrust>(s.forces[1].law).curve.at(0).force, 10);
  EXPECT_EQ(std::get<Spring>(s.forces[2].law).stiffness, 3000);
  EXPECT_EQ(s.forces[2].other, "a");
  EXPECT_EQ(std::get<GravityForce>(s.forces[3].law).gravity.y, -9.80665);
}

TEST(WorldScenario, EffectiveSettingsReproduceIt) {
  const Scenario s = parsed(kEverything);
  std::vector<std::string> overrides;
  for (const auto& [path, value] : effective_settings(s)) overrides.push_back(path + "=" + value);
  const Scenario again = parsed("[[shot]]\nname = \"a\"\n[[shot]]\nname = \"b\"\n", overrides);
  EXPECT_EQ(effective_settings(again), effective_settings(s));
  EXPECT_EQ(again.shots[0].body, s.shots[0].body);
  EXPECT_EQ(again.forces.size(), s.forces.size());
  EXPECT_EQ(WorldRun::create(again).value().world().hash(), WorldRun::create(s).value().world().hash());
}

TEST(WorldScenario, FlightsSayNothingOfWorlds) {
  for (const auto& [path, value] : effective_settings(parsed("[[shot]]\n"))) {
    EXPECT_FALSE(path.starts_with("world") || path.starts_with("volley")) << path;
    EXPECT_EQ(path.find(".body."), std::string::npos) << path;
  }
}

TEST(WorldRun, FiresOnTime) {
  WorldRun run = run_of(kGun);
  std::vector<double> times;
  for (std::uint64_t step = 0; step < run.steps(); ++step) {
    run.step();
    for (const RunEvent& each : run.events())
      if (each.event.kind == EventKind::spawned) times.push_back(each.event.time);
  }
  ASSERT_EQ(times.size(), 50u);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], 1 + 0.5 * static_cast<double>(i), 1e-9);
  const WorldGroup group = run.groups().at(0);
  EXPECT_EQ(group.name, "burst");
  EXPECT_EQ(group.spawned, 50u);
  EXPECT_EQ(group.landed, 50u);
  EXPECT_EQ(group.range.count, 50u);
  EXPECT_GT(group.range.high, group.range.low);
}

/// A duration that is no multiple of the step ends with a shorter one.
TEST(WorldRun, EndsWhereItsDurationDoes) {
  for (const char* step : {"16.6666666666667 ms", "0.1 s", "10 s", "0.409 s"}) {
    WorldRun run =
        WorldRun::create(
            parsed("[[shot]]\nname = \"r\"\nspeed = 100\n"
                   "fidelity = { preset = \"arcade\", gravity = \"off\", precision = \"float64\" }\n[world]\n"
                   "duration = \"0.409 s\"\nground = \"none\"\n",
                   {std::string("world.step=") + step}))
            .value();
    finish(run);
    EXPECT_NEAR(run.world().time(), 0.409, 1e-15) << step;
    EXPECT_NEAR(run.groups()[0].position.x, 40.9, 1e-12) << step;
    run.step();  // it goes on in whole steps
    EXPECT_NEAR(run.world().time(), 0.409 + run.scenario().world.def.step, 1e-15) << step;
  }
}

TEST(WorldRun, EqualSeedsAreEqualAndOthersAreNot) {
  WorldRun a = run_of(kGun), b = run_of(kGun);
  WorldRun c = WorldRun::create(parsed(kGun, {"volley.seed=2"})).value();
  for (WorldRun* run : {&a, &b, &c}) finish(*run);
  EXPECT_EQ(a.world().hash(), b.world().hash());
  EXPECT_NE(a.groups()[0].range.mean, c.groups()[0].range.mean);
}

TEST(WorldRun, AWallStopsAndMeasures) {
  WorldRun run = WorldRun::create(parsed(kGun, {"world.wall=40 m", "volley.spread.speed=0"})).value();
  finish(run);
  const WorldGroup group = run.groups().at(0);
  EXPECT_EQ(group.hits, 50u);
  EXPECT_EQ(group.landed, 0u);
  EXPECT_EQ(group.alive, 0u);
  EXPECT_NEAR(group.hit_z.spread(), 0.2, 3 * 0.2 / std::sqrt(2 * 50));
  EXPECT_NEAR(group.hit_y.mean, 2 - 9.80665 / 2 * 0.16, 0.15) << "drag and Euler's error aside";
}

TEST(WorldRun, AWallIsHitWhereAFlightPassesIt) {
  Scenario scenario = parsed(
      "[[shot]]\nspeed = 100\nelevation = \"10 deg\"\nazimuth = \"5 deg\"\n"
      "fidelity = \"small_arms\"\n[world]\nduration = \"2 s\"\nground = \"none\"\nwall = \"40 m\"\n");
  WorldRun run = WorldRun::create(scenario).value();
  std::vector<WallHit> hits;
  for (std::uint64_t step = 0; step < run.steps(); ++step) {
    run.step();
    hits.insert(hits.end(), run.hits().begin(), run.hits().end());
  }
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].position.x, 40) << "on the wall, to the bit";
  const ScenarioShot& shot = scenario.shots[0];
  const Flight flight = fly(shot.projectile, shot.launch, scenario.environment, shot.projectile.fidelity,
                            {.relative = 1e-10, .absolute = 1e-10}, {.ground = {}, .time = hits[0].time});
  EXPECT_LT(length(flight.end().position - hits[0].position), 0.002);
  EXPECT_LT(length(flight.end().velocity - hits[0].velocity), 0.02);
}

TEST(WorldRun, APoolRefusesOrReplaces) {
  const std::string pool = "world.pools=[{ name = \"p\", maximum = 3, when_full = \"";
  WorldRun refuses =
      WorldRun::create(parsed(kGun, {pool + "refuse\" }]", "volley.interval=0 s", "volley.rate=none"})).value();
  WorldRun replaces =
      WorldRun::create(parsed(kGun, {pool + "replace_oldest\" }]", "volley.interval=0 s", "volley.rate=none"})).value();
  finish(refuses), finish(replaces);
  EXPECT_EQ(refuses.groups()[0].refused, 47u);
  EXPECT_NE(refuses.groups()[0].refusal.find("full"), std::string::npos);
  EXPECT_EQ(replaces.groups()[0].spawned, 50u);
  EXPECT_EQ(replaces.groups()[0].retired, 47u);
  EXPECT_EQ(replaces.groups()[0].landed, 3u);
}

TEST(WorldRun, AShotOfNoVolleyIsFiredOnceAndSpringsFindIt) {
  WorldRun run = run_of(R"(
[environment]
gravity = "off"
atmosphere = "vacuum"
[[shot]]
name = "anchor"
body = { infinite_mass = true }
[[shot]]
name = "bob"
position = [1, 0, 0]
fidelity = "constant_air"
[[force]]
shots = "bob"
spring = { other = "anchor", stiffness = "39.47841760435743 N/m" }
[world]
duration = "1 s"
ground = "none"
)");
  finish(run);
  EXPECT_NEAR(run.groups().at(1).position.x, 1, 1e-4) << "one period of the spring";
}

TEST(WorldRun, AVelocityTakesThePlaceOfAPresetsSpeed) {
  WorldRun run = run_of("[[shot]]\npreset = \"arrow\"\nvelocity = [1, 2, 3]\n[world]\n");
  EXPECT_EQ(run.world()[run.world().ids().at(0)].velocity(), (Vec3d{1, 2, 3}));
}

// --------------------------------------------------------------------------------------------------------- scatter
Volley volley_of(Spread spread) { return {.spread = spread}; }

TEST(Scatter, HasTheDeviationsAskedFor) {
  const Volley volley = volley_of({.horizontal = 0.01, .vertical = 0.02, .speed = 3});
  Series right, up, speed;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Vec3d v = *scattered({.velocity = Vec3d{0, 0, 100}}, volley, i).velocity;  // looking along z, right is -x
    right.add(std::atan2(-v.x, v.z)), up.add(std::atan2(v.y, v.z)), speed.add(length(v));
  }
  EXPECT_NEAR(right.mean, 0, 3e-4);
  EXPECT_NEAR(right.spread(), 0.01, 2e-4);
  EXPECT_NEAR(up.spread(), 0.02, 4e-4);
  EXPECT_NEAR(speed.mean, 100, 0.1);
  EXPECT_NEAR(speed.spread(), 3, 0.06);
}

TEST(Scatter, UniformStaysInsideItsBounds) {
  const Volley volley =
      volley_of({.shape = SpreadShape::uniform, .horizontal = 0.2, .vertical = 0.1, .speed = 5, .position = {1, 0, 2}});
  Series speed, x;
  std::set<double> places;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const Launch launch = scattered({.velocity = Vec3d{50, 0, 0}}, volley, i);
    const Vec3d v = *launch.velocity * (1 / length(*launch.velocity));
    const double angle = std::acos(std::min(v.x, 1.0)), size = std::hypot(v.y, v.z);
    ASSERT_GT(size, 0);
    EXPECT_LE(std::hypot(angle * v.y / size / 0.1, angle * v.z / size / 0.2), 1 + 1e-9);
    speed.add(length(*launch.velocity)), x.add(launch.position.x);
    EXPECT_EQ(launch.position.y, 0);
    EXPECT_LE(std::abs(launch.position.z), 2);
    places.insert(launch.position.x);
  }
  EXPECT_EQ(places.size(), 5000u) << "every launch has numbers of its own";
  EXPECT_GE(speed.low, 45);
  EXPECT_LE(speed.high, 55);
  EXPECT_NEAR(x.spread(), 1 / std::sqrt(3.0), 0.02);
}

TEST(Scatter, WithoutSpreadChangesNothing) {
  const Launch launch = scattered({.position = {1, 2, 3}, .velocity = Vec3d{3, 4, 0}}, Volley{}, 5);
  EXPECT_EQ(launch.position, (Vec3d{1, 2, 3}));
  EXPECT_NEAR(length(*launch.velocity - Vec3d{3, 4, 0}), 0, 1e-15);
}

TEST(WorldRun, GoesBackToASnapshotWithItsLaunchesAndCounts) {
  const Scenario scenario = must(load_scenario(PHYSIM_SOURCE_DIR "/scenarios/world_machine_gun.toml"));
  WorldRun run = std::move(WorldRun::create(scenario).value());
  for (int i = 0; i < 25; ++i) run.step();
  const RunSnapshot then = run.snapshot();
  EXPECT_EQ(then.time(), run.world().time());
  const std::uint64_t spawned_then = run.groups()[0].spawned;
  for (int i = 0; i < 50; ++i) run.step();
  const std::uint64_t hash = run.world().hash(), spawned = run.groups()[0].spawned, hits = run.groups()[0].hits;
  EXPECT_GT(spawned, spawned_then);
  ASSERT_TRUE(run.restore(then));
  EXPECT_EQ(run.groups()[0].spawned, spawned_then);
  for (int i = 0; i < 50; ++i) run.step();
  EXPECT_EQ(run.world().hash(), hash);
  EXPECT_EQ(run.groups()[0].spawned, spawned);
  EXPECT_EQ(run.groups()[0].hits, hits);
  WorldRun other = std::move(WorldRun::create(scenario).value());
  EXPECT_FALSE(other.restore(then));
  EXPECT_FALSE(run.restore(RunSnapshot{}));
}

}  // namespace physim::scenario_world_run_test
