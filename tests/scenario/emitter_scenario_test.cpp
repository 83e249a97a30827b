// Emitters in scenario files: what is read, what is written back, and what is refused and where.
#include "base/archive.hpp"
#include "must.hpp"
#include "scenario/revise.hpp"
#include "scenario/world_run.hpp"

namespace physim::scenario_emitter_scenario_test {

constexpr double kDegreeOfEmitters = 3.14159265358979323846 / 180;

/// All that an emitter may say, once; the second one moves.
const std::string kEverything = R"(physim = 1
[[shot]]
name = "round"
rail_length = "1 m"
[[shot]]
name = "tracer"
[[shot]]
name = "carrier"
[[emitter]]
name = "gun"
shot = "round"
position = ["1 m", "2 m", "3 m"]
rotation = { pitch = "90 deg" }
inherit_velocity = 0.5
seed = 7
cycle = { duration = "2 s", looping = false, delay = ["1 s", "2 s"], rate = 2, plays = false }
per_second = { value = "5 Hz", to = "10 Hz", curve = [[0, 1], [0.5, 0.25], [1, 0]], to_curve = [[0, 2]] }
per_metre = 3
bursts = [{ time = "0.5 s", count = [5, 9], cycles = 2, interval = "0.25 s", probability = 0.5 }, {}]
maximum = 50
when_full = "replace_oldest"
[emitter.gun]
rounds_per_minute = 600
burst_rounds = 3
burst_pause = "0.5 s"
magazine = 30
reload = "3 s"
magazines = 2
dispersion = "1 mrad"
tracer_every = 5
tracer = "tracer"
barrels = [{ position = [0, 0, "0.5 m"] }, { position = [0, 0, "-0.5 m"] }]
convergence = "250 m"
recoil_up = [[0, 0], [1, 1]]
recoil_right = [[0, 0], [0.5, -0.5], [1, 0.5]]
recoil = "2 deg"
[emitter.from]
shape = "cone"
radius = "0.5 m"
angle = "10 deg"
tube = "0.25 m"
size = [1, 2, 3]
length = "4 m"
thickness = 0.75
arc = "180 deg"
arc_mode = "ping_pong"
arc_speed = "0.5 Hz"
randomise = 0.25
[emitter.start]
lifetime = ["4 s", "6 s"]
speed = ["-4 m/s", "6 m/s"]
size = "2 cm"
size_y = 2
size_z = 3
rotation = "90 deg"
rotation_y = ["0 deg", "90 deg"]
rotation_z = "180 deg"
flipped = 0.5
colour = { colour = "#ff8000", to = "#8040204f", gradient = [[0, "#ffffff"], [1, "#20202000"]] }
gravity = -1
[emitter.life]
size = { value = 1, curve = [[0, 1], [1, 0]] }
turn = "90 deg/s"
colour = ["#ffffff", "#ffffff80"]
fast = "20 m/s"
size_by_speed = [[0, 1], [1, 2]]
colour_by_speed = [[0, "#ff0000"], [1, "#00ff0000"]]
[emitter.flight]
drag = { value = 4, to = 6, curve = [[0, 0], [1, 1]] }
fast = "20 m/s"
drag_by_speed = [[0, 0], [1, 1]]
gravity = [-1, 0.5]
velocity_x = "1 m/s"
velocity_y = ["2 m/s", "3 m/s"]
velocity_z = { value = "3 m/s", curve = [[0, 1], [1, -1]] }
force_x = "1 N"
force_y = ["2 N", "3 N"]
force_z = -4
limit = "30 m/s"
limit_rate = "5 Hz"
noise = "6 m/s^2"
noise_size = "50 cm"
noise_rate = "0.5 Hz"
noise_octaves = 3
noise_gain = 0.25
[[emitter.sub]]
on = "hit"
emitter = "sparks"
count = [3, 5]
probability = 0.5
axis = "normal"
inherit_velocity = 0.25
inherit_colour = true
inherit_size = true
[[emitter.sub]]
on = "age"
emitter = "gun"
age = "1 s"
[[emitter]]
name = "sparks"
shot = "tracer"
from = "sphere"
cycle = { prewarm = true }
[emitter.motion]
keys = [{ time = "1 s", position = [1, 2, 3], velocity = [1, 0, 0], rotation = { yaw = "90 deg" } }]
curve = "smooth"
[[emitter]]
shot = "tracer"
motion = { start = "1 s", velocity = [1, 0, 0], angular_velocity = [0, "1 rad/s", 0] }
[[emitter]]
shot = "tracer"
follows = "carrier"
[world]
)";

Scenario everything() { return must(parse_scenario(kEverything, "f.toml")); }

TEST(EmitterScenario, ReadsWhenAndWhere) {
  const Scenario s = everything();
  ASSERT_EQ(s.emitters.size(), 4u);
  const ScenarioEmitter& gun = s.emitters[0];
  EXPECT_EQ(gun.shot, "round");
  EXPECT_EQ(gun.tracer, "tracer");
  EXPECT_EQ(gun.def.position, (Vec3d{1, 2, 3}));
  EXPECT_NEAR(gun.rotation.pitch, 90 * kDegreeOfEmitters, 1e-15);
  EXPECT_EQ(gun.def.seed, 7u);
  EXPECT_EQ(gun.def.cycle.duration, 2);
  EXPECT_FALSE(gun.def.cycle.looping);
  EXPECT_EQ(gun.def.cycle.delay, (DrawnNumber{1, 2}));
  EXPECT_EQ(gun.def.cycle.rate, 2);
  EXPECT_FALSE(gun.def.cycle.plays);
  EXPECT_EQ(gun.def.per_second, (DrawnNumber{5, 10, {{0, 1}, {0.5, 0.25}, {1, 0}}, {{0, 2}}}));
  EXPECT_EQ(gun.def.per_metre, 3);
  EXPECT_EQ(gun.def.bursts, (std::vector<Burst>{{0.5, {5, 9}, 2, 0.25, 0.5}, {}}));
  EXPECT_EQ(gun.def.maximum, 50u);
  EXPECT_EQ(gun.def.when_full, WhenFull::replace_oldest);
  EXPECT_EQ(s.emitters[1].motion.keys.at(0).position, (Vec3d{1, 2, 3}));
  EXPECT_EQ(s.emitters[1].motion.curve, MotionCurve::smooth);
  EXPECT_TRUE(s.emitters[1].def.cycle.prewarm);
  EXPECT_EQ(s.emitters[2].def.name, "emitter-3");
  EXPECT_EQ(s.emitters[2].motion.velocity, (Vec3d{1, 0, 0}));
  EXPECT_EQ(s.emitters[2].def.seed, std::nullopt);
  EXPECT_EQ(s.emitters[3].follows, "carrier");
}

TEST(EmitterScenario, ReadsGunsAndShapes) {
  const EmitterDef def = everything().emitters.at(0).def;
  EXPECT_EQ(def.gun.rounds_per_minute, 600);
  EXPECT_EQ(def.gun.burst_rounds, 3u);
  EXPECT_EQ(def.gun.burst_pause, 0.5);
  EXPECT_EQ(def.gun.magazine, 30u);
  EXPECT_EQ(def.gun.reload, 3);
  EXPECT_EQ(def.gun.magazines, 2u);
  EXPECT_EQ(def.gun.dispersion, 0.001);
  EXPECT_EQ(def.gun.tracer_every, 5u);
  EXPECT_EQ(def.gun.barrels, (std::vector<Barrel>{{{0, 0, 0.5}}, {{0, 0, -0.5}}}));
  EXPECT_EQ(def.gun.convergence, 250);
  EXPECT_EQ(def.gun.recoil_up, (Curve{{0, 0}, {1, 1}}));
  EXPECT_EQ(def.gun.recoil_right, (Curve{{0, 0}, {0.5, -0.5}, {1, 0.5}})) << "values may be below zero";
  EXPECT_NEAR(def.gun.recoil, 2 * kDegreeOfEmitters, 1e-15);
  EXPECT_EQ(def.from.shape, EmitShape::cone);
  EXPECT_EQ(def.from.radius, 0.5);
  EXPECT_NEAR(def.from.angle, 10 * kDegreeOfEmitters, 1e-15);
  EXPECT_EQ(def.from.tube, 0.25);
  EXPECT_EQ(def.from.size, (Vec3d{1, 2, 3}));
  EXPECT_EQ(def.from.length, 4);
  EXPECT_EQ(def.from.thickness, 0.75);
  EXPECT_NEAR(def.from.arc, 180 * kDegreeOfEmitters, 1e-15);
  EXPECT_EQ(def.from.arc_mode, ArcMode::ping_pong);
  EXPECT_EQ(def.from.arc_speed, 0.5);
  EXPECT_EQ(def.from.randomise, 0.25);
  EXPECT_EQ(everything().emitters.at(1).def.from.shape, EmitShape::sphere) << "a shape may stand for the table";
}

TEST(EmitterScenario, ReadsStartsLivesAndSubs) {
  const ScenarioEmitter gun = everything().emitters.at(0);
  const ParticleStart& start = gun.def.start;
  EXPECT_EQ(start.lifetime, (DrawnNumber{4, 6}));
  EXPECT_EQ(start.speed, (DrawnNumber{-4, 6}));
  EXPECT_EQ(start.size, DrawnNumber{0.02});
  EXPECT_EQ(start.size_y, DrawnNumber{2});
  EXPECT_EQ(start.size_z, DrawnNumber{3});
  EXPECT_NEAR(start.rotation.value, 90 * kDegreeOfEmitters, 1e-15);
  EXPECT_NEAR(start.rotation_y.to.value(), 90 * kDegreeOfEmitters, 1e-15);
  EXPECT_NEAR(start.rotation_z.value, 180 * kDegreeOfEmitters, 1e-15);
  EXPECT_EQ(start.flipped, 0.5);
  EXPECT_EQ(start.colour, (DrawnColour{0xff8000ff, 0x8040204f, {{0, 0xffffffff}, {1, 0x20202000}}}));
  EXPECT_EQ(start.gravity, DrawnNumber{-1});
  const ParticleLife& life = gun.def.life;
  EXPECT_EQ(life.size, (DrawnNumber{1, {}, {{0, 1}, {1, 0}}}));
  EXPECT_NEAR(life.turn.value, 90 * kDegreeOfEmitters, 1e-15);
  EXPECT_EQ(life.colour, (DrawnColour{0xffffffff, 0xffffff80}));
  EXPECT_EQ(life.fast, 20);
  EXPECT_EQ(life.size_by_speed, (Curve{{0, 1}, {1, 2}}));
  EXPECT_EQ(life.colour_by_speed, (Gradient{{0, 0xff0000ff}, {1, 0x00ff0000}}));
  const ParticleFlight& flight = gun.def.flight;
  EXPECT_EQ(flight.drag, (DrawnNumber{4, 6, {{0, 0}, {1, 1}}}));
  EXPECT_EQ(flight.fast, 20);
  EXPECT_EQ(flight.drag_by_speed, (Curve{{0, 0}, {1, 1}}));
  EXPECT_EQ(flight.gravity, (DrawnNumber{-1, 0.5}));
  EXPECT_EQ(flight.velocity_x, DrawnNumber{1});
  EXPECT_EQ(flight.velocity_y, (DrawnNumber{2, 3}));
  EXPECT_EQ(flight.velocity_z, (DrawnNumber{3, {}, {{0, 1}, {1, -1}}}));
  EXPECT_EQ(flight.force_x, DrawnNumber{1});
  EXPECT_EQ(flight.force_y, (DrawnNumber{2, 3}));
  EXPECT_EQ(flight.force_z, DrawnNumber{-4});
  EXPECT_EQ(flight.limit, DrawnNumber{30});
  EXPECT_EQ(everything().emitters.at(1).def.flight.limit, DrawnNumber{kInfinity});
  EXPECT_EQ(flight.limit_rate, 5);
  EXPECT_EQ(flight.noise, DrawnNumber{6});
  EXPECT_EQ(flight.noise_size, 0.5);
  EXPECT_EQ(flight.noise_rate, 0.5);
  EXPECT_EQ(flight.noise_octaves, 3u);
  EXPECT_EQ(flight.noise_gain, 0.25);
  ASSERT_EQ(gun.subs.size(), 2u);
  const ScenarioSub& sub = gun.subs[0];
  EXPECT_EQ(sub.emitter, "sparks");
  EXPECT_EQ(sub.def.on, SubEvent::hit);
  EXPECT_EQ(sub.def.count, (DrawnNumber{3, 5}));
  EXPECT_EQ(sub.def.probability, 0.5);
  EXPECT_EQ(sub.def.axis, SubAxis::normal);
  EXPECT_EQ(sub.def.inherit_velocity, 0.25);
  EXPECT_TRUE(sub.def.inherit_colour && sub.def.inherit_size);
  EXPECT_EQ(gun.subs[1].def.age, 1);
}

TEST(EmitterScenario, IsWrittenAsItWasRead) {
  const Scenario before = everything();
  const std::string text = scenario_text(before);
  const Scenario after = must(parse_scenario(text, "f.toml"), text);
  EXPECT_TRUE(say_the_same(after, before)) << text;
  EXPECT_EQ(scenario_text(after), text);
  ASSERT_EQ(after.emitters.size(), before.emitters.size());
  for (std::size_t i = 0; i < before.emitters.size(); ++i)
    EXPECT_EQ(hash_of(after.emitters[i]), hash_of(before.emitters[i]));
  EXPECT_NE(text.find(R"(["4 s", "6 s"])"), text.npos) << text;
  EXPECT_NE(text.find("\"#ff8000\""), text.npos) << text;
}

TEST(EmitterScenario, SaysNothingOfDefaults) {
  const std::string said = "physim = 1\n\n[[shot]]\n\n[world]\n\n[[emitter]]\nname = \"a\"\nshot = \"shot-1\"\n";
  const Scenario read = parse_scenario(said, "f.toml").value();
  EXPECT_EQ(hash_of(read.emitters.at(0).def), hash_of(EmitterDef{.name = "a"}));
  EXPECT_TRUE(scenario_text(read).ends_with("\n[[emitter]]\nname = \"a\"\nshot = \"shot-1\"\n")) << scenario_text(read);
}

/// Who adds an emitter and saves keeps the file as it was, with comments, and the emitter behind it.
TEST(EmitterScenario, OneMoreIsWrittenBehindTheFile) {
  const std::string text = "physim = 1\n[[shot]]  # a\n[world]  # b\n[[emitter]]  # c\nshot = \"shot-1\"\n";
  Scenario now = parse_scenario(text, "f.toml").value();
  now.emitters.push_back(now.emitters[0]);
  now.emitters[1].def.name = "second";
  now.emitters[1].def.start.speed = {4, 6};
  EXPECT_EQ(revised_text(text, "f.toml", now),
            text + "\n[[emitter]]\nname = \"second\"\nshot = \"shot-1\"\nstart = { speed = [\"4 m/s\", \"6 m/s\"] }\n");
}

/// A file of two emitters, with what its author has to say of them.
constexpr const char* kCommented = R"(physim = 1
title = "sparks"  # of a wheel

[[shot]]
name = "spark"

# The first wheel.
[[emitter]]
name = "left"
shot = "spark"
per_second = 10   # a slow one
start = { speed = "4 m/s",  lifetime = "2 s" }  # as filmed

# The second wheel.
[[emitter]]
name = "right"  # of the bench
shot = "spark"
per_second = [10, 20]
maximum = 100   # enough
bursts = [
  { time = "1 s", count = 3 },  # first
  { time = "2 s", count = 4 },
]
[emitter.start]
lifetime = "3 s"  # they glow
size = "2 cm"     # of the glow

[world]
step = "10 ms"
)";

TEST(EmitterScenario, EditedEmittersKeepTheCommentsOfTheirFile) {
  const Scenario read = must(parse_scenario(kCommented, "f.toml"));
  Scenario now = read;
  now.emitters[0].def.start.speed = {0, 4, {}, {{0, 1}, {1, 0.5}}};
  now.emitters[0].def.start.size = {0.1};
  now.emitters[1].def.bursts.pop_back();
  now.emitters[1].def.maximum = EmitterDef{}.maximum;
  now.emitters[1].def.start.speed = {0, 4, {}, {{0, 1}, {1, 0.5}}};
  now.emitters[1].def.start.size = EmitterDef{}.start.size;
  const auto revised = must(revised_text(kCommented, "f.toml", now));
  const Scenario again = must(parse_scenario(revised, "f.toml"));
  EXPECT_TRUE(say_the_same(again, now));
  for (const char* kept :
       {"title = \"sparks\"  # of a wheel\n", "# The first wheel.\n[[emitter]]\nname = \"left\"\n",
        "per_second = 10   # a slow one\n", "}  # as filmed\n", "\n\n# The second wheel.\n[[emitter]]\n",
        "name = \"right\"  # of the bench\n", "per_second = [10, 20]\n", "lifetime = \"3 s\"  # they glow\n"})
    EXPECT_NE(revised.find(kept), std::string::npos) << kept << "is not in\n" << revised;
  for (const char* gone : {"enough", "first\n", "of the glow"})
    EXPECT_EQ(revised.find(gone), std::string::npos) << gone << " is in\n" << revised;
}

TEST(EmitterScenario, TakesOverrides) {
  const std::vector<std::string> overrides = {
      "emitter.start.speed=12 m/s", "emitter.start.lifetime={ value = 2, curve = [[0, 1], [1, 0.5]] }",
      "emitter.start.colour=#ff8000", "emitter.seed=none", "emitter.per_second=[1, 2]"};
  const Scenario read = must(parse_scenario(kEverything, "f.toml", overrides));
  for (const ScenarioEmitter& emitter : read.emitters) {
    EXPECT_EQ(emitter.def.start.speed, DrawnNumber{12});
    EXPECT_EQ(emitter.def.start.lifetime, (DrawnNumber{2, {}, {{0, 1}, {1, 0.5}}}));
    EXPECT_EQ(emitter.def.start.colour, DrawnColour{0xff8000ff});
    EXPECT_EQ(emitter.def.seed, std::nullopt);
    EXPECT_EQ(emitter.def.per_second, (DrawnNumber{1, 2}));
  }
}

// ------------------------------------------------------------------------------------------------------------- refused
struct Bad {
  std::string text, error;
  friend std::ostream& operator<<(std::ostream& out, const Bad& bad) { return out << bad.error; }
};

class BadEmitterTest : public testing::TestWithParam<Bad> {};
TEST_P(BadEmitterTest, SaysWhereAndWhy) {
  const std::string text = "physim = 1\n[[shot]]\n[world]\n[[emitter]]\nshot = \"shot-1\"\n" + GetParam().text;
  const Result<Scenario> scenario = parse_scenario(text, "f.toml");
  EXPECT_EQ(scenario.ok() ? "no error" : scenario.error().text(), GetParam().error) << text;
}

// The text begins on line 6.
INSTANTIATE_TEST_SUITE_P(
    Values, BadEmitterTest,
    testing::Values(
        Bad{"per_secnd = 1", "f.toml:6:1: error: unknown key \"per_secnd\" in [emitter]; did you mean \"per_second\"?"},
        Bad{"start.speed = \"1 m\"",
            "f.toml:6:15: error: emitter.start.speed: \"1 m\" is a length; expected a speed such as \"800 m/s\""},
        Bad{"start.speed = [1, 2, 3]",
            "f.toml:6:15: error: emitter.start.speed: found 3 entries; expected a value, or two to draw from: [low, "
            "high]"},
        Bad{"start.speed = [1, \"2 s\"]",
            "f.toml:6:19: error: emitter.start.speed: \"2 s\" is a time; expected a speed such as \"800 m/s\""},
        Bad{"start.speed = { valu = 1 }",
            "f.toml:6:17: error: emitter.start.speed: unknown key \"valu\"; did you mean \"value\"?"},
        Bad{"start.speed = { to = 1 }",
            "f.toml:6:15: error: emitter.start.speed: missing key \"value\"; expected { value, to, curve, to_curve }"},
        Bad{"start.speed = { value = 1, curve = [[0.5, 1], [0.25, 2]] }",
            "f.toml:6:48: error: emitter.start.speed: part of the span 0.25 after 0.5; they must rise"},
        Bad{"start.speed = { value = 1, curve = [[0, 1], [2, 2]] }",
            "f.toml:6:46: error: emitter.start.speed: 2 is out of range; must be 0 .. 1"},
        Bad{"start.lifetime = 0",
            "f.toml:6:18: error: emitter.start.lifetime: 0 is out of range; must be > 0 s; a bare number is in s"},
        Bad{"start.colour = \"#ff80\"",
            "f.toml:6:16: error: emitter.start.colour: \"#ff80\" is no colour; expected a colour such as \"#ff8000\", "
            "with transparency \"#ff800080\""},
        Bad{"start.colour = [\"#ff8000\", \"red\"]",
            "f.toml:6:28: error: emitter.start.colour: \"red\" is no colour; expected a colour such as \"#ff8000\", "
            "with transparency \"#ff800080\""},
        Bad{"start.colour = -1",
            "f.toml:6:16: error: emitter.start.colour: -1 is no colour; expected a colour such as \"#ff8000\", with "
            "transparency \"#ff800080\""},
        Bad{"life.colour_by_speed = [[1, \"#ffffff\"], [0, \"#ffffff\"]]",
            "f.toml:6:42: error: emitter.life.colour_by_speed: part of the span 0 after 1; they must rise"},
        Bad{"life.colour_by_speed = [\"#ffffff\"]",
            "f.toml:6:25: error: emitter.life.colour_by_speed: this is no key; expected colours [[part of the span, "
            "\"#rrggbb\"], ...]"},
        Bad{"flight.drag = -1",
            "f.toml:6:15: error: emitter.flight.drag: -1 is out of range; must be >= 0 1/s; a bare number is in 1/s"},
        Bad{"flight.noise_octaves = 9",
            "f.toml:6:24: error: emitter.flight.noise_octaves: 9 is out of range; must be 1 .. 8"},
        Bad{"flight.drag_by_speed = [[0, 1]]",
            "f.toml:6:24: error: emitter.flight.drag_by_speed: does nothing without `fast`; give the speed at which it "
            "ends"},
        Bad{"flight.noise_siz = 1",
            "f.toml:6:8: error: unknown key \"noise_siz\" in [flight]; did you mean \"noise_size\"?"},
        Bad{"from = \"con\"", "f.toml:6:8: error: emitter.from.shape: unknown value \"con\"; did you mean \"cone\"?"},
        Bad{"seed = 1.5",
            "f.toml:6:8: error: emitter.seed: 1.5 is not a whole number; expected a whole number such as 1000"},
        Bad{"start.lifetime = { value = 1, curve = [[0, 1], [1, 0]] }",
            "f.toml:6:18: error: emitter.start.lifetime: becomes 0 on its curve; keep its keys above 0"},
        Bad{"bursts = [{}, { cycles = 0, interval = 0 }]",
            "f.toml:6:40: error: emitter.bursts[1].interval: must be positive, not 0; it goes on to the end of the "
            "cycle: the moments would not end"},
        Bad{"sub = [{ emitter = \"emitter-1\", on = \"age\" }]",
            "f.toml:6:8: error: emitter.sub[0].age: must be positive, not 0; at what age it fires, in s"},
        Bad{"per_second = 1e12",
            "f.toml:6:14: error: emitter.per_second: would let out 1e+12 particles a second; at most 1e9, by rate, "
            "bursts and gun together"},
        Bad{"motion = { keys = [{}, {}] }",
            "f.toml:6:24: error: emitter.motion.keys[1].time: must be later than the key before; by more than 1e-9 s"},
        Bad{"seed = -1", "f.toml:6:8: error: emitter.seed: -1 is out of range; must be 0 .. 9007199254740992"}));

INSTANTIATE_TEST_SUITE_P(
    Names, BadEmitterTest,
    testing::Values(
        Bad{"[[emitter]]\nshot = \"shot-2\"",
            "f.toml:7:8: error: emitter.shot: no shot is named \"shot-2\"; did you mean \"shot-1\"?"},
        Bad{"[[emitter]]\nname = \"b\"",
            "f.toml:6:1: error: missing key \"shot\" in [emitter]; name of the shot that "
            "it fires: projectile, body, rail, attitude, spin; not its place and speed"},
        Bad{"name = \"a\"\n[[emitter]]\nshot = \"shot-1\"\nname = \"a\"",
            "f.toml:9:8: error: emitter.name: another emitter, volley or shot is named \"a\"; give it a name of its "
            "own"},
        Bad{"name = \"sparks\"\nsub = [{ emitter = \"spark\" }]",
            "f.toml:7:20: error: emitter.sub.emitter: no emitter is named \"spark\"; did you mean \"sparks\"?"},
        Bad{"name = \"a\"\nsub = [{ emitter = \"a\", on = \"apex\" }]",
            "f.toml:7:30: error: emitter.sub.on: no event says when a particle is at its apex; write apex_events = "
            "true "
            "into [world]"},
        Bad{"name = \"a\"\nsub = [{ emitter = \"b\" }]\n[[emitter]]\nshot = \"shot-1\"\nname = \"b\"\nsub = [{ "
            "emitter = \"a\" }]",
            "f.toml:7:7: error: emitter.sub: emitters fire each other in a circle; an emitter may fire itself, and "
            "those that do not lead back to it"},
        Bad{"gun = { tracer_every = 5 }",
            "f.toml:6:24: error: emitter.gun.tracer_every: there is no tracer; name a shot: tracer = \"...\""},
        Bad{"gun = { tracer = \"shot-1\" }",
            "f.toml:6:18: error: emitter.gun.tracer: no round is one; say which: tracer_every = 5"},
        Bad{"gun = { tracer = \"x\", tracer_every = 5 }",
            "f.toml:6:18: error: emitter.gun.tracer: no shot is named \"x\"; shots: shot-1"},
        Bad{"follows = \"shot-1\"",
            "f.toml:6:11: error: emitter.follows: \"shot-1\" is fired by an emitter; name a shot that no emitter "
            "fires: there is one of it"},
        Bad{"follows = \"other\"\nmotion = { velocity = [1, 0, 0] }\n[[shot]]\nname = \"other\"",
            "f.toml:6:11: error: emitter.follows: given together with motion; give one of them"},
        Bad{"position = [1, 0, 0]\nmotion = { keys = [{}] }",
            "f.toml:6:12: error: emitter.position: given together with keys; the keys say where it is and how it "
            "moves"},
        Bad{"motion = { keys = [{}], velocity = [1, 0, 0] }",
            "f.toml:6:36: error: emitter.motion.velocity: given together with keys; the keys say where it is and how "
            "it moves"},
        Bad{"rotation = { angle = 1, yaw = 1 }",
            "f.toml:6:12: error: emitter.rotation: given by an angle and by yaw, pitch and roll; give one of them"},
        Bad{"[[expect]]\nquantity = \"born\"\nshot = \"shot-1\"\nequals = 1\nwithin = 0",
            "f.toml:8:8: error: expect.shot: nothing is counted as \"shot-1\"; there are: emitter-1"}));

/// A gun has no rate where the file says none, and whatever rate it has is written so that it is read again.
TEST(EmitterScenario, AGunAloneHasNoRateAndKeepsTheOneItIsGiven) {
  const std::string gun =
      "physim = 1\n[[shot]]\n[world]\n[[emitter]]\nshot = \"shot-1\"\ngun.rounds_per_minute = 600\n";
  for (const auto& [more, rate] : {std::pair{"", 0.0}, {"per_second = 10\n", 10.0}, {"per_second = 3\n", 3.0}}) {
    const Scenario scenario = must(parse_scenario(gun + more, "f.toml"));
    EXPECT_EQ(scenario.emitters[0].def.per_second.value, rate);
    const Scenario again = must(parse_scenario(scenario_text(scenario), "g.toml"));
    EXPECT_EQ(again.emitters[0].def.per_second.value, rate) << scenario_text(scenario);
  }
}

TEST(BadEmitter, NeedsAWorld) {
  const Result<Scenario> scenario = parse_scenario("physim = 1\n[[shot]]\n[[emitter]]\nshot = \"shot-1\"\n", "f.toml");
  ASSERT_FALSE(scenario);
  EXPECT_EQ(scenario.error().text(),
            "f.toml:3:1: error: emitter: there is no [world] for it; write [world], and the shots fly in it");
}

TEST(BadEmitter, ItsFiguresNeedOne) {
  const std::string text = "physim = 1\n[[shot]]\n[world]\n[[expect]]\nquantity = \"born\"\nequals = 1\nwithin = 0\n";
  const Result<Scenario> none = parse_scenario(text, "f.toml");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().text(),
            "f.toml:5:12: error: expect.quantity: \"born\" is a figure of emitters; there is no [[emitter]]");
  const Result<Scenario> other =
      parse_scenario(text + "shot = \"shot-1\"\n[[shot]]\nname = \"a\"\n[[emitter]]\nshot = \"a\"\n", "f.toml");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().text(),
            "f.toml:5:12: error: expect.quantity: \"born\" is a figure of emitters; name one as "
            "expect.shot");
}

}  // namespace physim::scenario_emitter_scenario_test
