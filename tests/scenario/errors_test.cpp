// Bad scenarios: every one gets a place, a reason and, where there is one, a way out.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenario/scenario.hpp"

namespace physim::scenario_errors_test {

struct Bad {
  std::string text;
  std::string error;
  friend std::ostream& operator<<(std::ostream& out, const Bad& bad) { return out << bad.error; }
};

std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Result<Scenario> scenario = parse_scenario(text, "f.toml", overrides);
  return scenario.ok() ? "no error" : scenario.error().text();
}

class BadFileTest : public testing::TestWithParam<Bad> {};
TEST_P(BadFileTest, SaysWhereAndWhy) { EXPECT_EQ(error_of(GetParam().text), GetParam().error) << GetParam().text; }

INSTANTIATE_TEST_SUITE_P(
    Toml, BadFileTest,
    testing::Values(
        Bad{"", "f.toml:1:1: error: the format version is missing; write physim = 1 at the top"},
        Bad{"physim = 2", "f.toml:1:10: error: physim: unknown format version 2; this program reads version 1"},
        Bad{"physim = \"1\"", "f.toml:1:10: error: physim: unknown format version \"1\"; this program reads version 1"},
        Bad{"physim = 1", "f.toml:1:1: error: the scenario has no shot; add a [[shot]]"},
        Bad{"physim = 1\n[[shots]]\nmass = 1",
            "f.toml:2:3: error: unknown key \"shots\" in the file; did you mean \"shot\"?"},
        Bad{"physim = 1\nshot = []", "f.toml:2:8: error: the scenario has no shot; add a [[shot]]"},
        Bad{"physim = 1\nphysim = 1",
            "f.toml:2:10: error: not valid TOML (key-value pair): cannot redefine existing integer 'physim'; a name "
            "may stand only once in a table"},
        Bad{"physim = 1\n[[shot]]\n[until]\n[until]",
            "f.toml:4:1: error: not valid TOML (table header): cannot redefine existing table 'until'; a name may "
            "stand only once in a table"},
        Bad{"physim = 1\n[[shot]]\nname = \"half",
            "f.toml:3:13: error: not valid TOML (string): encountered end-of-file"},
        Bad{"physim = 1\n[[shot", "f.toml:2:7: error: not valid TOML (table header): encountered end-of-file"},
        Bad{"physim = 1\n[[shot]]\nname = \"\xC3\x28\"",
            "f.toml:3:8: error: not valid TOML: Encountered invalid utf-8 sequence"},
        Bad{"[[[[[[",
            "f.toml:1:3: error: not valid TOML (key): expected bare key starting character or string delimiter, saw "
            "'['"},
        Bad{"physim = " + std::string(10000, '['),
            "f.toml:1:266: error: not valid TOML (value): exceeded maximum nested value depth of 256 "
            "(TOML_MAX_NESTED_VALUES)"},
        Bad{std::string(1, 'a') +
                [] {
                  std::string s;
                  for (int i = 0; i < 100000; ++i) s += ".a";
                  return s;
                }() +
                " = 1",
            "f.toml:1:1002: error: a key of more than 500 parts"}));

// The head is one line, so the text begins on line 2.
class BadKeyTest : public testing::TestWithParam<Bad> {};
TEST_P(BadKeyTest, SaysWhereAndWhy) {
  EXPECT_EQ(error_of("physim = 1\n" + GetParam().text), GetParam().error) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadKeyTest,
    testing::Values(
        Bad{"[[shot]]\n[environment.wind]\nvelocty = [0, 0, 0]",
            "f.toml:4:1: error: unknown key \"velocty\" in [wind]; did you mean \"velocity\"?"},
        Bad{"[[shot]]\n[enviroment]\n",
            "f.toml:3:2: error: unknown key \"enviroment\" in the file; did you mean \"environment\"?"},
        Bad{"[[shot]]\nMass = 1", "f.toml:3:1: error: unknown key \"Mass\" in [shot]; did you mean \"mass\"?"},
        Bad{"[[shot]]\nfrobnicate = 1\n[shot.drag]\nwidth = 1",
            "f.toml:3:1: error: unknown key \"frobnicate\" in [shot]; known keys: name, preset, mass, diameter, "
            "length, twist, "
            "drag, gravity_scale, force, force_duration, position, speed, elevation, azimuth, velocity, rail_length, "
            "sight, spin, magnus, motor, inertia, aero, attitude, fidelity, body\n"
            "f.toml:5:1: error: unknown key \"width\" in [drag]; known keys: table, coefficient, curve, "
            "ballistic_coefficient, bands, form_factor, damping, k1, k2"},
        Bad{"[[shot]]\nzero_range = 100",
            "f.toml:3:1: error: unknown key \"zero_range\" in [shot]; \"zero_range\" belongs into [shot.sight]"},
        Bad{"[[shot]]\n[until]\nevents = [{ kind = \"mach\", terminals = true }]",
            "f.toml:4:28: error: unknown key \"terminals\" in [events]; did you mean \"terminal\"?"},
        Bad{"[[shot]]\n[shot.fidelity]\nintegrater = \"rk4\"",
            "f.toml:4:1: error: unknown key \"integrater\" in [fidelity]; did you mean \"integrator\"?"},
        Bad{"[[shot]]\n[[expect]]\nequals = 1\nwithin = 1",
            "f.toml:3:1: error: missing key \"quantity\" in [expect]; figure to look at"},
        Bad{"[[shot]]\n[[expect]]\nquantity = \"drop\"\nequals = 1",
            "f.toml:3:1: error: missing key \"within\" in [expect]; distance allowed"},
        Bad{"[[shot]]\n[until]\nevents = [{ value = 1 }]",
            "f.toml:4:11: error: missing key \"kind\" in [events]; what is watched"},
        Bad{"[[shot]]\n[output]\nranges = { from = 0, to = 100, stop = 10 }",
            "f.toml:4:32: error: unknown key \"stop\" in [ranges]; did you mean \"step\"?"}));

INSTANTIATE_TEST_SUITE_P(
    Types, BadKeyTest,
    testing::Values(
        Bad{"[shot]", "f.toml:2:1: error: shot: found a table; expected a list of tables; write [[shot]]"},
        Bad{"shot = 5", "f.toml:2:8: error: shot: found a number; expected a list of tables; write [[shot]]"},
        Bad{"shot = [5]",
            "f.toml:2:9: error: shot: found a number; expected a table with keys out of: name, preset, mass, diameter, "
            "length, "
            "twist, drag, gravity_scale, force, force_duration, position, speed, elevation, azimuth, velocity, "
            "rail_length, "
            "sight, spin, magnus, motor, inertia, aero, attitude, fidelity, body"},
        Bad{"[[shot]]\nmass = true",
            "f.toml:3:8: error: shot.mass: found a boolean; expected a mass such as \"168 gr\""},
        Bad{"[[shot]]\nmass = 2024-01-01",
            "f.toml:3:8: error: shot.mass: found a date; expected a mass such as \"168 gr\""},
        Bad{"[[shot]]\nname = 308", "f.toml:3:8: error: shot.name: found a number; expected a text in quotes"},
        Bad{"[[shot]]\ndrag = \"g7\"",
            "f.toml:3:8: error: shot.drag: found a text; expected a table with keys out of: table, coefficient, curve, "
            "ballistic_coefficient, bands, form_factor, damping, k1, k2"},
        Bad{"[[shot]]\nposition = 5",
            "f.toml:3:12: error: shot.position: found a number; expected three components [x, y, z]"},
        Bad{"[[shot]]\nposition = [1, 2]",
            "f.toml:3:12: error: shot.position: found 2 components; expected three components [x, y, z]"},
        Bad{"[[shot]]\nposition = [1, 2, \"3 s\"]",
            "f.toml:3:19: error: shot.position: \"3 s\" is a time; expected a length such as \"7.82 mm\""},
        Bad{"[[shot]]\n[shot.sight]\nzero_in_calm_air = \"yes\"",
            "f.toml:4:20: error: shot.sight.zero_in_calm_air: found a text; expected true or false"},
        Bad{"[[shot]]\n[tolerance]\nmax_steps = 1.5",
            "f.toml:4:13: error: tolerance.max_steps: 1.5 is not a whole number; expected a whole number such as 1000"},
        Bad{"[[shot]]\n[shot.drag]\ntable = \"G7\"",
            "f.toml:4:9: error: shot.drag.table: unknown value \"G7\"; did you mean \"g7\"?"},
        Bad{"[[shot]]\n[shot.drag]\ntable = \"g9\"",
            "f.toml:4:9: error: shot.drag.table: unknown value \"g9\"; known values: constant, g1, g2, g5, g6, g7, g8, "
            "gi, gs, ra4, sphere, custom"},
        Bad{"[[shot]]\nfidelity = \"simulaton\"",
            "f.toml:3:12: error: shot.fidelity.preset: unknown value \"simulaton\"; did you mean \"simulation\"?"},
        Bad{"environment.gravity = 9.81\n[[shot]]",
            "f.toml:2:23: error: environment.gravity.model: unknown value 9.81; known values: off, constant, "
            "inverse_square, j2, wgs84"},
        Bad{"[[shot]]\n[[expect]]\nquantity = \"hight\"\nequals = 1\nwithin = 1",
            "f.toml:4:12: error: expect.quantity: unknown value \"hight\"; known values: drop, windage, range, speed, "
            "time, x, y, z, vx, vy, vz, ax, ay, az, jx, jy, jz, mach, energy, mass, thrust, latitude, longitude, "
            "altitude, "
            "elevation, yaw, pitch, roll, spin_rate, angle_of_attack, ..."},
        Bad{"[[shot]]\n[[expect]]\nquantity = \"drop\"\nequals = \"1 m/s\"\nwithin = 1",
            "f.toml:5:10: error: expect.equals: \"1 m/s\" is a speed; expected a length such as \"7.82 mm\""},
        Bad{"[[shot]]\n[until]\nevents = [{ kind = \"speed\", value = \"3 m\" }]",
            "f.toml:4:37: error: until.events.value: \"3 m\" is a length; expected a speed such as \"800 m/s\""},
        Bad{"[[shot]]\n[output]\nranges = \"100 m .. 200 m\"",
            "f.toml:4:10: error: output.ranges: \"100 m .. 200 m\" has no step; expected \"100 m .. 1000 m step 100 "
            "m\""},
        Bad{"[[shot]]\n[output]\nranges = { from = 0, to = 100 }",
            "f.toml:4:10: error: output.ranges: missing key \"step\"; expected { from, to, step }"},
        Bad{"[[shot]]\n[shot.drag]\ncurve = [[0, 1], [1]]",
            "f.toml:4:18: error: shot.drag.curve: this is no point; expected points [[Mach number, drag coefficient], "
            "...]"}));

INSTANTIATE_TEST_SUITE_P(
    Values, BadKeyTest,
    testing::Values(
        Bad{"[[shot]]\nmass = \"168 ft\"",
            "f.toml:3:8: error: shot.mass: \"168 ft\" is a length; expected a mass such as \"168 gr\""},
        Bad{"[[shot]]\nmass = \"168 grains\"",
            "f.toml:3:8: error: shot.mass: unknown unit \"grains\" in \"168 grains\"; known units: kg, g, mg, gr, lb, "
            "oz, slug, t"},
        Bad{"[[shot]]\nmass = \"heavy\"",
            "f.toml:3:8: error: shot.mass: \"heavy\" is not a number; expected a mass such as \"168 gr\""},
        Bad{"[[shot]]\nmass = nan",
            "f.toml:3:8: error: shot.mass: nan is not a finite number; expected a mass such as \"168 gr\""},
        Bad{"[[shot]]\nmass = inf",
            "f.toml:3:8: error: shot.mass: inf is not a finite number; expected a mass such as \"168 gr\""},
        Bad{"[[shot]]\nmass = \"inf kg\"",
            "f.toml:3:8: error: shot.mass: \"inf kg\" is not a finite number; expected a mass such as \"168 gr\""},
        Bad{"[[shot]]\nposition = [0, nan, 0]",
            "f.toml:3:16: error: shot.position: nan is not a finite number; expected a length such as \"7.82 mm\""},
        Bad{"[[shot]]\nmass = \"-1 kg\"", "f.toml:3:8: error: shot.mass: \"-1 kg\" is out of range; must be > 0 kg"},
        Bad{"[[shot]]\ndiameter = 0",
            "f.toml:3:12: error: shot.diameter: 0 is out of range; must be > 0 m; a bare number is in m"},
        Bad{"[[shot]]\nelevation = 2",
            "f.toml:3:13: error: shot.elevation: 2 is out of range; must be -90 deg .. 90 deg; a bare number is in "
            "rad"},
        Bad{"environment.atmosphere.humidity = \"140 %\"\n[[shot]]",
            "f.toml:2:35: error: environment.atmosphere.humidity: \"140 %\" is out of range; must be 0 .. 1"},
        Bad{"[[shot]]\n[shot.drag]\ndamping = 0",
            "f.toml:4:11: error: shot.drag.damping: 0 is out of range; must be > 0, <= 1"},
        Bad{"[[shot]]\n[shot.drag]\ndamping = 1.1",
            "f.toml:4:11: error: shot.drag.damping: 1.1 is out of range; must be > 0, <= 1"},
        Bad{"[[shot]]\n[tolerance]\nmax_steps = 0",
            "f.toml:4:13: error: tolerance.max_steps: 0 is out of range; must be 1 .. 1e+09"},
        Bad{"[[shot]]\n[until]\ntime = inf",
            "f.toml:4:8: error: until.time: inf is not a finite number; expected a time such as \"2.5 s\""},
        Bad{"[[shot]]\n[shot.drag]\ntable = \"custom\"\ncurve = []",
            "f.toml:5:9: error: shot.drag.curve: table = \"custom\" without points; write curve = [[Mach number, drag "
            "coefficient], ...]"},
        Bad{"[[shot]]\n[shot.drag]\ntable = \"custom\"",
            "f.toml:3:1: error: shot.drag.curve: table = \"custom\" without points; write curve = [[Mach number, drag "
            "coefficient], ...]"},
        Bad{"[[shot]]\n[shot.drag]\ncurve = [[0, 0.1], [2, 0.3], [1, 0.2]]",
            "f.toml:4:31: error: shot.drag.curve: Mach number 1 after 2; they must rise"},
        Bad{"[[shot]]\n[shot.drag]\ncurve = [[0, 0.1], [0, 0.3]]",
            "f.toml:4:21: error: shot.drag.curve: Mach number 0 after 0; they must rise"},
        Bad{"[[shot]]\n[shot.drag]\ncurve = [[0, -0.1]]",
            "f.toml:4:14: error: shot.drag.curve: -0.1 is out of range; must be >= 0"},
        Bad{"[[shot]]\n[output]\nranges = \"0 m .. 1000 km step 1 mm\"",
            "f.toml:4:10: error: output.ranges: too many steps; at most 100000"},
        Bad{"[[shot]]\n[output]\nranges = \"0 m .. 100 m step 0 m\"",
            "f.toml:4:10: error: output.ranges: the steps lead nowhere; from <= to and step > 0"},
        Bad{"[[shot]]\n[output]\nranges = [-5]",
            "f.toml:4:11: error: output.ranges: -5 is out of range; must be >= 0 m; a bare number is in m"}));

INSTANTIATE_TEST_SUITE_P(
    Contradictions, BadKeyTest,
    testing::Values(
        Bad{"[[shot]]\nname = \"a\"\n[[shot]]\nname = \"a\"",
            "f.toml:5:8: error: shot.name: two shots are named \"a\"; the first is at f.toml:3:8"},
        Bad{"[[shot]]\nname = \"a=b\"",
            "f.toml:3:8: error: shot.name: \"a=b\" has a character that names may not have; leave out =, \" and "
            "control "
            "characters"},
        Bad{"[[shot]]\nname = \" a\"", "f.toml:3:8: error: shot.name: \" a\" begins or ends with a space"},
        Bad{"[[shot]]\nelevation = \"2 deg\"\nsight = { zero_range = \"100 m\" }",
            "f.toml:3:13: error: shot.elevation: given together with sight.zero_range; the zero range finds the "
            "elevation; give one of them"},
        Bad{"[[shot]]\nvelocity = [1, 2, 3]\nspeed = 5",
            "f.toml:4:9: error: shot.speed: given together with velocity; give either velocity, or speed with "
            "elevation "
            "and azimuth"},
        Bad{"[[shot]]\nvelocity = [1, 2, 3]\nsight.zero_range = 100",
            "f.toml:4:20: error: shot.sight.zero_range: given together with velocity; give speed instead; the zero "
            "range "
            "finds the elevation"},
        Bad{"[[shot]]\ndrag = { curve = [[0, 0.1], [1, 0.3]] }",
            "f.toml:3:18: error: shot.drag.curve: not used by the default table = \"constant\"; write table = "
            "\"custom\""},
        Bad{"[[shot]]\n[shot.drag]\ntable = \"g1\"\nballistic_coefficient = 100\nbands = [{ ballistic_coefficient = 90 "
            "}]",
            "f.toml:6:9: error: shot.drag.bands: given together with ballistic_coefficient; give one of them"},
        Bad{"[[shot]]\n[shot.drag]\ntable = \"g1\"\nbands = [{ above = 5, ballistic_coefficient = 90 },\n { above = 5, "
            "ballistic_coefficient = 90 }]",
            "f.toml:6:12: error: shot.drag.bands: two bands from 5 m/s; each band needs its own speed"},
        Bad{"[environment.wind]\nprofile = [{ at = 10, velocity = [0,0,0] },\n { at = 5, velocity = [0,0,0] "
            "}]\n[[shot]]",
            "f.toml:4:2: error: environment.wind.profile[1]: places must rise, by 1e-9 m at least; sort the points"},
        Bad{"[environment.atmosphere]\nprofile = [{ altitude = 0, temperature = 288, pressure = 101325 },\n { altitude "
            "= "
            "1000, temperature = 281, pressure = 120000 }]\n[environment.wind]\nprofile = [{ at = 10, velocity = "
            "[0,0,0] "
            "}, { at = 5, velocity = [0,0,0] }]\n[[shot]]",
            "f.toml:4:2: error: environment.atmosphere.profile[1]: must have less pressure than the level below; "
            "pressures are those at the level, in pascal\nf.toml:6:45: error: environment.wind.profile[1]: places must "
            "rise, by 1e-9 m at least; sort the points"},
        Bad{"[[shot]]\nname = \"one\"\n[[expect]]\nshot = \"ome\"\nquantity = \"drop\"\nequals = 1\nwithin = 1",
            "f.toml:5:8: error: expect.shot: no shot is named \"ome\"; did you mean \"one\"?"},
        Bad{"[[shot]]\n[[expect]]\nat = { time = 1, range = 2 }\nquantity = \"drop\"\nequals = 1\nwithin = 1",
            "f.toml:4:6: error: expect.at: 2 places; give one of time, range, height or a moment"}));

// -------------------------------------------------------------------------------------------------------------- limits
std::string list_of(std::size_t count, const std::string& element) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) out += (i ? "," : "") + element;
  return "[" + out + "]";
}

/// The words of an error behind its place.
std::string hint_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const std::string error = error_of("physim = 1\n" + text, overrides);
  const std::size_t hint = error.find("; ");
  return hint == error.npos ? error : error.substr(hint + 2);
}

TEST(UnknownKeys, OfWindSayThatItIsAVelocity) {
  const std::string words =
      "wind is a velocity of x downrange, y up, z right: velocity = [0, 0, \"-5 m/s\"] comes from the right";
  for (const std::string key : {"speed = \"5 m/s\"", "from = \"90 deg\"", "direction = 3"})
    EXPECT_TRUE(hint_of("[[shot]]\n[environment]\nwind = { " + key + " }\n").starts_with(words)) << key;
  for (const std::string path : {"environment.wind.from", "environment.wind.speed"})
    EXPECT_TRUE(hint_of("[[shot]]\n", {path + "=3"}).starts_with(words)) << path;
}

TEST(UnknownKeys, ThatAreShortForALongerOneAreThatOne) {
  const std::pair<const char*, const char*> paths[] = {{"shot.drag.BC", "shot.drag.ballistic_coefficient"},
                                                       {"drag.bc", "shot.drag.ballistic_coefficient"},
                                                       {"shot.sight.zero", "shot.sight.zero_range"},
                                                       {"shot.drag.ballistic", "shot.drag.ballistic_coefficient"},
                                                       {"shot.mas", "shot.mass"},
                                                       {"shot.drag.k3", "shot.drag.k1"}};
  for (const auto& [typed, meant] : paths)
    EXPECT_EQ(hint_of("[[shot]]\n", {std::string(typed) + "=1"}), "did you mean \"" + std::string(meant) + "\"?");
  EXPECT_EQ(hint_of("[[shot]]\ndrag = { bc = 0.3 }\n"), "did you mean \"ballistic_coefficient\"?");
  EXPECT_EQ(hint_of("[[shot]]\nsight = { zero = 100 }\n"), "did you mean \"zero_range\"?");
}

TEST(Expectations, OfAQuantityThatThereIsNotBringNoErrorsOfUnits) {
  const std::string numbers = "equals = \"5 m/s\"\nwithin = \"1 m/s\"\n", head = "physim = 1\n[[shot]]\n[[expect]]\n";
  const std::string wrong = error_of(head + "quantity = \"velocity\"\n" + numbers);
  EXPECT_NE(wrong.find("f.toml:4:12: error: expect.quantity: unknown value \"velocity\""), std::string::npos) << wrong;
  EXPECT_EQ(wrong.find("is a speed"), std::string::npos) << wrong;
  EXPECT_EQ(wrong.find('\n'), std::string::npos) << wrong;
  const std::string none = error_of(head + numbers);
  EXPECT_NE(none.find("missing key \"quantity\""), std::string::npos) << none;
  EXPECT_EQ(none.find("is a speed"), std::string::npos) << none;
  const std::string event =
      error_of("physim = 1\n[[shot]]\n[until]\nevents = [{ kind = \"fast\", value = \"5 m/s\" }]\n");
  EXPECT_EQ(event.find('\n'), std::string::npos) << event;
  const std::string both = error_of(head + "quantity = \"speed\"\nequals = \"5 kg\"\nwithin = 1\nsource = 5\n");
  EXPECT_NE(both.find("expect.equals"), std::string::npos) << both;
}

TEST(BadLists, HaveLimits) {
  const std::string head = "physim = 1\n[[shot]]\n";
  EXPECT_EQ(error_of(head + "[shot.drag]\nbands = " + list_of(9, "{ ballistic_coefficient = 1 }")),
            "f.toml:4:9: error: shot.drag.bands: 9 entries are too many; allowed are 0 .. 8");
  EXPECT_EQ(error_of(head + "[environment.wind]\nprofile = " + list_of(100001, "{}")),
            "f.toml:4:11: error: environment.wind.profile: 100001 entries are too many; allowed are 0 .. 100000");
  EXPECT_EQ(error_of(head + "[until]\nevents = " + list_of(25, "{ kind = \"apex\" }")),
            "f.toml:4:10: error: until.events: 25 entries are too many; allowed are 0 .. 24");
  EXPECT_EQ(error_of("physim = 1\nshot = " + list_of(100001, "{}")),
            "f.toml:2:8: error: shot: 100001 entries are too many; allowed are 1 .. 100000");
  EXPECT_EQ(error_of("physim = 1\nshot = " + list_of(100000, "{}")), "no error");
}

// ----------------------------------------------------------------------------------------------------------- overrides
class BadOverrideTest : public testing::TestWithParam<Bad> {};
TEST_P(BadOverrideTest, SaysWhereAndWhy) {
  const std::string file = "physim = 1\n[[shot]]\nname = \"308\"\n[[shot]]\nname = \"22 LR\"\n";
  EXPECT_EQ(error_of(file, {GetParam().text}), GetParam().error) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Overrides, BadOverrideTest,
    testing::Values(
        Bad{"shot.mass=168 ft",
            "--set shot.mass=168 ft: error: shot.mass: \"168 ft\" is a length; expected a mass such as \"168 gr\""},
        Bad{"shot.mass=-1",
            "--set shot.mass=-1: error: shot.mass: -1 is out of range; must be > 0 kg; a bare number is in kg"},
        Bad{"shot.mas=1", "--set shot.mas=1: error: unknown setting \"shot.mas\"; did you mean \"shot.mass\"?"},
        Bad{"envronment.gravity.model=off",
            "--set envronment.gravity.model=off: error: unknown setting \"envronment.gravity.model\"; did you mean "
            "\"environment.gravity.model\"?"},
        Bad{"gibberish=1", "--set gibberish=1: error: unknown setting \"gibberish\"; physim list settings shows all"},
        Bad{"=1", "--set =1: error: unknown setting \"\"; physim list settings shows all"},
        Bad{"shot.mass.=1", "--set shot.mass.=1: error: unknown setting \"shot.mass.\"; did you mean \"shot.mass\"?"},
        Bad{"shot.309.mass=1", "--set shot.309.mass=1: error: no shot is named \"309\"; did you mean \"308\"?"},
        Bad{"shot.300.winmag.mass=1",
            "--set shot.300.winmag.mass=1: error: no shot is named \"300.winmag\"; shots: 308, 22 LR"},
        Bad{"shot.308.mas=1",
            "--set shot.308.mas=1: error: unknown setting \"shot.mas\" of shot \"308\"; did you mean \"shot.mass\"?"},
        Bad{"shot.mass",
            "--set shot.mass: error: an override without \"=\"; write path=value, such as shot.mass=\"168 gr\""},
        Bad{"shot.mass=",
            "--set shot.mass=: error: an override without a value; write path=value, such as shot.mass=\"168 gr\""},
        Bad{"environment.wind.profile.at=3",
            "--set environment.wind.profile.at=3: error: there is no [[environment.wind.profile]] to change; set the "
            "list as a whole"},
        Bad{"environment.wind.velocity=[0,0]",
            "--set environment.wind.velocity=[0,0]: error: environment.wind.velocity: found 2 components; expected "
            "three "
            "components [x, y, z]"},
        Bad{"environment.wind={velocty=[0,0,1]}",
            "--set environment.wind={velocty=[0,0,1]}: error: unknown key \"velocty\" in [wind]; did you mean "
            "\"velocity\"?"},
        Bad{"shot.drag=g7",
            "--set shot.drag=g7: error: shot.drag: found a text; expected a table with keys out of: table, "
            "coefficient, "
            "curve, ballistic_coefficient, bands, form_factor, damping, k1, k2"},
        Bad{"shot.name=x",
            "--set shot.name=x: error: shot.name: two shots are named \"x\"; the first is at --set shot.name=x"},
        Bad{"title=\xFF", "--set title=\xFF: error: title: the text is not UTF-8"}));

// --------------------------------------------------------------------------------------------------------------- lists
/// The lines of an error, each with the place of its mistake in front, in the order of the file.
std::vector<std::string> errors_of(const std::string& text) {
  const Result<Scenario> scenario = parse_scenario("physim = 1\n" + text, "f.toml");
  std::vector<std::string> lines;
  const std::string all = scenario ? "" : scenario.error().text();
  for (std::size_t from = 0; from < all.size();) {
    const std::size_t end = std::min(all.find('\n', from), all.size());
    lines.push_back(all.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

void expect_errors(const std::string& text, const std::vector<std::string>& begins) {
  const std::vector<std::string> lines = errors_of(text);
  ASSERT_EQ(lines.size(), begins.size()) << testing::PrintToString(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_TRUE(lines[i].starts_with(begins[i])) << lines[i];
}

const std::string kShot = "[[shot]]\nmass = 1\ndiameter = 0.1\nspeed = 300\n";  // four lines

TEST(ListErrors, levels_of_a_sounding_and_of_its_wind) {
  expect_errors(
      "environment.atmosphere.profile = [\n"
      "  { altitude = 0, temperature = 288 },\n"
      "  { altitude = 1000, temperature = 281 },\n"
      "  { altitude = 900, temperature = 280 },\n"  // 5
      "  { altitude = 2000, temperature = 275 },\n"
      "  { altitude = 1900, temperature = 275 },\n"  // 7
      "]\n"
      "environment.wind.profile = [\n"
      "  { at = 0, velocity = [0, 0, 1] },\n"
      "  { at = 50, velocity = [0, 0, 1] },\n"
      "  { at = 40, velocity = [0, 0, 1] },\n"  // 12
      "  { at = 30, velocity = [0, 0, 1] },\n"  // 13
      "]\n" +
          kShot,
      {"f.toml:5:3: error: environment.atmosphere.profile[2]: must lie higher than the one below",
       "f.toml:7:3: error: environment.atmosphere.profile[4]: must lie higher than the one below",
       "f.toml:12:3: error: environment.wind.profile[2]: places must rise",
       "f.toml:13:3: error: environment.wind.profile[3]: places must rise"});
}

TEST(ListErrors, points_of_curves) {
  expect_errors(kShot +
                    "[shot.drag]\ntable = \"custom\"\n"
                    "curve = [[0, 0.2],\n [1, 0.4],\n [0.9, 0.5],\n [2, -1],\n [1.5, \"x\"],\n [3]]\n"
                    "[shot.motor]\nthrust = [[0, 5],\n [1, 3],\n [0.5, 3],\n [2, -5],\n [3, 0]]\n",
                {"f.toml:10:3: error: shot.drag.curve: Mach number 0.9 after 1; they must rise",
                 "f.toml:11:6: error: shot.drag.curve: -1 is out of range",
                 "f.toml:12:3: error: shot.drag.curve: Mach number 1.5 after 2; they must rise",
                 "f.toml:12:8: error: shot.drag.curve: \"x\" is not a number",
                 "f.toml:13:2: error: shot.drag.curve: this is no point",
                 "f.toml:17:3: error: shot.motor.thrust: time 0.5 after 1",
                 "f.toml:18:6: error: shot.motor.thrust: -5 is out of range"});
}

TEST(ListErrors, coefficients_vectors_ranges_and_gradients) {
  expect_errors(kShot +
                    "[shot.aero]\nlift = [[0, 2],\n [1, \"a\"],\n [0.5, 3],\n [0.4, 3]]\n"
                    "[output]\nranges = [\"100 m\",\n \"2 s\",\n \"3 s\"]\n",
                {"f.toml:8:6: error: shot.aero.lift: \"a\" is not a number",
                 "f.toml:10:2: error: shot.aero.lift: this point comes after a later one",
                 "f.toml:13:2: error: output.ranges: \"2 s\" is a time", "f.toml:14:2: error: output.ranges: \"3 s\""});
  expect_errors("[world]\n" + kShot +
                    "[[shape]]\nname = \"h\"\nhull = { points = [[0, 0, 0],\n [1, \"x\", \"y\"],\n [1, 2]] }\n"
                    "[[emitter]]\nshot = \"shot-1\"\n"
                    "start = { colour = { colour = \"#ff0000\", gradient = [[0, \"#12\"],\n [0.5, \"#000000\"],\n "
                    "[0.4, \"#000000\"]] } }\n",
                {"f.toml:10:6: error: shape.hull.points: \"x\" is not a number",
                 "f.toml:10:11: error: shape.hull.points: \"y\" is not a number",
                 "f.toml:11:2: error: shape.hull.points: found 2 components",
                 "f.toml:14:58: error: emitter.start.colour: \"#12\" is no colour",
                 "f.toml:16:3: error: emitter.start.colour: part of the span 0.4 after 0.5"});
}

/// What single settings cannot say of themselves, beside another mistake of the file.
TEST(ListErrors, what_the_library_objects_to_in_shots) {
  expect_errors(
      kShot +
          "inertia = { moments = [1, 1, 5] }\n"
          "drag = { table = \"custom\", curve = [[0, 0.2], [1, 0.4],\n [1.00000000001, 0.5], [2, 1],\n "
          "[2.00000000001, 3]] }\n"
          "[[shot]]\nmagnus = { table = [{ speed = 10, spin = 10 },\n { speed = 20, spin = 20 }] }\n"
          "[[shot]]\n[shot.motor]\nthrust = [[0, 5], [1, 5],\n [1.0000000001, 3], [2, 0]]\npropellant_mass = 2\n"
          "[environment.wind]\nprofile = [{ at = 1 },\n { at = 1 }]\n",
      {"f.toml:6:11: error: shot.inertia: is no inertia that a body can have",
       "f.toml:8:2: error: shot.drag.curve[2]: Mach numbers must rise",
       "f.toml:9:2: error: shot.drag.curve[4]: Mach numbers must rise",
       "f.toml:11:20: error: shot.magnus.table: is no full grid",
       "f.toml:16:2: error: shot.motor.thrust[2]: times must rise",
       "f.toml:17:19: error: shot.motor.propellant_mass: is not less than the projectile's mass",
       "f.toml:20:2: error: environment.wind.profile[1]: places must rise"});
}

TEST(ListErrors, texts_of_a_study) {
  expect_errors(kShot +
                    "[until]\nrange = 100\n[study]\ninputs = [\"shot.speeed = 1 m/s +- 3 m/s\",\n"
                    " \"shot.mass = 10 m +- 1 m\",\n \"shot.speed = +- 3 m/s\"]\n"
                    "targets = [\"circle 1 m\",\n \"cicle 1 m\"]\nquantities = [\"right\",\n \"upp\"]\n"
                    "at = [\"apox\",\n \"50 m\",\n \"50 s\"]\n",
                {"f.toml:9:11: error: study.inputs[0]: no number of a shot that may be uncertain is called",
                 "f.toml:10:2: error: study.inputs[1]: \"10 m\" is a length",
                 "f.toml:13:2: error: study.targets[1]: \"cicle 1 m\" is no target",
                 "f.toml:15:2: error: study.quantities[1]: no quantity", "f.toml:16:7: error: study.at[0]: no place",
                 "f.toml:18:2: error: study.at[2]: \"50 s\" is a time"});
  expect_errors(kShot +
                    "[until]\nrange = 100\n[study]\ninputs = [\"shot.speed = 9 m/s +- -3 m/s\",\n"
                    " \"shot.drag.curve.2 = 0.1 +- 0.01\"]\ntargets = [\"a: circle 1 m\",\n \"a: circle -2 m\"]\n",
                {"f.toml:9:11: error: study.inputs[0].distribution.deviation: must be a positive number",
                 "f.toml:10:2: error: study.inputs[1].path: the projectile has no drag curve of its own",
                 "f.toml:12:2: error: study.targets[1].radius: must be a positive number",
                 "f.toml:12:2: error: study.targets[1]: has the name \"a\" of targets[0]"});
}

/// A file that is wrong throughout is refused at once, however long it is.
TEST(ListErrors, twenty_are_told_of_very_many) {
  std::string text = "environment.wind.profile = [\n";
  for (int i = 0; i < 50000; ++i) text += "  { at = " + std::to_string(-i) + ", velocity = [0, 0, \"x\"] },\n";
  const std::vector<std::string> lines = errors_of(text + "]\n" + kShot);
  ASSERT_EQ(lines.size(), 21u);
  EXPECT_EQ(lines.back(), "error: there are more mistakes");
  EXPECT_TRUE(lines.front().starts_with("f.toml:3:")) << lines.front();
}

}  // namespace physim::scenario_errors_test
