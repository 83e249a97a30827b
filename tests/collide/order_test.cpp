// The order in which large batches of segments are cast.
#include "collide/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "random_shots.hpp"

namespace physim::collide_order_test {

using test::Random;

std::vector<SceneSegment> segments_over(double side, std::size_t count) {
  Random r(17);
  std::vector<SceneSegment> segments;
  while (segments.size() < count) {
    const Vec3d from{r.in(0, side), r.in(-1, 3), r.in(0, side)};
    segments.push_back({from, from + Vec3d{r.in(-8, 8), r.in(-6, 2), r.in(-8, 8)}});
  }
  return segments;
}

double way_between(const std::vector<SceneSegment>& segments, const std::vector<std::uint32_t>& order) {
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i) sum += length(segments[order[i]].from - segments[order[i - 1]].from);
  return sum;
}

TEST(OrderByPlace, names_each_once_and_neighbours_together) {
  const std::vector<SceneSegment> segments = segments_over(1000, 20000);
  std::vector<std::uint32_t> order = collide::order_by_place(segments), as_given(segments.size());
  for (std::uint32_t i = 0; i < as_given.size(); ++i) as_given[i] = i;
  // At random two places in a square are 0.52 sides apart; along the curve about a cell, and rarely more.
  EXPECT_LT(way_between(segments, order), 0.03 * way_between(segments, as_given));
  std::ranges::sort(order);
  EXPECT_EQ(order, as_given);
}

TEST(OrderByPlace, of_places_that_are_none_or_one) {
  EXPECT_TRUE(collide::order_by_place({}).empty());
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Vec3d here{1, 2, 3};
  std::vector<SceneSegment> segments(5, {here, here});
  segments[3].from = {kNan, 0, 0};
  segments[1].from = {1e300, 0, 0};
  EXPECT_EQ(collide::order_by_place(segments), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

/// A scene larger than a cache, so that segments are sorted: each gets its own answer.
TEST(OrderByPlace, changes_no_answer) {
  constexpr std::uint32_t kPoints = 400;
  HeightFieldShape field{.columns = kPoints, .rows = kPoints, .spacing_x = 2, .spacing_z = 2, .heights = {}};
  for (std::uint32_t i = 0; i < kPoints * kPoints; ++i) field.heights.push_back(std::sin(i * 0.7) + std::cos(i * 0.01));
  Scene scene;
  ASSERT_TRUE(scene.add({.shape = scene.add_shape(field).value()}));
  ASSERT_GT(scene.bytes(), std::size_t{1} << 20);
  std::vector<SceneSegment> segments = segments_over(2.0 * kPoints, 6000);
  segments[77].to.y = std::numeric_limits<double>::infinity();
  std::vector<SceneHit> hits(segments.size()), lent(segments.size());
  scene.first_hits(segments, hits);
  const auto pool = make_thread_pool(3);
  scene.first_hits(segments, lent, {}, pool.get());
  int some = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const SceneHit one = scene.first_hit(segments[i]);
    some += one ? 1 : 0;
    for (const SceneHit& hit : {hits[i], lent[i]}) {
      ASSERT_EQ(hit.instance, one.instance) << i;
      ASSERT_EQ(hit.part, one.part) << i;
      ASSERT_EQ(hit.primitive, one.primitive) << i;
    }
  }
  EXPECT_GT(some, 1000);
}

}  // namespace physim::collide_order_test
