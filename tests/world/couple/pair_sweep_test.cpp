// The search for boxes that meet, against looking at every two.
#include "world/couple/pair_sweep.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace physim::world_pair_sweep_test {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

class Sweep : public testing::Test {
 protected:
  std::mt19937_64 random{17};
  std::uniform_real_distribution<double> unit{-1, 1};
  Vec3d any(const Vec3d& size) { return {unit(random) * size.x, unit(random) * size.y, unit(random) * size.z}; }

  std::vector<Collider> boxes(std::size_t count, const Vec3d& spread) {
    std::vector<Collider> all(count);
    for (std::size_t i = 0; i < count; ++i) {
      Collider& c = all[i];
      c.slot = static_cast<std::uint32_t>(i + 1);
      if (i % 50 == 7) continue;  // one that left has none
      c.box.take(any(spread));
      c.box.take(c.box.low + any({1, 1, 1}) * (i % 40 == 3 ? 30.0 : 0.5));  // some are fast
      c.box.widen(0.1);
    }
    return all;
  }
};

TEST_F(Sweep, finds_each_two_whose_boxes_meet_once) {
  for (const Vec3d& spread : {Vec3d{10, 10, 10}, Vec3d{100, 1, 1}, Vec3d{1, 2, 50}, Vec3d{5, 80, 0}, Vec3d{0, 0, 0}})
    for (const std::size_t count : {2u, 60u, 400u}) {
      const auto all = boxes(count, spread);
      Pairs expected;
      for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = i + 1; j < count; ++j)
          if (all[i].box.meets(all[j].box)) expected.insert({i, j});
      Pairs found;
      PairSweep(all).each([&](std::uint32_t i, std::uint32_t j) {
        EXPECT_LT(i, j);
        EXPECT_TRUE(found.insert({i, j}).second) << "told twice";
      });
      EXPECT_EQ(found, expected);
    }
}

TEST_F(Sweep, finds_who_is_beside_one_that_has_another_path) {
  auto all = boxes(300, {10, 6, 3});
  PairSweep sweep(all);
  for (std::uint32_t turn = 0; turn < 200; ++turn) {
    const std::uint32_t i = turn * 7 % 300;
    Collider& c = all[i];
    c.box = {};
    c.box.take(any({14, 9, 5}));  // now and then outside of what there was
    c.box.take(c.box.low + any({3, 3, 3}));
    if (!std::exchange(c.is_new, true)) sweep.note_new(i);
    std::multiset<std::uint32_t> found, expected;
    sweep.each_beside(i, [&](std::uint32_t j) { found.insert(j); });
    for (std::uint32_t j = 0; j < 300; ++j)
      if (j != i && all[j].box.meets(c.box)) expected.insert(j);
    ASSERT_EQ(found, expected) << turn;
  }
}

}  // namespace physim::world_pair_sweep_test
