// Walks of people who have read nothing, by real mouse and keyboard events, from the first start to what they came for.
#include <cmath>

#include "window/x_client.hpp"

namespace physim::testing_window::window_walk {
namespace {

bool have_landed(const Json& state, std::size_t count) {
  const Json& tracks = state["tracks"];
  return tracks.size() == count &&
         std::ranges::all_of(tracks, [](const Json& track) { return track["status"] == "landed"; });
}

/// Seven events. The session's own clock says how long it took: a busy machine makes it no longer.
TEST(Walk, FromTheFirstStartToAHitTargetAndASharedPicture) {
  const Screen screen;
  RunningClient client(screen, {RunningClient::kWithGallery, "--size", "1200x760"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  client.key("Escape");  // the gallery's button says: open range
  client.wait_for([](const Json& s) { return !s.contains("dialog"); });
  client.key("Return");  // "Click on the scene, or press Enter"
  const Json landed = client.wait_for([](const Json& s) { return have_landed(s, 1); });
  ASSERT_TRUE(have_landed(landed, 1));
  client.key("o");
  client.click(landed["tracks"][0]["pixel"][0], landed["tracks"][0]["pixel"][1]);
  ASSERT_EQ(client.wait_for([](const Json& s) { return !s["things"].empty(); })["things"].size(), 1U);
  client.key("Return");
  const Json hit = client.wait_for([](const Json& s) { return !s["hits"].empty(); });
  ASSERT_FALSE(hit["hits"].empty());
  EXPECT_EQ(hit["hits"][0]["thing"], "target-1");
  EXPECT_LT(hit["time"], 60);
  client.key("F12");
  const Json saved = client.wait_for([](const Json& s) { return s.value("message", "").starts_with("saved "); });
  const std::string picture = saved.value("message", "").substr(6, std::string("physim_picture_1.png").size());
  EXPECT_TRUE(testing_cli::read(picture).starts_with("\x89PNG")) << saved.value("message", "");
  EXPECT_LT(saved["time"], 120);
  std::filesystem::remove(picture);
}

/// On a projector, in the white theme: a golf ball with air and without.
TEST(Walk, ATeacherShowsDragAgainstNoDrag) {
  const Screen screen;
  RunningClient client(screen, {RunningClient::kWithGallery, "--size", "1000x640"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  client.keys_at_once({"g", "o", "l", "f", "space", "d", "r", "i", "v", "e"});
  client.key("Return");
  ASSERT_EQ(client.wait_for([](const Json& s) { return s["tracks"].size() == 1; })["shot"]["type"], "drive");
  for (int i = 0; i < 2; ++i) client.chord({"Control_L", "t"});
  const std::uint32_t bar = client.picture().at(620, 12);
  EXPECT_GT(bar & 0xFF, 200U) << "panels are white, too";
  EXPECT_NE(client.state()["shot"]["drag"], "off");
  client.click(144, 271);  // the tick beside "drag"
  EXPECT_EQ(client.next_frames()["shot"]["drag"], "off");
  for (int i = 0; i < 3; ++i) client.key("plus");
  client.move(600, 300);
  client.key("Return");
  const Json both = client.wait_for([](const Json& s) { return have_landed(s, 2); });
  ASSERT_TRUE(have_landed(both, 2));
  const double with_air = both["tracks"][0]["position"][0], without = both["tracks"][1]["position"][0];
  EXPECT_GT(std::abs(without - with_air), 10) << "on the ground one sees the difference";
  EXPECT_NE(both["tracks"][0]["colour"], both["tracks"][1]["colour"]);
}

}  // namespace
}  // namespace physim::testing_window::window_walk
