// What is computed while frames are drawn.
#include "simclient/core/beside.hpp"

#include <chrono>
#include <future>

#include "client/support.hpp"

namespace physim::client {
namespace {

/// Until nothing is computed any more.
void settle(Client& client) {
  for (int i = 0; i < 20'000; ++i) {
    (void)client.prediction();
    if (client.bottom == BottomPanel::compare) (void)client.comparison();
    client.advance(0);
    if (!client.awaits_answer()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  FAIL() << "no answer came";
}

bool is_same(const std::vector<TrackSample>& a, const std::vector<TrackSample>& b) {
  return std::ranges::equal(a, b, [](const TrackSample& s, const TrackSample& t) {
    return s.time == t.time && s.position == t.position && s.velocity == t.velocity;
  });
}

TEST(Beside, DoesTheNewestOfWhatWaits) {
  std::promise<void> gate;
  std::shared_future<void> opened = gate.get_future().share();
  std::promise<void> begun;
  Beside<int> beside;
  std::atomic<int> done = 0;
  beside.ask([&] {
    begun.set_value();
    opened.wait();
    return 1;
  });
  begun.get_future().wait();
  beside.ask([&] { return ++done, 2; });
  beside.ask([&] { return ++done, 3; });
  EXPECT_FALSE(beside.take());
  gate.set_value();
  int last = 0;
  while (last != 3)
    if (const auto answer = beside.take()) last = *answer;
  EXPECT_EQ(done, 1) << "the one between was left out";
}

TEST(Beside, WhatWasForgottenIsNotAnswered) {
  std::promise<void> gate;
  std::shared_future<void> opened = gate.get_future().share();
  std::promise<void> begun;
  std::atomic<bool> is_last = false;
  Beside<int> beside;
  beside.ask([&] {
    begun.set_value();
    opened.wait();
    return 1;
  });
  begun.get_future().wait();
  beside.forget();
  gate.set_value();
  beside.ask([&] { return is_last = true, 2; });
  std::optional<int> answer;
  while (!answer) answer = beside.take();
  EXPECT_EQ(*answer, 2);
  EXPECT_TRUE(is_last);
}

/// The shell of six degrees of freedom takes much longer than a frame. While its aim moves, frames have the arrow of
/// the new aim and the path of an old one; afterwards they have the path that a client computes which waits for it.
TEST(Beside, ASlowPredictionComesLaterAndIsThatOfTheLastAim) {
  Client client = client_of("105mm_m1_six_dof");
  client.computes_beside = true;
  const std::vector<TrackSample> before = client.prediction().path;
  ASSERT_FALSE(client.prediction().is_old);
  for (int i = 0; i < 5; ++i) {
    client.launcher.turn(0.01, -0.02);
    const Prediction& ahead = client.prediction();
    EXPECT_TRUE(ahead.is_old);
    Client waits = client_of("105mm_m1_six_dof");
    for (int k = 0; k <= i; ++k) waits.launcher.turn(0.01, -0.02);
    if (i == 0) {
      EXPECT_TRUE(is_same(ahead.path, before));
    }
    const Vec3d wanted = beginning_of(waits.session.scenario(), waits.launcher.shot()).velocity;
    EXPECT_EQ(ahead.velocity, wanted) << "the arrow follows at once";
    client.advance(1.0 / 60);
  }
  settle(client);
  EXPECT_FALSE(client.prediction().is_old);
  Client waits = client_of("105mm_m1_six_dof");
  for (int i = 0; i < 5; ++i) waits.launcher.turn(0.01, -0.02);
  EXPECT_TRUE(is_same(client.prediction().path, waits.prediction().path));
  EXPECT_EQ(client.prediction().velocity, waits.prediction().velocity);
  EXPECT_FALSE(is_same(client.prediction().path, before));
}

TEST(Beside, ThePathOfAScenarioIsNeverThatOfTheOneBefore) {
  Client client = client_of("105mm_m1_six_dof");
  client.computes_beside = true;
  (void)client.prediction();
  client.launcher.turn(0.01, 0);
  EXPECT_TRUE(client.prediction().is_old);
  ASSERT_TRUE(client.open(PHYSIM_SOURCE_DIR "/scenarios/golf_drive.toml"));
  EXPECT_FALSE(client.prediction().is_old);
  EXPECT_TRUE(is_same(client.prediction().path, client_of("golf_drive").prediction().path));
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  client.advance(1.0 / 60);
  EXPECT_TRUE(is_same(client.prediction().path, client_of("golf_drive").prediction().path));
}

TEST(Beside, AClientLeavesWhileItComputes) {
  Client client = client_of("105mm_m1_six_dof");
  client.computes_beside = true;
  (void)client.prediction();
  client.launcher.turn(0.01, 0);
  EXPECT_TRUE(client.prediction().is_old);
}

TEST(Beside, AComparisonComesLater) {
  Client client = client_of("golf_drive");
  client.computes_beside = true;
  client.bottom = BottomPanel::compare;
  (void)client.comparison();
  client.launcher.turn(0.02, 0.05);
  (void)client.comparison();
  settle(client);
  EXPECT_FALSE(client.is_comparison_old());
  Client waits = client_of("golf_drive");
  waits.launcher.turn(0.02, 0.05);
  const auto &later = client.comparison(), &at_once = waits.comparison();
  ASSERT_EQ(later.size(), at_once.size());
  for (std::size_t i = 0; i < later.size(); ++i) EXPECT_EQ(later[i].figures(), at_once[i].figures()) << later[i].name;
}

}  // namespace
}  // namespace physim::client
