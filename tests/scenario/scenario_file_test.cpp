// ScenarioFile: the door of scenarios without their parsed tables. It flies what the tables fly, to the bit.
#include "cli/program.hpp"
#include "scenario/scenario.hpp"
#include "scenario/world_run.hpp"
#include "shipped.hpp"

namespace physim::scenario_scenario_file_test {

constexpr const char* kTwo = R"(physim = 1
[[shot]]
name = "one"
mass = "168 gr"
diameter = "0.308 in"
speed = "800 m/s"
drag = { table = "g7", ballistic_coefficient = "0.218 lb/in^2" }
[[shot]]
name = "other"
mass = "1 kg"
speed = "50 m/s"
elevation = "45 deg"
)";
constexpr const char* kWorld = R"(physim = 1
[[shot]]
mass = "1 kg"
speed = "50 m/s"
elevation = "45 deg"
[world]
duration = "1 s"
[[volley]]
shot = "shot-1"
count = 20
interval = "50 ms"
spread = { horizontal = "1 deg" }
)";

ScenarioFile read(const std::string& text) {
  ScenarioFile file = must(ScenarioFile::parse(text, "test.toml"));
  return file;
}

void expect_same(const Flight& a, const Flight& b) {
  ASSERT_FALSE(a.error());
  EXPECT_EQ(a.end().position, b.end().position);
  EXPECT_EQ(a.end().velocity, b.end().velocity);
  EXPECT_EQ(a.duration(), b.duration());
}

TEST(ScenarioDoor, shots_fly_as_their_tables_do) {
  const ScenarioFile file = read(kTwo);
  const Scenario tables = *parse_scenario(kTwo, "test.toml");
  EXPECT_EQ(file.shots(), (std::vector<std::string>{"one", "other"}));
  expect_same(*file.fly(), fly_shot(tables, tables.shots[0]));
  expect_same(*file.fly("other"), fly_shot(tables, tables.shots[1]));
  const auto stranger = file.fly("third");
  ASSERT_FALSE(stranger.ok());
  EXPECT_EQ(stranger.error().place, "third");
}

TEST(ScenarioDoor, settings_are_read_and_changed_by_path) {
  ScenarioFile file = read(kTwo);
  const ScenarioFile copy = file;
  EXPECT_EQ(*file.get("shot.other.mass"), "1 kg");
  EXPECT_FALSE(file.get("shot.mass").ok()) << "of which shot?";
  ASSERT_TRUE(file.set("shot.other.mass", "2 lb"));
  ASSERT_TRUE(file.set("shot.speed", "60 m/s"));
  EXPECT_EQ(*file.get("shot.other.mass"), "0.90718474 kg");
  EXPECT_EQ(*file.get("shot.one.speed"), "60 m/s");
  EXPECT_EQ(*copy.get("shot.other.mass"), "1 kg");
  const std::string before = file.text();
  for (const auto& [path, value] : {std::pair{"shot.other.mass", "-1"},
                                    {"shot.other.mas", "1"},
                                    {"shot.none.mass", "1"},
                                    {"shot.other.mass", "1 ft"},
                                    {"", ""}}) {
    const Status status = file.set(path, value);
    EXPECT_FALSE(status) << path;
    EXPECT_FALSE(status.error().message.empty());
    EXPECT_EQ(file.text(), before);
  }
  const ScenarioFile again = read(file.text());
  EXPECT_EQ(again.text(), before);
  expect_same(*again.fly("other"), *file.fly("other"));
  EXPECT_EQ(*read("physim = 1\n[[shot]]\nmass = 3\nspeed = 1\n").get("shot.mass"), "3 kg") << "the only shot";
}

TEST(ScenarioDoor, every_setting_of_every_shipped_scenario_can_be_read) {
  for (const std::string& name : test::shipped_scenarios()) {
    const std::string path = PHYSIM_SOURCE_DIR "/scenarios/" + name + ".toml";
    const ScenarioFile file = must(ScenarioFile::load(path));
    const auto settings = effective_settings(*load_scenario(path));
    for (std::size_t i = 0; i < settings.size(); i += 17)
      EXPECT_EQ(*file.get(settings[i].first), settings[i].second) << name << ": " << settings[i].first;
  }
}

TEST(ScenarioDoor, worlds_run_as_their_tables_do) {
  ScenarioRun run = *read(kWorld).run();
  WorldRun tables = *WorldRun::create(*parse_scenario(kWorld, "test.toml"));
  ASSERT_EQ(run.steps(), tables.steps());
  for (std::uint64_t i = 0; i < run.steps(); ++i) run.step(), tables.step();
  EXPECT_EQ(run.world().size(), 20U);
  EXPECT_EQ(run.world().hash(), tables.world().hash());
  EXPECT_FALSE(read(kTwo).run().ok()) << "no [world]";
}

TEST(ScenarioDoor, a_recording_never_replaces_the_file_itself) {
  const testing_cli::File path("itself.toml", kWorld);
  ScenarioFile file = *ScenarioFile::load(path);
  EXPECT_FALSE(file.run(path).ok());
  ASSERT_TRUE(file.set("world.duration", "2 s"));
  EXPECT_FALSE(file.run(path).ok());
  EXPECT_TRUE(ScenarioFile::load(path).ok());
}

TEST(ScenarioDoor, errors_name_their_place) {
  EXPECT_FALSE(ScenarioFile::load("no such file").ok());
  const auto bad = ScenarioFile::parse("physim = 1\n[[shot]]\nmass = -1\n", "bad.toml");
  ASSERT_FALSE(bad.ok());
  EXPECT_TRUE(bad.error().place.starts_with("bad.toml:3")) << bad.error().place;
}

}  // namespace physim::scenario_scenario_file_test
