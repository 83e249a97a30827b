// Walls and targets put up by the mouse, by real events in a window.
#include <cmath>

#include "window/x_client.hpp"

namespace physim::testing_window {
namespace {

int yellow_pixels(const Shot& seen) {
  int count = 0;
  for (int y = 60; y < seen.height - 60; ++y)
    for (int x = 330; x < seen.width; ++x) {
      const std::uint32_t p = seen.at(x, y);
      count += (p >> 16) > 200 && ((p >> 8) & 255) > 190 && (p & 255) < 110;
    }
  return count;
}

/// A wall across the line of fire, where the last shot came down.
TEST(Placing, AWallByTwoClicksStopsTheNextShot) {
  const Screen screen;
  RunningClient client(screen, {"--size", "1200x760"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  client.key("Return");
  const Json landed =
      client.wait_for([](const Json& s) { return !s["tracks"].empty() && s["tracks"][0]["status"] == "landed"; });
  ASSERT_FALSE(landed["tracks"].empty());
  const double far = landed["tracks"][0]["position"][0];
  const int x = landed["tracks"][0]["pixel"][0].get<int>(), y = landed["tracks"][0]["pixel"][1].get<int>() + 12;
  client.key("i");
  client.click(x - 90, y);
  EXPECT_TRUE(client.next_frames()["things"].empty()) << "one end is no wall";
  client.move(x + 60, y);
  EXPECT_GT(yellow_pixels(client.picture()), 60) << "what is about to stand there is shown";
  client.click(x + 90, y);
  const Json placed = client.wait_for([](const Json& s) { return !s["things"].empty(); });
  ASSERT_EQ(placed["things"].size(), 1U);
  EXPECT_EQ(placed["things"][0]["name"], "wall-1");
  client.key("Return");
  const Json hit = client.wait_for([](const Json& s) { return !s["hits"].empty(); });
  ASSERT_EQ(hit["hits"].size(), 1U);
  EXPECT_EQ(hit["hits"][0]["thing"], "wall-1");
  EXPECT_EQ(hit["hits"][0]["what"], "stopped");
  EXPECT_LT(hit["hits"][0]["position"][0], far);
  client.chord({"Control_L", "z"});
  EXPECT_TRUE(client.wait_for([](const Json& s) { return s["things"].empty(); })["things"].empty());
}

TEST(Placing, ATargetByOneClickIsSavedWithItsFile) {
  const Screen screen;
  const Folder folder;
  const std::string file = folder / "mine.toml";
  std::filesystem::copy_file(PHYSIM_SOURCE_DIR "/scenarios/billiards.toml", file);
  const std::string before = testing_cli::read(file);
  RunningClient client(screen, {"--size", "1200x760", file});
  ASSERT_TRUE(client.has_window()) << client.errors();
  const std::size_t known = client.state()["things"].size();
  client.key("space");
  client.key("o");
  client.key("Escape");
  client.click(600, 420);  // fires: the tool was put away
  EXPECT_EQ(client.next_frames()["things"].size(), known);
  client.key("O");
  client.click(760, 520);
  const Json placed = client.wait_for([&](const Json& s) { return s["things"].size() > known; });
  ASSERT_EQ(placed["things"].size(), known + 1);
  EXPECT_EQ(placed["things"].back()["name"], "target-1");
  EXPECT_LT(std::abs(placed["things"].back()["pixel"][0].get<double>() - 760), 40);
  client.chord({"Control_L", "s"});
  client.next_frames();
  const std::string after = testing_cli::read(file);
  EXPECT_TRUE(after.starts_with(before));
  EXPECT_NE(after.find("name = \"target-1\"\nshape = \"target-1\"\nmaterial = \"concrete\""), std::string::npos)
      << after;
}

}  // namespace
}  // namespace physim::testing_window
