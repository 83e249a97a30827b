// Undo and redo by keys, and keys that stay out of the panels.
#include "window/x_client.hpp"

namespace physim::testing_window {
namespace {

class Undo : public testing::Test {
 protected:
  Undo() : client(screen, {"--size", "1000x640"}) {}
  void SetUp() override { ASSERT_TRUE(client.has_window()) << client.errors(); }

  Screen screen;
  RunningClient client;
};

TEST_F(Undo, TheAimComesBackAndGoesAgain) {
  const Json before = client.next_frames()["shot"];
  client.key("Up");
  const Json raised = client.next_frames()["shot"];
  EXPECT_GT(raised["elevation"], before["elevation"]);
  client.chord({"Control_L", "z"});
  EXPECT_EQ(client.next_frames()["shot"], before);
  client.chord({"Control_L", "y"});
  EXPECT_EQ(client.next_frames()["shot"], raised);
  client.chord({"Control_L", "z"});
  client.chord({"Control_L", "z"});
  EXPECT_NE(client.next_frames().value("message", "").find("nothing was changed"), std::string::npos);
}

/// A change of each kind, by real events, in a copy of a scenario: its file tells what is set.
struct Change {
  const char *what, *scenario;
  std::function<void(RunningClient&)> make;
};

class UndoOf : public testing::TestWithParam<Change> {};

TEST_P(UndoOf, IsUndoneAndDoneAgain) {
  const Screen screen;
  const Folder folder;
  const std::string shipped = PHYSIM_SOURCE_DIR "/scenarios/" + std::string(GetParam().scenario) + ".toml";
  const std::string before = testing_cli::read(shipped), file = folder.write("mine.toml", before);
  RunningClient client(screen, {"--size", "1200x760", file});
  ASSERT_TRUE(client.has_window()) << client.errors();
  const auto saved = [&] {
    client.chord({"Control_L", "s"});
    client.next_frames();
    return testing_cli::read(file);
  };
  EXPECT_EQ(saved(), before);
  GetParam().make(client);
  client.next_frames();
  const std::string changed = saved();
  EXPECT_NE(changed, before);
  client.chord({"Control_L", "z"});
  EXPECT_TRUE(client.next_frames().value("message", "").starts_with("taken back: ")) << client.state()["message"];
  EXPECT_EQ(saved(), before) << "undone";
  client.chord({"Control_L", "y"});
  client.next_frames();
  EXPECT_EQ(saved(), changed) << "done again";
  client.chord({"Control_L", "z"});
  client.next_frames();
  EXPECT_EQ(saved(), before) << "and undone once more";
}

// The sliders of a window of 1200 by 760 stand in rows below the title of the settings.
const Change kChanges[] = {
    {"Aim", "golf_drive", [](RunningClient& c) { c.key("Up"); }},
    {"Rung", "golf_drive", [](RunningClient& c) { c.key("g"); }},
    {"Accuracy", "golf_drive", [](RunningClient& c) { c.click(160, 144); }},
    {"Setting", "golf_drive", [](RunningClient& c) { c.click(250, 169); }},
    {"Environment", "golf_drive", [](RunningClient& c) { c.click(250, 296); }},
    {"Curve", "emit_fountain",
     [](RunningClient& c) {
       c.key("j");
       c.click(924, 105);  // a key of the gradient
     }},
    {"Thing", "billiards",
     [](RunningClient& c) {
       c.key("space");
       c.key("o");
       c.click(760, 520);
     }},
};

INSTANTIATE_TEST_SUITE_P(EachKind, UndoOf, testing::ValuesIn(kChanges),
                         [](const auto& change) { return change.param.what; });

/// A click on the title of a panel gives it the focus; Tab selects a projectile all the same, and the next key is seen.
TEST_F(Undo, TabTypesIntoNoField) {
  client.click(150, 37);
  client.move(500, 300);
  client.key("Tab");
  client.key("p");
  EXPECT_TRUE(client.next_frames()["paused"]);
}

}  // namespace
}  // namespace physim::testing_window
