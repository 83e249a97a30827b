// Curves and gradients of emitters, drawn by the mouse, by real events in a window.
#include "window/x_client.hpp"

namespace physim::testing_window {
namespace {

/// Where the panel of emitters has its bar, in a window of 1200 by 760 without the panels at its sides.
constexpr int kBarLeft = 838, kBarWidth = 344, kBarHeight = 105;
int on_bar(double part) { return kBarLeft + static_cast<int>(part * kBarWidth); }

TEST(Emitters, AGradientDrawnByTheMouseIsSavedWithItsFile) {
  const Screen screen;
  const Folder folder;
  const std::string file = folder / "mine.toml";
  std::filesystem::copy_file(PHYSIM_SOURCE_DIR "/scenarios/emit_fountain.toml", file);
  RunningClient client(screen, {"--size", "1200x760", file});
  ASSERT_TRUE(client.has_window()) << client.errors();
  for (const char* key : {"F2", "F3", "j"}) client.key(key);
  client.click(on_bar(0.25), kBarHeight);                                   // puts a key in
  client.drag(on_bar(0.25), kBarHeight, on_bar(0.25) + 32, kBarHeight, 1);  // and takes it along
  client.click(on_bar(0.9), kBarHeight);                                    // another one
  client.click(on_bar(0.9), kBarHeight, 3);                                 // which goes again
  client.chord({"Control_L", "s"});
  client.next_frames();
  const std::string after = testing_cli::read(file);
  const std::size_t at = after.find("life = { colour = { colour = \"#ffffff\", gradient = [[0.34");
  ASSERT_NE(at, std::string::npos) << after;
  EXPECT_LT(after.find("]]", at) - at, 100U) << "one key alone: " << after.substr(at, 120);
}

}  // namespace
}  // namespace physim::testing_window
