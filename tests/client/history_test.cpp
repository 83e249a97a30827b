// Undo and redo, over every kind of change.
#include "simclient/core/history.hpp"

#include "cli/program.hpp"
#include "client/support.hpp"
#include "scenario/scenario.hpp"
#include "simclient/core/actions.hpp"

namespace physim::client::client_history {
namespace {

/// What a hand can change, as text that can be compared.
std::string all_of(const Client& client) {
  Scenario scenario = client.session.scenario();
  scenario.shots = {client.launcher.shot()};
  return scenario_text(scenario) + client.launcher.elevation_text();
}

struct Change {
  const char *scenario, *script, *what;
};
std::ostream& operator<<(std::ostream& out, const Change& change) { return out << change.script; }

class EachKind : public testing::TestWithParam<Change> {};

TEST_P(EachKind, IsTakenBackAndChangedAgain) {
  const auto& [scenario, script, what] = GetParam();
  Client client = client_of(scenario);
  const std::string before = all_of(client);
  EXPECT_FALSE(run(client, "undo")) << "nothing was changed";
  ASSERT_TRUE(run(client, script));
  const std::string after = all_of(client);
  ASSERT_NE(before, after);
  client.note_changes();
  EXPECT_EQ(client.history().undo_text(), what);
  ASSERT_TRUE(run(client, "undo"));
  EXPECT_EQ(all_of(client), before);
  EXPECT_EQ(client.history().redo_text(), what);
  EXPECT_FALSE(run(client, "undo"));
  ASSERT_TRUE(run(client, "redo"));
  EXPECT_EQ(all_of(client), after);
  EXPECT_FALSE(run(client, "redo"));
  ASSERT_TRUE(run(client, "undo"));
  EXPECT_EQ(all_of(client), before);
}

INSTANTIATE_TEST_SUITE_P(
    Changes, EachKind,
    testing::Values(Change{"golf_drive", "set shot.mass=50 g", "mass"},
                    Change{"golf_drive", "turn-up; turn-left", "aim"}, Change{"22lr", "turn-up", "aim"},
                    Change{"22lr", "elevation", "aim"}, Change{"golf_drive", "set shot.fidelity.drag=off", "drag"},
                    Change{"golf_drive", "shot baseball", "shot baseball"},
                    Change{"golf_drive", "set environment.wind.velocity=0, 0, 5 m/s", "environment"},
                    Change{"", "wall 10 -3 10 3", "wall-1"},
                    Change{"billiards", "material oak; target 1 0 0", "target-1"}));

TEST(History, CurvesOfEmittersAreTakenBack) {
  Client client = client_of("emit_fountain");
  std::vector<ScenarioEmitter> changed = client.session.scenario().emitters;
  const DrawnNumber before = changed[0].def.per_second;
  changed[0].def.per_second = DrawnNumber{50};
  ASSERT_TRUE(client.set_emitters(changed));
  EXPECT_EQ(client.history().undo_text(), "curves of emitters");
  ASSERT_TRUE(client.undo());
  EXPECT_EQ(client.session.scenario().emitters[0].def.per_second, before);
  ASSERT_TRUE(client.redo());
  EXPECT_EQ(client.session.scenario().emitters[0].def.per_second, DrawnNumber{50});
}

TEST(History, StepsComeInOrderAndADragIsOne) {
  Client client = client_of("golf_drive");
  ASSERT_TRUE(run(client, "set shot.mass=50 g; wait 1"));
  for (int i = 0; i < 10; ++i) {
    client.launcher.turn(0.01, 0);
    client.advance(1.0 / 60);
  }
  ASSERT_TRUE(run(client, "wall 10 -3 10 3"));
  const double azimuth = client.launcher.azimuth();
  ASSERT_TRUE(run(client, "undo"));
  EXPECT_TRUE(client.session.scenario().things.empty());
  ASSERT_TRUE(run(client, "undo"));
  EXPECT_NEAR(client.launcher.azimuth(), azimuth - 0.1, 1e-12) << "all of the drag";
  EXPECT_NEAR(client.launcher.shot().projectile.mass, 0.05, 1e-12);
  ASSERT_TRUE(run(client, "undo"));
  EXPECT_NEAR(client.launcher.shot().projectile.mass, 0.04593, 1e-12);
  ASSERT_TRUE(run(client, "redo; redo"));
  EXPECT_NEAR(client.launcher.azimuth(), azimuth, 1e-12);
  ASSERT_TRUE(run(client, "set shot.mass=60 g"));
  EXPECT_FALSE(run(client, "redo")) << "another change was made";
}

TEST(History, WhatIsTakenBackIsSaved) {
  const std::string text = testing_cli::read(PHYSIM_SOURCE_DIR "/scenarios/22lr.toml");
  const testing_cli::File file("mine.toml", text);
  Client client = std::move(open_client(file, {}).value());
  ASSERT_TRUE(run(client, "turn-up; elevation; save"));
  const std::string aimed = testing_cli::read(file);
  EXPECT_NE(aimed.find("zero_range = \"100 yd\", dial = \"5 deg\""), aimed.npos) << aimed;
  ASSERT_TRUE(run(client, "set shot.mass=3 g; undo; save"));
  EXPECT_EQ(testing_cli::read(file), aimed);
}

/// 997 words of an author, which a world with a wall cannot keep.
TEST(Saving, AsksBeforeExpectationsAreLost) {
  const std::string text = testing_cli::read(PHYSIM_SOURCE_DIR "/scenarios/308_168gr_g7.toml");
  const testing_cli::File file("mine.toml", text);
  Client client = std::move(open_client(file, {}).value());
  run_action(client, *find_action("save"));
  EXPECT_FALSE(client.question) << "nothing would be lost";
  ASSERT_TRUE(run(client, "wall 50 -2 50 2"));
  run_action(client, *find_action("save"));
  ASSERT_TRUE(client.question);
  EXPECT_NE(client.question->text.find("expectations"), std::string::npos) << client.question->text;
  answer(client, Answer::no);
  EXPECT_EQ(testing_cli::read(file), text);
  run_action(client, *find_action("save"));
  answer(client, Answer::yes);
  EXPECT_NE(testing_cli::read(file), text);
}

}  // namespace
}  // namespace physim::client::client_history
