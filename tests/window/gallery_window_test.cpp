// The gallery and the sliders, by real mouse and keyboard events.
#include "window/x_client.hpp"

namespace physim::testing_window::window_gallery_window {
namespace {

/// As people start it: from the first start to something that flies, by one click.
TEST(GalleryAtStart, ACardThatIsClickedFlies) {
  const Screen screen;
  RunningClient client(screen, {RunningClient::kWithGallery, "--size", "1000x640"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  ASSERT_EQ(client.next_frames()["dialog"], "gallery");
  client.click(130, 180);  // the first card, a rifle
  const Json state = client.wait_for([](const Json& s) { return !s.contains("dialog") && !s["tracks"].empty(); });
  EXPECT_EQ(state["shot"]["type"], "308-168gr");
  EXPECT_EQ(state["tracks"].size(), 1U);
}

TEST(GalleryAtStart, EscLeavesItForTheOpenRange) {
  const Screen screen;
  RunningClient client(screen, {RunningClient::kWithGallery, "--size", "800x600"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  client.key("F9");  // nothing goes on behind it
  EXPECT_FALSE(client.next_frames().contains("message"));
  client.key("Escape");
  const Json state = client.wait_for([](const Json& s) { return !s.contains("dialog"); });
  EXPECT_FALSE(state.contains("dialog"));
  EXPECT_EQ(state["shot"]["type"], "artillery");
  ASSERT_TRUE(client.is_running());
  client.key("Return");
  EXPECT_EQ(client.wait_for([](const Json& s) { return !s["tracks"].empty(); })["tracks"].size(), 1U);
}

/// A few letters and Enter. When its pictures are there nothing more is drawn.
TEST(Gallery, IsSearchedAndComesToRest) {
  const Screen screen;
  RunningClient client(screen, {"--size", "1000x640"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  EXPECT_FALSE(client.next_frames().contains("dialog")) << "--range begins without it";
  client.key("p");  // the clock is drawn every other second
  client.chord({"Control_L", "g"});
  EXPECT_EQ(client.next_frames()["dialog"], "gallery");
  bool rests = false;
  for (int i = 0; i < 20 && !rests; ++i) rests = client.frame_at_rest(1500).has_value();
  EXPECT_TRUE(rests);
  client.keys_at_once({"f", "r", "e", "e", "space", "k", "i", "c", "k"});
  client.key("Return");
  const Json state = client.wait_for([](const Json& s) { return s["shot"]["type"] == "curled"; });
  EXPECT_EQ(state["shot"]["type"], "curled") << state.value("message", "");
}

/// A slider of the settings is dragged, and one Ctrl+Z brings the value back.
TEST(Sliders, AreDraggedAndTakenBack) {
  const Screen screen;
  RunningClient client(screen, {"--size", "1000x640", PHYSIM_SOURCE_DIR "/scenarios/golf_drive.toml"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  const double before = client.next_frames()["shot"]["speed"];
  client.drag(220, 172, 260, 172, 1);
  const double after = client.next_frames()["shot"]["speed"];
  EXPECT_GT(after, before + 5);
  client.move(600, 300);
  client.chord({"Control_L", "z"});
  EXPECT_EQ(client.next_frames()["shot"]["speed"], before);
}

}  // namespace
}  // namespace physim::testing_window::window_gallery_window
