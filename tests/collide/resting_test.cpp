// Things that come and go in a tree that is there already, beside a list of them.
#include "collide/resting.hpp"

#include <gtest/gtest.h>

#include <set>

#include "random_shots.hpp"

namespace physim::collide_resting_test {

using test::Random;

collide::Bounds box_about(const Vec3d& middle, double half) {
  const Vec3d aside{half, half, half};
  return {middle - aside, middle + aside};
}

using Boxes = std::vector<std::optional<collide::Bounds>>;  // by thing

/// Each thing whose box a segment enters is told by the tree, once, and none that is gone.
void expect_found(const collide::RestingThings& things, const Boxes& boxes, Random& r, double side) {
  for (int k = 0; k < 20; ++k) {
    collide::Segment s{r.vector(side), r.vector(side), r.one_in(3) ? r.in(0, 2) : 0.0, 1};
    std::multiset<std::uint32_t> seen;
    things.along(s, [&](std::uint32_t thing, collide::Segment&) { seen.insert(thing); });
    std::multiset<std::uint32_t> over;
    const collide::Bounds about = box_about(s.from, 3);
    things.overlapping(about, [&](std::uint32_t thing) { over.insert(thing); });
    for (std::uint32_t thing = 0; thing < boxes.size(); ++thing) {
      ASSERT_LE(seen.count(thing), boxes[thing] ? 1u : 0u);
      ASSERT_EQ(over.count(thing), boxes[thing] && boxes[thing]->meets(about) ? 1u : 0u);
      const bool is_met = boxes[thing] && collide::BoxTest(s).enters(*boxes[thing], 1) <= 1;
      ASSERT_GE(seen.count(thing), is_met ? 1u : 0u);
    }
  }
}

TEST(RestingThings, those_that_come_and_go_are_found_where_they_are) {
  Random r(61);
  for (int i = 0; i < 12; ++i) {
    const double side = i % 3 == 0 ? 1e6 : 30;
    collide::RestingThings things;
    Boxes boxes(1 + static_cast<std::size_t>(r.below(300)));
    for (int step = 0; step < 60; ++step) {
      for (int k = 0; k < 40; ++k) {
        const auto thing = static_cast<std::uint32_t>(r.below(static_cast<int>(boxes.size())));
        const bool stays = step < 40 ? r.one_in(3) : r.one_in(20);  // in the end nearly all of them go
        if (boxes[thing]) {
          ASSERT_TRUE(things.remove(thing));
          boxes[thing].reset();
          if (!stays) continue;
        }
        if (step >= 40 && !stays) continue;
        // Some stand in one place.
        boxes[thing] = box_about(r.one_in(4) ? Vec3d{1, 2, 3} : r.vector(side), r.in(0, 2));
        things.insert(*boxes[thing], thing);
      }
      expect_found(things, boxes, r, side);
    }
    for (std::uint32_t thing = 0; thing < boxes.size(); ++thing)
      ASSERT_EQ(things.remove(thing), boxes[thing].has_value());
    ASSERT_TRUE(things.tree().is_empty());
  }
}

/// Each comes beside the one before it, farther away, so that all of them would go down one way.
TEST(RestingThings, things_in_a_row_make_no_tree_that_is_too_deep) {
  collide::RestingThings things;
  double size = 1e-6;
  for (std::uint32_t thing = 0; thing < 3000; ++thing, size = std::min(2 * size, 1e6))
    things.insert(box_about({size, 0, 0}, 0.1 * size), thing);
  int seen = 0;
  collide::Segment s{{-1, 0, 0}, {2e6, 0, 0}, 0, 1};
  things.along(s, [&](std::uint32_t, collide::Segment&) { ++seen; });
  EXPECT_EQ(seen, 3000);
}

}  // namespace physim::collide_resting_test
