// `physim run`, `compare` and `list`, as a user runs them.
#include <cmath>
#include <map>

#include "cli/program.hpp"
#include "physim/result.hpp"
#include "scenario/libraries.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_cli_test {

constexpr const char* kBall = R"(physim = 1
title = "A ball, it's {x} \"thrown\""
[[shot]]
name = "ball"
mass = "0.5 kg"
diameter = "0.1 m"
drag = { table = "constant", coefficient = 0.4 }
speed = "40 m/s"
elevation = "30 deg"
fidelity = "constant_air"
[output]
ranges = ["20 m", "50 m", "900 m"]
)";

std::vector<double> numbers_of(const std::string& csv_line) {
  std::vector<double> numbers;
  std::istringstream in(csv_line.substr(csv_line.find(',') + 1));
  for (std::string cell; std::getline(in, cell, ',');) numbers.push_back(std::stod(cell));
  return numbers;
}

// ------------------------------------------------------------------------------------------------------ the program
TEST(Cli, TellsItsVersionAndHelp) {
  EXPECT_EQ(physim({"--version"}).code, 0);
  const std::string version = physim({"--version"}).out;
  EXPECT_EQ(lines_of(version)[0], std::string("physim ") + kVersion);
  EXPECT_TRUE(has(version, PHYSIM_HAS_ASSIMP ? "with     Assimp   meshes" : "without  Assimp   meshes")) << version;
  const Ran bare = physim({"--version"}, {"PATH="});
  EXPECT_TRUE(has(bare.out, "without  gnuplot") && has(bare.out, "gnuplot-nox")) << bare.out;
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{"--help"},
                                                                                       {"run", "--help"},
                                                                                       {"compare", "--help"},
                                                                                       {"list", "--help"},
                                                                                       {"validate", "--help"},
                                                                                       {"replay", "--help"}}) {
    const Ran ran = physim(command);
    EXPECT_EQ(ran.code, 0);
    EXPECT_TRUE(has(ran.out, "Examples:")) << command.front();
  }
}

TEST(Cli, NamesWhatItDoesNotKnow) {
  expect_complaint(physim({}), "a subcommand is required");
  expect_complaint(physim({"fly"}), "there is no command \"fly\"");
  expect_complaint(physim({"run"}), "FILE is required");
  expect_complaint(physim({"run", "a.toml", "--velocty", "3"}), "--velocty");
  expect_complaint(physim({"run", "a.toml", "b.toml"}), "b.toml");
  expect_complaint(physim({"list", "settings", "--frobnicate"}), "--frobnicate");
  expect_complaint(physim({"list", "setings"}), "there is no command \"list setings\"; did you mean \"settings\"?");
  expect_complaint(physim({"comapre", "a.toml"}), "did you mean \"compare\"? see physim --help");
  expect_complaint(physim({"run", "a.toml", "--plott", "3"}), "unknown option \"--plott\"; did you mean \"--plot\"?");
  expect_complaint(physim({"run", "a.toml", "--plott=3"}), "did you mean \"--plot\"? see physim run --help");
}

TEST(Cli, RefusesEmptyValues) {
  for (const char* option : {"--csv", "--json", "--plot", "--out", "--interval"})
    expect_complaint(physim({"run", "a.toml", option, ""}), std::string(option) + ": the value is empty");
  expect_complaint(physim({"compare", "a.toml", "--shot", ""}), "--shot: the value is empty");
}

TEST(Cli, NamesTheKernelsThereAre) {
  const auto with_kernel = [](const std::string& kernel) {
    return run_program(PHYSIM_CLI, {"list", "kernels"}, "", {"PHYSIM_KERNEL=" + kernel});
  };
  expect_complaint(with_kernel("avx9"), "PHYSIM_KERNEL: error: unknown kernel \"avx9\"; ");
  expect_complaint(with_kernel("avx9"), "base, scalar");
  EXPECT_EQ(with_kernel("base").code, 0);
  EXPECT_EQ(with_kernel("").code, 0);
}

TEST(Cli, WritesNoColourIntoAPipe) {
  EXPECT_FALSE(has(physim({"run", Folder().write("ball.toml", kBall)}).out, "\033"));
}

// -------------------------------------------------------------------------------------------------------------- run
TEST(CliRun, PrintsARangeCard) {
  const Ran ran = physim({"run", Folder().write("ball.toml", kBall)});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  for (const char* part : {"A ball, it's {x} \"thrown\"", "constant_air", "range [m]",
                           "height [m]  windage [m]  time [s]", "not reached", "landed", "apex", "cost"})
    EXPECT_TRUE(has(ran.out, part)) << part << "\n" << ran.out;
}

TEST(CliRun, OddFlightsAreShownToo) {
  const Folder folder;
  const auto with = [&](const std::vector<std::string>& settings) {
    std::vector<std::string> arguments = {"run", folder.write("ball.toml", kBall), "--plot", folder / "a.png"};
    for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    return physim(arguments);
  };
  const Ran up = with({"shot.elevation=90 deg", "output.ranges=[]"});
  EXPECT_EQ(up.code, 0) << up.err;
  EXPECT_FALSE(has(up.out, "range [m]")) << up.out;  // there is no range
  EXPECT_EQ(with({"shot.elevation=-10 deg"}).code, 0);
  const Ran fast = with({"shot.speed=299792458 m/s", "shot.fidelity=arcade", "until.range=1 m"});
  EXPECT_TRUE(has(fast.out, "reached_range  at 0.000000003")) << fast.out << fast.err;
  const Ran lost = with({"shot.speed=0 m/s", "until.ground=off", "shot.fidelity=small_arms"});
  EXPECT_EQ(lost.code, 1);
  EXPECT_TRUE(has(lost.err, "warning: shot \"ball\" ended early: left_domain")) << lost.err;
}

TEST(CliRun, TheRangeThatEndsAFlightIsOnItsCard) {
  const File file("ball.toml", kBall);
  for (int range = 11; range < 60; range += 3) {
    const std::string text = std::to_string(range) + " m";
    const Ran ran = physim({"run", file, "--set", "until.range=" + text, "--set", "output.ranges=[\"" + text + "\"]"});
    EXPECT_TRUE(has(ran.out, "reached_range")) << ran.out << ran.err;
    EXPECT_FALSE(has(ran.out, "not reached")) << ran.out;
  }
}

TEST(CliRun, CsvHoldsTheFlightAndNothingElse) {
  const Ran ran = physim({"run", Folder().write("ball.toml", kBall), "--csv", "-"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::vector<std::string> lines = lines_of(ran.out);
  ASSERT_GE(lines.size(), 201U);
  ASSERT_LE(lines.size(), 503U);
  EXPECT_EQ(lines[0],
            "shot,t [s],x [m],y [m],z [m],vx [m/s],vy [m/s],vz [m/s],ax [m/s^2],ay [m/s^2],az [m/s^2],"
            "speed [m/s],mach [-],mass [kg],thrust [N]");
  EXPECT_TRUE(lines[1].starts_with("ball,0,0,0,0,")) << lines[1];
  double last_time = -1;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<double> row = numbers_of(lines[i]);
    ASSERT_EQ(row.size(), 14U) << lines[i];
    EXPECT_GT(row[0], last_time);
    EXPECT_NEAR(row[10], std::hypot(row[4], row[5], row[6]), 1e-9);
    last_time = row[0];
  }
  const std::vector<double> first = numbers_of(lines[1]), last = numbers_of(lines.back());
  EXPECT_NEAR(first[10], 40, 1e-12);
  EXPECT_NEAR(last[2], 0, 1e-6);  // on the ground
}

/// Damping of rate k: j = -k a, whatever the place; a world has no samples to add it to.
TEST(CliRun, JerkIsAddedToSamplesAndPlotsWhereItIsAskedFor) {
  const Folder folder;
  const std::string file =
      folder.write("damped.toml",
                   "physim = 1\n[until]\ntime = \"1 s\"\nground = \"off\"\n[[shot]]\nspeed = \"9 m/s\"\n"
                   "elevation = \"40 deg\"\ndrag.damping = 0.5\nfidelity = { preset = \"constant_air\", "
                   "drag = \"damping\" }\n");
  const std::vector<std::string> lines =
      lines_of(physim({"run", file, "--jerk", "--interval", "0.1 s", "--csv", "-"}).out);
  ASSERT_GT(lines.size(), 10U);
  EXPECT_TRUE(lines[0].ends_with("mass [kg],thrust [N],jx [m/s^3],jy [m/s^3],jz [m/s^3]")) << lines[0];
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<double> row = numbers_of(lines[i]);
    ASSERT_EQ(row.size(), 17U) << lines[i];
    for (const std::size_t axis : {0U, 1U, 2U}) EXPECT_NEAR(row[14 + axis], std::log(0.5) * row[7 + axis], 1e-5);
  }
  EXPECT_TRUE(has(physim({"run", file, "--jerk", "--json", "-"}).out, "\"jy [m/s^3]\""));
  const std::string world =
      folder.write("world.toml", "physim = 1\n[world]\nduration = \"1 s\"\n[[shot]]\nspeed = \"9 m/s\"\n");
  const Ran ran = physim({"run", world, "--jerk"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(has(ran.err, "--jerk")) << ran.err;
}

/// Of a curve from Mach 0.5 to 1.5 a flight from Mach 2 down to rest keeps the ends.
TEST(CliRun, SaysWhereAFlightLeavesItsOwnDragCurve) {
  const Folder folder;
  const auto text = [](const std::string& curve) {
    return "physim = 1\n[until]\ntime = \"60 s\"\n[[shot]]\nname = \"b\"\nmass = \"10 g\"\ndiameter = \"8 mm\"\n"
           "drag = { table = \"custom\", curve = " +
           curve + " }\nspeed = \"680 m/s\"\nelevation = \"20 deg\"\nfidelity = \"small_arms\"\n";
  };
  const std::string file = folder.write("c.toml", text("[[0.5, 0.2], [1.5, 0.3]]"));
  const Ran ran = physim({"run", file});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "the drag curve ends at Mach 1.5, and the flight is above it between 0 and ")) << ran.out;
  EXPECT_TRUE(has(ran.out, "by Mach 1.998 at 0 m at the most")) << ran.out;
  EXPECT_TRUE(has(ran.out, "the drag curve begins at Mach 0.5, and the flight is below it between ")) << ran.out;
  const auto json = nlohmann::json::parse(physim({"run", file, "--json", "-"}).out);
  EXPECT_EQ(json["shots"][0]["notes"].size(), 2U);
  EXPECT_TRUE(has(physim({"table", file}).err, "the drag curve ends at Mach 1.5"));
  const Ran within = physim({"run", folder.write("d.toml", text("[[0, 0.2], [5, 0.3]]"))});
  EXPECT_FALSE(has(within.out, "drag curve")) << within.out;
  // Behind every other door, too.
  const std::string above = "shot \"b\": the drag curve ends at Mach 1.5, and the flight is above it between 0 and ";
  const std::string study = "study.inputs=[\"shot.speed = +- 1 m/s\"]";
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"aim", file, "--target", "500 m, 0 m, 0 m", "--arc", "low"},
           {"danger-space", file, "--range", "300 m", "--height", "1 m"},
           {"max-range", file},
           {"study", file, "--set", study, "--shots", "64"},
           {"run",
            folder.write("w.toml", "physim = 1\n[world]\nduration = 1\n" +
                                       text("[[0.5, 0.2], [1.5, 0.3]]")
                                           .substr(std::string("physim = 1\n[until]\ntime = \"60 s\"\n").size()))}}) {
    const Ran other = physim(command);
    EXPECT_NE(other.code, 2) << command[0] << other.err;
    EXPECT_TRUE(has(other.err, above)) << command[0] << ": " << other.err;
  }
}

TEST(Cli, mistakes_of_all_options_are_told_at_once) {
  const File file("m.toml", "physim = 1\n[[shot]]\nspeed = 50\nmas = 3\n");
  const Ran ran = physim({"run", file, "--set", "shot.speeed=5", "--set", "shot.diameter", "--set", "shot.mass=-1 kg"});
  EXPECT_EQ(ran.code, 2);
  for (const char* mistake : {"speeed", "an override without \"=\"", "shot.mass", "mas"})
    EXPECT_TRUE(has(ran.err, mistake)) << mistake << ": " << ran.err;
}

/// A launcher gives its ranks a terminal, whose text goes into a file.
TEST(CliRun, RanksOfAJobWriteNoEscapeCodes) {
  const std::string script = "/usr/bin/script";
  if (!std::filesystem::exists(script)) GTEST_SKIP() << "script is missing";
  const Folder folder;
  const std::string command = std::string(PHYSIM_CLI) + " run " + folder.write("ball.toml", kBall);
  const auto run_on_terminal = [&](const std::string& what, std::vector<std::string> environment) {
    environment.insert(environment.end(), {"TERM=xterm", "PATH=/usr/bin:/bin"});
    return run_program(script, {"-qec", what, folder / "typescript"}, "", environment);
  };
  if (run_on_terminal("true", {}).code != 0) GTEST_SKIP() << "no terminal can be made here";
  EXPECT_TRUE(has(run_on_terminal(command, {}).out, "\033[1m")) << "a terminal has colours";
  const std::string of_rank = run_on_terminal(command, {"OMPI_COMM_WORLD_SIZE=4"}).out;
  EXPECT_TRUE(has(of_rank, "ball"));
  EXPECT_FALSE(has(of_rank, "\033[")) << of_rank;
}

TEST(CliRun, IntervalIsKept) {
  const std::vector<std::string> lines =
      lines_of(physim({"run", Folder().write("ball.toml", kBall), "--csv", "-", "--interval", "100 ms"}).out);
  ASSERT_GT(lines.size(), 5U);
  EXPECT_TRUE(lines[2].starts_with("ball,0.1,")) << lines[2];
  EXPECT_TRUE(lines[4].starts_with("ball,0.3,")) << lines[4];
}

TEST(CliRun, IntervalsThatCannotBeAreRefused) {
  const File file("ball.toml", kBall);
  const auto with = [&](const char* interval) { return physim({"run", file, "--csv", "-", "--interval", interval}); };
  expect_complaint(with("0 s"), "positive");
  expect_complaint(with("-1 s"), "positive");
  expect_complaint(with("nan"), "--interval");
  expect_complaint(with("inf"), "--interval");
  expect_complaint(with("3 kg"), "--interval");
  expect_complaint(with("1e-9 s"), "1000000 are allowed");
  expect_complaint(with("1e-300 s"), "1000000 are allowed");
}

TEST(CliRun, JsonHoldsResultAndProvenance) {
  const Ran ran = physim({"run", Folder().write("ball.toml", kBall), "--json", "-", "--set", "shot.mass=0.4 kg"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json.at("program"), "physim");
  EXPECT_TRUE(json.at("version").is_string());
  EXPECT_EQ(json.at("settings").at("shot.ball.mass"), "0.4 kg");
  const auto& shot = json.at("shots").at(0);
  EXPECT_EQ(shot.at("name"), "ball");
  EXPECT_EQ(shot.at("outcome"), "landed");
  EXPECT_EQ(shot.at("fidelity_asked").at("integrator"), "adaptive");
  EXPECT_EQ(shot.at("fidelity_granted").at("integrator"), "rk43") << "a point";
  EXPECT_EQ(shot.at("fidelity_granted").at("precision"), "float64");
  EXPECT_GT(shot.at("cost").at("evaluations"), 0);
  EXPECT_EQ(shot.at("range_card").size(), 2U);
  EXPECT_EQ(shot.at("events").back().at("kind"), "ground");
  const auto& trajectory = shot.at("trajectory");
  EXPECT_EQ(trajectory.size(), 14U);
  EXPECT_EQ(trajectory.at("t [s]").size(), trajectory.at("mach [-]").size());
  EXPECT_EQ(trajectory.at("t [s]").back(), shot.at("duration [s]"));
}

/// Defaults with which the flight would end elsewhere, and no others.
TEST(CliRun, JsonListsWhatWasAssumed) {
  const File file("ball.toml", kBall);
  const auto assumed = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"run", file, "--json", "-"};
    words.insert(words.end(), more.begin(), more.end());
    const auto json = nlohmann::json::parse(physim(words).out);
    std::map<std::string, std::string> all;
    for (const auto& each : json.at("shots").at(0).at("assumed")) all[each.at("path")] = each.at("value");
    return all;
  };
  const auto all = assumed({});
  EXPECT_TRUE(all.contains("environment.gravity.acceleration"));
  EXPECT_EQ(all.at("environment.gravity.acceleration"), "9.80665 m/s^2");
  EXPECT_TRUE(all.contains("environment.atmosphere.temperature") || all.contains("environment.atmosphere.pressure"));
  EXPECT_TRUE(all.contains("until.ground"));
  EXPECT_FALSE(all.contains("shot.ball.mass")) << "it is given";
  EXPECT_FALSE(all.contains("shot.ball.drag.coefficient")) << "in a table of its own";
  EXPECT_FALSE(all.contains("shot.ball.twist")) << "on this rung no spin is flown";
  EXPECT_FALSE(all.contains("until.time")) << "it lands before";
  EXPECT_FALSE(
      assumed({"--set", "environment.gravity.acceleration=9.81 m/s^2"}).contains("environment.gravity.acceleration"));
}

TEST(CliRun, NamesWithCommasSurvive) {
  const Ran ran = physim({"run", Folder().write("ball.toml", kBall), "--csv", "-", "--set", "shot.name=a, b"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(lines_of(ran.out)[1].starts_with("\"a, b\",0,")) << lines_of(ran.out)[1];
}

TEST(CliRun, ExpectationsDecideTheExitCode) {
  const Folder folder;
  const auto expecting = [](const char* equals) {
    return std::string(kBall) + "[[expect]]\nat = \"end\"\nquantity = \"y\"\nequals = \"" + equals +
           "\"\nwithin = \"1 mm\"\nsource = \"the ground\"\n";
  };
  const Ran met = physim({"run", folder.write("met.toml", expecting("0 m"))});
  EXPECT_EQ(met.code, 0) << met.err;
  EXPECT_TRUE(has(met.out, "1 of 1 met")) << met.out;
  const std::string file = folder.write("missed.toml", expecting("5 m"));
  const Ran missed = physim({"run", file});
  EXPECT_EQ(missed.code, 1) << missed.err;
  EXPECT_TRUE(has(missed.out, "MISSED")) << missed.out;
  EXPECT_TRUE(has(missed.out, "the ground")) << missed.out;
  const Ran quiet = physim({"run", file, "--csv", "-"});
  EXPECT_EQ(quiet.code, 1);
  EXPECT_TRUE(has(quiet.err, "1 of 1 checks were missed")) << quiet.err;
}

TEST(CliRun, ChecksAreShownAsTypedOneLineEach) {
  const std::string expect =
      "[[expect]]\nat = \"end\"\nquantity = \"y\"\nequals = \"0 m\"\nwithin = \"26 mm\"\n"
      "source = \"\"\"\n  first line \n\n\tand second\\u001b[31m\n\"\"\"\n"
      "[[expect]]\nat = { range = \"10 yd\" }\nquantity = \"range\"\nequals = \"30 ft\"\nwithin = \"2.6 cm\"\n";
  const Ran ran = physim({"run", Folder().write("ball.toml", kBall + expect)});
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::vector<std::string> lines = lines_of(ran.out);
  ASSERT_GT(lines.size(), 4U);
  EXPECT_EQ(lines[lines.size() - 1], "  2 of 2 met");
  EXPECT_TRUE(lines[lines.size() - 3].ends_with(" 0.026  m     first line and second [31m")) << ran.out;
  EXPECT_TRUE(has(lines[lines.size() - 2], "  range 9.144 m  ")) << ran.out;
  EXPECT_TRUE(has(lines[lines.size() - 2], "  9.144   0.026  m")) << ran.out;
}

TEST(CliRun, ManyOddEndsAreCounted) {
  std::string many = kBall;
  for (int i = 0; i < 9; ++i) many += "[[shot]]\nname = \"s" + std::to_string(i) + "\"\nspeed = 30\nelevation = 1\n";
  const Ran ran = physim({"run", Folder().write("many.toml", many), "--set", "tolerance.max_steps=1"});
  EXPECT_EQ(ran.code, 1) << ran.err;
  const std::vector<std::string> lines = lines_of(ran.err);
  ASSERT_EQ(lines.size(), 6U) << ran.err;
  EXPECT_EQ(lines[0], "warning: shot \"ball\" ended early: step_limit, it took tolerance.max_steps steps");
  EXPECT_EQ(lines[5], "warning: 5 more shots ended early");
}

TEST(CliRun, BadScenariosAreNamedWithTheirPlace) {
  const Folder folder;
  expect_complaint(physim({"run", folder / "none.toml"}), "none.toml: error: ");
  expect_complaint(physim({"run", folder / "."}), "error: ");
  expect_complaint(physim({"run", "/dev/zero"}), "/dev/zero: error: this is a device");
  expect_complaint(physim({"run", folder.write("bad.toml", "physim = 1\n[[shot]]\nsped = 3\n")}),
                   "bad.toml:3:1: error: ");
  expect_complaint(physim({"run", folder.write("ball.toml", kBall), "--set", "shot.mass=-1 kg"}), "mass");
  expect_complaint(physim({"run", folder / "ball.toml", "--set", "shot.mas=1 kg"}), "mas");
  expect_complaint(physim({"run", folder / "ball.toml", "--set", "nonsense"}), "nonsense");
}

// ------------------------------------------------------------------------------------------------------------ files
TEST(CliFiles, AreWholeAndLeaveNothingBehind) {
  const Folder folder;
  const std::string file = folder.write("ball.toml", kBall);
  const Ran ran = physim({"run", file, "--csv", folder / "a.csv", "--json", folder / "a.json"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "landed"));
  EXPECT_TRUE(read(folder / "a.csv").ends_with("\n"));
  EXPECT_TRUE(nlohmann::json::accept(read(folder / "a.json")));
  EXPECT_EQ(folder.names().size(), 3U);
}

TEST(CliFiles, ThatCannotBeWrittenAreNamed) {
  const Folder folder;
  const std::string file = folder.write("ball.toml", kBall);
  expect_complaint(physim({"run", file, "--csv", folder / "no/a.csv"}), "no such directory");
  expect_complaint(physim({"run", file, "--json", folder / "."}), "it is a directory");
  expect_complaint(physim({"run", file, "--csv", "/dev/full"}), "No space left");
  expect_complaint(physim({"run", file, "--csv", "-", "--json", "-"}), "cannot both");
  expect_complaint(physim({"run", file, "--plot", folder / "a.pdf"}), "end it with .png or .svg");
  expect_complaint(physim({"run", file, "--plot", "-"}), "end it with .png or .svg");
  expect_complaint(physim({"run", file, "--out", file}), "it is a file, not a directory");
  EXPECT_EQ(folder.names().size(), 1U);
}

TEST(CliFiles, AreNeverWrittenOverEachOther) {
  const Folder folder;
  const std::string file = folder.write("ball.toml", kBall);
  const std::string other = folder / "./a.csv", dots = folder / "./ball.toml";
  expect_complaint(physim({"run", file, "--csv", dots}), "cannot write: it is the scenario itself");
  expect_complaint(physim({"compare", file, "--json", file}), "cannot write: it is the scenario itself");
  expect_complaint(physim({"run", file, "--csv", folder / "a.csv", "--json", other}), "--csv and --json cannot both");
  expect_complaint(physim({"run", file, "--csv", folder / "a.png", "--plot", folder / "a.png"}), "--csv and --plot");
  EXPECT_EQ(read(file), kBall);
  EXPECT_EQ(folder.names().size(), 1U);
  EXPECT_EQ(physim({"run", file, "--csv", "/dev/null", "--json", "/dev/null"}).code, 0);
}

TEST(CliFiles, AFullStandardOutputIsAnError) {
  const File file("ball.toml", kBall);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", file}, {"run", file, "--csv", "-"}, {"list", "settings"}}) {
    const Ran ran = run_program(PHYSIM_CLI, arguments, "/dev/full");
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(has(ran.err, "No space left")) << ran.err;
  }
}

TEST(CliFiles, ADeviceIsWrittenToAndNotReplaced) {
  EXPECT_EQ(physim({"run", Folder().write("ball.toml", kBall), "--csv", "/dev/null"}).code, 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

// ------------------------------------------------------------------------------------------------------------ plots
TEST(CliPlot, IsDrawnInBothFormats) {
  const Folder folder;
  const std::string file = folder.write("ball.toml", kBall);
  const Ran ran = physim({"run", file, "--plot", folder / "a.svg"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string svg = read(folder / "a.svg");
  EXPECT_TRUE(has(svg, "<svg"));
  for (const char* part : {"A ball, it", "{x}", "speed [m/s]", "vx [m/s]", "ay [m/s", "t [s]", "height [m]"})
    EXPECT_TRUE(has(svg, part)) << part;
  EXPECT_EQ(physim({"run", file, "--plot", folder / "A.PNG"}).code, 0);
  EXPECT_TRUE(read(folder / "A.PNG").starts_with("\x89PNG"));
}

TEST(CliPlot, TitlesAreTextAndNeverCommands) {
  const Folder folder;
  const std::string trap = folder / "trap";
  for (const std::string& name :
       std::vector<std::string>{"'; system('touch " + trap + "') #", "`touch " + trap + "`", "\\n @x ^_{~a b}"}) {
    const Ran ran =
        physim({"run", folder.write("ball.toml", kBall), "--set", "shot.name=" + name, "--plot", folder / "a.svg"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(trap)) << name;
  }
}

// Where the label of a text stands in a picture of gnuplot's: pixels from its top.
double height_of(const std::string& svg, const std::string& text) {
  const std::size_t at = svg.find(">" + text), place = svg.rfind("translate(", at);
  if (at == std::string::npos || place == std::string::npos) return NAN;
  return std::stod(svg.substr(svg.find(',', place) + 1));
}

TEST(CliPlot, TheLegendStaysOutOfTheTitle) {
  const Folder folder;
  const std::string title = "A title that is so long that it reaches from one end of the picture to the other end";
  std::string four = kBall;
  for (const char* name : {"second", "third", "fourth"})
    four += "[[shot]]\nname = \"" + std::string(name) + "\"\nspeed = \"30 m/s\"\nelevation = \"50 deg\"\n";
  const Ran ran =
      physim({"run", folder.write("four.toml", four), "--set", "title=" + title, "--plot", folder / "a.svg"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string svg = read(folder / "a.svg");
  for (const char* name : {"ball", "second", "third", "fourth"}) {
    EXPECT_GT(height_of(svg, name), height_of(svg, title) + 25) << name;
    EXPECT_LT(height_of(svg, name), height_of(svg, "height [m] over distance") - 20) << name;
  }
}

TEST(CliPlot, AMissingGnuplotIsNamedWithItsPackage) {
  const Folder folder;
  const std::string file = folder.write("ball.toml", kBall);
  for (const std::vector<std::string>& output :
       std::vector<std::vector<std::string>>{{"--plot", folder / "a.png"}, {"--out", folder / "out"}}) {
    const Ran ran = run_program(PHYSIM_CLI, {"run", file, output[0], output[1]}, "", {"PATH=/nonexistent"});
    expect_complaint(ran, "apt-get install gnuplot-nox");
    EXPECT_EQ(folder.names().size(), 1U);
  }
}

TEST(CliPlot, AFolderGetsEverything) {
  const Folder folder;
  const std::string second = "[[shot]]\nname = \"an/other\"\nspeed = \"30 m/s\"\nelevation = \"50 deg\"\n";
  const std::string two = std::string(kBall) + second;
  const Ran ran = physim({"run", folder.write("two.toml", two), "--out", folder / "deep/out"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* name : {"two.csv", "two.json", "two.png", "two_ball.png", "two_an_other.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / "deep/out/" + name)) << name;
}

// ---------------------------------------------------------------------------------------------------------- compare
TEST(CliCompare, ListsRungsFromPresetsToTheReference) {
  const Folder folder;
  const std::string file = folder.write("ball.toml", kBall);
  const Ran ran = physim({"compare", file, "--csv", "-", "--plot", folder / "ladder.svg"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::vector<std::string> lines = lines_of(ran.out);
  ASSERT_GT(lines.size(), 20U);
  EXPECT_EQ(lines[0],
            "shot,family,rung,error [m],at worst [m],time error [s],steps [-],evaluations [-],cost [us],work "
            "[operations],beaten by,outcome,leaves out");
  EXPECT_TRUE(lines[1].starts_with("ball,presets,arcade,")) << lines[1];
  EXPECT_TRUE(lines.back().starts_with("ball,reference,reference,0,0,")) << lines.back();
  for (const char* part : {"rk4 10 ms", "tsit5 1e-9", "dop853 1e-12", "no drag", "float32"})
    EXPECT_TRUE(has(ran.out, part)) << part;
  EXPECT_TRUE(has(read(folder / "ladder.svg"), "semi_implicit_euler"));
}

TEST(CliCompare, JudgesByTheRotationThatTheShotAsksFor) {
  const std::string shell = std::string(PHYSIM_SOURCE_DIR) + "/scenarios/105mm_m1_six_dof.toml";
  const Ran ran = physim({"compare", shell, "--json", "-", "--set", "shot.elevation=15 deg"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  std::map<std::string, double> error;
  for (const auto& rung : json.at("rungs")) error[rung.at("rung")] = rung.at("error [m]").get<double>();
  EXPECT_LT(error.at("rk4 1 ms"), 0.01);
  EXPECT_GT(error.at("modified point mass"), 1);
  EXPECT_LT(error.at("modified point mass"), error.at("spin drift only"));
  EXPECT_LT(error.at("spin drift only"), error.at("no rotation"));
}

TEST(CliCompare, ErrorsShrinkWithTheStep) {
  const Ran ran = physim({"compare", Folder().write("ball.toml", kBall), "--json", "-"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(ran.out);
  const auto error_of = [&](const std::string& wanted) {
    for (const auto& rung : json.at("rungs"))
      if (rung.at("rung") == wanted) return rung.at("error [m]").get<double>();
    ADD_FAILURE() << wanted;
    return 0.0;
  };
  EXPECT_LT(error_of("explicit_euler 1 ms"), error_of("explicit_euler 1/60 s"));
  EXPECT_LT(error_of("heun 1 ms"), error_of("explicit_euler 1 ms"));
  EXPECT_LT(error_of("rk4 10 ms"), 1e-5);
  EXPECT_LT(error_of("dop853 1e-12"), 1e-8);
  EXPECT_GT(error_of("no drag"), 1);
}

TEST(CliCompare, NamesTheShotsThereAre) {
  const Folder folder;
  const std::string file = folder.write("ball.toml", kBall);
  expect_complaint(physim({"compare", file, "--shot", "bal"}), "its shots are \"ball\"");
  expect_complaint(physim({"compare", folder / "none.toml"}), "none.toml");
  expect_complaint(physim({"compare", file, "--set", "until.ground=off", "--set", "shot.speed=0 m/s"}), "left_domain");
  expect_complaint(physim({"compare", file, "--plot", folder / "x.gif"}), ".png or .svg");
}

// ------------------------------------------------------------------------------------------------------------- list
TEST(CliList, EverythingThatHasAName) {
  const auto list = [](const std::string& what) {
    const Ran ran = physim({"list", what});
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out;
  };
  EXPECT_TRUE(has(list("settings"), "shot.drag.ballistic_coefficient"));
  EXPECT_TRUE(has(list("presets"), "small_arms"));
  EXPECT_TRUE(has(list("drag_tables"), "ra4"));
  EXPECT_TRUE(has(list("kernels"), "base"));
  EXPECT_TRUE(has(list("units"), "lb/in^2"));
  EXPECT_TRUE(has(list("models"), "inverse_square"));
  EXPECT_FALSE(has(list("models"), "(no text)"));  // a new rung needs its line in rungs.cpp
}

TEST(CliList, SettingsAsMarkdown) {
  const Ran ran = physim({"list", "settings", "--markdown"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_TRUE(has(ran.out, "# Settings"));
  EXPECT_TRUE(has(ran.out, "| `shot.mass` |"));
}

}  // namespace physim::testing_cli::cli_cli_test
#endif  // PHYSIM_CLI
