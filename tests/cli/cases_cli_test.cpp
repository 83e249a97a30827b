// What users of the command line reported, with right values of closed forms, tables and integrations of their own.
#include <cmath>

#include "cli/program.hpp"
#include "rifles.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_cases_cli_test {

using nlohmann::json;

const std::string kRifle = "physim = 1\n" + test::rifle308();

json json_of(std::vector<std::string> words) {
  words.insert(words.end(), {"--json", "-"});
  const Ran ran = physim(words);
  EXPECT_EQ(ran.code, 0) << ran.err;
  return json::parse(ran.out, nullptr, false);
}

/// The number behind the name of a row of CSV.
double row_of(const std::string& csv, const std::string& name) {
  const std::size_t at = csv.find("\n" + name + ",");
  return at == std::string::npos ? NAN : std::stod(csv.substr(csv.find(',', at) + 1));
}

// ------------------------------------------------------------------------------------------------------------- studies
/// dwoll/shotGroups, table DFdistr of ten million groups: extreme spreads of 3, 5 and 10 shots for a deviation of 1, in
/// the text, in CSV and in JSON alike.
TEST(CasesOfStudies, quantiles_of_extreme_spreads_are_in_every_format) {
  const Folder folder;
  const std::string file = folder.write("s.toml", R"(physim = 1
environment = { gravity = "off", atmosphere = "vacuum" }
[[shot]]
speed = "1000 m/s"
fidelity = { preset = "simulation", gravity = "off", drag = "off", air = "vacuum", earth = "flat" }
[until]
ground = "off"
range = "1000 m"
[study]
inputs = ["shot.elevation = +- 1 mrad", "shot.azimuth = +- 1 mrad"]
quantities = ["right", "up"]
)");
  const json all = json_of({"study", file, "--shots", "400000", "--csv", folder / "s.csv"});
  const std::string csv = read(folder / "s.csv");
  const auto figure = [&](const std::string& name) -> double {
    for (const auto& each : all["figures"])
      if (each["name"] == name) return each["value"].get<double>();
    ADD_FAILURE() << name << " is missing";
    return NAN;
  };
  struct Row {
    const char* shots;
    double mean, low, high;
  };
  for (const auto& [shots, mean, low, high] :
       {Row{"3", 2.40846, 1.06860, 3.98758}, {"5", 3.06582, 1.80345, 4.51291}, {"10", 3.81143, 2.67956, 5.10790}}) {
    const std::string name = std::string("extreme_spread.") + shots;
    for (const auto& [what, right] :
         {std::pair{" [m]", mean}, {".quantile_0.05 [m]", low}, {".quantile_0.95 [m]", high}}) {
      EXPECT_NEAR(row_of(csv, name + what), right, 0.006 * right) << name << what;
      EXPECT_EQ(row_of(csv, name + what), figure(name + what)) << name << what;
    }
  }
}

/// A mean elevation beside a zero range is refused wherever it is written; one that is added to the zero hits.
TEST(CasesOfStudies, an_elevation_beside_a_zero_is_refused_at_every_door) {
  const File file("r.toml", kRifle);
  const std::string drawn = "shot.elevation = 0 mrad +- 0.1 mrad";
  const std::vector<std::vector<std::string>> doors = {{"--set", "study.inputs=[\"" + drawn + "\"]"},
                                                       {"--vary", drawn},
                                                       {"--set", "shot.elevation=\"0 mrad +- 0.1 mrad\""}};
  for (const auto& door : doors) {
    std::vector<std::string> words = {"study", file, "--shots", "4096"};
    words.insert(words.end(), door.begin(), door.end());
    const Ran ran = physim(words);
    EXPECT_EQ(ran.code, 2) << door.back();
    EXPECT_TRUE(has(ran.err, "the zero range gives another")) << door.back() << ran.err;
  }
  const json added = json_of({"study", file, "--shots", "4096", "--vary", "shot.elevation = +- 0.1 mrad", "--range",
                              "100 yd", "--target", "plate: rectangle 45 cm x 75 cm"});
  for (const auto& each : added["figures"])
    if (each["name"] == "hit.plate") {
      EXPECT_EQ(each["value"], 1);
    }
}

// ---------------------------------------------------------------------------------------------------------- spin,
// cards
/// A golf ball with backspin flies its lift on every preset that knows air, in flights, studies and worlds, as it does
/// with rotation = "magnus"; without lift it flew 133.5 m.
TEST(CasesOfSpin, a_golf_ball_with_backspin_is_lifted_at_every_door) {
  const Folder folder;
  const std::string ball = R"(physim = 1
[[shot]]
preset = "golf_ball"
speed = "75 m/s"
elevation = "11 deg"
spin = { backspin = "2700 rpm" }
)";
  const auto carry = [&](const std::string& fidelity) {
    const json flown = json_of({"run", folder.write("g.toml", ball + "fidelity = " + fidelity + "\n")});
    return flown["shots"][0]["trajectory"]["x [m]"].back().get<double>();
  };
  const double right = carry("{ preset = \"simulation\", rotation = \"magnus\" }");
  EXPECT_GT(right, 230);
  for (const char* preset : {"game", "small_arms", "artillery", "simulation"})
    EXPECT_NEAR(carry("\"" + std::string(preset) + "\""), right, 0.3) << preset;
  const std::string file = folder.write("g.toml", ball);
  const json world = json_of({"run", file, "--set", "world.duration=10 s", "--set", "shot.fidelity=simulation"});
  EXPECT_NEAR(world["world"]["groups"][0]["impact_range [m]"]["mean"].get<double>(), right, 0.3) << world;
  const Ran study = physim({"study", file, "--vary", "shot.speed = +- 0.001 m/s", "--shots", "4096", "--csv", "-"});
  EXPECT_NEAR(row_of(study.out, "along.mean [m]"), right, 0.3) << study.err;
}

/// A ball and a rocket have no rifling; nothing is said of it.
TEST(CasesOfSpin, nobody_tells_balls_and_rockets_of_a_twist) {
  const Folder folder;
  for (const char* shot : {"mass = \"1 kg\"\nspeed = \"50 m/s\"\nelevation = \"30 deg\"\n",
                           "mass = \"1 kg\"\nrail_length = \"1 m\"\nelevation = \"80 deg\"\n"
                           "motor = { propellant_mass = \"0.1 kg\", thrust = [[0, 60], [1, 0]] }\n"})
    for (const char* preset : {"game", "small_arms", "simulation"}) {
      const Ran ran = physim({"run", folder.write("b.toml", "physim = 1\n[[shot]]\n" + std::string(shot) +
                                                                "fidelity = \"" + preset + "\"\n")});
      EXPECT_EQ(ran.code, 0) << ran.err;
      EXPECT_FALSE(has(ran.out + ran.err, "twist")) << preset << ran.out << ran.err;
    }
}

/// A 6.5 Creedmoor zeroed at 100 yd on the level and shot up 30 degrees strikes 0.33 in high there and 278.4 in low at
/// 1000 yd.
TEST(CasesOfCards, a_slope_comes_behind_the_zero) {
  const std::string slope = test::creedmoor(", look_angle = \"30 deg\"");
  const File file("c.toml", "physim = 1\n" + slope + "range = \"1200 yd\"\n");
  const Ran ran =
      physim({"table", file, "--ranges", "[\"100 yd\", \"1000 yd\"]", "--units", "customary", "--format", "csv"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 3u) << ran.out;
  ASSERT_TRUE(lines[0].starts_with("range [yd],drop [in],")) << lines[0];
  EXPECT_NEAR(std::stod(lines[1].substr(lines[1].find(',') + 1)), 0.33, 0.01);
  EXPECT_NEAR(std::stod(lines[2].substr(lines[2].find(',') + 1)), -278.4, 0.1);
}

/// Cards end where their flights do, in text and in JSON: ten rows of 100 to 1000 yd, the last one 12.1342 m low.
TEST(CasesOfCards, the_row_at_the_end_of_a_flight_is_there) {
  const File file("r.toml", kRifle + "[output]\nranges = \"100 yd .. 1000 yd step 100 yd\"\n");
  const json card = json_of({"run", file})["shots"][0]["range_card"];
  ASSERT_EQ(card.size(), 10u);
  EXPECT_EQ(card[9]["range [m]"], 914.4);
  EXPECT_NEAR(card[9]["drop [m]"].get<double>(), -12.1342, 1e-4);
  EXPECT_NEAR(card[9]["time [s]"].get<double>(), 1.900113, 2e-6);
  const Ran table = physim({"table", file, "--units", "customary"});
  EXPECT_FALSE(has(table.out, "not reached")) << table.out;
  EXPECT_TRUE(has(table.out, "      1000     -477.7")) << table.out;  // 12.1342 m in inches
  const Ran beyond = physim({"table", file, "--units", "customary", "--ranges", "[\"1001 yd\"]"});
  EXPECT_TRUE(has(beyond.out, "reached_range at 1000 yd")) << beyond.out;
}

/// Up a slope of 85 to 89.9 degrees a .308 carries farthest between the slope and the vertical: near the 3109.9 m of a
/// shot straight up, and farther on flatter slopes.
TEST(CasesOfCards, the_farthest_range_up_a_steep_slope) {
  const File file("r.toml", kRifle);
  double before = INFINITY;
  for (const char* slope : {"80", "85", "89", "89.9"}) {
    const json far = json_of({"max-range", file, "--slope", std::string(slope) + " deg"});
    const double range = far["range [m]"], elevation = far["elevation [rad]"].get<double>() * 180 / 3.14159265358979;
    EXPECT_LT(range, before) << slope;
    EXPECT_GT(elevation, std::stod(slope));
    EXPECT_LT(elevation, 90);
    before = range;
  }
  EXPECT_NEAR(before, 3110, 5);
}

// --------------------------------------------------------------------------------------------------------------
// rockets
/// What comes down behind its muzzle over a round Earth has a negative distance: linear drag in a wind of 5 m/s takes a
/// body that falls from h at a terminal speed of m g / k to h 5 k / (m g) behind.
TEST(CasesOfRocketsAtTheDoor, what_lands_behind_the_rail_is_behind_it) {
  const File file("b.toml", R"(physim = 1
[environment]
gravity = { model = "constant", acceleration = "9.80665 m/s^2" }
earth = { latitude = "47.5 deg", longitude = "8.5 deg", azimuth = "90 deg", rotation_rate = 0 }
wind = { velocity = ["-5 m/s", 0, 0] }
[[shot]]
mass = 1
position = [0, "100 m", 0]
drag = { k1 = 2, k2 = 0 }
fidelity = { preset = "simulation", gravity = "constant", drag = "linear_quadratic", earth = "ellipsoid" }
)");
  const auto distance = [&](const std::string& wind) {
    const Ran ran = physim({"run", file, "--set", "environment.wind.velocity=[\"" + wind + "\", 0, 0]"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const std::size_t end = ran.out.find(" m along the ground", ran.out.find("landed"));
    return end == std::string::npos ? std::nan("") : std::stod(ran.out.substr(ran.out.rfind(' ', end - 1) + 1));
  };
  const double right = 100 * 5 * 2 / 9.80665;
  EXPECT_NEAR(distance("5 m/s"), right, 0.01);
  EXPECT_NEAR(distance("-5 m/s"), -right, 0.01);
}

/// Numbers that are unlikely are told by every command, with the option that gave them.
TEST(CasesOfSettings, unlikely_numbers_are_told_behind_every_command) {
  const File file("r.toml", kRifle);
  const auto told = [&](std::vector<std::string> words, const std::string& set) {
    words.insert(words.end(), {"--set", set});
    const Ran ran = physim(words);
    return has(ran.err, "warning: --set " + set + ": ") && has(ran.err, "is unusual");
  };
  for (const char* set : {"environment.atmosphere.pressure=1013", "tolerance.relative=1e300", "shot.speed=9e8 m/s",
                          "environment.altitude=1e9 m", "shot.mass=1 kg"})
    EXPECT_TRUE(told({"run", file}, set)) << set;
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"table", file, "--ranges", "[\"100 m\"]"},
        {"study", file, "--vary", "shot.azimuth = +- 1 mrad", "--shots", "4096"},
        {"aim", file, "--range", "100 m"}})
    EXPECT_TRUE(told(command, "environment.atmosphere.pressure=1013")) << command[0];
}

/// What other settings overrule is told by every command, with the option that gave it.
TEST(CasesOfSettings, overruled_settings_are_told_behind_every_command) {
  const Folder folder;
  const std::string file = folder.write("r.toml", kRifle), text = kRifle;
  const std::string world = folder.write("w.toml", text.substr(0, text.find("[until]")) + "[world]\nduration = 0.1\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"run", file},
        {"table", file, "--ranges", "[\"100 m\"]"},
        {"study", file, "--vary", "shot.azimuth = +- 1 mrad", "--shots", "4096"},
        {"aim", file, "--range", "100 m"},
        {"run", world}}) {
    std::vector<std::string> words = command;
    words.insert(words.end(), {"--set", "shot.drag.form_factor=3"});
    const Ran ran = physim(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(has(ran.err,
                    "--set shot.drag.form_factor=3: shot.drag.form_factor: has no effect beside "
                    "shot.drag.ballistic_coefficient"))
        << command[0] << ran.err;
  }
}

/// JSON has what the warnings say.
TEST(CasesOfSettings, notes_stand_in_json) {
  const File file("r.toml", kRifle);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"run", file}, {"aim", file, "--range", "100 m"}}) {
    std::vector<std::string> words = command;
    words.insert(words.end(), {"--set", "shot.drag.form_factor=3"});
    const json notes = json_of(words)["scenario"]["notes"];
    ASSERT_EQ(notes.size(), 1u) << command[0];
    EXPECT_TRUE(has(notes[0].get<std::string>(), "has no effect beside shot.drag.ballistic_coefficient"));
  }
  EXPECT_TRUE(json_of({"run", file})["scenario"]["notes"].empty());
}

// ----------------------------------------------------------------------------------------------------------- soundings
constexpr const char* kSounding = R"(
[environment.atmosphere]
profile = [
  { altitude = "100 m", temperature = "6 degC", pressure = "1008 hPa", humidity = "90 %" },
  { altitude = "350 m", temperature = "11.4 degC", pressure = "978 hPa", humidity = "75 %" },
  { altitude = "3000 m", temperature = "-2.8 degC", pressure = "704.9 hPa" },
]
)";

/// Air by levels at every door: a run, a world, a study; mistakes in it with their places.
TEST(CasesOfAir, levels_of_a_sounding_are_flown) {
  const Folder folder;
  const std::string file = folder.write("r.toml", kRifle + kSounding);
  const auto speed = [&](const std::string& of, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"run", of};
    words.insert(words.end(), more.begin(), more.end());
    const json out = json_of(words);
    return out["shots"][0]["trajectory"]["vx [m/s]"].back().get<double>();
  };
  const double cold = speed(file), standard = speed(folder.write("s.toml", kRifle));
  // Of one level below the sounding and the standard's lapse rate: the same air as a station's, dry.
  const std::string level = "[environment.atmosphere]\nprofile = [{ altitude = 0, temperature = \"6 degC\" }]\n";
  const std::string station = "[environment.atmosphere]\ntemperature = \"6 degC\"\n";
  EXPECT_NEAR(speed(folder.write("l.toml", kRifle + level)), speed(folder.write("t.toml", kRifle + station)), 1e-3);
  EXPECT_LT(cold, standard - 5) << "air that is colder is denser";
  const Ran both = physim({"run", file, "--set", "environment.atmosphere.temperature=300"});
  EXPECT_EQ(both.code, 2);
  EXPECT_TRUE(has(both.err, "a station gives it, too")) << both.err;
  const Ran study = physim({"study", file, "--vary", "environment.atmosphere.temperature = 280 +- 5"});
  EXPECT_EQ(study.code, 2);
  EXPECT_TRUE(has(study.err, "the environment has air by levels")) << study.err;
  EXPECT_EQ(physim({"study", file, "--vary", "shot.speed = +- 1", "--shots", "4096"}).code, 0);
  const std::string text = kRifle + kSounding;
  const std::string world =
      folder.write("w.toml", text.substr(0, text.find("[until]")) + kSounding + "[world]\nduration = 0.5\n");
  EXPECT_EQ(physim({"run", world}).code, 0);
  std::string mistaken = text;
  mistaken.replace(mistaken.find("\"3000 m\""), 8, "\"300 m\"");
  const Ran wrong = physim({"run", folder.write("m.toml", mistaken)});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(
      has(wrong.err, "m.toml:18:3: error: environment.atmosphere.profile[2]: must lie higher than the one below"))
      << wrong.err;
  const Ran slip =
      physim({"run", file, "--set", "environment.atmosphere.profile=[{ temperature = 288, pressure = 1013 }]"});
  EXPECT_TRUE(has(slip.err, "a pressure of 1013 Pa at 0 m is unusual")) << slip.err;
  // Simpler air leaves all but the origin's out.
  const Ran vacuum = physim({"run", file, "--set", "shot.fidelity.air=vacuum"});
  EXPECT_TRUE(has(vacuum.err, "environment.atmosphere.profile")) << vacuum.err;
}

// --------------------------------------------------------------------------------------------------------------- units
const std::string kUnits = "physim = 1\n" + test::creedmoor() + R"(range = "800 yd"
[study]
inputs = [
  "shot.speed = +- 10 ft/s",
  "shot.azimuth = +- 0.1 mrad",
  "environment.atmosphere.temperature = 59 degF +- 9 degF",
]
targets = ["plate: rectangle 45 cm x 75 cm"]
shots = 4096
)";

/// Ranges in yards stand in yards, and lengths beside them in inches: 0.1 mrad at 600 yd are 2.16 in.
TEST(CasesOfUnits, a_study_over_ranges_tells_them_in_their_unit) {
  const File file("r.toml", kUnits);
  const Ran yards = physim({"study", file, "--ranges", "600 yd .. 800 yd step 200 yd"});
  ASSERT_EQ(yards.code, 0) << yards.err;
  EXPECT_TRUE(has(yards.out, "range [yd]  right +- [in]")) << yards.out;
  const std::size_t row = yards.out.find("\n         600 ");
  ASSERT_NE(row, std::string::npos) << yards.out;
  EXPECT_NEAR(std::stod(yards.out.substr(row + 13)), 2.16, 0.1) << yards.out;
  const Ran metres = physim({"study", file, "--ranges", "600 m"});
  EXPECT_TRUE(has(metres.out, "range [m]  right +- [m]")) << metres.out;
}

/// The table of inputs has what the file says, with its unit: 10 ft/s, 0.1 mrad, 9 degF.
TEST(CasesOfUnits, inputs_of_a_study_are_told_in_the_units_of_the_file) {
  const Ran ran = physim({"study", Folder().write("r.toml", kUnits)});
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const auto& [input, deviation] : {std::pair{"shot.speed [ft/s]", " 10 "},
                                         {"shot.azimuth [mrad]", " 0.1 "},
                                         {"environment.atmosphere.temperature [degF]", " 9 "}}) {
    const std::size_t at = ran.out.find(input);
    ASSERT_NE(at, std::string::npos) << input << ran.out;
    EXPECT_TRUE(has(ran.out.substr(at, ran.out.find('\n', at) - at).substr(0, 60), deviation)) << ran.out;
  }
  EXPECT_TRUE(has(ran.out, "with shot.speed += ") && has(ran.out, " ft/s, shot.azimuth += ")) << ran.out;
}

}  // namespace physim::testing_cli::cli_cases_cli_test
#endif
