// The dialogue of files, and letters of three sizes, by real mouse and keyboard events.
#include "window/x_client.hpp"

namespace physim::testing_window::window_dialog_window {
namespace {

class Dialogs : public testing::Test {
 protected:
  Dialogs() : client(screen, {"--size", "1000x640"}) {}
  void SetUp() override { ASSERT_TRUE(client.has_window()) << client.errors(); }
  void type(const std::string& text) {
    std::vector<std::string> keys;
    for (const char letter : text) keys.emplace_back(letter == ' ' ? "space" : std::string(1, letter));
    client.keys_at_once(keys);
  }

  Screen screen;
  RunningClient client;
};

TEST_F(Dialogs, AFewLettersAndEnterOpenAScenario) {
  client.chord({"Control_L", "o"});
  client.next_frames();
  type("golf drive");
  client.key("Return");
  const Json state = client.wait_for([](const Json& s) { return s["shot"]["type"] == "drive"; });
  EXPECT_EQ(state["shot"]["type"], "drive") << state.value("message", "");
}

/// Behind a dialogue nothing fires, records or moves; one press of Esc closes it, and the client stays.
TEST_F(Dialogs, AreModal) {
  for (const char* key : {"o", "S"}) {
    const Json before = client.next_frames();
    if (std::string(key) == "S")
      client.chord({"Control_L", "Shift_L", "s"});
    else
      client.chord({"Control_L", "o"});
    client.next_frames();
    client.click(800, 560);  // on the scene, beside the dialogue
    client.key("F9");
    client.key("F4");
    client.drag(950, 500, 900, 450, 1);
    const Json during = client.next_frames();
    EXPECT_EQ(during["tracks"].size(), before["tracks"].size());
    EXPECT_EQ(during["shot"]["azimuth"], before["shot"]["azimuth"]);
    EXPECT_FALSE(during.contains("message")) << during["message"];
    client.key("Escape");
    client.next_frames();
    ASSERT_TRUE(client.is_running());
    EXPECT_FALSE(client.state().contains("question"));
  }
  client.key("Return");  // it is closed: the key fires again
  EXPECT_EQ(client.wait_for([](const Json& s) { return !s["tracks"].empty(); })["tracks"].size(), 1U);
}

TEST_F(Dialogs, LettersHaveThreeSizes) {
  const auto dark_rows = [&] {  // of the menu bar, at a place without letters
    const Shot shot = client.picture();
    int y = 0;
    while (y < 200 && shot.at(700, y) == shot.at(700, 0)) ++y;
    return y;
  };
  const int usual = dark_rows();
  client.chord({"Control_L", "equal"});
  const Json large = client.next_frames();
  EXPECT_GT(dark_rows(), 1.3 * usual);
  client.chord({"Control_L", "equal"});  // there is no larger one
  client.chord({"Control_L", "minus"});
  client.next_frames();
  EXPECT_EQ(dark_rows(), usual);
  client.chord({"Control_L", "minus"});
  client.next_frames();
  EXPECT_LT(dark_rows(), usual);
}

}  // namespace
}  // namespace physim::testing_window::window_dialog_window
