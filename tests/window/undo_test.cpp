// Undo and redo by keys, and keys that stay out of the panels.
#include <gtest/gtest.h>

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
