// Touches of two on curved paths, against a search that steps along them.
#include "collide/pair_path.hpp"
#include "must.hpp"

#include <random>
#include <vector>

namespace physim::collide::collide_pair_path_test {

/// The cubic of a leg by Hermite's own polynomials.
Vec3d place(const Leg& leg, double time) {
  const double h = leg.end.time - leg.begin.time, s = (time - leg.begin.time) / h;
  const double s2 = s * s, s3 = s2 * s;
  return leg.begin.x * (2 * s3 - 3 * s2 + 1) + leg.begin.v * (h * (s3 - 2 * s2 + s)) + leg.end.x * (3 * s2 - 2 * s3) +
         leg.end.v * (h * (s3 - s2));
}

class PairPaths : public testing::Test {
 protected:
  std::mt19937_64 random{11};
  std::uniform_real_distribution<double> unit{-1, 1};
  Vec3d any(double size) { return Vec3d{unit(random), unit(random), unit(random)} * size; }
};

TEST_F(PairPaths, legs_are_hermites_cubics) {
  for (int i = 0; i < 200; ++i) {
    const Leg leg{{0.5, any(10), any(40)}, {0.75, any(10), any(40)}};
    for (const double t : {0.5, 0.51, 0.6, 0.7, 0.75}) {
      EXPECT_LT(length(leg.at(t).x - place(leg, t)), 1e-13);
      if (t < 0.51 || t > 0.74) continue;
      const Vec3d slope = (place(leg, t + 1e-5) - place(leg, t - 1e-5)) * (1 / 2e-5);
      EXPECT_LT(length(leg.at(t).v - slope), 1e-5);
    }
  }
}

TEST_F(PairPaths, the_first_touch_is_found_on_paths_that_bend) {
  int met = 0, missed = 0;
  for (int i = 0; i < 1600; ++i) {
    const double dt = 0.25, bend = i % 4 == 0 ? 0 : std::pow(10, unit(random));
    const Vec3d x = any(2), y = any(2), w = any(20), v = w + (y - x + any(0.8)) * (1 / 0.15);
    const auto turned = [&](const Vec3d& speed) { return speed + any(20 * bend); };
    const std::vector<Knot> a{{0, x, v}, {dt, x + (v + any(bend)) * dt, turned(v)}};
    const std::vector<Knot> b{
        {0, y, w}, {0.1, y + (w + any(bend)) * 0.1, turned(w)}, {dt, y + w * dt + any(bend), turned(w)}};
    const double radius = 0.4;
    const auto gap = [&](double t) {
      const Leg on_b = t < 0.1 ? Leg{b[0], b[1]} : Leg{b[1], b[2]};
      return length(place({a[0], a[1]}, t) - place(on_b, t)) - radius;
    };
    if (gap(0) < 0) continue;
    // Steps so short that only what barely touches is stepped over.
    double expected = -1, nearest = 1e9;
    constexpr int kSteps = 5000;
    for (int k = 1; k <= kSteps && expected < 0; ++k) {
      const double t = dt * k / kSteps;
      nearest = std::min(nearest, gap(t));
      if (gap(t) > 0) continue;
      double low = dt * (k - 1) / kSteps, high = t;
      for (int halving = 0; halving < 60; ++halving) (gap(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
      expected = high;
    }
    const auto found = first_touch(a, b, radius, Touch::comes_near, 0);
    if (expected < 0) {
      ++missed;
      if (nearest > 1e-4) {
        EXPECT_FALSE(found) << nearest;
      }
      continue;
    }
    ++met;
    ASSERT_TRUE(found);
    EXPECT_NEAR(gap(*found), 0, 1e-11);
    EXPECT_LE(*found, expected + 1e-10);
    if (*found > expected - 1e-4) continue;
    EXPECT_GT(nearest, -1e-4) << "an earlier touch that steps went over is a grazing one";
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(missed, 300);
}

TEST_F(PairPaths, whoever_is_inside_is_seen_coming_out) {
  for (int i = 0; i < 500; ++i) {
    const Vec3d v = any(30), w = any(30);
    if (length(v - w) < 8) continue;
    const Vec3d x = any(0.2);
    const std::vector<Knot> a{{0, x, v}, {0.25, x + v * 0.25, v}}, b{{0, {}, w}, {0.25, w * 0.25, w}};
    const auto out = must(first_touch(a, b, 1, Touch::goes_away, 0));
    EXPECT_NEAR(length(x + (v - w) * out), 1, 1e-12);
    EXPECT_FALSE(first_touch(a, b, 1, Touch::goes_away, out + 1e-9) > out + 2e-9);
  }
}

TEST_F(PairPaths, far_from_the_origin_the_search_ends) {
  const Vec3d far{4e6, -3e6, 5e6};
  const std::vector<Knot> a{{0, far, {50, -3, 0}}, {1, far + Vec3d{50, -8, 0}, {50, -13, 0}}};
  const std::vector<Knot> b{{0, far + Vec3d{40, -2, 0}, {-50, 1, 0}}, {1, far + Vec3d{-10, -1, 0}, {-50, 0, 0}}};
  const auto found = must(first_touch(a, b, 1, Touch::comes_near, 0));
  const Leg one = leg_of(a, 0), other = leg_of(b, 0);
  EXPECT_NEAR(length(one.at(found).x - other.at(found).x), 1, 1e-8);
}

/// One flies around another one at just the distance at which they touch: no piece of the way is for sure too far.
TEST_F(PairPaths, along_each_other_the_search_ends) {
  const double radius = 1, turn = 1.5;
  const auto on_circle = [&](double t, double r) {
    const double a = turn * t;
    return Knot{t, {r * std::cos(a), r * std::sin(a), 0}, {-r * turn * std::sin(a), r * turn * std::cos(a), 0}};
  };
  const std::vector<Knot> rests{{0, {}, {}}, {1, {}, {}}};
  std::vector<Knot> around, wider;
  for (int i = 0; i <= 64; ++i)
    around.push_back(on_circle(i / 64.0, radius)), wider.push_back(on_circle(i / 64.0, 1.1));
  EXPECT_TRUE(first_touch(around, rests, radius * (1 + 1e-6), Touch::comes_near, 0));
  EXPECT_FALSE(first_touch(wider, rests, radius, Touch::comes_near, 0));
  // A cubic lies inside of the circle by 1e-12 of it here, so it may touch or not.
  static_cast<void>(first_touch(around, rests, radius * (1 - 2e-12), Touch::comes_near, 0));
  static_cast<void>(first_touch(around, rests, radius * (1 + 2e-12), Touch::goes_away, 0));
}

TEST_F(PairPaths, wild_ones_and_those_without_numbers_end) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Knot> rests{{0, {}, {}}, {1, {}, {}}};
  for (const double wild : {1e20, 1e160, 1e300, std::numeric_limits<double>::infinity(), nan})
    for (const bool by_place : {false, true}) {
      const Knot end{1, by_place ? Vec3d{wild, 0, 0} : Vec3d{2, 0, 0}, by_place ? Vec3d{} : Vec3d{-wild, wild, 0}};
      const std::vector<Knot> path{{0, {3, 0, 0}, {1, 2, 3}}, end};
      for (const Touch touch : {Touch::comes_near, Touch::goes_away})
        static_cast<void>(first_touch(path, rests, 1, touch, 0));
    }
  const std::vector<Knot> none{{0, {3, 0, 0}, {nan, 0, 0}}, {1, {2, 0, 0}, {}}};
  EXPECT_FALSE(first_touch(none, rests, 1, Touch::comes_near, 0)) << "and meet nothing";
}

/// Where one of two is so far away that its numbers are rounded by more than both are large, nobody knows when they
/// touch: what is left of the distance is below 0.
TEST_F(PairPaths, nothing_comes_nearer_than_no_distance) {
  const std::vector<Knot> rests{{0, {}, {}}, {1, {}, {}}},
      comes{{0, {2, 0, 0}, {-4, 0, 0}}, {1, {-2, 0, 0}, {-4, 0, 0}}};
  for (const double distance : {0.0, -1.0, -400.0})
    EXPECT_FALSE(first_touch(comes, rests, distance, Touch::comes_near, 0)) << distance;
}

}  // namespace physim::collide::collide_pair_path_test
