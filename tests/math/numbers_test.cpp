// Structures of numbers: runs, lanes and casts.
#include "math/numbers.hpp"

#include <gtest/gtest.h>

#include "physim/math.hpp"

namespace physim::math_numbers_test {

template <class R>
struct Five {
  Vec3<R> place;
  R mass;
  R list[1];
};
constexpr Five<double> kSample{{0.1, 0.2, 0.3}, 0.4, {0.5}};

TEST(Numbers, are_those_of_a_structure_in_order) {
  static_assert(kNumbers<Five> == 5);
  for (unsigned i = 0; i < 5; ++i) EXPECT_DOUBLE_EQ(numbers(kSample)[i], 0.1 * (i + 1.0)) << i;
}

TEST(NumberRuns, go_on_where_they_touch) {
  NumberRuns runs{};
  runs.add(0, 2);
  runs.add(2, 1);
  runs.add(4, 1);
  EXPECT_EQ(runs.count, 2u);
  EXPECT_EQ(runs.numbers(), 4u);
  unsigned sum = 0;
  runs.each([&](unsigned i) { sum += i; });
  EXPECT_EQ(sum, 0u + 1 + 2 + 4);
}

TEST(Numbers, move_lane_by_lane) {
  using P = Pack<float, 4>;
  Five<P> pack{}, other{};
  for (int lane = 0; lane < 4; ++lane) put_lane(kSample, pack, lane);
  set_lane(pack.mass, 2, 7.0f);
  copy_lane(pack, 2, other, 1);
  EXPECT_EQ(lane_of(other.mass, 1), 7.0f);
  EXPECT_EQ(lane_of(other.place.z, 1), 0.3f);
  EXPECT_EQ(lane_of(other.mass, 2), 0.0f);
  Five<float> alone{};
  NumberRuns mass{};
  mass.add(3, 1);
  copy_lane(pack, 2, alone, 0, mass);
  EXPECT_EQ(alone.mass, 7.0f);
  EXPECT_EQ(alone.place.x, 0.0f);
}

TEST(Numbers, are_cast_all_lanes_at_a_time) {
  Five<Pack<float, 4>> narrow{};
  for (int lane = 0; lane < 4; ++lane) put_lane(kSample, narrow, lane);
  Five<Pack<double, 4>> wide{};
  cast_numbers(narrow, wide);
  EXPECT_EQ(lane_of(wide.list[0], 3), 0.5);
  EXPECT_EQ(lane_of(wide.place.y, 0), double(0.2f));
}

}  // namespace physim::math_numbers_test
