// The front-end tests of the original's evaluation, row by row, by real keyboard and mouse events: in both letter
// cases, because capitals were one of its two bugs. The other was a clock that ran on during a pause.
#include <cmath>
#include <set>

#include "window/x_client.hpp"

namespace physim::testing_window {
namespace {

enum class Letters { lower, upper };

bool are_near(std::uint32_t a, std::uint32_t b) {
  for (const int shift : {0, 8, 16})
    if (std::abs(static_cast<int>((a >> shift) & 255) - static_cast<int>((b >> shift) & 255)) > 40) return false;
  return true;
}

/// A colour so many tenths of the way to white.
std::uint32_t lighter(std::uint32_t colour, unsigned tenths) {
  std::uint32_t out = 0;
  for (const int shift : {0, 8, 16}) {
    const std::uint32_t part = colour >> shift & 255U;
    out |= (part + (255U - part) * tenths / 10) << shift;
  }
  return out;
}

class FrontEnd : public testing::TestWithParam<Letters> {
 protected:
  FrontEnd() : client(screen, {"--size", "1000x640"}) {}
  void SetUp() override { ASSERT_TRUE(client.has_window()) << client.errors(); }

  /// A letter key in the case at hand.
  void press(char letter) {
    client.key(std::string(1, static_cast<char>(GetParam() == Letters::upper ? letter - 32 : letter)));
  }
  Json shot() { return client.next_frames()["shot"]; }
  /// Presses a letter until the value of a setting comes back to where it was; all its values.
  std::vector<Json> cycle(char letter, const char* setting) {
    const Json first = shot()[setting];
    std::vector<Json> values = {first};
    for (int i = 0; i < 30; ++i) {
      press(letter);
      const Json now = shot()[setting];
      if (now == first) return values;
      values.push_back(now);
    }
    ADD_FAILURE() << setting << " never came back to " << first;
    return values;
  }
  /// A left click in the middle of the scene.
  Json fire() {
    const std::size_t known = client.state()["tracks"].size();
    client.click(500, 200);
    const Json now = client.wait_for([known](const Json& s) { return s["tracks"].size() > known; });
    EXPECT_EQ(now["tracks"].size(), known + 1);
    return now["tracks"].back();
  }
  /// How many pixels of the panel of statistics have about the colour of a projectile, or one that is a little lighter,
  /// to be read: the edges of letters are softer.
  int pixels_in_statistics(const Json& track) {
    const std::uint32_t colour = track["colour"].get<std::uint32_t>() >> 8;
    const Shot seen = client.picture();
    int count = 0;
    for (int y = seen.height / 2; y < seen.height - 64; ++y)
      for (int x = 0; x < 300; ++x)
        for (const unsigned part : {0U, 1U, 2U})
          if (are_near(seen.at(x, y), lighter(colour, part))) {
            ++count;
            break;
          }
    return count;
  }

  Screen screen;
  RunningClient client;
};

TEST_P(FrontEnd, StartsWithAWindowAndNothingInFlight) {
  const Json state = client.state();
  EXPECT_FALSE(state["paused"]);
  EXPECT_TRUE(state["tracks"].empty());
  EXPECT_EQ(state["shot"]["type"], "artillery");
  EXPECT_EQ(state["shot"]["elevation_setting"], 2);
  EXPECT_EQ(client.picture().width, 1000);
  const double before = state["time"];
  EXPECT_GT(client.wait_for([&](const Json& s) { return s["time"].get<double>() > before; })["time"], before);
}

TEST_P(FrontEnd, SCyclesTheShot) {
  const std::vector<Json> types = cycle('s', "type");
  ASSERT_GE(types.size(), 4U);
  EXPECT_EQ(types[0], "artillery");
  EXPECT_EQ(types[1], "bullet");
  EXPECT_EQ(types[2], "laser");
  EXPECT_EQ(types[3], "sphere");
}

TEST_P(FrontEnd, DigitsSpecifyTheShot) {
  const char* const types[] = {"artillery", "bullet", "laser", "sphere"};
  for (const int i : {3, 1, 2, 0}) {
    client.key(std::to_string(i + 1));
    EXPECT_EQ(shot()["type"], types[i]);
  }
}

/// The original's settings on its shots, and all rungs on others.
TEST_P(FrontEnd, FCyclesTheMotion) {
  const std::vector<Json> original = {"velocity", "force"}, all = {"force", "closed_form", "velocity"};
  EXPECT_EQ(cycle('f', "motion"), original);
  client.key("4");
  EXPECT_EQ(cycle('f', "motion"), all);
}

TEST_P(FrontEnd, DCyclesTheDrag) {
  press('f');  // motion force, which knows all of them
  const std::vector<Json> original = {"damping", "linear_quadratic", "off"};
  const std::vector<Json> all = {"equation", "off", "damping", "linear_quadratic"};
  EXPECT_EQ(cycle('d', "drag"), original);
  client.key("4");
  EXPECT_EQ(cycle('d', "drag"), all);
}

TEST_P(FrontEnd, GCyclesTheGravity) {
  std::vector<Json> names;
  for (int i = 0; i < 3; ++i, press('g')) names.push_back(shot()["original"]["gravity"]);
  const std::vector<Json> original = {"constant", "force", "off"};
  EXPECT_EQ(names, original);
  client.key("4");
  const std::vector<Json> all = {"constant", "inverse_square", "j2", "wgs84", "off"};
  EXPECT_EQ(cycle('g', "gravity"), all);
}

/// All 18 settings of the original on each of its shots, set by its keys and fired by its click: frame by frame its
/// loop, whose forces act in every frame (docs/original.md).
class FrontEndSettings : public FrontEnd {};
TEST_P(FrontEndSettings, EachSettingOfEachShotFliesAsTheOriginalsLoopDoes) {
  const struct {
    const char* key;
    double mass, forward, up, gravity, damping;
  } shots[] = {{"1", 200, 40, 2, 20, 0.9}, {"2", 2, 35, 1, 2, 0.9}, {"3", 1, 35, 1, 0, 1}};
  const std::string constant = "constant", force = "force";
  for (const auto& s : shots)
    for (int motion = 0; motion < 2; ++motion, press('f'))
      for (int gravity = 0; gravity < 3; ++gravity, press('g'))
        for (int drag = 0; drag < 3; ++drag, press('d')) {
          client.key(s.key);
          const Json set = shot()["original"];
          const bool pushed = set["motion"] == "force";
          fire();
          client.wait_for([](const Json& now) { return now["tracks"].back()["time"].get<double>() > 0.2; });
          press('p');
          const Json state = client.next_frames(), track = state["tracks"].back();
          const auto frames = std::lround(track["time"].get<double>() * 60);
          const double g = set["gravity"] == constant ? s.gravity : set["gravity"] == force && pushed ? 4 : 0;
          const double d = set["drag"] == constant ? s.damping : 1;
          const double k1 = set["drag"] == force && pushed ? 0.1 : 0, k2 = set["drag"] == force && pushed ? 0.4 : 0;
          double x = 0, y = 1.5, vx = pushed ? 0 : s.forward, vy = pushed ? 0 : 2 * s.up, ax = 0, ay = 0;
          for (long i = 0; i < frames; ++i) {
            x += vx / 60, y += vy / 60;
            const double rate = (k1 + k2 * std::hypot(vx, vy)) / s.mass;  // of the frame's start
            const double next_ax = (pushed ? 10 : 0) - rate * vx, next_ay = (pushed ? 2 : 0) - g - rate * vy;
            vx += ax / 60, vy += ay / 60;
            vx *= std::pow(d, 1.0 / 60), vy *= std::pow(d, 1.0 / 60);
            ax = next_ax, ay = next_ay;
          }
          const std::string what = std::string(s.key) + " " + set.dump();
          EXPECT_NEAR(track["position"][0].get<double>(), x, 1e-3) << what;
          EXPECT_NEAR(track["position"][1].get<double>(), y, 1e-3) << what;
          EXPECT_NEAR(track["velocity"][0].get<double>(), vx, 1e-3) << what;
          EXPECT_NEAR(track["velocity"][1].get<double>(), vy, 1e-3) << what;
          EXPECT_NEAR(track["acceleration"][0].get<double>(), ax, 1e-3) << what;
          EXPECT_NEAR(track["acceleration"][1].get<double>(), ay, 1e-3) << what;
          press('p');
        }
}

TEST_P(FrontEnd, ECyclesTheElevation) {
  const std::vector<Json> expected = {2, 3, 4, 5, 0, 1};
  EXPECT_EQ(cycle('e', "elevation_setting"), expected);
}

TEST_P(FrontEnd, AClickFiresWithTheSettingsShown) {
  client.key("2");
  press('e');
  const Json track = fire();
  EXPECT_EQ(track["name"], "bullet");
  EXPECT_EQ(track["mass"], 2.0);
  EXPECT_EQ(track["status"], "in_flight");
  // Settings belong to the shot: later changes do not reach it.
  client.key("1");
  EXPECT_EQ(client.next_frames()["tracks"][0]["name"], "bullet");
}

/// The laser flies straight on for ever: wherever it is, the arrow pointed there, in the world and on the screen.
TEST_P(FrontEnd, TheArrowPointsWhereTheShotGoes) {
  client.key("3");
  for (int elevation = 0; elevation < 6; ++elevation) {
    const Json arrow = client.next_frames()["arrow"];
    const double ax = arrow["from"][0], ay = arrow["from"][1], bx = arrow["to"][0], by = arrow["to"][1];
    const double size = std::hypot(bx - ax, by - ay);
    ASSERT_GT(size, 20);
    const Shot seen = client.picture();
    for (const double part : {0.3, 0.5, 0.7}) {
      const std::uint32_t pixel =
          seen.at(static_cast<int>(ax + (bx - ax) * part), static_cast<int>(ay + (by - ay) * part));
      EXPECT_GT(pixel & 0xFF, 150U) << "no white arrow at " << part << " of its length, elevation " << elevation;
    }
    fire();
    const Json state = client.wait_for([](const Json& s) { return s["tracks"].back()["time"].get<double>() > 0.2; });
    const Json& track = state["tracks"].back();
    const double px = track["pixel"][0], py = track["pixel"][1];
    const double off = std::abs((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / size;
    EXPECT_LT(off, 1.0) << "pixels beside the arrow's line, elevation " << elevation;
    const double t = track["time"], e = state["shot"]["elevation_setting"];
    EXPECT_NEAR(track["position"][0].get<double>(), 35 * t, 1e-3);
    EXPECT_NEAR(track["position"][1].get<double>(), 1.5 + e * t, 1e-3);
    press('e');
  }
}

TEST_P(FrontEnd, PStopsAndGoesOn) {
  fire();
  press('p');
  const Json stopped = client.next_frames();
  EXPECT_TRUE(stopped["paused"]);
  nap(300);
  const Json later = client.next_frames();
  EXPECT_EQ(later["time"], stopped["time"]);
  EXPECT_EQ(later["tracks"], stopped["tracks"]);
  press('p');
  const double then = stopped["time"];
  EXPECT_FALSE(client.wait_for([&](const Json& s) { return s["time"].get<double>() > then; })["paused"]);
}

/// Artillery at e = 2 by the sums of the original's frame loop, frame by frame (docs/original.md).
TEST_P(FrontEnd, StatisticsAreThoseOfTheProjectile) {
  fire();
  client.wait_for([](const Json& s) { return s["tracks"][0]["time"].get<double>() > 0.2; });
  press('p');
  const Json state = client.next_frames();
  const Json track = state["tracks"][0];
  const double t = track["time"];
  const auto frames = std::lround(t * 60);
  ASSERT_NEAR(t, static_cast<double>(frames) / 60, 1e-9);
  double x = 0, y = 1.5, vx = 40, vy = 4, ay = 0;
  for (long i = 0; i < frames; ++i) {
    x += vx / 60, y += vy / 60;
    vy += ay / 60;
    ay = -20;
    vx *= std::pow(0.9, 1.0 / 60), vy *= std::pow(0.9, 1.0 / 60);
  }
  EXPECT_NEAR(track["position"][0].get<double>(), x, 1e-4);
  EXPECT_NEAR(track["position"][1].get<double>(), y, 1e-4);
  EXPECT_NEAR(track["velocity"][0].get<double>(), vx, 1e-4);
  EXPECT_NEAR(track["velocity"][1].get<double>(), vy, 1e-4);
  EXPECT_NEAR(track["acceleration"][1].get<double>(), ay, 1e-3)
      << "the register of the original, as in files and plots";
  EXPECT_NEAR(track["speed"].get<double>(), std::hypot(vx, vy), 1e-4);
  EXPECT_EQ(track["mach"], 0) << "the original flies in no air, as in files and plots";
  EXPECT_EQ(track["mass"], 200.0);
  EXPECT_GT(pixels_in_statistics(track), 100) << "no numbers in its colour";
}

/// In steps of a pause, so that nothing depends on how fast the machine is.
TEST_P(FrontEnd, SeveralProjectilesHaveTheirOwnColoursAndNumbers) {
  constexpr int kSteps = 3;  // behind each shot
  press('p');
  for (const char* type : {"1", "2", "3"}) {
    client.key(type);
    fire();
    for (int i = 0; i < kSteps; ++i) press('n');
  }
  std::set<std::uint32_t> colours;
  const Json state = client.next_frames();
  ASSERT_EQ(state["tracks"].size(), 3U);
  for (const Json& track : state["tracks"]) {
    colours.insert(track["colour"].get<std::uint32_t>());
    EXPECT_GT(pixels_in_statistics(track), 100) << track["name"];
  }
  EXPECT_EQ(colours.size(), 3U);
  EXPECT_NE(state["tracks"][0]["position"], state["tracks"][1]["position"]);
  for (int i = 0; i < 3; ++i)  // each has its own clock, from its own launch
    EXPECT_NEAR(state["tracks"][i]["time"].get<double>(), kSteps * (3 - i) / 60.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Letters, FrontEnd, testing::Values(Letters::lower, Letters::upper),
                         [](const auto& letters) { return letters.param == Letters::lower ? "lower" : "upper"; });
INSTANTIATE_TEST_SUITE_P(Letters, FrontEndSettings, testing::Values(Letters::lower));  // a minute, in either case

// ------------------------------------------------------------------------------------------------ leaving, three ways
class Leaving : public testing::Test {
 protected:
  Leaving() : client(screen, {"--size", "1000x640"}) {}
  void SetUp() override { ASSERT_TRUE(client.has_window()) << client.errors(); }
  Screen screen;
  RunningClient client;
};

TEST_F(Leaving, ByEscape) {
  client.key("Escape");
  EXPECT_EQ(client.exit_code(), 0) << client.errors();
}

TEST_F(Leaving, ByTheCloseButton) {
  client.close_window();
  EXPECT_EQ(client.exit_code(), 0) << client.errors();
}

TEST_F(Leaving, ByTheMenuOfTheRightButton) {
  client.key("p");  // so that nothing else moves
  const Shot before = client.picture();
  client.click(400, 200, 3);
  EXPECT_TRUE(client.is_running());
  client.next_frames();
  const Shot after = client.picture();
  int bottom = 0, left = before.width, right = 0;
  for (int y = 190; y < 560; ++y)
    for (int x = 330; x < 680; ++x)
      if (before.at(x, y) != after.at(x, y))
        bottom = std::max(bottom, y), left = std::min(left, x), right = std::max(right, x);
  ASSERT_GT(bottom, 250) << "no menu was drawn";
  client.click((left + right) / 2, bottom - 16);  // "Leave" is the last
  EXPECT_EQ(client.exit_code(), 0) << client.errors();
}

// --------------------------------------------------------------------------------------------------- the two bugs
/// Published: keys were not seen while Caps Lock was on.
TEST_F(Leaving, CapitalsAreSeenWithCapsLockToo) {
  client.key("Caps_Lock");
  client.key("e");
  EXPECT_EQ(client.next_frames()["shot"]["elevation_setting"], 3);
  client.key("p");
  EXPECT_TRUE(client.next_frames()["paused"]);
  client.key("Caps_Lock");
  client.key("Escape");
  EXPECT_EQ(client.exit_code(), 0);
}

/// Published: after a pause everything jumped ahead by the time that it took.
TEST_F(Leaving, NoTimePassesDuringAPause) {
  client.key("3");
  client.click(500, 200);
  client.key("space");
  const Json stopped = client.next_frames();
  ASSERT_TRUE(stopped["paused"]);
  nap(2000);
  const auto start = std::chrono::steady_clock::now();
  client.key("space");
  client.wait_for([](const Json& s) { return !s["paused"].get<bool>(); });
  client.key("space");
  const Json after = client.next_frames();
  const double resumed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double passed = after["time"].get<double>() - stopped["time"].get<double>();
  EXPECT_GT(passed, 0);
  EXPECT_LT(passed, resumed) << "the clock ran on during a pause of two seconds";
  const Json &a = stopped["tracks"][0], &b = after["tracks"][0];
  EXPECT_NEAR(b["time"].get<double>() - a["time"].get<double>(), passed, 1e-9);
  EXPECT_NEAR(b["position"][0].get<double>() - a["position"][0].get<double>(), 35 * passed, 1e-3);
}

// ---------------------------------------------------------------------------------------------------- beyond the table
using InWindow = Leaving;

TEST_F(InWindow, TheMouseTurnsTheViewAndNeverFiresByIt) {
  const Json before = client.next_frames()["arrow"];
  client.drag(450, 300, 520, 330, 3);
  const Json state = client.next_frames();
  EXPECT_NE(state["arrow"], before);
  EXPECT_TRUE(state["tracks"].empty());
  client.drag(450, 300, 480, 280, 1);  // aims
  EXPECT_TRUE(client.next_frames()["tracks"].empty());
  EXPECT_NE(client.next_frames()["shot"]["azimuth"], 0.0);
}

TEST_F(InWindow, ClicksOnPanelsFireNothing) {
  client.click(100, 400);
  client.click(100, 500);
  client.click(500, 630);
  EXPECT_TRUE(client.next_frames()["tracks"].empty());
}

TEST_F(InWindow, StepsForwardAndBack) {
  client.key("3");
  client.key("Return");
  client.key("n");
  const Json then = client.next_frames();
  EXPECT_TRUE(then["paused"]);
  client.key("n");
  EXPECT_EQ(client.next_frames()["step"], then["step"].get<int>() + 1);
  client.key("b");
  const Json back = client.next_frames();
  EXPECT_EQ(back["step"], then["step"]);
  EXPECT_EQ(back["tracks"], then["tracks"]);
}

/// The keyboard reaches the panels: with F8 the arrows, Space and Enter are theirs. Esc gives them back.
TEST_F(InWindow, TheKeyboardReachesThePanels) {
  const double azimuth = client.next_frames()["shot"]["azimuth"];
  client.key("F8");
  for (const char* key : {"Down", "Down", "space", "Down", "space"})
    client.hold(key);  // opens the list, takes the next
  EXPECT_EQ(client.next_frames()["shot"]["type"], "bullet");
  EXPECT_EQ(client.next_frames()["shot"]["azimuth"], azimuth);
  EXPECT_FALSE(client.next_frames()["paused"]) << "space belongs to the panels";
  client.key("Escape");
  client.next_frames();
  client.key("Right");
  EXPECT_NE(client.next_frames()["shot"]["azimuth"], azimuth);
}

TEST_F(InWindow, TypingIntoAFieldPressesNoKeys) {
  client.click(150, 115);  // the search for settings
  for (const char* key : {"p", "e", "s", "2"}) client.key(key);
  const Json state = client.next_frames();
  EXPECT_FALSE(state["paused"]);
  EXPECT_EQ(state["shot"]["type"], "artillery");
  client.key("Escape");  // leaves the field, not the client
  client.next_frames();
  EXPECT_TRUE(client.is_running());
}

/// A key that goes down and up between two frames is seen, and in its order: Debian's Dear ImGui looks once in a frame.
TEST_F(InWindow, ShortPressesOfKeysAreNotLostInFields) {
  const Folder folder;
  const std::string file = folder.write("ab.toml", "physim = 1\n[[shot]]\nname = \"found\"\n");
  client.chord({"Control_L", "o"});
  std::vector<std::string> keys;
  for (const char letter : folder / "ax") keys.emplace_back(1, letter);
  for (const char* key : {"BackSpace", "x", "Left", "b", "End", "BackSpace", ".", "t", "o", "m", "l", "m", "BackSpace"})
    keys.emplace_back(key);
  keys.emplace_back("Return");
  client.keys_at_once(keys);
  const Json state = client.wait_for([](const Json& s) { return s["shot"]["type"] == "found"; });
  EXPECT_EQ(state["shot"]["type"], "found") << state.value("message", "") << client.errors();
}

/// With nothing changed Ctrl+S writes the file as it was, letter by letter; a flight never turns into a world.
TEST(OfAScenario, IsSavedByCtrlS) {
  const Screen screen;
  const Folder folder;
  const std::string before = testing_cli::read(PHYSIM_SOURCE_DIR "/scenarios/308_168gr_g7.toml");
  const std::string file = folder.write("mine.toml", before);
  RunningClient client(screen, {"--size", "1000x640", file});
  ASSERT_TRUE(client.has_window()) << client.errors();
  client.chord({"Control_L", "s"});
  const Json state = client.wait_for([](const Json& s) { return s.contains("message"); });
  EXPECT_EQ(state.value("message", ""), "saved " + file);
  EXPECT_EQ(testing_cli::read(file), before);
}

/// A closed form knows no drag by the drag equation: what is granted is told, not what was asked for.
TEST(OfAScenario, TellsWhatIsGranted) {
  const Screen screen;
  RunningClient client(screen, {"--size", "1000x640", PHYSIM_SOURCE_DIR "/scenarios/308_168gr_g7.toml"});
  ASSERT_TRUE(client.has_window()) << client.errors();
  EXPECT_EQ(client.next_frames()["shot"]["granted"]["drag"], "equation");
  client.key("f");
  const Json shot = client.next_frames()["shot"];
  EXPECT_EQ(shot["motion"], "closed_form");
  EXPECT_EQ(shot["drag"], "equation");
  EXPECT_EQ(shot["granted"]["drag"], "off");
}

TEST_F(InWindow, AsksBeforeWorkIsLost) {
  client.key("3");
  client.click(500, 200);
  client.wait_for([](const Json& s) { return !s["tracks"].empty(); });
  for (const char* key : {"r", "Escape"}) {
    client.key(key);
    EXPECT_TRUE(client.next_frames().contains("question")) << key;
    client.key("e");  // belongs to nobody now
    EXPECT_EQ(client.next_frames()["shot"]["elevation_setting"], 2);
    client.key("Escape");
    EXPECT_FALSE(client.next_frames().contains("question")) << key;
    EXPECT_FALSE(client.next_frames()["tracks"].empty()) << key;
  }
  client.close_window();
  EXPECT_TRUE(client.wait_for([](const Json& s) { return s.contains("question"); }).contains("question"));
  EXPECT_TRUE(client.is_running());
  client.key("Escape");
  client.key("r");
  client.key("Return");
  EXPECT_TRUE(client.next_frames()["tracks"].empty());
  client.key("Escape");
  EXPECT_EQ(client.exit_code(), 0) << client.errors();
}

TEST_F(InWindow, CanBeResized) {
  for (const auto& [width, height] : {std::pair{1500, 900}, {640, 420}, {1000, 640}}) {
    client.resize(width, height);
    client.next_frames();
    const Shot seen = client.picture();
    EXPECT_EQ(seen.width, width);
    EXPECT_EQ(seen.height, height);
    EXPECT_TRUE(client.is_running()) << client.errors();
  }
}

}  // namespace
}  // namespace physim::testing_window
