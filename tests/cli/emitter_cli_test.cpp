// `physim run` of scenarios with emitters, as a user runs it.
#include <chrono>

#include "cli/program.hpp"

#ifdef PHYSIM_CLI

namespace physim::testing_cli::cli_emitter_cli_test {

constexpr const char* kEmitters = R"(physim = 1
[environment]
gravity = "constant"
atmosphere = "vacuum"
[[shot]]
name = "drop"
fidelity = { preset = "arcade", precision = "float64" }
[[shot]]
name = "stone"
position = [0, "5 m", 0]
fidelity = { preset = "arcade", precision = "float64" }
[[emitter]]
name = "jet"
shot = "drop"
position = [0, "1 m", 0]
rotation = { pitch = "80 deg" }
per_second = 100
start = { speed = ["4 m/s", "6 m/s"] }
sub = [{ on = "landing", emitter = "splash", count = 2 }]
maximum = 50
[[emitter]]
name = "splash"
shot = "drop"
per_second = 0
from = "sphere"
start = { speed = 1, lifetime = "0.1 s" }
[world]
duration = "2.05 s"
[[expect]]
shot = "jet"
quantity = "born"
equals = 100
within = 60
[[expect]]
quantity = "aged"
equals = 100
within = 100
)";

TEST(CliEmitter, PrintsATable) {
  const Ran ran = physim({"run", Folder().write("e.toml", kEmitters)});
  EXPECT_EQ(ran.code, 0) << ran.out << ran.err;
  EXPECT_EQ(ran.err, "") << "a full emitter refuses, and its table says so";
  for (const char* part : {"\n  what   spawned  landed", "\n  stone        1       1", "\n  emitter  born  alive",
                           "refused", "aged", "\n  jet ", "\n  splash ", "impacts of", "3 of 3 met"})
    EXPECT_TRUE(has(ran.out, part)) << part << "\n" << ran.out;
  EXPECT_FALSE(has(ran.out, "replaced")) << "counts that are zero everywhere are left out\n" << ran.out;
}

TEST(CliEmitter, WritesCountsPathsAndAPicture) {
  const Folder folder;
  const Ran ran = physim({"run", folder.write("e.toml", kEmitters), "--json", folder / "e.json", "--csv",
                          folder / "e.csv", "--events", folder / "events.csv", "--plot", folder / "e.png"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto json = nlohmann::json::parse(read(folder / "e.json"));
  const auto& groups = json.at("world").at("groups");
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_FALSE(groups[0].contains("emitter"));
  const auto& jet = groups[1];
  EXPECT_EQ(jet.at("name"), "jet");
  EXPECT_EQ(jet.at("shot"), "drop");
  const auto& counts = jet.at("emitter");
  const int born = counts.at("born"), alive = counts.at("alive"), landed = counts.at("landed");
  EXPECT_EQ(born, alive + landed);
  EXPECT_LE(alive, 50);
  EXPECT_GT(counts.at("refused"), 0);
  EXPECT_EQ(born + counts.at("refused").get<int>(), 205);
  EXPECT_EQ(jet.at("spawned"), born);
  EXPECT_TRUE(has(json.at("settings").at("emitter"), "splash"));
  EXPECT_TRUE(has(read(folder / "e.csv"), "\njet,"));
  EXPECT_TRUE(has(read(folder / "events.csv"), ",spawned,none,jet,"));
  EXPECT_TRUE(has(read(folder / "events.csv"), ",expired,older,splash,"));
  EXPECT_GT(read(folder / "e.png").size(), 10'000u);
}

TEST(CliEmitter, HashesDoNotDependOnThreads) {
  const File file("e.toml", kEmitters);
  const std::string hash = hash_of(physim({"run", file, "--threads", "1"}));
  EXPECT_EQ(hash_of(physim({"run", file, "--threads", "5", "--set", "world.rows_per_thread=1"})), hash);
  EXPECT_NE(hash_of(physim({"run", file, "--set", "emitter.seed=3"})), hash);
}

TEST(CliEmitter, GoesOnFromASaveAndIsReplayed) {
  const Folder folder;
  const std::string file = folder.write("e.toml", kEmitters);
  const Ran whole = physim({"run", file, "--record", folder / "e.rec"});
  const Ran saving = physim({"run", file, "--save", folder / "e.save", "--save-at", "1 s"});
  EXPECT_EQ(saving.out, whole.out) << saving.err;
  const Ran loaded = physim({"run", file, "--load", folder / "e.save"});
  EXPECT_EQ(loaded.out, whole.out) << loaded.err;
  const Ran replayed = physim({"replay", folder / "e.rec", "--json", "-"});
  ASSERT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_EQ(nlohmann::json::parse(replayed.out).at("hash"), "0x" + hash_of(whole));
}

/// An emitter that fires itself at every birth would never end: it is cut, and that is told.
TEST(CliEmitter, WarnsOfWhatWasCut) {
  const Ran ran = physim({"run", Folder().write("e.toml", R"(physim = 1
[[shot]]
name = "dot"
fidelity = { preset = "arcade", precision = "float64" }
[[emitter]]
name = "mirror"
shot = "dot"
sub = [{ emitter = "mirror", on = "birth" }]
maximum = 100000
[world]
duration = "0.15 s"
)")});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.err,
                  "warning: 1 particle of \"mirror\" could not be emitted: more than a million in a step, or "
                  "sub-emitters without end"))
      << ran.err;
  EXPECT_TRUE(has(ran.out, "  cut\n")) << ran.out;
}

constexpr const char* kFiring = R"(physim = 1
[[shot]]
name = "round"
mass = "15 kg"
diameter = "105 mm"
fidelity = "arcade"
[world]
duration = "10 s"
[[emitter]]
name = "gun"
shot = "round"
)";

TEST(CliEmitter, TellsHowManyWereNotBorn) {
  const Ran ran =
      physim({"run",
              Folder().write("e.toml", std::string(kFiring) + "per_second = 0\nbursts = [{ time = 0, count = 5e6 }]\n"
                                                              "maximum = 10\n"),
              "--steps", "2"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(has(ran.err, "warning: 3951424 particles of \"gun\" could not be emitted")) << ran.err << "5e6 less 2^20";
  EXPECT_TRUE(has(ran.err, "emitter.bursts: a burst of 5000000")) << "told before: " << ran.err;
}

TEST(CliEmitter, AGunAloneFiresItsRoundsAlone) {
  const Folder folder;
  const std::string gun = std::string(kFiring) + "gun = { rounds_per_minute = 600 }\n";
  const auto born = [&](const std::string& text) {
    const Ran ran = physim({"run", folder.write("e.toml", text), "--json", "-"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    return nlohmann::json::parse(ran.out)["world"]["groups"][0]["spawned"].get<int>();
  };
  EXPECT_EQ(born(gun), 101);
  EXPECT_EQ(born(gun + "per_second = 10\n"), 201) << "who says so has it";
  EXPECT_EQ(physim({"run", folder.write("e.toml", gun), "--set", "emitter.per_second=10", "--steps", "60"}).code, 0);
}

TEST(CliEmitter, SaysThatRoundsLeftTheAirOfAge) {
  const Folder folder;
  const std::string gun =
      std::string(kFiring) +
      "rotation = { pitch = \"80 deg\" }\ngun = { rounds_per_minute = 60, magazine = 3, magazines = 1 }\n";
  const Ran aged = physim({"run", folder.write("e.toml", gun + "start = { speed = \"400 m/s\" }\n")});
  EXPECT_TRUE(has(aged.err, "3 rounds of \"gun\" left the air at an age of 5 s")) << aged.err;
  EXPECT_TRUE(has(aged.err, "emitter.start.lifetime")) << aged.err;
  const Ran landed = physim({"run", folder.write("e.toml", gun + "start = { speed = \"1 m/s\" }\n")});
  EXPECT_EQ(landed.err, "");
  const Ran asked =
      physim({"run", folder.write("e.toml", gun + "start = { speed = \"400 m/s\", lifetime = \"4 s\" }\n")});
  EXPECT_EQ(asked.err, "") << "who gives a lifetime knows it";
}

/// One particle every 0.1 s for 5 s each, whatever was before; the past costs nothing where it left nothing behind.
TEST(CliEmitter, APrewarmOfALongCycleIsThere) {
  const auto alive = [&](const std::string& duration) {
    const std::string text = std::string(kFiring) +
                             "position = [0, \"1000 m\", 0]\ncycle = { prewarm = true, duration = \"" + duration +
                             "\" }\n";
    const Ran ran = physim({"run", Folder().write("e.toml", text), "--steps", "30", "--json", "-"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    const auto group = nlohmann::json::parse(ran.out)["world"]["groups"][0];
    EXPECT_EQ(group["emitter"]["cut"], 0) << duration;
    return group["alive"].get<int>();
  };
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(alive("1e7 s"), 50);
  EXPECT_EQ(alive("1000 s"), 50);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(CliEmitter, SaysWhereAFileIsWrong) {
  const File file("e.toml", kEmitters);
  const Ran ran = physim({"run", file, "--set", "emitter.start.sped=1"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(has(ran.err, "unknown setting \"emitter.start.sped\"; did you mean \"emitter.start.speed\"?")) << ran.err;
  EXPECT_TRUE(has(physim({"list", "settings"}).out, "emitter.start.lifetime"));
}

}  // namespace physim::testing_cli::cli_emitter_cli_test
#endif
