// The window is drawn only where something changed.
#include "window/x_client.hpp"

namespace physim::testing_window {
namespace {

constexpr int kRest = 800;  // shorter than the time between two drawings of the clock [ms]

class Quiet : public testing::Test {
 protected:
  Quiet() : client(screen, {"--size", "640x420"}) {}
  void SetUp() override { ASSERT_TRUE(client.has_window()) << client.errors(); }

  Screen screen;
  RunningClient client;
};

TEST_F(Quiet, NothingIsDrawnWhileNothingChanges) {
  EXPECT_TRUE(client.frame_at_rest(kRest)) << "the clock runs, nothing flies";
  client.key("space");
  const auto paused = must(client.frame_at_rest(kRest));
  nap(2500);
  EXPECT_EQ(client.state()["frame"], paused) << "not even the clock";
  client.key("e");
  EXPECT_EQ(client.next_frames()["shot"]["elevation_setting"], 3) << "a key wakes it";
}

TEST_F(Quiet, WhatFliesIsDrawnToItsEnd) {
  client.key("Return");
  const Json landed =
      client.wait_for([](const Json& s) { return !s["tracks"].empty() && s["tracks"][0]["status"] != "in_flight"; });
  ASSERT_FALSE(landed["tracks"].empty());
  EXPECT_EQ(landed["tracks"][0]["status"], "landed");
  EXPECT_TRUE(client.frame_at_rest(kRest)) << "it lies there";
}

TEST_F(Quiet, AnIconIsNotDrawnButItsClockRunsOn) {
  client.key("3");
  client.key("Return");  // the laser flies on and on
  client.iconify(true);
  const auto icon = must(client.frame_at_rest(kRest));
  const double then = client.state()["time"];
  nap(1000);
  EXPECT_EQ(client.state()["frame"], icon);
  client.iconify(false);
  EXPECT_GT(client.next_frames()["time"], then + 0.9);
}

TEST_F(Quiet, AMessageGoesByItself) {
  client.key("b");  // there is nothing to go back to, or there is: it says so, or pauses
  client.chord({"Control_L", "z"});
  ASSERT_TRUE(client.next_frames().contains("message"));
  const Json later = client.wait_for([](const Json& s) { return !s.contains("message"); });
  EXPECT_FALSE(later.contains("message"));
}

}  // namespace
}  // namespace physim::testing_window
