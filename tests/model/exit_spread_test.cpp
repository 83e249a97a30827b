// Spread behind a material: its statistics, and that it depends on nothing but its numbers.
#include "model/exit_spread.hpp"

#include <set>

#include "support.hpp"

namespace physim::model_exit_spread_test {

using test::near;

TEST(ExitSpread, deviations_are_normal_in_two_planes_and_independent) {
  constexpr int kHits = 200000;
  double sum[4] = {}, squares[4] = {}, products[2] = {}, beyond = 0;
  for (std::uint32_t i = 0; i < kHits; ++i) {
    const HitNumbers n = hit_numbers(42, i / 7, i % 7);
    const double x[4] = {n.angle[0] * std::cos(n.about[0]), n.angle[0] * std::sin(n.about[0]),
                         n.angle[1] * std::cos(n.about[1]), n.angle[1] * std::sin(n.about[1])};
    for (int j = 0; j < 4; ++j) sum[j] += x[j], squares[j] += x[j] * x[j];
    products[0] += x[0] * x[1], products[1] += x[0] * x[2];
    beyond += std::abs(x[0]) > 1.959963985;
  }
  for (int j = 0; j < 4; ++j) {
    EXPECT_NEAR(sum[j] / kHits, 0, 0.01);
    EXPECT_NEAR(squares[j] / kHits, 1, 0.015);
  }
  for (const double p : products) EXPECT_NEAR(p / kHits, 0, 0.01);
  EXPECT_NEAR(beyond / kHits, 0.05, 0.002);
}

TEST(ExitSpread, each_hit_has_its_own_numbers_whatever_the_order) {
  std::set<double> seen;
  for (std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32})
    for (std::uint32_t projectile : {0u, 1u, 4000000000u})
      for (std::uint32_t hit : {0u, 1u, 7u}) {
        const HitNumbers n = hit_numbers(seed, projectile, hit);
        for (const double x : {n.angle[0], n.angle[1], n.about[0], n.about[1]}) EXPECT_TRUE(seen.insert(x).second);
      }
  EXPECT_EQ(hit_numbers(5, 6, 7).angle[0], hit_numbers(5, 6, 7).angle[0]);
}

TEST(ExitSpread, a_direction_is_turned_by_the_angle_and_stays_of_length_one) {
  for (const Vec3d& direction :
       {Vec3d{1, 0, 0}, Vec3d{0, -1, 0}, normalized(Vec3d{1, -2, 3}), normalized(Vec3d{1, 1, 1})})
    for (const double angle : {0.0, 1e-6, 0.1, 1.0})
      for (const double about : {0.0, 1.0, 4.0}) {
        const Vec3d turned = turned_off(direction, angle, about);
        EXPECT_NEAR(length(turned), 1, 1e-15);
        EXPECT_NEAR(length(turned - direction), 2 * std::sin(angle / 2), 1e-15);
      }
}

TEST(ExitSpread, turns_about_a_direction_are_spread_evenly) {
  const Vec3d d = normalized(Vec3d{0.2, 0.9, -0.4});
  const Vec3d first = turned_off(d, 0.3, 0) - d * std::cos(0.3), second = turned_off(d, 0.3, 1.2) - d * std::cos(0.3);
  EXPECT_NEAR(dot(first, second) / (length(first) * length(second)), std::cos(1.2), 1e-14);
  EXPECT_NEAR(dot(first, d), 0, 1e-15);
}

}  // namespace physim::model_exit_spread_test
