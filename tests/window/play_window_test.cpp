// The bar of play, by real mouse and keyboard events.
#include "window/x_client.hpp"

namespace physim::testing_window::window_play_window {
namespace {

class PlayBar : public testing::Test {
 protected:
  PlayBar() : client(screen, {"--size", "1000x640"}) {}
  void SetUp() override { ASSERT_TRUE(client.has_window()) << client.errors(); }

  /// The pixel of a part of the timeline.
  std::pair<int, int> place(double part) {
    const Json line = client.next_frames()["timeline"];
    const double from = line["from"][0], to = line["to"][0];
    return {static_cast<int>(from + part * (to - from)), static_cast<int>(line["from"][1].get<double>())};
  }
  /// A shot that has landed, and the clock stands.
  void fly() {
    client.key("Return");
    client.wait_for([](const Json& s) { return !s["tracks"].empty() && s["tracks"][0]["status"] != "in_flight"; });
    client.key("p");
    client.wait_for([](const Json& s) { return s["paused"].get<bool>(); });
  }

  Screen screen;
  RunningClient client;
};

TEST_F(PlayBar, DraggingGoesBackAndOnToTheBit) {
  fly();
  const Json end = client.next_frames();
  ASSERT_TRUE(end.contains("hash"));
  const auto [from_x, y] = place(1);
  const auto [to_x, unused] = place(0.3);
  client.drag(from_x, y, to_x, y, 1);
  const Json back = client.wait_for([&](const Json& s) { return s["step"] < end["step"]; });
  EXPECT_NEAR(back["timeline"]["now"].get<double>(),
              back["timeline"]["begin"].get<double>() +
                  0.3 * (back["timeline"]["end"].get<double>() - back["timeline"]["begin"].get<double>()),
              0.04);
  EXPECT_EQ(back["tracks"][0]["status"], "in_flight");
  EXPECT_TRUE(back["paused"].get<bool>()) << "as before it was dragged";
  client.drag(to_x, y, from_x + 30, y, 1);
  const Json again = client.wait_for([&](const Json& s) { return s["tracks"][0]["status"] != "in_flight"; });
  EXPECT_EQ(again["tracks"], end["tracks"]);
  while (client.state()["step"] < end["step"]) client.key("n");
  const Json there = client.next_frames();
  EXPECT_EQ(there["step"], end["step"]);
  EXPECT_EQ(there["hash"], end["hash"]);
}

TEST_F(PlayBar, AClickWhileItPlaysPlaysOnFromThere) {
  fly();
  client.key("p");
  const auto [x, y] = place(0.2);
  client.click(x, y);
  const Json now = client.wait_for([](const Json& s) { return s["tracks"][0]["status"] == "in_flight"; });
  EXPECT_FALSE(client.next_frames()["paused"].get<bool>());
  client.wait_for([&](const Json& s) { return s["step"] > now["step"]; });
  EXPECT_EQ(client.wait_for([](const Json& s) { return s["tracks"][0]["status"] != "in_flight"; })["tracks"].size(),
            1U);
}

/// The signs stand in the order of the guide: start, back, pause, on.
TEST_F(PlayBar, ButtonsDoWhatTheirKeysDo) {
  fly();
  const Json end = client.next_frames();
  const int y = static_cast<int>(end["timeline"]["from"][1].get<double>()) - 4;
  const auto press = [&](int i) {
    client.click(20 + 29 * i, y);
    return client.next_frames();
  };
  EXPECT_EQ(press(1)["step"].get<int>(), end["step"].get<int>() - 1);
  EXPECT_EQ(press(3)["step"], end["step"]);
  const Json start = press(0);
  EXPECT_NEAR(start["time"].get<double>(), start["timeline"]["begin"].get<double>(), 1e-9);
  EXPECT_TRUE(start["paused"].get<bool>());
  EXPECT_FALSE(press(2)["paused"].get<bool>());
  client.wait_for([](const Json& s) { return s["tracks"][0]["time"].get<double>() > 0.2; });
  client.key("p");  // a busy machine may play far on between two frames
  client.chord({"Control_L", "Home"});
  EXPECT_LT(client.next_frames()["tracks"][0]["time"].get<double>(), 0.2);
  client.chord({"Control_L", "Right"});
  const Json leapt = client.next_frames();
  client.chord({"Control_L", "Left"});
  EXPECT_LT(client.next_frames()["step"], leapt["step"]);
}

/// The mouse on the path, on a plot or on the timeline points at one time, in all of them.
TEST_F(PlayBar, OneCursorGoesThroughSceneAndPlots) {
  client.key("F4");
  fly();
  const auto [x, y] = place(0.5);
  client.move(x, y);
  const Json pointed = client.wait_for([](const Json& s) { return s["timeline"].contains("cursor"); })["timeline"];
  EXPECT_NEAR(pointed["cursor"].get<double>(), (pointed["begin"].get<double>() + pointed["end"].get<double>()) / 2,
              0.02);
  // The second plot, y over time: a press in its middle goes to about the middle of the flight.
  client.move(565, y - 130);
  const Json read = client.wait_for([](const Json& s) { return s["timeline"].contains("cursor"); });
  ASSERT_TRUE(read["timeline"].contains("cursor"));
  client.click(565, y - 130);
  const Json gone = client.wait_for([&](const Json& s) { return s["step"] != read["step"]; });
  EXPECT_NEAR(gone["time"].get<double>(), read["timeline"]["cursor"].get<double>(), 0.02);
}

}  // namespace
}  // namespace physim::testing_window::window_play_window
