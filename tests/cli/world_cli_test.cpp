// `physim run` of scenarios with a [world], as a user runs it.
#include "cli/program.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_world_cli_test {

constexpr const char* kWorld = R"(physim = 1
title = "A burst, it's {x}"
[[shot]]
name = "gun"
preset = "tennis_ball"
position = ["0 m", "1 m", "0 m"]
speed = "20 m/s"
elevation = "10 deg"
fidelity = "game"
[[volley]]
name = "burst, \"quoted\""
shot = "gun"
count = 300
rate = "100 Hz"
spread = { horizontal = "3 deg", vertical = "3 deg", speed = "1 m/s" }
[[force]]
point_attractor = { centre = [10, 2, 0], strength = 40, softening = 1 }
[world]
duration = "6 s"
ground = "bounce"
rows_per_thread = 1
[[expect]]
quantity = "spawned"
equals = 300
within = 0
)";

/// A rope of 500 N holds 60 kg no step, one of 600 N does; a cable of 1 m catches what falls by 0.3 m once.
constexpr const char* kJoints = R"(physim = 1
[world]
duration = "0.5 s"
ground = "none"
[[shot]]
name = "climber"
mass = "60 kg"
position = ["0 m", "-1 m", "0 m"]
fidelity = "game"
[[shot]]
name = "weight"
mass = "1 kg"
position = ["5 m", "-0.7 m", "0 m"]
fidelity = "game"
[[joint]]
name = "rope"
a = "climber"
break_force = "500 N"
[[joint]]
kind = "cable"
a = "weight"
point = ["5 m", "0 m", "0 m"]
length = "1 m"
)";

TEST(CliWorld, JointsThatBreakAndComeTautAreListed) {
  const std::string scenario = testing::TempDir() + "joints.toml", json = testing::TempDir() + "joints.json";
  std::ofstream(scenario) << kJoints;
  const Ran broken = physim({"run", scenario, "--json", json});
  ASSERT_EQ(broken.code, 0) << broken.err;
  EXPECT_NE(broken.out.find("  rope     rod               broke  0.0167\n"), broken.out.npos) << broken.out;
  EXPECT_NE(broken.out.find("  joint-2  cable          1\n"), broken.out.npos) << broken.out;
  std::ifstream in(json);
  const auto joints = nlohmann::json::parse(in)["world"]["joints"];
  EXPECT_EQ(joints[0]["end"], "broke");
  EXPECT_NEAR(joints[0]["end_time [s]"].get<double>(), 1.0 / 60, 1e-12);
  EXPECT_EQ(joints[1]["came_taut"], 1);
  EXPECT_TRUE(joints[1]["end"].is_null());
  const Ran held = physim({"run", scenario, "--set", "joint.rope.break_force=600 N"});
  EXPECT_EQ(held.out.find("broke"), held.out.npos) << held.out;
}

TEST(CliWorld, ASavedRunListsItsJoints) {
  const std::string scenario = testing::TempDir() + "joints_saved.toml", save = testing::TempDir() + "joints.save";
  std::ofstream(scenario) << kJoints;
  const Ran saving = physim({"run", scenario, "--save", save, "--save-at", "0.2 s"});
  ASSERT_EQ(saving.code, 0) << saving.err;
  EXPECT_EQ(physim({"run", scenario, "--load", save}).out, saving.out);
}

TEST(CliWorld, ASavedRunGoesOn) {
  const std::string folder = testing::TempDir();
  const std::string scenario = folder + "save.toml", save = folder + "world.save";
  std::ofstream(scenario) << kWorld;
  const Ran whole = physim({"run", scenario});
  ASSERT_EQ(whole.code, 0) << whole.err;
  const Ran saving = physim({"run", scenario, "--save", save, "--save-at", "2.5 s"});
  ASSERT_EQ(saving.code, 0) << saving.err;
  EXPECT_EQ(saving.out, whole.out) << "saving changes nothing";
  const Ran loaded = physim({"run", scenario, "--load", save});
  ASSERT_EQ(loaded.code, 0) << loaded.err;
  EXPECT_EQ(hash_of(loaded), hash_of(whole));
  EXPECT_EQ(loaded.out, whole.out) << "counts are those of one run";
  expect_complaint(physim({"run", scenario, "--load", save, "--set", "volley.seed=9"}), "is of another scenario");
  expect_complaint(physim({"run", scenario, "--load", scenario}), "not the save of a run");
  expect_complaint(physim({"run", scenario, "--load", folder + "nothing"}), "no such file");
  expect_complaint(physim({"run", scenario, "--save-at", "1 s"}), "--save FILE");
  expect_complaint(physim({"run", scenario, "--save", save, "--save-at", "7 s"}), "within the run");
  expect_complaint(physim({"run", scenario, "--load", save, "--save", save, "--save-at", "1 s"}), "later already");
  for (const std::vector<std::string>& shorter :
       {std::vector<std::string>{"--set", "world.duration=1 s"}, {"--steps", "10"}}) {
    std::vector<std::string> command = {"run", scenario, "--load", save};
    command.insert(command.end(), shorter.begin(), shorter.end());
    expect_complaint(physim(command), "the run is at 2.5 s, behind the end of this one at ");
  }
}

/// A gun, a wall that its rounds hit and sparks: what happened before the save is told, too.
constexpr const char* kSparks = R"(physim = 1
[[shape]]
name = "slab"
box = ["0.2 m", "5 m", "10 m"]
[[thing]]
name = "wall"
shape = "slab"
position = ["150.2 m", "5 m", 0]
[[shot]]
name = "round"
mass = "9.5 g"
diameter = "7.82 mm"
fidelity = "game"
[[shot]]
name = "spark"
mass = "1 mg"
diameter = "0.5 mm"
fidelity = "game"
[[emitter]]
name = "gun"
shot = "round"
position = [0, "2 m", 0]
rotation = { pitch = "1 deg" }
gun = { rounds_per_minute = 900, magazine = 20, magazines = 1, dispersion = "2 mrad" }
start = { speed = "850 m/s" }
sub = [{ on = "hit", emitter = "sparks", count = 6, axis = "normal" }]
[[emitter]]
name = "sparks"
shot = "spark"
per_second = 0
cycle.plays = false
from = { shape = "cone", radius = 0, angle = "60 deg" }
start = { lifetime = ["0.2 s", "0.4 s"], speed = ["5 m/s", "15 m/s"] }
[world]
duration = "3 s"
)";

TEST(CliWorld, FilesOfALoadedRunAreThoseOfOneRun) {
  const Folder folder;
  const std::string file = folder.write("w.toml", kSparks);
  const auto files = [&](const std::string& name, std::vector<std::string> more) {
    std::vector<std::string> words = {"run", file};
    for (const char* kind : {"csv", "events", "hits", "json"})
      words.insert(words.end(), {std::string("--") + kind, folder / (name + "." + kind)});
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = physim(words);
    EXPECT_EQ(ran.code, 0) << ran.err;
    return ran.out;
  };
  const std::string whole = files("whole", {});
  ASSERT_EQ(physim({"run", file, "--save", folder / "w.save", "--save-at", "1 s"}).code, 0);
  EXPECT_EQ(files("loaded", {"--load", folder / "w.save"}), whole);
  EXPECT_GT(std::ranges::count(read(folder / "whole.hits"), '\n'), 15);
  for (const char* kind : {"csv", "events", "hits", "json"})
    EXPECT_EQ(read(folder / ("loaded." + std::string(kind))), read(folder / ("whole." + std::string(kind)))) << kind;
  EXPECT_EQ(physim({"run", file, "--load", folder / "w.save"}).out, physim({"run", file}).out) << "the table of hits";
}

TEST(CliWorld, ReplayCountsWhatEmittersFired) {
  const Folder folder;
  const Ran ran =
      physim({"run", folder.write("w.toml", kSparks), "--record", folder / "w.rec", "--json", folder / "w.json"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  int fired = 0;
  const auto json = nlohmann::json::parse(read(folder / "w.json"));
  for (const auto& group : json["world"]["groups"]) fired += group["spawned"].get<int>();
  ASSERT_GT(fired, 20);
  const Ran replayed = physim({"replay", folder / "w.rec"});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_TRUE(has(replayed.out, "projectiles  " + std::to_string(fired) + " spawned, " + std::to_string(fired) +
                                    " of them by emitters, "))
      << replayed.out;
}

/// Without a thing, hit_y and hit_z are those of all that was hit: the wall of the world, and things.
TEST(CliWorld, HeightsOfHitsAreThoseOfThingsToo) {
  const std::string text = R"(physim = 1
[environment]
gravity = "off"
atmosphere = "vacuum"
[[shape]]
name = "box"
box = ["1 m", "1 m", "1 m"]
[[thing]]
shape = "box"
position = ["5 m", 0, 0]
[[shot]]
name = "low"
position = [0, "0.3 m", "0.2 m"]
velocity = ["100 m/s", 0, 0]
[[shot]]
name = "high"
position = [0, "2.3 m", "0.6 m"]
velocity = ["100 m/s", 0, 0]
[world]
duration = "0.2 s"
wall = "10 m"
)";
  const auto expecting = [&](const std::string& shot, const std::string& quantity, const std::string& equals) {
    const Ran ran =
        physim({"run", Folder().write("w.toml", text + "[[expect]]\nshot = \"" + shot + "\"\nquantity = \"" + quantity +
                                                    "\"\nequals = \"" + equals + "\"\nwithin = \"1 mm\"\n")});
    EXPECT_EQ(ran.code, 0) << shot << " " << quantity << ran.out << ran.err;
  };
  expecting("low", "hit_y", "0.3 m");
  expecting("low", "hit_z", "0.2 m");
  expecting("low", "hit_y_spread", "0 m");
  expecting("high", "hit_y", "2.3 m");
  expecting("high", "hit_z", "0.6 m");
}

TEST(CliWorld, PrintsASummary) {
  const Folder folder;
  const Ran ran = physim({"run", folder.write("w.toml", kWorld)});
  EXPECT_EQ(ran.code, 0) << ran.err;
  for (const char* part : {"A burst, it's {x}", "spawned", "bounces", "impacts of", "range [m]",
                           "gun game: motion force", "steps 360 of 0.0166667 s", "hash ", "1 of 1 met"})
    EXPECT_TRUE(has(ran.out, part)) << part << "\n" << ran.out;
  EXPECT_EQ(physim({"run", folder.write("w.toml", kWorld), "--set", "volley.count=299"}).code, 1);
}

TEST(CliWorld, HashesDoNotDependOnThreadsAndKernels) {
  const File file("w.toml", kWorld);
  const std::string hash = hash_of(physim({"run", file, "--threads", "1"}));
  EXPECT_EQ(hash_of(physim({"run", file, "--threads", "7"})), hash);
  std::istringstream kernels(physim({"list", "kernels"}).out);
  int tried = 0;
  for (std::string kernel; std::getline(kernels, kernel); ++tried)
    EXPECT_EQ(hash_of(physim({"run", file, "--threads", "2"}, {"PHYSIM_KERNEL=" + kernel})), hash) << kernel;
  EXPECT_GE(tried, 2);
  EXPECT_NE(hash_of(physim({"run", file, "--set", "volley.seed=2"})), hash);
}

TEST(CliWorld, WritesTrajectoriesAndEvents) {
  const Folder folder;
  const std::string file = folder.write("w.toml", kWorld);
  const Ran ran = physim({"run", file, "--interval", "1 s", "--csv", folder / "w.csv", "--json", folder / "w.json",
                          "--events", folder / "e.csv", "--plot", folder / "w.png"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string csv = read(folder / "w.csv"), events = read(folder / "e.csv");
  EXPECT_TRUE(csv.starts_with("what,number,t [s],x [m],y [m],z [m],vx [m/s],vy [m/s],vz [m/s]\n")) << csv;
  EXPECT_TRUE(has(csv, "\n\"burst, \"\"quoted\"\"\",1,0,0,1,0,")) << csv.substr(0, 500);
  EXPECT_TRUE(events.starts_with("t [s],event,reason,what,number,x [m]")) << events;
  EXPECT_TRUE(has(events, "\n0,spawned,none,"));
  EXPECT_TRUE(has(events, ",bounced,none,"));
  const auto json = nlohmann::json::parse(read(folder / "w.json"));
  EXPECT_EQ(json.at("world").at("hash"), hash_of(ran));
  EXPECT_EQ(json.at("world").at("groups").at(0).at("spawned"), 300);
  EXPECT_EQ(json.at("world").at("trajectories").at("x [m]").size(), std::ranges::count(csv, '\n') - 1u);
  EXPECT_EQ(json.at("world").at("events").size(), std::ranges::count(events, '\n') - 1u);
  EXPECT_EQ(json.at("settings").at("world.duration"), "6 s");
  EXPECT_GT(read(folder / "w.png").size(), 10'000u);
  EXPECT_TRUE(physim({"run", file, "--steps", "200", "--interval", "1 s", "--csv", "-"}).out.starts_with("what,"));
}

TEST(CliWorld, WritesAFolder) {
  const Folder folder;
  const Ran ran = physim({"run", folder.write("w.toml", kWorld), "--out", folder / "out"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  for (const char* name : {"out/w.csv", "out/w.json", "out/w.png", "out/w_events.csv"})
    EXPECT_FALSE(read(folder / name).empty()) << name;
}

TEST(CliWorld, RecordsForReplay) {
  const Folder folder;
  const Ran ran = physim({"run", folder.write("w.toml", kWorld), "--steps", "200", "--record", folder / "w.rec"});
  EXPECT_EQ(ran.err, "");
  const Ran replayed = physim({"replay", folder / "w.rec", "--json", "-"});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_EQ(nlohmann::json::parse(replayed.out).at("hash"), "0x" + hash_of(ran));
}

TEST(CliWorld, TakesStepsInsteadOfADuration) {
  EXPECT_TRUE(has(physim({"run", Folder().write("w.toml", kWorld), "--steps", "17"}).out, "steps 17 of"));
}

TEST(CliWorld, SaysWhatIsNotForFlights) {
  const Folder folder;
  const std::string flight = folder.write("f.toml", "physim = 1\n[[shot]]\nspeed = 10\n");
  expect_complaint(physim({"run", flight, "--steps", "5"}), "--steps: error: the scenario has no [world]");
  expect_complaint(physim({"run", flight, "--threads", "5"}), "--threads: error: the scenario has no [world]");
  expect_complaint(physim({"run", flight, "--record", folder / "r"}), "--record: error: the scenario has no [world]");
  expect_complaint(physim({"run", flight, "--events", folder / "e.csv"}),
                   "--events: error: the scenario has no [world]");
  const std::string world = folder.write("w.toml", kWorld);
  expect_complaint(physim({"run", world, "--steps", "0"}), "--steps");
  expect_complaint(physim({"run", world, "--events", world}), "cannot write: it is the scenario itself");
  expect_complaint(physim({"run", world, "--set", "world.step=1 m"}), "--set world.step=1 m: error: world.step");
}

TEST(CliWorld, WarnsOfRefusals) {
  const Ran ran = physim({"run", Folder().write("w.toml", kWorld), "--set", "world.max_projectiles=5"});
  EXPECT_TRUE(has(ran.err, "warning: 295 launches of \"burst, \"quoted\"\" were refused: the world is full"))
      << ran.err;
}

TEST(CliWorld, ListsPresets) {
  const Ran ran = physim({"list", "presets"});
  for (const char* part : {"small_arms", "rifle_bullet", "tennis_ball", "artillery"}) EXPECT_TRUE(has(ran.out, part));
}

}  // namespace physim::testing_cli::cli_world_cli_test
#endif
