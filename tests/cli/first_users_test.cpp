// What first users stumbled on at the command line: answers that were wrong or silent.
#include "cli/program.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_first_users_test {

constexpr const char* kBullet = R"(physim = 1
[[shot]]
name = "308"
mass = "168 gr"
diameter = "0.308 in"
length = "1.215 in"
twist = "11.25 in"
drag = { table = "g7", ballistic_coefficient = "0.218 lb/in^2" }
speed = "2650 ft/s"
sight = { zero_range = "100 m", height = "1.5 in" }
fidelity = "small_arms"
[output]
ranges = ["100 m", "500 m"]
[until]
ground = "off"
range = "600 m"
)";

std::string scenario_of(const std::string& name) { return std::string(PHYSIM_SOURCE_DIR "/scenarios/") + name; }

TEST(FirstUsers, AFlightThatEndsBeforeItsTimeHasAnExitCode) {
  const std::string file = scenario_of("308_168gr_g7.toml");
  const Ran ran = physim({"run", file, "--set", "tolerance.max_steps=3"});
  EXPECT_EQ(ran.code, 1) << ran.out;
  EXPECT_TRUE(has(ran.err, "step_limit")) << ran.err;
  EXPECT_EQ(physim({"run", file}).code, 0);
}

TEST(FirstUsers, HelpIntoAFullDiskFails) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  for (const auto& words : {std::vector<std::string>{"--help"}, {"run", "--help"}, {"--version"}}) {
    const Ran ran = run_program(PHYSIM_CLI, words, "/dev/full");
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(has(ran.err, "cannot write")) << ran.err;
  }
}

TEST(FirstUsers, ACardSaysWhyARangeIsNotReached) {
  for (const char* command : {"table", "run"}) {
    const Ran ran = physim({command, scenario_of("22lr.toml"), "--set", "output.ranges=[\"50 m\", \"9 km\"]"});
    EXPECT_TRUE(has(ran.out, "not reached: ")) << ran.out << ran.err;
    EXPECT_FALSE(has(ran.out, "not reached\n")) << ran.out;
  }
}

/// A flight that lands at 1019.716 m does not reach 1019.8 m: "landed at 1020 m" would be beyond it.
TEST(FirstUsers, ACardTellsTheEndInDigitsThatShowIt) {
  const File file("v.toml", R"(physim = 1
[environment]
gravity = { model = "constant", acceleration = 9.80665 }
atmosphere = "vacuum"
[[shot]]
speed = 100
elevation = "45 deg"
fidelity = { preset = "simulation", drag = "off", air = "vacuum", gravity = "constant", earth = "flat" }
[output]
ranges = [1019.8, 2000]
)");
  const Ran ran = physim({"run", file});
  EXPECT_TRUE(has(ran.out, "not reached: landed at 1019.7 m")) << ran.out;
  EXPECT_TRUE(has(ran.out, "2000  not reached: landed at 1020 m")) << ran.out;
}

TEST(FirstUsers, ARowOfAPresetsTableIsNotSetAlone) {
  const File file("g.toml", "physim = 1\n[[shot]]\npreset = \"golf_ball\"\n");
  const Ran ran = physim({"run", file, "--set", "shot.magnus.table.1.speed=7"});
  EXPECT_EQ(ran.code, 2) << "it would be the whole table: " << ran.out;
  EXPECT_TRUE(has(ran.err, "shot.magnus.table is that of the preset \"golf_ball\"")) << ran.err;
  EXPECT_EQ(physim({"run", file, "--set", "shot.mass=0.046"}).code, 0);
}

TEST(FirstUsers, CardsInCsvKeepAllDigits) {
  const File file("b.toml", kBullet);
  const Ran csv = physim({"table", file, "--format", "csv"});
  ASSERT_EQ(csv.code, 0) << csv.err;
  std::istringstream lines(csv.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_TRUE(has(line, "drop [mil]")) << line;
  std::getline(lines, line);
  std::getline(lines, line);  // 500 m
  std::istringstream cells(line);
  std::string cell;
  for (int i = 0; i < 3; ++i) std::getline(cells, cell, ',');
  EXPECT_GT(cell.size() - cell.find('.'), 6u) << line;
}

TEST(FirstUsers, EveryCardOfWhatSpinsShowsItsStability) {
  const File file("b.toml", kBullet);
  for (const auto& words : {std::vector<std::string>{"run", file},
                            {"table", file},
                            {"table", file, "--format", "markdown"},
                            {"run", file, "--set", "shot.fidelity=simulation"}}) {
    const Ran ran = physim(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(has(ran.out, "Sg 1.")) << ran.out;
  }
}

TEST(FirstUsers, AForgottenUnitOrSpeedIsToldAsSuch) {
  const File file("b.toml", kBullet);
  const Ran unit = physim({"run", file, "--set", "shot.drag.ballistic_coefficient=0.218"});
  EXPECT_EQ(unit.code, 2);
  EXPECT_TRUE(has(unit.err, "ballistic_coefficient") && has(unit.err, "lb/in^2")) << unit.err;
  const Ran speed = physim({"run", file, "--set", "shot.speed=0"});
  EXPECT_EQ(speed.code, 2);
  EXPECT_TRUE(has(speed.err, "speed") && has(speed.err, "give the muzzle speed")) << speed.err;
}

TEST(FirstUsers, HeightsOverARoundEarthAreAltitudesAndGroundDistances) {
  const Ran ran = physim({"run", scenario_of("intercontinental_lob.toml")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "m along the ground, altitude ")) << ran.out;
  EXPECT_FALSE(has(ran.out, "downrange, height")) << ran.out;
}

TEST(FirstUsers, AShotWithoutASightIsShownByItsHeight) {
  const Ran lofted = physim({"run", scenario_of("shot_put.toml")});
  EXPECT_TRUE(has(lofted.out, "height [m]") && !has(lofted.out, "drop [m]")) << lofted.out;
  const Ran sighted = physim({"run", scenario_of("308_168gr_g7.toml")});
  EXPECT_TRUE(has(sighted.out, "drop [m]")) << sighted.out;
}

TEST(FirstUsers, ACrowdTellsWhatItNeedsBeforeItStarts) {
  const std::string world =
      std::string(kBullet).substr(0, std::string(kBullet).find("[output]")) +
      "[[volley]]\nshot = \"308\"\ncount = 9000000\nrate = \"1 1/s\"\n[world]\nduration = \"0.1 s\"\n";
  const Ran ran = physim({"run", Folder().write("w.toml", world), "--set", "shot.fidelity=game"});
  EXPECT_TRUE(has(ran.err, "9000000 launches will take about 3.2 GB")) << ran.err << ran.out;
}

/// Straight up at 2 m/s a shot in a vacuum comes 2^2 / (2 g) = 0.2039 m far, and a rail holds it there.
TEST(FirstUsers, WhatStopsOnItsRailIsTold) {
  const Folder folder;
  const std::string shot =
      folder.write("r.toml",
                   "physim = 1\n[[shot]]\nmass = 1\nspeed = 2\nelevation = \"90 deg\"\nrail_length = 1\n"
                   "fidelity = { air = \"vacuum\", drag = \"off\" }\n[until]\ntime = 5\n");
  const std::string note = "it never leaves its rail of 1 m: it stops 0.2039 m along it";
  const Ran stopped = physim({"run", shot});
  EXPECT_TRUE(has(stopped.out, note)) << stopped.out;
  EXPECT_TRUE(has(physim({"run", shot, "--json", "-"}).out, note));
  for (const char* off : {"shot.rail_length=0.2", "shot.speed=5", "until.time=0.1"})
    EXPECT_FALSE(has(physim({"run", shot, "--set", off}).out, "never leaves")) << off;
}

TEST(FirstUsers, AMotorOfACollectionIsReadThoughOthersAreFaulty) {
  const Folder folder;
  std::ofstream(folder / "all.eng") << "BAD 18 70 0 .0108 .0231 E\n0.2 5\n0.1 4\n1 0\n"
                                       "GOOD 18 70 0 .0108 .0231 E\n0.1 0\n0.1 10\n";
  const std::string rocket =
      "physim = 1\n[[shot]]\nname = \"r\"\nmass = \"0.1 kg\"\nrail_length = \"1 m\"\nelevation = \"80 deg\"\n";
  std::ofstream(folder / "all.eng") << "BAD 18 70 0 .0108 .0231 E\n0.2 5\n0.1 4\n1 0\n"
                                       "GOOD 18 70 0 .0108 .0231 E\n0.1 5\n0.1 10\n1 10\n1 0\n";
  const std::string good = folder.write("g.toml", rocket + "motor = { file = \"all.eng\", name = \"GOOD\" }\n");
  const std::string bad = folder.write("b.toml", rocket + "motor = { file = \"all.eng\", name = \"BAD\" }\n");
  const Ran flown = physim({"run", good});
  EXPECT_EQ(flown.code, 0) << flown.err;
  EXPECT_TRUE(has(flown.out, "9.250 N s")) << flown.out;  // 0.1 s up to 5 N, then 0.9 s of 10 N
  const Ran refused = physim({"run", bad});
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(has(refused.err, "all.eng:3")) << refused.err;
}

}  // namespace physim::testing_cli::cli_first_users_test
#endif
