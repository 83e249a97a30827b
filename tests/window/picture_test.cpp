// What the client shows, against pictures that were looked at. PHYSIM_NEW_PICTURES=1 writes them anew: look at them,
// and pack them with tools/shrink_png.py --shades 16.
#include <stb/stb_image.h>

#include <cmath>

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

/// A program in the place of ffmpeg, first in PATH as long as this lives.
class FakeFfmpeg {
 public:
  explicit FakeFfmpeg(const std::string& script) : old_(std::getenv("PATH")) {
    if (!script.empty()) {
      const std::string program = folder_.write("ffmpeg", "#!/bin/sh\n" + script);
      std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    }
    setenv("PATH", ((folder_ / "") + (script.empty() ? "" : ":" + old_)).c_str(), 1);
  }
  ~FakeFfmpeg() { setenv("PATH", old_.c_str(), 1); }
  FakeFfmpeg(const FakeFfmpeg&) = delete;
  FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;

 private:
  Folder folder_;
  std::string old_;
};

/// Writes into its last argument how many bytes came in, and behind them all its arguments.
constexpr const char* kCounts = "for last; do :; done\ncount=$(wc -c)\necho \"$count $*\" > \"$last\"\n";

TEST(Share, PicturesOfTheSceneAreSoManyWindowsWideAndHaveNoPanels) {
  const Screen screen;
  const Folder folder;
  for (int times = 1; times <= 4; ++times) {
    const std::string size = std::to_string(times), path = folder / (size + ".png");
    ASSERT_EQ(draw(screen, {"--size", "500x400", "--script",
                            "fire; wait 40; picture-size " + size + "; picture-of-scene " + path + "; wait 1"}),
              0);
    const Shot shot = read_png(path);
    EXPECT_EQ(shot.width, 500 * times);
    EXPECT_EQ(shot.height, 400 * times);
    // Sky at the upper right and ground at the lower right, where panels stand in the window.
    const std::uint32_t sky = shot.at(shot.width - 5, 5), ground = shot.at(shot.width - 5, shot.height - 5);
    EXPECT_GT(sky & 255, 150U) << std::hex << sky;
    EXPECT_GT((ground >> 8) & 255, ground & 255) << std::hex << ground;
    // The scale bar: white letters and lines on a dark box, lower left.
    int white = 0;
    for (int y = shot.height - 40 * times; y < shot.height; ++y)
      for (int x = 0; x < 150 * times; ++x) white += shot.at(x, y) > 0xDCDCDC;
    EXPECT_GT(white, 100 * times);
  }
}

TEST(Share, FilmsHaveAllTheirPicturesAndLeaveTheSessionAsItWas) {
  const Screen screen;
  const Folder folder;
  const FakeFfmpeg counts(kCounts);
  for (const char* ending : {".mp4", ".gif"}) {
    const std::string film = folder / (std::string("a") + ending);
    const std::string fly = "set shot.speed=20 m/s; set shot.elevation=50 deg; fire; wait 100; ";
    const std::string then = "wait 20; pause; wait 2";
    for (const std::string& script : {fly + then, fly + "film-length 1; film " + film + "; " + then})
      ASSERT_EQ(draw(screen, {"--size", "500x400", "--script", script, "--state",
                              folder / (script.find("film") != script.npos ? "with" : "without")}),
                0);
    const std::string told = testing_cli::read(film);
    EXPECT_EQ(told.substr(0, told.find(' ')), std::to_string(31 * 500 * 400 * 3)) << told;
    EXPECT_NE(told.find("-s 500x400 -r 30"), std::string::npos) << told;
    const auto last = [&](const char* name) {
      const std::string all = testing_cli::read(folder / name);
      Json state = Json::parse(all.substr(all.rfind('\n', all.size() - 2) + 1));
      state.erase("message");
      return state;
    };
    EXPECT_EQ(last("with"), last("without"));
  }
}

TEST(Share, FilmsThatFailAreToldAndLeaveNoFile) {
  const Screen screen;
  const Folder folder;
  const std::string film = folder / "a.mp4";
  const struct {
    std::string ffmpeg, name, says;
  } bad[] = {{"", film, "ffmpeg is needed for films and was not found"},
             {"echo there is no such codec >&2; exit 3", film, "ffmpeg failed: there is no such codec"},
             {kCounts, folder / "a.avi", "end it with .mp4 or .gif"},
             {kCounts, "/nowhere/a.mp4", "cannot write"}};
  for (const auto& each : bad) {
    const FakeFfmpeg fake(each.ffmpeg);
    const std::string err = folder / "err";
    std::filesystem::remove(err);
    EXPECT_EQ(draw(screen, {"--size", "500x400", "--script", "fire; wait 20; film " + each.name + "; wait 1"}, err), 2);
    EXPECT_NE(testing_cli::read(err).find(each.says), std::string::npos) << testing_cli::read(err);
    for (const std::string& left : folder.names()) EXPECT_EQ(left, "err");
  }
}

/// By any name, and through links.
TEST(Share, NothingReplacesWhatTheSessionReads) {
  const Screen screen;
  const Folder folder;
  const FakeFfmpeg counts(kCounts);
  const std::string text = testing_cli::read(PHYSIM_SOURCE_DIR "/scenarios/golf_drive.toml");
  const std::string scenario = folder.write("golf.toml", text);
  std::filesystem::create_symlink(scenario, folder / "link.mp4");
  std::filesystem::create_hard_link(scenario, folder / "twin.png");
  for (const std::string& act : {"film " + (folder / "link.mp4"), "picture-of-scene " + (folder / "twin.png"),
                                 "picture " + scenario, "film " + scenario}) {
    const std::string err = folder / "err";
    std::filesystem::remove(err);
    EXPECT_EQ(draw(screen, {"--script", "fire-whole; wait 20; " + act + "; wait 1", scenario}, err), 2) << act;
    EXPECT_NE(testing_cli::read(err).find("this session reads"), std::string::npos) << testing_cli::read(err);
    EXPECT_EQ(testing_cli::read(scenario), text);
  }
}

/// With keys, into the folder where the client was started.
TEST(Share, KeysTakePicturesAndFilms) {
  const Screen screen;
  const FakeFfmpeg counts(kCounts);
  RunningClient client(screen, {"--size", "640x480"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  client.key("Return");
  client.wait_for([](const Json& s) { return !s["tracks"].empty() && s["tracks"][0]["time"].get<double>() > 0.5; });
  client.key("p");
  const auto saved = [&](const char* ending) {
    const Json state = client.wait_for([&](const Json& s) {
      return s.contains("message") && s["message"].get<std::string>().find(ending) != std::string::npos;
    });
    const std::string message = state.value("message", "");
    const std::string path = message.substr(message.find(' ') + 1);
    return path.substr(0, path.find(ending) + std::string(ending).size());
  };
  client.key("F12");
  const std::string picture = saved(".png");
  EXPECT_EQ(read_png(picture).width, 1280) << "two windows wide";
  std::filesystem::remove(picture);
  const Json before = client.next_frames();
  client.chord({"Control_L", "F12"});
  const std::string film = saved(".mp4");
  EXPECT_GT(testing_cli::read(film).size(), 20U);
  std::filesystem::remove(film);
  EXPECT_EQ(client.next_frames()["hash"], before["hash"]);
  client.key("p");  // a long film is given up by Esc
  client.wait_for([](const Json& s) { return s["timeline"]["end"].get<double>() > 0.6; });
  client.key("p");
  client.chord({"Control_L", "F12"});
  client.key("Escape");
  const Json after = client.wait_for([](const Json& s) { return !s.contains("filmed"); });
  EXPECT_TRUE(client.is_running()) << "Esc ends the film alone";
  const std::string told = after.value("message", "");
  if (told.starts_with("saved")) std::filesystem::remove(told.substr(6));
}

TEST(Hidden, SavesPicturesWhenTheScriptSaysSo) {
  const Screen screen;
  const Folder folder;
  const std::string window = folder / "window.png", plots = folder / "plots.png";
  ASSERT_EQ(draw(screen, {"--size", "800x500", "--script",
                          "plots; fire; wait 30; picture " + window + "; picture-of-plots " + plots + "; wait 2"}),
            0);
  EXPECT_EQ(read_png(window).height, 500);
  EXPECT_GT(read_png(plots).width, 0.6 * 800);
  EXPECT_LT(read_png(plots).width, 800) << "beside the settings";
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
