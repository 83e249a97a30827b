// What the client shows, against pictures that were looked at. PHYSIM_NEW_PICTURES=1 writes them anew: look at them,
// and pack them with tools/shrink_png.py --shades 16.
#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "window/x_client.hpp"

namespace physim::testing_window {
namespace {

const std::string kFolder = PHYSIM_SOURCE_DIR "/tests/window/pictures/";

/// The picture of a file; without pixels where it cannot be read.
Shot read_png(const std::string& path) {
  Shot shot;
  int channels = 0;
  unsigned char* data = stbi_load(path.c_str(), &shot.width, &shot.height, &channels, 3);
  if (data == nullptr) return shot;
  const auto count = static_cast<std::size_t>(shot.width) * static_cast<std::size_t>(shot.height);
  for (std::size_t i = 0; i < count; ++i)
    shot.pixels.push_back(static_cast<std::uint32_t>(data[3 * i] << 16 | data[3 * i + 1] << 8 | data[3 * i + 2]));
  stbi_image_free(data);
  return shot;
}

int difference(std::uint32_t a, std::uint32_t b) {
  int most = 0;
  for (const int shift : {0, 8, 16})
    most = std::max(most, std::abs(static_cast<int>((a >> shift) & 255) - static_cast<int>((b >> shift) & 255)));
  return most;
}

/// Part of the pixels that clearly differ from all pixels around their place in the other picture: lines and letters
/// may lie a pixel beside.
double part_that_differs(const Shot& a, const Shot& b) {
  std::size_t count = 0;
  for (int y = 1; y + 1 < a.height; ++y)
    for (int x = 1; x + 1 < a.width; ++x) {
      int nearest = 255;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) nearest = std::min(nearest, difference(a.at(x, y), b.at(x + dx, y + dy)));
      count += nearest > 40;
    }
  return static_cast<double>(count) / static_cast<double>(a.pixels.size());
}

/// Of the pixels: other processors and versions of the software renderer round a little otherwise.
constexpr double kMostThatDiffers = 0.0006;

/// Runs the client without a window until its script is over.
int draw(const Screen& screen, const std::vector<std::string>& arguments, const std::string& err = "/dev/null") {
  std::vector<std::string> words = {PHYSIM_SIMCLIENT, "--hidden"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t child =
      start(words, {"DISPLAY=" + screen.name(), "LIBGL_ALWAYS_SOFTWARE=1", "ASAN_OPTIONS=detect_leaks=0"}, -1, err);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

struct View {
  const char *name, *scenario, *script;
};

std::ostream& operator<<(std::ostream& out, const View& view) { return out << view.name; }

constexpr View kViews[] = {
    {"range", "", "settings; fit; fire; wait 12; bullet; elevation; fire; wait 14; laser; fire; wait 14"},
    {"plots", "original_test_3", "fire-scenario; plot z y vz vy; wait 112"},
    {"side", "308_168gr_g7", "settings; wait 1; camera; camera; fire; wait 60"},
    {"force_field", "world_force_field", "wait 100"},
    {"vectors", "golf_ball_no_spin", "settings; fit; fire; wait 50; vectors; camera; wait 1"},
    {"things", "billiards", "settings; statistics; fit; wait 50"},
    {"granted", "308_168gr_g7", "statistics; set shot.fidelity.motion=closed_form; set shot.mass=170 gr; wait 2"},
};

class Pictures : public testing::TestWithParam<View> {};

TEST_P(Pictures, LookAsTheyDid) {
  const View& view = GetParam();
  const Screen screen;
  const Folder folder;
  const std::string drawn = folder / "a.png", golden = kFolder + view.name + ".png";
  std::vector<std::string> arguments = {"--size", "800x500", "--script", view.script, "--screenshot", drawn};
  if (*view.scenario != '\0')
    arguments.push_back(PHYSIM_SOURCE_DIR "/scenarios/" + std::string(view.scenario) + ".toml");
  ASSERT_EQ(draw(screen, arguments), 0);
  if (std::getenv("PHYSIM_NEW_PICTURES") != nullptr)
    std::filesystem::copy_file(drawn, golden, std::filesystem::copy_options::overwrite_existing);
  const Shot now = read_png(drawn), then = read_png(golden);
  ASSERT_EQ(now.width, 800);
  ASSERT_EQ(now.height, 500);
  ASSERT_EQ(then.pixels.size(), now.pixels.size()) << "no picture " << golden;
  const double part = std::max(part_that_differs(now, then), part_that_differs(then, now));
  EXPECT_LT(part, kMostThatDiffers) << "of the pixels differ";
  if (part < kMostThatDiffers) return;
  const std::string kept = std::filesystem::temp_directory_path() / ("physim_" + std::string(view.name) + ".png");
  std::filesystem::copy_file(drawn, kept, std::filesystem::copy_options::overwrite_existing);
  std::printf("what was drawn: %s\n", kept.c_str());
}

INSTANTIATE_TEST_SUITE_P(Views, Pictures, testing::ValuesIn(kViews),
                         [](const auto& view) { return std::string(view.param.name); });

/// The comparison itself: another scene, a panel less or a missing trail must be seen.
TEST(PictureComparison, SeesWhatChanged) {
  const Screen screen;
  const Folder folder;
  const std::string script = "settings; fit; fire; wait 12; bullet; elevation; fire; wait 14; laser; fire; wait 14";
  const Shot golden = read_png(kFolder + "range.png");
  for (const char* change : {"; trails; wait 1", "; statistics; wait 1", "; artillery; wait 1", "; wait 4"}) {
    ASSERT_EQ(draw(screen, {"--size", "800x500", "--script", script + change, "--screenshot", folder / "a.png"}), 0);
    EXPECT_GT(part_that_differs(read_png(folder / "a.png"), golden), kMostThatDiffers) << change;
  }
}

/// The same script twice: the same pixels, frame by frame of simulation, whatever the machine's clock did.
TEST(Hidden, IsTheSameEveryTime) {
  const Screen screen;
  const Folder folder;
  for (const char* name : {"a", "b"})
    ASSERT_EQ(
        draw(screen, {"--size", "640x400", "--script", "fire; wait 20; elevation; fire; wait 15", "--state",
                      folder / (std::string(name) + ".jsonl"), "--screenshot", folder / (std::string(name) + ".png")}),
        0);
  EXPECT_EQ(testing_cli::read(folder / "a.jsonl"), testing_cli::read(folder / "b.jsonl"));
  EXPECT_EQ(testing_cli::read(folder / "a.png"), testing_cli::read(folder / "b.png"));
}

TEST(Hidden, SavesPicturesWhenTheScriptSaysSo) {
  const Screen screen;
  const Folder folder;
  const std::string window = folder / "window.png", plots = folder / "plots.png";
  ASSERT_EQ(draw(screen, {"--size", "800x500", "--script",
                          "plots; fire; wait 30; picture " + window + "; picture-of-plots " + plots + "; wait 2"}),
            0);
  EXPECT_EQ(read_png(window).height, 500);
  EXPECT_EQ(read_png(plots).width, 800);
  EXPECT_LT(read_png(plots).height, 300);
}

/// The row of buttons is lighter than all that plots are made of, but for letters and curves.
TEST(Hidden, PicturesOfPlotsHaveNoButtons) {
  const Screen screen;
  const Folder folder;
  const std::string plots = folder / "plots.png", window = folder / "window.png";
  ASSERT_EQ(draw(screen, {"--size", "800x500", "--script",
                          "plots; wait 2; picture-of-plots " + plots + "; wait 1; picture " + window + "; wait 2"}),
            0);
  const std::uint32_t button = 0x2F3945;
  const auto pixels_of_buttons = [button](const Shot& shot) {
    return std::count(shot.pixels.begin(), shot.pixels.end(), button);
  };
  EXPECT_GT(pixels_of_buttons(read_png(window)), 1000) << "the panel has its buttons";
  EXPECT_LT(pixels_of_buttons(read_png(plots)), 10);
}

TEST(Hidden, BadInputIsToldAndEndsWithTwo) {
  const Screen screen;
  const Folder folder;
  const std::string broken = folder.write("broken.toml", "physim = 1\n[[shot]]\nmass = \"1 ft\"\n");
  const std::string damaged = folder.write("damaged.rec", "PHYSIMR\nnothing");
  const struct {
    std::vector<std::string> arguments;
    const char* says;
  } bad[] = {
      {{"nowhere.toml"}, "nowhere.toml: error: there is no such file"},
      {{broken}, "broken.toml:3:8: error: shot.mass: \"1 ft\" is a length"},
      {{damaged}, "error"},
      {{"--script", "fyre"}, "script, action 1: error: there is no action \"fyre\"; did you mean \"fire\"?"},
      {{"--script", "fire; open nowhere.toml"}, "nowhere.toml: error: there is no such file"},
      {{"--script", "@nowhere.txt"}, "nowhere.txt: error: there is no such file"},
      {{"--script", "picture-of-plots x.png"}, "there are no plots"},
      {{"--screenshot", "/nowhere/a.png"}, "/nowhere/a.png: error: cannot write the picture"},
      {{"--state", "/nowhere/a"}, "/nowhere/a: error: cannot write the file"},
      {{"--size", "3x4"}, "a size is WIDTHxHEIGHT"},
      {{"--frames", "0"}, "--frames"},
      {{"--bogus"}, "--bogus"},
      {{"--set", "shot.mass=1 kg"}, "--set changes a scenario, and none is named"},
  };
  for (const auto& each : bad) {
    const std::string err = folder / "err";
    std::filesystem::remove(err);
    EXPECT_EQ(draw(screen, each.arguments, err), 2) << each.says;
    EXPECT_NE(testing_cli::read(err).find(each.says), std::string::npos) << testing_cli::read(err);
  }
}

TEST(Hidden, NoDisplayIsToldAndEndsWithTwo) {
  const Folder folder;
  const pid_t child = start({PHYSIM_SIMCLIENT, "--hidden"}, {"DISPLAY=:63999"}, -1, folder / "err");
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_NE(testing_cli::read(folder / "err").find("there is no display"), std::string::npos);
}

}  // namespace
}  // namespace physim::testing_window
