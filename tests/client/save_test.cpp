// What the client saves: a scenario stays what its file was, nothing that could not be read is written, and nobody
// loses work without being asked.
#include <cmath>

#include "cli/program.hpp"
#include "scenario/revise.hpp"
#include "scenario/world_run.hpp"
#include "shipped.hpp"
#include "simclient/core/actions.hpp"
#include "simclient/core/script.hpp"

namespace physim::client {
namespace {

using testing_cli::Folder;

Client open(const std::string& file) { return std::move(open_client(file, {}).value()); }
std::string shipped(const std::string& name) { return PHYSIM_SOURCE_DIR "/scenarios/" + name + ".toml"; }

Status run(Client& client, const std::string& text) {
  Script script = Script::parse(text).value();
  return script.run(client);
}

std::string bits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%a ", x);
  return text;
}

/// What a scenario comes to, to the last bit: how its flights end, or its world, and what its expectations find.
std::string outcome(const Scenario& scenario) {
  std::string out;
  const auto judge = [&](const Expectation& expect, const Result<double>& found) {
    EXPECT_TRUE(found) << found.error().text();
    if (!found) return;
    out += bits(*found) + (std::abs(*found - expect.equals) <= expect.within ? "met\n" : "not met\n");
  };
  if (scenario.world.given) {
    WorldRun world = std::move(WorldRun::create(scenario).value());
    for (std::uint64_t i = 0; i < world.steps(); ++i) world.step();
    out = std::to_string(world.world().hash()) + "\n";
    for (const Expectation& expect : scenario.expect)
      for (const WorldGroup& group : world.groups())
        if (expect.shot.empty() || expect.shot == group.name) judge(expect, measure(group, expect));
    return out;
  }
  const SceneParts parts = scene_parts(scenario).value();
  for (const ScenarioShot& shot : scenario.shots) {
    const Flight flight = fly_shot(scenario, shot);
    const FlightHits hits = flight_hits(scenario, shot, flight, parts);
    const Sample end = flight.end();
    for (const double x : {end.time, end.position.x, end.position.y, end.position.z, end.speed, flight.elevation()})
      out += bits(x);
    for (const Expectation& expect : scenario.expect)
      if (expect.shot.empty() || expect.shot == shot.projectile.name) judge(expect, measure(flight, hits, expect));
  }
  return out;
}

class ShippedScenario : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScenario, SurvivesOpenSaveOpen) {
  const Folder folder;
  const std::string file = shipped(GetParam()), saved = folder / "saved.toml";
  const Scenario before = load_scenario(file).value();
  Client client = open(file);
  ASSERT_TRUE(run(client, "save " + saved));
  const Scenario after = must(load_scenario(saved));
  EXPECT_TRUE(say_the_same(after, before));
  EXPECT_EQ(after.world.given, before.world.given);
  EXPECT_EQ(after.expect.size(), before.expect.size());
  const Scenario anew = must(parse_scenario(scenario_text(before), "anew.toml"));
  const std::string wanted = outcome(before);
  EXPECT_EQ(outcome(after), wanted);
  EXPECT_EQ(outcome(anew), wanted) << scenario_text(before);
  Client again = open(saved);
  EXPECT_EQ(again.launcher.shot().projectile, client.launcher.shot().projectile);
  EXPECT_EQ(again.launcher.shot().body, client.launcher.shot().body);
}

TEST_P(ShippedScenario, KeepsItsCommentsWhenASettingIsChanged) {
  const Folder folder;
  std::filesystem::copy(PHYSIM_SOURCE_DIR "/scenarios/motors", folder / "motors");
  const std::string file = folder / "mine.toml", before = testing_cli::read(shipped(GetParam()));
  std::filesystem::copy_file(shipped(GetParam()), file);
  Client client = open(file);
  ASSERT_TRUE(run(client, "set environment.wind.velocity=1, 2, 3; save"));
  const std::string text = testing_cli::read(file);
  std::istringstream lines(before);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.find("wind") != line.npos || text.find(line) != text.npos) << line;
  EXPECT_LT(text.size(), before.size() + 120);
  const Vec3d wind{1, 2, 3};
  EXPECT_EQ(load_scenario(file).value().environment.wind.velocity, wind);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScenario, testing::ValuesIn(test::shipped_scenarios()),
                         [](const auto& test) { return test.param; });

// -------------------------------------------------------------------------------------------------------- what is kept
TEST(Save, WritesWhatIsChangedIntoTheFileThatWasOpened) {
  const Folder folder;
  const std::string file = folder / "mine.toml";
  std::filesystem::copy_file(shipped("308_168gr_g7"), file);
  Client client = open(file);
  ASSERT_TRUE(run(client, "set shot.mass=170 gr; set shot.twist=10 in; save; set shot.speed=800 m/s; save"));
  EXPECT_EQ(folder.names().size(), 1U);
  const Scenario saved = load_scenario(file).value();
  EXPECT_EQ(saved.shots[0].projectile.mass, client.launcher.shot().projectile.mass);
  EXPECT_EQ(saved.shots[0].launch.speed, 800);
  EXPECT_EQ(saved.shots[0].launch.sight.zero_range, 100);
  EXPECT_NE(testing_cli::read(file).find("[[expect]]"), std::string::npos);
}

/// An aim is dialled on top of a zero, and both are in the file.
TEST(Save, KeepsAZeroAndTheAimOffIt) {
  const testing_cli::File file("rifle.toml", testing_cli::read(shipped("22lr")));
  Client client = open(file);
  client.launcher.turn(0.01, 0.002);
  const double elevation = fly_shot(client.session.scenario(), client.launcher.shot()).elevation();
  ASSERT_TRUE(client.save(file));
  const std::string text = testing_cli::read(file);
  EXPECT_NE(text.find("zero_range"), std::string::npos);
  EXPECT_NE(text.find("dial = "), std::string::npos) << text;
  const Client again = open(file);
  EXPECT_TRUE(again.launcher.is_zeroed());
  EXPECT_EQ(again.launcher.raised(), 0.002);
  EXPECT_EQ(fly_shot(again.session.scenario(), again.launcher.shot()).elevation(), elevation);
}

TEST(Save, WritesNothingThatCouldNotBeRead) {
  const Folder folder;
  const std::string file = folder / "mine.toml";
  std::filesystem::copy_file(shipped("308_168gr_g7"), file);
  Client client = open(file);
  ASSERT_TRUE(run(client, "set shot.elevation=3 deg"));  // beside its zero range
  const Status status = run(client, "save");
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().text().find("zero_range"), std::string::npos) << status.error().text();
  EXPECT_EQ(testing_cli::read(file), testing_cli::read(shipped("308_168gr_g7")));
  EXPECT_TRUE(client.has_unsaved_settings());
}

TEST(Save, OfTheOpenRangeWithABodyIsAWorld) {
  const Folder folder;
  Client client = open("");
  ASSERT_TRUE(run(client, "bullet; set shot.body.restitution=0.25; save " + (folder / "a.toml")));
  for (const char* more : {"set shot.mass=3 kg", "save"}) ASSERT_TRUE(run(client, more));
  const Scenario saved = load_scenario(folder / "a.toml").value();
  EXPECT_TRUE(saved.world.given);
  EXPECT_EQ(saved.shots[0].body.restitution, 0.25);
  EXPECT_EQ(saved.shots[0].projectile.mass, 3);
}

TEST(Save, TellsWhatAFlightCannotKeep) {
  const Folder folder;
  Client client = open(shipped("golf_ball_no_spin"));
  ASSERT_TRUE(run(client, "set shot.body.restitution=0.25; save " + (folder / "a.toml")));
  EXPECT_FALSE(load_scenario(folder / "a.toml").value().world.given);
  EXPECT_NE(client.messages().back().text.find("shot.body"), std::string::npos) << client.messages().back().text;
}

TEST(Save, TellsThatAWorldIsGivenNoMoreToFire) {
  const Folder folder;
  Client client = open(shipped("world_sparks"));
  ASSERT_TRUE(run(client, "bullet; save " + (folder / "a.toml")));
  EXPECT_TRUE(say_the_same(load_scenario(folder / "a.toml").value(), client.session.scenario()));
  EXPECT_NE(client.messages().back().text.find("next shot"), std::string::npos) << client.messages().back().text;
}

TEST(Save, OfAReplayIsRefused) {
  const Folder folder;
  Client client = open("");
  ASSERT_TRUE(run(client, "record " + (folder / "a.rec") + "; fire; step; record; replay"));
  EXPECT_FALSE(run(client, "save " + (folder / "a.toml")));
}

// --------------------------------------------------------------------------------------------------------- what is
// asked
const Action& action(const char* name) { return *find_action(name); }

TEST(Ask, LeavesAtOnceWhereNothingIsLost) {
  Client client = open("");
  run_action(client, action("quit"));
  EXPECT_FALSE(client.question);
  EXPECT_TRUE(client.leaves);
}

TEST(Ask, BeforeWhatWasFiredIsForgotten) {
  for (const char* name : {"restart", "quit", "record", "test"}) {
    Client client = open("");
    ASSERT_TRUE(run(client, "fire; step; step"));
    run_action(client, action(name), *name == 't' ? "1" : "");
    ASSERT_TRUE(client.question) << name;
    EXPECT_EQ(client.session.step(), 2U) << name;
    answer(client, Answer::no);
    EXPECT_FALSE(client.question || client.leaves);
    EXPECT_EQ(client.session.tracks().size(), 1U);
  }
  Client client = open("");
  ASSERT_TRUE(run(client, "fire; step"));
  run_action(client, action("restart"));
  answer(client, Answer::yes);
  EXPECT_TRUE(client.session.tracks().empty());
  run_action(client, action("restart"));
  EXPECT_FALSE(client.question) << "nothing was fired since";
}

TEST(Ask, BeforeSettingsAreLost) {
  const Folder folder;
  Client client = open("");
  ASSERT_TRUE(run(client, "set shot.mass=3 kg"));
  run_action(client, action("open"), shipped("arrow"));
  ASSERT_TRUE(client.question);
  answer(client, Answer::no);
  run_action(client, action("restart"));
  EXPECT_FALSE(client.question) << "settings of the next shot stay";
  ASSERT_TRUE(run(client, "save " + (folder / "a.toml")));
  run_action(client, action("open"), shipped("arrow"));
  EXPECT_FALSE(client.question) << "they were saved";
  EXPECT_EQ(client.file(), shipped("arrow"));
}

TEST(Ask, BeforeAnotherFileIsReplaced) {
  const Folder folder;
  const std::string other = folder.write("other.toml", "mine");
  Client client = open("");
  run_action(client, action("save-as"), other);
  ASSERT_TRUE(client.question);
  answer(client, Answer::no);
  EXPECT_EQ(testing_cli::read(other), "mine");
  run_action(client, action("save-as"), folder / "new.toml");
  EXPECT_FALSE(client.question);
  run_action(client, action("save"));
  EXPECT_FALSE(client.question) << "its own file";
  run_action(client, action("save-as"), other);
  answer(client, Answer::yes);
  EXPECT_TRUE(load_scenario(other));
}

/// A new scenario has no file: the client asks where, and writes nothing by itself.
TEST(Ask, WhereANewScenarioIsSaved) {
  const Folder folder;
  Client client = open("");
  ASSERT_TRUE(run(client, "set shot.mass=3 kg"));
  run_action(client, action("save"));
  EXPECT_EQ(client.dialog, Dialog::save);
  EXPECT_EQ(client.file(), "");
  client.dialog = Dialog::none;
  // Before unsaved changes are left, too; then it goes on with what was asked for.
  run_action(client, action("quit"));
  ASSERT_TRUE(client.question && client.question->can_save);
  answer(client, Answer::save);
  EXPECT_EQ(client.dialog, Dialog::save);
  EXPECT_FALSE(client.leaves);
  client.dialog = Dialog::none;  // given up
  client.advance(1.0 / 60);
  run_action(client, action("save-as"), folder / "one.toml");
  EXPECT_FALSE(client.leaves) << "nobody waits any more";
  ASSERT_TRUE(run(client, "set shot.mass=4 kg"));
  run_action(client, action("open"), shipped("arrow"));
  ASSERT_TRUE(client.question);
  answer(client, Answer::save);  // in its own file
  EXPECT_EQ(client.file(), shipped("arrow"));
  EXPECT_EQ(load_scenario(folder / "one.toml").value().shots.at(0).projectile.mass, 4);
  ASSERT_TRUE(run(client, "fire-whole; step"));
  run_action(client, action("restart"));
  ASSERT_TRUE(client.question);
  EXPECT_FALSE(client.question->can_save) << "settings stay";
}

TEST(Ask, BeforeARecordingIsCutOff) {
  const Folder folder;
  Client client = open("");
  ASSERT_TRUE(run(client, "record " + (folder / "a.rec") + "; step"));
  run_action(client, action("quit"));
  EXPECT_TRUE(client.question);
  answer(client, Answer::no);
  run_action(client, action("record"));
  EXPECT_FALSE(client.question) << "that completes it";
  EXPECT_FALSE(client.session.is_recording());
}

// --------------------------------------------------------------------------------------------------------- recent
// files
TEST(RecentFiles, AreRememberedWithTheLastInFront) {
  const Folder folder;
  const std::string list = folder / "state/physim/recent_files";
  RecentFiles recent(list);
  for (int i = 0; i < 12; ++i) recent.add(folder / (std::to_string(i) + ".toml"));
  recent.add(folder / "5.toml");
  const RecentFiles again(list);
  ASSERT_EQ(again.files().size(), 10U);
  EXPECT_EQ(again.files()[0], folder / "5.toml");
  EXPECT_EQ(again.files()[1], folder / "11.toml");
  EXPECT_EQ(std::ranges::count(again.files(), folder / "5.toml"), 1);
  EXPECT_TRUE(RecentFiles(folder / "nowhere").files().empty());
}

TEST(RecentFiles, OfTwoWindowsAreAllKept) {
  const Folder folder;
  const std::string list = folder / "state/recent";
  RecentFiles one(list), two(list);
  one.add("/a.toml");
  two.add("/b.toml");
  const RecentFiles later(list);
  ASSERT_EQ(later.files().size(), 2u);
  EXPECT_EQ(later.files()[0], "/b.toml");
  EXPECT_EQ(later.files()[1], "/a.toml");
}

TEST(RecentFiles, AreThoseThatWereOpenedAndSaved) {
  const Folder folder;
  Client client = open("");
  ASSERT_TRUE(run(client, "open " + shipped("arrow") + "; save " + (folder / "a.toml")));
  ASSERT_EQ(client.recent.files().size(), 2U);
  EXPECT_EQ(client.recent.files()[0], folder / "a.toml");
  EXPECT_EQ(client.recent.files()[1], shipped("arrow"));
}

}  // namespace
}  // namespace physim::client
