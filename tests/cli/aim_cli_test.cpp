// `physim aim`, `table`, `fit`, `max-range` and `danger-space`, as a user runs them.
#include <cmath>

#include "cli/program.hpp"
#include "rifles.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_aim_cli_test {

constexpr double kG = 10;
constexpr double kDegree = 3.14159265358979323846 / 180;

constexpr const char* kShell = R"(physim = 1
title = "A shell"
[environment]
atmosphere = "vacuum"
gravity = { model = "constant", acceleration = "10 m/s^2" }
[target]
position = ["3360 m", "0 m", "-70 m"]
velocity = ["0 m/s", "0 m/s", "5 m/s"]
[[shot]]
name = "shell"
speed = "250 m/s"
azimuth = "90 deg"
elevation = "20 deg"
fidelity = { preset = "simulation", earth = "flat" }
)";

const std::string kBullet = "physim = 1\n" + test::rifle308("1000 m", "length = \"31 mm\"\ntwist = \"12 in\"\n");

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) {
    const auto first = cell.find_first_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first));
  }
  return cells;
}

/// A row of a CSV table as numbers by the names of its columns.
double cell(const std::vector<std::string>& table, std::size_t row, const std::string& column) {
  const auto heads = cells_of(table.at(0)), cells = cells_of(table.at(row));
  const auto found = std::find(heads.begin(), heads.end(), column);
  EXPECT_NE(found, heads.end()) << column;
  return found == heads.end() ? NAN : std::stod(cells.at(static_cast<std::size_t>(found - heads.begin())));
}

// ---------------------------------------------------------------------------------------------------------------- aim
TEST(CliAim, LeadsTheTargetOfTheScenario) {
  const File file("shell.toml", kShell);
  const auto json = json_of(physim({"aim", file, "--json", "-"}));
  EXPECT_TRUE(json["in_reach"]);
  EXPECT_NEAR(json["low"]["elevation [rad]"], std::asin(0.28), 1e-5);
  EXPECT_NEAR(json["low"]["time [s]"], 14, 1e-4);
  EXPECT_NEAR(json["low"]["azimuth [rad]"], 0, 1e-5);
  EXPECT_LE(json["low"]["miss [m]"], 0.01);
  EXPECT_GT(json["high"]["time [s]"], 40);
  EXPECT_EQ(json["shot"], "shell");
  const Ran text = physim({"aim", file});
  EXPECT_EQ(text.code, 0);
  for (const char* part : {"A shell: shell", "target at (3360, 0, -70) m, moving at (0, 0, 5) m/s", "low", "high",
                           "16.260", "trajectories flown"})
    EXPECT_TRUE(has(text.out, part)) << part << "\n" << text.out;
}

TEST(CliAim, TakesATargetByPlaceOrByRange) {
  const File file("shell.toml", kShell);
  const auto still = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"aim", file, "--target-velocity", "0, 0, 0", "--json", "-", "--arc", "low"});
    return json_of(physim(words));
  };
  // The shot points along z: 800 m ahead lie at z = 800, 30 m to the right at x = -30.
  const auto by_place = still({"--target", "-30 m, 12 m, 800"});
  const auto by_range = still({"--range", "800 m", "--height", "12 m", "--cross", "30 m"});
  EXPECT_NEAR(by_place["low"]["elevation [rad]"], double(by_range["low"]["elevation [rad]"]), 1e-12);
  EXPECT_NEAR(by_place["low"]["azimuth [rad]"], std::atan2(800, -30), 1e-5);
  EXPECT_FALSE(by_place.contains("high"));
}

TEST(CliAim, OutOfReachIsExitCodeOne) {
  const File file("shell.toml", kShell);
  const Ran ran = physim({"aim", file, "--range", "7 km", "--tolerance", "1 m"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_TRUE(has(ran.out, "out of reach: the nearest path passes")) << ran.out;
  EXPECT_TRUE(has(ran.out, "nearest")) << ran.out;
}

TEST(CliAim, RocketsFromRestHaveALowAndAHighWay) {
  const auto answer = json_of(physim({"aim", PHYSIM_SOURCE_DIR "/scenarios/model_rocket.toml", "--range", "150 m",
                                      "--tolerance", "0.1 m", "--json", "-"}));
  EXPECT_LT(double(answer["low"]["elevation [rad]"]), double(answer["high"]["elevation [rad]"]));
  EXPECT_LT(double(answer["low"]["miss [m]"]), 0.1);
  EXPECT_LT(double(answer["high"]["miss [m]"]), 0.1);
}

TEST(CliAim, RefusesWhatMakesNoSense) {
  const Folder folder;
  const std::string file = folder.write("shell.toml", kShell), bullet = folder.write("bullet.toml", kBullet);
  expect_complaint(physim({"aim", bullet}), "there is no target; write --target");
  expect_complaint(physim({"aim", file, "--target", "1 m, 2 m"}), "--target: error: \"1 m, 2 m\" is no vector");
  expect_complaint(physim({"aim", file, "--target", "1 m, 2 kg, 0"}), "--target: error: ");
  expect_complaint(physim({"aim", file, "--target", "1, , 0"}), "a component is empty");
  expect_complaint(physim({"aim", file, "--target", "1, 2, 3, 4"}), "--target: error: ");
  expect_complaint(physim({"aim", file, "--target", "9, 0, 0", "--range", "3 m"}), "given together with --range");
  expect_complaint(physim({"aim", bullet, "--height", "3 m"}), "--height: error: needs a range");
  expect_complaint(physim({"aim", file, "--target", "0, 0, 0"}), "--target: error: is at the muzzle");
  expect_complaint(physim({"aim", file, "--tolerance", "0 m"}), "--tolerance: error");
  expect_complaint(physim({"aim", file, "--arc", "flat"}), "unknown arc \"flat\"; low, high or both");
  expect_complaint(physim({"aim", file, "--shot", "gun"}), "there is no shot \"gun\"");
  expect_complaint(physim({"aim", file, "--json", folder / "no/such/a.json"}), "no such directory");
  expect_complaint(physim({"aim", file, "--set", "shot.mass=-1 kg"}), "shot.mass");
  expect_complaint(physim({"aim", bullet, "--set", "target.velocity=[1, 2, 3]"}), "there is no target");
}

// ----------------------------------------------------------------------------------------------------- range, danger
TEST(CliMaxRange, OfAParabola) {
  const File file("shell.toml", kShell);
  const auto flat = json_of(physim({"max-range", file, "--json", "-"}));
  EXPECT_NEAR(flat["range [m]"], 250 * 250 / kG, 1e-4);
  EXPECT_NEAR(flat["elevation [rad]"], 45 * kDegree, 1e-4);
  const auto down = json_of(physim({"max-range", file, "--slope", "-10 deg", "--json", "-"}));
  EXPECT_NEAR(down["range [m]"], 250 * 250 / kG / (1 + std::sin(-10 * kDegree)), 1e-3);
  expect_complaint(physim({"max-range", file, "--slope", "100 deg"}),
                   "--slope: error: must lie between -90 and 90 degrees; as in \"5 deg\"; a bare number is in radians");
  expect_complaint(physim({"max-range", file, "--set", "environment.gravity.acceleration=0"}), "does not come down");
}

TEST(CliNotes, CheapestWithinIsOfFlightsThatAreFlownAlone) {
  const File file("shell.toml", kShell);
  const std::vector<std::vector<std::string>> commands = {
      {"aim"}, {"max-range"}, {"study", "--vary", "shot.speed = +- 1 m/s", "--shots", "100"}};
  for (std::vector<std::string> command : commands) {
    command.insert(command.begin() + 1, {file, "--set", "shot.fidelity.cheapest_within=1 m"});
    const Ran ran = physim(command);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(has(ran.err, "shot.fidelity.cheapest_within has no effect")) << command[0] << ran.err;
  }
}

TEST(CliRun, AVelocityOfZeroHasNoDirection) {
  const File file("up.toml", kShell);
  const Ran ran = physim(
      {"run", file, "--set", "shot.elevation=90 deg", "--set", "until.events=[{ kind = \"apex\", terminal = true }]"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, " 0 m/s, 0 J")) << ran.out;
  EXPECT_FALSE(has(ran.out, " deg up")) << ran.out;
}

TEST(CliDangerSpace, OfAParabola) {
  const File file("shell.toml", kShell);
  const std::vector<std::string> base = {"danger-space",         file,    "--set",
                                         "shot.elevation=1 deg", "--set", "until.ground=-30 m"};
  const auto with = [&](std::vector<std::string> words) {
    words.insert(words.begin(), base.begin(), base.end());
    return physim(words);
  };
  const auto json = json_of(with({"--range", "300 m", "--height", "1 m", "--json", "-"}));
  const double tan = std::tan(kDegree), k = kG / (2 * 250 * 250 * std::pow(std::cos(kDegree), 2));
  const double y = 300 * tan - k * 300 * 300;
  const auto falling = [&](double at) { return (tan + std::sqrt(tan * tan - 4 * k * at)) / (2 * k); };
  EXPECT_NEAR(json["from [m]"], falling(y + 0.5), 1e-6);
  EXPECT_NEAR(json["to [m]"], falling(y - 0.5), 1e-6);
  expect_complaint(with({"--range", "300 m"}), "--height is required");
  expect_complaint(with({"--range", "300 km", "--height", "1 m"}), "never reaches a range of 300000 m");
  expect_complaint(with({"--range", "300 m", "--height", "0 m"}), "height: error: must be a positive number");
}

// -------------------------------------------------------------------------------------------------------------- table
TEST(CliTable, InBothSystemsOfUnitsTheNumbersAreTheSame) {
  const File file("bullet.toml", kBullet);
  const auto table = [&](const std::string& units, const std::string& ranges) {
    const Ran ran =
        physim({"table", file, "--units", units, "--ranges", ranges, "--format", "csv", "--wind", "10 mph"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    return lines_of(ran.out);
  };
  const auto metric = table("metric", "[\"457.2 m\", \"914.4 m\"]");
  const auto customary = table("customary", "500 yd .. 1000 yd step 500 yd");
  ASSERT_EQ(metric.size(), 3u);
  for (std::size_t row : {1u, 2u}) {
    EXPECT_NEAR(cell(metric, row, "drop [cm]"), 2.54 * cell(customary, row, "drop [in]"), 0.2);
    EXPECT_NEAR(cell(metric, row, "drop [mil]"), 0.2908882 * cell(customary, row, "drop [MOA]"), 0.02);
    EXPECT_NEAR(cell(metric, row, "speed [m/s]"), 0.3048 * cell(customary, row, "speed [ft/s]"), 0.25);
    EXPECT_NEAR(cell(metric, row, "energy [J]"), 1.3558 * cell(customary, row, "energy [ft lbf]"), 1.3);
    EXPECT_NEAR(cell(metric, row, "wind 10 mph [cm]"), 2.54 * cell(customary, row, "wind 10 mph [in]"), 0.2);
    EXPECT_EQ(cell(metric, row, "time [s]"), cell(customary, row, "time [s]"));
  }
  EXPECT_EQ(cell(customary, 2, "range [yd]"), 1000);
  EXPECT_LT(cell(metric, 2, "wind 10 mph [cm]"), -200);  // from the right: pushed left
  EXPECT_GT(cell(metric, 2, "spin [cm]"), 10);           // right-handed twist: to the right
}

TEST(CliTable, AnglesAreThoseOfTheOffsets) {
  const File file("bullet.toml", kBullet);
  const auto rows = lines_of(physim({"table", file, "--ranges", "800 m", "--format", "csv", "--angle", "moa"}).out);
  const double drop = cell(rows, 1, "drop [cm]") / 100;
  EXPECT_NEAR(cell(rows, 1, "drop [MOA]"), std::atan2(drop, 800) / kDegree * 60, 0.06);
}

TEST(CliTable, ComesAsTextMarkdownAndFile) {
  const Folder folder;
  const std::string file = folder.write("bullet.toml", kBullet);
  const Ran text = physim({"table", file});
  EXPECT_TRUE(has(text.out, "range [m]  drop [cm]  drop [mil]")) << text.out;
  const Ran markdown = physim({"table", file, "--format", "markdown"});
  EXPECT_TRUE(has(markdown.out, "| range [m] | drop [cm] |")) << markdown.out;
  const std::string path = folder / "card.csv";
  const Ran written = physim({"table", file, "--format", "csv", "--to", path});
  EXPECT_EQ(written.out, "");
  EXPECT_TRUE(read(path).starts_with("range [m],drop [cm]"));
  const Ran far = physim({"table", file, "--ranges", "900 m .. 1800 m step 900 m"});
  EXPECT_TRUE(has(far.out, "not reached")) << far.out;
}

TEST(CliTable, RefusesWhatMakesNoSense) {
  const Folder folder;
  const std::string file = folder.write("bullet.toml", kBullet);
  expect_complaint(physim({"table", file, "--units", "imperial"}), "imperial");
  expect_complaint(physim({"table", file, "--format", "pdf"}), "pdf");
  expect_complaint(physim({"table", file, "--wind", "10 kg"}), "--wind: error: ");
  expect_complaint(physim({"table", file, "--ranges", "far"}), "output.ranges");
  expect_complaint(physim({"table", file, "--to", folder / "no/such/card"}), "no such directory");
  expect_complaint(physim({"table", file, "--set", "shot.elevation=90 deg", "--set", "shot.sight.zero_range=0", "--set",
                           "until.range=none", "--set", "until.time=1 s"}),
                   "no range to show");
}

TEST(CliOptions, AreNamedInErrorsAboutThem) {
  const File file("bullet.toml", kBullet);
  expect_complaint(physim({"danger-space", file, "--range", "300 m", "--height", "-1 m"}),
                   "--height: error: must be a positive");
  expect_complaint(physim({"aim", file, "--range", "300 m", "--tolerance", "-1 m"}),
                   "--tolerance: error: must be a positive");
  expect_complaint(physim({"aim", file, "--range", "300 m", "--time", "-1 s"}), "--time: error: must be a positive");
}

TEST(CliTable, HasNullWhereThereIsNoNumber) {
  const File file("bullet.toml", kBullet);
  const auto json = json_of(physim({"table", file, "--format", "json", "--ranges", "[\"0 m\", \"200 m\", \"90 km\"]"}));
  ASSERT_EQ(json["speed [m/s]"].size(), 3u);
  EXPECT_TRUE(json["speed [m/s]"][1].is_number());
  EXPECT_TRUE(json["speed [m/s]"][2].is_null()) << json;
  EXPECT_TRUE(json["windage [mil]"][0].is_null()) << "an angle at the muzzle: " << json;
}

TEST(CliRun, HasItsCardInJsonWithoutRangesToo) {
  const File file("shell.toml", kShell);
  const auto json = nlohmann::json::parse(physim({"run", file, "--json", "-"}).out);
  const auto& card = json["shots"][0]["range_card"];
  ASSERT_EQ(card.size(), 8u) << "4017 m are 8 times 500 m: " << card;
  EXPECT_NEAR(card[0]["range [m]"].get<double>(), 500, 1e-6);
  EXPECT_NEAR(card[7]["range [m]"].get<double>(), 4000, 1e-6);
  EXPECT_TRUE(has(physim({"run", file}).out, " 4000 ")) << "as the text has it";
}

TEST(CliRun, SaysThatAMotorNeverBurns) {
  const File file("rocket.toml", R"(physim = 1
[[shot]]
name = "bomb"
mass = 1
speed = 10
position = [0, 20, 0]
motor = { propellant_mass = 0.1, ignition_delay = 9, thrust = [[0, 40], [1, 0]] }
fidelity = { preset = "simulation", drag = "off" }
)");
  const Ran ran = physim({"run", file});
  EXPECT_TRUE(has(ran.err, "warning: the motor of shot \"bomb\" never burns: the flight ends after 2.0")) << ran.err;
  EXPECT_TRUE(has(ran.err, "shot.motor.ignition_delay is 9 s")) << ran.err;
  EXPECT_EQ(physim({"run", file, "--set", "shot.motor.ignition_delay=1"}).err, "");
}

// ---------------------------------------------------------------------------------------------------------------- fit
TEST(CliFit, ReadsFieldsInQuotesAndBlankLines) {
  const Folder folder;
  const std::string file = folder.write("bullet.toml", kBullet);
  const auto scale = [&](const std::string& data) {
    return json_of(physim({"fit", file, "--data", folder.write("d.csv", data), "--json", "-"}))["scale"].get<double>();
  };
  EXPECT_EQ(scale("\"range [yd]\",\"speed [ft/s]\"\r\n200,\"2202\"\r\n\"500\", \"1673\"\r\n"),
            scale("range [yd], speed [ft/s]\n200, 2202\n500, 1673\n"));
  EXPECT_EQ(scale("range [yd], speed [ft/s]\n200, 2202\n,\n500, 1673\n , \n"),
            scale("range [yd], speed [ft/s]\n200, 2202\n500, 1673\n"));
  expect_complaint(physim({"fit", file, "--data", folder.write("d.csv", "range, speed\n100, \"7o0\"\n")}),
                   "d.csv:2:7: error: ");
}

TEST(CliFit, FindsTheCoefficientThatMadeTheTable) {
  const Folder folder;
  const std::string file = folder.write("bullet.toml", kBullet);
  const auto rows = lines_of(
      physim({"table", file, "--units", "customary", "--format", "csv", "--ranges", "200 yd .. 800 yd step 200 yd"})
          .out);
  std::string data = "# from a table\nspeed [ft/s], range [yd], drop [in]\n";
  for (std::size_t row = 1; row < rows.size(); ++row)
    data += std::to_string(cell(rows, row, "speed [ft/s]")) + ", " + std::to_string(cell(rows, row, "range [yd]")) +
            "," + (row == 2 ? "" : std::to_string(cell(rows, row, "drop [in]"))) + "\n";
  const std::string csv = folder.write("data.csv", data);
  const std::vector<std::string> words = {"fit", file,    "--data",
                                          csv,   "--set", "shot.drag.ballistic_coefficient=0.4 lb/in^2"};
  const Ran text = physim(words);
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_TRUE(has(text.out, "drag.ballistic_coefficient")) << text.out;
  auto as_json = words;
  as_json.insert(as_json.end(), {"--json", "-"});
  const auto json = json_of(physim(as_json));
  const double found = json["drag"]["ballistic_coefficient [kg/m^2]"];
  EXPECT_NEAR(found, 0.218 * 0.45359237 / (0.0254 * 0.0254), 0.3);
  EXPECT_EQ(json["residuals"].size(), 7u);
}

TEST(CliFit, ErrorsHaveTheirPlaceInTheData) {
  const Folder folder;
  const std::string file = folder.write("bullet.toml", kBullet);
  const auto complaint = [&](const std::string& data, const std::string& part) {
    const std::string csv = folder.write("d.csv", data);
    expect_complaint(physim({"fit", file, "--data", csv}), part);
  };
  complaint("", "d.csv:1:1: error: there is no header line");
  complaint("range [m], speed [m/s]\n", "there is no figure below the header");
  complaint("range [m], velocity [m/s]\n1, 2\n", "d.csv:1:12: error: unknown column \"velocity\"");
  complaint("range [m], speed [kg]\n", "d.csv:1:12: error: ");
  complaint("range, range, speed\n", "two columns are named \"range\"");
  complaint("speed, drop\n1, 2\n", "there is no column \"range\"");
  complaint("range\n1\n", "there is a range and nothing else");
  complaint("range, speed\n100, 700\n200\n", "d.csv:3:1: error: 1 field; the header has 2 columns");
  complaint("range, speed\n100, 7o0\n", "d.csv:2:6: error: ");
  complaint("range [yd], speed\n,700\n", "d.csv:2:1: error: the range is empty");
  complaint("range, speed [ft/s]\n100, -\n", "d.csv:2:6: error: \"-\" is not a number");
  complaint("range;speed\n100;700\n", "d.csv:1:1: error: semicolons part the columns");
  complaint("range, drop [mil]\n100, -1\n0, -1\n", "d.csv:3:4: error: an angle at range 0 says nothing of the drop");
  complaint("range, drop [deg]\n100, -90\n", "d.csv:2:6: error: the angle of a drop is below 90 deg");
  complaint("range, speed\n0, 790\n", "lie at the muzzle");
  complaint("range, speed\n100, 500\n# a comment\n300, 650\n500, 500\n", "d.csv:4:1: error: the speed rises");
  complaint("range, speed\n100, 900\n", "less than a thousandth of the drag");
  expect_complaint(physim({"fit", file, "--data", folder / "none.csv"}), "none.csv: error: there is no such file");
  expect_complaint(physim({"fit", file}), "--data is required");
  const std::string csv = folder.write("d.csv", "range, speed\n100, 700\n");
  expect_complaint(physim({"fit", file, "--data", csv, "--muzzle-speed"}), "are fewer than the unknowns");
  expect_complaint(physim({"fit", file, "--data", csv, "--speed-error", "0 m/s"}),
                   "--speed-error: error: must be positive");
}

TEST(CliCompare, ShowsWhatCheapestWithinChooses) {
  const File file("bullet.toml", kBullet);
  const Ran ran = physim({"compare", file, "--set", "shot.fidelity={ cheapest_within = \"5 cm\" }"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "cheapest within 0.05 m")) << ran.out;
}

TEST(CliDangerSpace, GoesOnBeyondTheEndOfTheFlight) {
  const File file("bullet.toml", kBullet);
  const std::vector<std::string> words = {"danger-space", file,  "--range", "1000 m",
                                          "--height",     "1 m", "--set",   "shot.sight.zero_range=100 m",
                                          "--json",       "-"};
  const auto json = json_of(physim(words));
  // Right: own RK4 at 1 ms, US76, G7 by PCHIP.
  EXPECT_NEAR(json["from [m]"], 989.807, 0.01);
  EXPECT_NEAR(json["to [m]"], 1009.970, 0.01);
  EXPECT_EQ(json["ends_with_flight"], false);
  // A flight that lands inside of the space ends it, and says so.
  const Ran landed = physim({"danger-space", file, "--range", "600 m", "--height", "8 m", "--set", "until.ground=0 m",
                             "--set", "shot.position=[0, 5, 0]"});
  EXPECT_EQ(landed.code, 0) << landed.err;
  EXPECT_TRUE(has(landed.out, "because the flight does: landed")) << landed.out;
}

TEST(CliTable, IsInItsOwnUnitsToTheLastRow) {
  std::string text = kBullet;
  text.replace(text.find("\"1000 m\""), 8, "\"1500 yd\"");
  const File file("bullet.toml", text + "[output]\nranges = \"10 yd .. 1600 yd step 10 yd\"\n");
  const auto rows = lines_of(physim({"table", file, "--units", "customary"}).out);
  const auto row = [&](const std::string& range) {
    const auto found =
        std::ranges::find_if(rows, [&](const std::string& each) { return has(each, " " + range + " "); });
    return found == rows.end() ? "no row " + range : *found;
  };
  EXPECT_FALSE(has(row("1500"), "not reached")) << row("1500");
  EXPECT_TRUE(has(row("1510"), "not reached: reached_range at 1500 yd")) << row("1510");
}

TEST(CliFit, TakesDropsAsAnglesAndAnswersInTheUnitsOfTheFile) {
  const Folder folder;
  const std::string file = folder.write("bullet.toml", kBullet);
  for (const auto& [unit, size] : {std::pair{"mil", 1e-3}, {"moa", kDegree / 60}}) {
    std::string data = "range [yd], drop [" + std::string(unit) + "]\n", metres = "range [yd], drop [m]\n";
    for (const int yards : {300, 500, 700}) {
      const double drop = -1e-5 * yards * yards;
      data += std::to_string(yards) + ", " + std::to_string(std::atan2(drop, yards * 0.9144) / size) + "\n";
      metres += std::to_string(yards) + ", " + std::to_string(drop) + "\n";
    }
    const auto fit = [&](const std::string& csv) {
      return physim({"fit", file, "--data", folder.write("d.csv", csv)});
    };
    const auto scale = [&](const std::string& csv) {
      return json_of(physim({"fit", file, "--data", folder.write("d.csv", csv), "--json", "-"}))["scale"].get<double>();
    };
    EXPECT_NEAR(scale(data), scale(metres), 1e-4) << unit;
    const Ran text = fit(data);
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_TRUE(has(text.out, "range [yd]") && has(text.out, unit) && has(text.out, "   500  drop")) << text.out;
  }
}

}  // namespace physim::testing_cli::cli_aim_cli_test
#endif
