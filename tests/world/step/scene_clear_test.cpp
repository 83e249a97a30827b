// What rows know to be clear about them: balls and tubes in which nothing stands save questions and change no answer.
#include "world/clear_support.hpp"

namespace physim::world_scene_clear_test {

using namespace test_clear;

TEST(SceneClear, what_is_known_to_be_clear_changes_no_answer) {
  std::size_t hits = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(seed);
    Trial trial(seed);
    auto& [r, shapes, scene, pair] = trial;
    launch_some(pair, r, 100);  // more than look ahead together
    const double dt = std::array{1.0 / 30, 1.0 / 60, 1.0 / 240}[std::size_t(r.below(3))];
    const bool edits = r.one_in(2);
    for (int step = 0; step < 90; ++step) {
      if (edits && r.one_in(3)) edit(pair, r, shapes);
      if (r.one_in(4)) push(pair, r);
      if (step == 40) launch_some(pair, r, 20);
      pair.clear.step(dt), pair.asking.step(dt);
      expect_the_same(pair, step);
      if (testing::Test::HasFatalFailure()) return;
      hits += pair.clear.events().size();
    }
  }
  EXPECT_GT(hits, 1500u);
}

}  // namespace physim::world_scene_clear_test
