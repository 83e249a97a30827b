// Scenario files: what they say and where it goes.
#include "scenario/scenario.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "physim/units.hpp"
#include "scenario/run_support.hpp"

namespace physim::scenario_scenario_test {

using namespace physim::units;

// The sketch of the house plan, section 7.
const std::string kDesignExample = R"(physim = 1                          # format version
[environment]
gravity = "constant"
atmosphere = { model = "isa", temperature = "25 degC", pressure = "990 hPa", humidity = 0.4 }
wind = { velocity = ["0 m/s", "0 m/s", "-4 m/s"] }               # air velocity: from the right
[[shot]]
name = "308-175gr"
mass = "175 gr"
diameter = "7.82 mm"
drag = { table = "g7", ballistic_coefficient = "0.243 lb/in^2" }
speed = "800 m/s"
elevation = "2 deg"
fidelity = "simulation"             # or a table: { motion = "force", drag = "linear_quadratic", integrator = "rk4" }
[until]
ground = "0 m"
time = "10 s"
[[expect]]                          # makes this file a test; the source says why it should be true
at = { range = "500 m" }
quantity = "drop"
equals = "-3.10 m"
within = "0.02 m"
source = "..."
)";

TEST(Scenario, ReadsTheExampleOfTheDesign) {
  const Scenario s = parsed(kDesignExample);
  EXPECT_EQ(s.file, "f.toml");
  EXPECT_EQ(s.environment.gravity.model, GravityModel::constant);
  EXPECT_EQ(s.environment.atmosphere.model, AirModel::isa);
  EXPECT_EQ(s.environment.atmosphere.temperature, 298.15);
  EXPECT_EQ(s.environment.atmosphere.pressure, 99000.0);
  EXPECT_EQ(s.environment.atmosphere.humidity, 0.4);
  EXPECT_EQ(s.environment.atmosphere.density, std::nullopt);
  EXPECT_EQ(s.environment.wind.velocity, (Vec3d{0, 0, -4}));
  ASSERT_EQ(s.shots.size(), 1U);
  const ProjectileDef& bullet = s.shots[0].projectile;
  EXPECT_EQ(bullet.name, "308-175gr");
  EXPECT_EQ(bullet.mass, 175_gr);
  EXPECT_EQ(bullet.diameter, 7.82_mm);
  EXPECT_EQ(bullet.drag.table, DragTable::g7);
  EXPECT_EQ(bullet.drag.ballistic_coefficient, 0.243_lb_in2);
  EXPECT_EQ(bullet.fidelity, Fidelity::simulation());
  EXPECT_EQ(s.shots[0].launch.speed, 800);
  EXPECT_EQ(s.shots[0].launch.elevation, 2_deg);
  EXPECT_EQ(s.until.ground, 0.0);
  EXPECT_EQ(s.until.time, 10);
  ASSERT_EQ(s.expect.size(), 1U);
  EXPECT_EQ(s.expect[0].at, ExpectAt::range);
  EXPECT_EQ(s.expect[0].at_value, 500);
  EXPECT_EQ(s.expect[0].quantity, "drop");
  EXPECT_EQ(s.expect[0].equals, -3.1);
  EXPECT_EQ(s.expect[0].within, 0.02);
  EXPECT_EQ(s.expect[0].source, "...");
  EXPECT_EQ(s.expect[0].place, "f.toml:17:1");
}

TEST(Scenario, LeavesTheDefaultsOfTheLibrary) {
  const Scenario s = parsed("physim = 1\n[[shot]]\n");
  EXPECT_EQ(s.shots[0].projectile.name, "shot-1");
  EXPECT_EQ(s.shots[0].projectile.mass, ProjectileDef{}.mass);
  EXPECT_EQ(s.shots[0].projectile.fidelity, Fidelity{});
  EXPECT_EQ(s.shots[0].projectile.force_duration, ProjectileDef{}.force_duration);
  EXPECT_EQ(s.shots[0].launch.velocity, std::nullopt);
  EXPECT_EQ(s.until.ground, 0.0);
  EXPECT_EQ(s.until.range, std::nullopt);
  EXPECT_EQ(s.tolerance.max_steps, Tolerance{}.max_steps);
  EXPECT_TRUE(s.ranges.empty());
  EXPECT_TRUE(s.expect.empty());
}

TEST(Scenario, ReadsEveryKindOfSetting) {
  const Scenario s = parsed(R"(physim = 1
title = "All of it"
source = "made up"
[environment]
altitude = "1200 ft"
atmosphere = "exponential"
[environment.gravity]
model = "inverse_square"
acceleration = "1 g0"
[environment.wind]
by = "range"
interpolation = "step"
profile = [ { at = "0 m", velocity = [0, 0, "-3 m/s"] }, { at = "100 yd", velocity = [1, 2, 3.5] } ]
[environment.earth]
latitude = "51 deg"
azimuth = "90 deg"
[[shot]]
name = "a"
length = "31 mm"
twist = "11 in"
force = [0, "10 N", 0]
force_duration = "2 s"
position = [0, "1.5 m", 0]
velocity = ["100 m/s", 10, 0]
[shot.drag]
table = "custom"
curve = [[0, 0.2], [1, 0.5], [2.5, 0.3]]
form_factor = 1.1
damping = 0.99
k1 = 0.1
k2 = "0.02 kg/m"
[shot.fidelity]
preset = "game"
drag = "equation"
planar = true
[[shot]]
name = "b"
speed = "800 m/s"
drag = { table = "g1", bands = [ { above = "800 m/s", ballistic_coefficient = "0.5 lb/in^2" },
                                 { above = 0, ballistic_coefficient = "0.4 lb/in^2" } ] }
sight.height = "1.5 in"
sight.look_angle = "10 deg"
sight.cant = "5 deg"
sight.zero_range = "100 m"
sight.zero_in_calm_air = true
sight.dial = "2 mil"
[tolerance]
relative = 1e-10
step = "5 ms"
max_step = inf
max_steps = 1e5
[until]
ground = "off"
range = "1 km"
events = [ { kind = "mach", value = 1.0, direction = "falling" },
           { kind = "speed", value = "100 ft/s", terminal = true } ]
[output]
ranges = ["100 m", 200, "300 yd"]
)");
  EXPECT_EQ(s.title, "All of it");
  EXPECT_EQ(s.source, "made up");
  EXPECT_EQ(s.environment.altitude, 1200_ft);
  EXPECT_EQ(s.environment.atmosphere.model, AirModel::exponential);
  EXPECT_EQ(s.environment.gravity.acceleration, 9.80665);
  EXPECT_EQ(s.environment.wind.by, WindAxis::range);
  EXPECT_EQ(s.environment.wind.interpolation, WindInterpolation::step);
  ASSERT_EQ(s.environment.wind.profile.size(), 2U);
  EXPECT_EQ(s.environment.wind.profile[0].velocity, (Vec3d{0, 0, -3}));
  EXPECT_EQ(s.environment.wind.profile[1].at, 100_yd);
  EXPECT_EQ(s.environment.earth.latitude, 51_deg);
  ASSERT_EQ(s.shots.size(), 2U);
  const ProjectileDef& a = s.shots[0].projectile;
  EXPECT_EQ(a.twist, 11_in);
  EXPECT_EQ(a.force, (Vec3d{0, 10, 0}));
  EXPECT_EQ(a.force_duration, 2);
  EXPECT_EQ(s.shots[0].launch.position, (Vec3d{0, 1.5, 0}));
  EXPECT_EQ(s.shots[0].launch.velocity, (Vec3d{100, 10, 0}));
  ASSERT_EQ(a.drag.curve.size(), 3U);
  EXPECT_EQ(a.drag.curve[2].mach, 2.5);
  EXPECT_EQ(a.drag.curve[2].coefficient, 0.3);
  EXPECT_EQ(a.drag.damping, 0.99);
  EXPECT_EQ(a.drag.k2, 0.02);
  Fidelity fidelity = Fidelity::game();
  fidelity.drag = DragModel::equation;
  fidelity.planar = true;
  EXPECT_EQ(a.fidelity, fidelity);
  const ScenarioShot& b = s.shots[1];
  ASSERT_EQ(b.projectile.drag.bands.size(), 2U);
  EXPECT_EQ(b.projectile.drag.bands[0].above, 800);
  EXPECT_EQ(b.projectile.drag.bands[1].ballistic_coefficient, 0.4_lb_in2);
  EXPECT_EQ(b.launch.sight.height, 1.5_in);
  EXPECT_EQ(b.launch.sight.zero_range, 100);
  EXPECT_TRUE(b.launch.sight.zero_in_calm_air);
  EXPECT_EQ(b.launch.sight.dial, 0.002);
  EXPECT_EQ(s.tolerance.relative, 1e-10);
  EXPECT_EQ(s.tolerance.step, 0.005);
  EXPECT_TRUE(std::isinf(s.tolerance.max_step));
  EXPECT_EQ(s.tolerance.max_steps, 100000);
  EXPECT_EQ(s.until.ground, std::nullopt);
  EXPECT_EQ(s.until.range, 1000.0);
  ASSERT_EQ(s.until.events.size(), 2U);
  EXPECT_EQ(s.until.events[0].kind, EventKind::mach);
  EXPECT_EQ(s.until.events[0].direction, Crossing::falling);
  EXPECT_EQ(s.until.events[1].value, 30.48);
  EXPECT_TRUE(s.until.events[1].terminal);
  EXPECT_EQ(s.ranges, (std::vector<double>{100, 200, 300_yd}));
}

TEST(Scenario, RangesHaveShortForms) {
  const std::string head = "physim = 1\n[[shot]]\n[output]\nranges = ";
  const std::vector<double> five = {100, 200, 300, 400, 500};
  EXPECT_EQ(parsed(head + "\"100 m .. 500 m step 100 m\"").ranges, five);
  EXPECT_EQ(parsed(head + "\"100 .. 0.5 km step 100 m\"").ranges, five);
  EXPECT_EQ(parsed(head + "{ from = \"100 m\", to = 500, step = 100 }").ranges, five);
  EXPECT_EQ(parsed(head + "\"0.1 m .. 1 m step 0.1 m\"").ranges.size(), 10U) << "rounding must not lose the last";
  const std::vector<double> yards = parsed(head + "\"10 yd .. 1500 yd step 10 yd\"").ranges;
  ASSERT_EQ(yards.size(), 150U);
  EXPECT_EQ(yards.back(), 1500_yd) << "to the bit: a flight may end there";
  EXPECT_EQ(parsed(head + "\"500 m\"").ranges, std::vector<double>{500});
  EXPECT_EQ(parsed("physim = 1\n[[shot]]\n", {"output.ranges=100 m .. 500 m step 100 m"}).ranges, five);
}

TEST(Scenario, ExpectationsLookAtPlacesAndMoments) {
  const std::string head = "physim = 1\n[[shot]]\n[[expect]]\nquantity = \"speed\"\nequals = \"10 ft/s\"\nwithin = 1\n";
  const auto expectation = [&head](const std::string& at) { return parsed(head + at).expect.at(0); };
  EXPECT_EQ(expectation("").at, ExpectAt::end);
  EXPECT_EQ(expectation("").equals, 3.048);
  EXPECT_EQ(expectation("at = \"apex\"").at, ExpectAt::apex);
  EXPECT_EQ(expectation("at = \"end\"").at, ExpectAt::end);
  EXPECT_EQ(expectation("at = { time = \"2 s\" }").at, ExpectAt::time);
  EXPECT_EQ(expectation("at = { time = \"2 s\" }").at_value, 2);
  EXPECT_EQ(expectation("at = { height = \"-2 m\" }").at, ExpectAt::height);
  EXPECT_EQ(expectation("at = { height = \"-2 m\" }").at_value, -2);
}

// ----------------------------------------------------------------------------------------------------------- overrides
const std::string kTwoShots = R"(physim = 1
[environment]
gravity = "constant"
[[shot]]
name = "a"
mass = "-1 kg"
fidelity = "game"
[[shot]]
name = "b.2 long"
)";

TEST(Overrides, ReplaceTheValueOfTheFileBeforeItIsChecked) {
  const Scenario s = parsed(kTwoShots, {"shot.mass=170 gr"});
  EXPECT_EQ(s.shots[0].projectile.mass, 170_gr);
  EXPECT_EQ(s.shots[1].projectile.mass, 170_gr);
}

TEST(Overrides, OfOneShotNameIt) {
  const Scenario s = parsed(kTwoShots, {"shot.mass=2", "shot.b.2 long.mass = \"3 kg\"", "shot.a.drag.table=g7"});
  EXPECT_EQ(s.shots[0].projectile.mass, 2);
  EXPECT_EQ(s.shots[1].projectile.mass, 3);
  EXPECT_EQ(s.shots[0].projectile.drag.table, DragTable::g7);
  EXPECT_EQ(s.shots[1].projectile.drag.table, DragTable::constant);
}

TEST(Overrides, MakeTheTablesTheyNeed) {
  const Scenario s = parsed("physim = 1\n[[shot]]\n",
                            {"environment.wind.velocity=[0,0,-4]", "until.ground=off", "tolerance.max_step=inf",
                             "until.events=[{kind=\"mach\", value=1}]", "shot.sight.zero_in_calm_air=true",
                             "expect=[{quantity=\"drop\", equals=\"-1 m\", within=1}]"});
  EXPECT_EQ(s.environment.wind.velocity, (Vec3d{0, 0, -4}));
  EXPECT_EQ(s.until.ground, std::nullopt);
  ASSERT_EQ(s.until.events.size(), 1U);
  EXPECT_EQ(s.until.events[0].value, 1);
  EXPECT_TRUE(s.shots[0].launch.sight.zero_in_calm_air);
  ASSERT_EQ(s.expect.size(), 1U);
  EXPECT_EQ(s.expect[0].place, "--set expect=[{quantity=\"drop\", equals=\"-1 m\", within=1}]");
}

TEST(Overrides, OpenShorthands) {
  const Scenario s =
      parsed(kTwoShots, {"shot.mass=1", "environment.gravity.acceleration=3.7", "shot.fidelity.drag=off"});
  EXPECT_EQ(s.environment.gravity.model, GravityModel::constant);
  EXPECT_EQ(s.environment.gravity.acceleration, 3.7);
  Fidelity fidelity = Fidelity::game();
  fidelity.drag = DragModel::off;
  EXPECT_EQ(s.shots[0].projectile.fidelity, fidelity);
  EXPECT_EQ(parsed(kTwoShots, {"shot.mass=1", "environment.gravity=off"}).environment.gravity.model, GravityModel::off);
  EXPECT_EQ(parsed(kTwoShots, {"shot.mass=1", "shot.fidelity=reference"}).shots[0].projectile.fidelity,
            Fidelity::reference());
}

TEST(Overrides, OfTextsAreTakenAsTyped) {
  const Scenario s = parsed("physim = 1\n[[shot]]\n", {"title=2024", "source=\"quoted = text\"", "shot.name=308"});
  EXPECT_EQ(s.title, "2024");
  EXPECT_EQ(s.source, "quoted = text");
  EXPECT_EQ(s.shots[0].projectile.name, "308");
}

TEST(Overrides, LaterOnesWin) {
  const Scenario s = parsed("physim = 1\n[[shot]]\nname = \"x\"\n", {"shot.x.mass=1", "shot.mass=2", "shot.mass=3"});
  EXPECT_EQ(s.shots[0].projectile.mass, 3);
}

TEST(Overrides, FindShotsByTheirDefaultNames) {
  const Scenario s = parsed("physim = 1\n[[shot]]\n[[shot]]\n", {"shot.shot-2.mass=5"});
  EXPECT_EQ(s.shots[0].projectile.mass, 1);
  EXPECT_EQ(s.shots[1].projectile.mass, 5);
}

// --------------------------------------------------------------------------------------------------------------- files
class ScenarioFile : public testing::Test {
 protected:
  void SetUp() override {
    // A name of our own: tests run side by side in processes of their own.
    std::string pattern = (std::filesystem::temp_directory_path() / "physim-scenario-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& text) const {
    const std::string file = (folder_ / "s.toml").string();
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  std::filesystem::path folder_;
};

TEST_F(ScenarioFile, IsLoaded) {
  const std::string file = write(kDesignExample);
  const Scenario scenario = must(load_scenario(file));
  EXPECT_EQ(scenario.file, file);
  EXPECT_EQ(scenario.shots.size(), 1U);
}

TEST_F(ScenarioFile, OfWindowsIsLoaded) {
  std::string text = "\xEF\xBB\xBF";  // byte order mark
  for (const char c : kDesignExample) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const Result<Scenario> scenario = load_scenario(write(text));
  EXPECT_TRUE(scenario.ok()) << scenario.error().text();
}

TEST_F(ScenarioFile, FailuresHaveNames) {
  const std::string folder = folder_.string();
  EXPECT_EQ(load_scenario(folder + "/none.toml").error().text(), folder + "/none.toml: error: there is no such file");
  EXPECT_EQ(load_scenario(folder).error().text(), folder + ": error: this is a folder; name a scenario file in it");
  EXPECT_EQ(load_scenario("").error().text(), "error: there is no such file");
  const std::string empty = write("");
  EXPECT_EQ(load_scenario(empty).error().text(),
            empty + ":1:1: error: the format version is missing; write physim = 1 at the top");
}

// All mistakes of a file are told at once, in the order in which they stand there.
TEST(Mistakes, all_are_told_with_their_places) {
  const auto read = parse_scenario(
      "physim = 1\n[environment]\naltitude = \"5 kg\"\n[[shot]]\nmas = 3\nspeed = -4\n[[shot]]\nmass = \"0 kg\"\n"
      "[tolerance]\nrelative = \"x\"\n",
      "f.toml");
  ASSERT_FALSE(read);
  const std::string text = read.error().text();
  std::size_t before = 0;
  for (const char* line : {"f.toml:3:12: error: environment.altitude", "\nf.toml:5:1: error: unknown key \"mas\"",
                           "\nf.toml:6:9: error: shot.speed", "\nf.toml:8:8: error: shot.mass",
                           "\nf.toml:10:12: error: tolerance.relative"}) {
    const std::size_t at = text.find(line);
    ASSERT_NE(at, std::string::npos) << line << "\n" << text;
    EXPECT_GE(at, before) << text;
    before = at;
  }
}

TEST(Mistakes, contradictions_are_told_at_once) {
  const auto read = parse_scenario(
      "physim = 1\n[[shot]]\nname = \"a\"\nvelocity = [1, 0, 0]\nspeed = 4\n[[shot]]\nname = \"a\"\n"
      "drag = { table = \"custom\" }\n[[expect]]\nshot = \"b\"\nquantity = \"x\"\nequals = 1\nwithin = 1\n",
      "f.toml");
  ASSERT_FALSE(read);
  const std::string text = read.error().text();
  for (const char* part : {"f.toml:5:9: error: shot.speed: given together with velocity", "two shots are named \"a\"",
                           "table = \"custom\" without points", "no shot is named \"b\""})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(Mistakes, of_very_many_the_first_are_told) {
  std::string text = "physim = 1\n";
  for (int i = 0; i < 100; ++i) text += "[[shot]]\nmass = -1\n";
  const auto read = parse_scenario(text, "f.toml");
  ASSERT_FALSE(read);
  const std::string told = read.error().text();
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 20);
  EXPECT_TRUE(told.ends_with("there are more mistakes")) << told;
}

}  // namespace physim::scenario_scenario_test
