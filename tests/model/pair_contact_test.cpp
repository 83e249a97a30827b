// Contacts of two balls: closed forms, and what must stay.
#include "model/pair_contact.hpp"

#include <gtest/gtest.h>

#include <random>

#include "model/ball_contact.hpp"

namespace physim::model_pair_contact_test {

PairBody ball(double mass, double radius, double k, const Vec3d& v, const Vec3d& w = {}) {
  const double m = 1 / mass;
  return {v, w, {m, m, m}, radius, 1 / (k * mass * radius * radius)};
}

void meet(PairBody& a, PairBody& b, const Vec3d& normal, const PairSurface& surface) {
  const PairTouch touch{a, b, normal, surface};
  physim::meet({&touch, 1});
}

TEST(PairContact, central_impulse_follows_the_closed_form) {
  PairBody a = ball(2, 0.1, 0.4, {3, 0, 0}), b = ball(5, 0.2, 0.4, {-1, 0, 0});
  meet(a, b, {-1, 0, 0}, {0.7, 0.5});
  EXPECT_NEAR(a.velocity.x, (2 * 3 - 5 * 1 - 5 * 0.7 * 4) / 7.0, 1e-14);
  EXPECT_NEAR(b.velocity.x, (2 * 3 - 5 * 1 + 2 * 0.7 * 4) / 7.0, 1e-14);
  EXPECT_EQ(a.spin, Vec3d{});
}

TEST(PairContact, what_nothing_moves_is_a_wall) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
  for (int i = 0; i < 1000; ++i) {
    const Vec3d n = normalized(any());
    Vec3d v = any() * 10;
    if (dot(v, n) > 0) v = -v;
    const Vec3d w = any() * 50;
    const double mu = 0.5 * (1 + unit(random)), e = 0.5 * (1 + unit(random));
    PairBody a = ball(0.3, 0.07, 0.55, v, w), wall{{}, {}, {}, 0.5, 0};
    meet(a, wall, n, {e, mu});
    const BallMotion expected = bounced(BallMotion{v, w}, n, Ball{0.07, 0.55}, BallSurface{e, mu, 0});
    EXPECT_LT(length(a.velocity - expected.velocity), 1e-13);
    EXPECT_LT(length(a.spin - expected.spin), 1e-11);
    EXPECT_EQ(wall.velocity, Vec3d{});
    EXPECT_EQ(wall.spin, Vec3d{});
  }
}

TEST(PairContact, momentum_stays_and_energy_follows_restitution) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
  for (int i = 0; i < 1000; ++i) {
    const double m[] = {2 + unit(random), 2 + unit(random)}, r[] = {2 + unit(random), 2 + unit(random)};
    const double mu = i % 2 == 0 ? 0 : 1 + unit(random), e = 0.5 * (1 + unit(random));
    const Vec3d n = normalized(any());
    PairBody a = ball(m[0], r[0], 0.4, any(), any()), b = ball(m[1], r[1], 0.6, any(), any());
    if (dot(a.velocity - b.velocity, n) > 0) std::swap(a.velocity, b.velocity);
    const auto momentum = [&] { return a.velocity * m[0] + b.velocity * m[1]; };
    const auto turning = [&] {  // about the point where they touch
      return a.spin * (1 / a.turnability) + b.spin * (1 / b.turnability) + cross(n * r[0], a.velocity) * m[0] -
             cross(n * r[1], b.velocity) * m[1];
    };
    const auto energy = [&] {
      return 0.5 * (m[0] * length_squared(a.velocity) + m[1] * length_squared(b.velocity) +
                    length_squared(a.spin) / a.turnability + length_squared(b.spin) / b.turnability);
    };
    const Vec3d p = momentum(), l = turning();
    const double before = energy(), v_n = dot(a.velocity - b.velocity, n);
    meet(a, b, n, {e, mu});
    EXPECT_LT(length(momentum() - p), 1e-14 * 10);
    EXPECT_LT(length(turning() - l), 1e-13 * 10);
    EXPECT_NEAR(dot(a.velocity - b.velocity, n), -e * v_n, 1e-14 * 10);
    const double reduced = m[0] * m[1] / (m[0] + m[1]), lost = 0.5 * reduced * (1 - e * e) * v_n * v_n;
    if (mu == 0)
      EXPECT_NEAR(before - energy(), lost, 1e-13 * 10);
    else
      EXPECT_GE(before - energy(), lost - 1e-13 * 10);
  }
}

/// A ball that meets two to five others at one moment, with spin and friction: Newton's restitution alone would give
/// some of them energy (T. R. Kane, 1984).
TEST(PairContact, many_at_one_moment_gain_no_energy) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return Vec3d{unit(random), unit(random), unit(random)}; };
  for (int i = 0; i < 20000; ++i) {
    std::vector<PairBody> balls;
    for (int k = 0; k < 3 + i % 4; ++k)
      balls.push_back(ball(std::pow(10, unit(random)), 0.5, 0.4, any() * 5, any() * 20));
    std::vector<PairTouch> touches;
    for (std::size_t k = 1; k < balls.size(); ++k) {
      Vec3d n = normalized(any());
      if (dot(balls[0].velocity - balls[k].velocity, n) > 0) n = -n;
      touches.push_back({balls[0], balls[k], n, {0.5 * (1 + unit(random)), i % 3 == 0 ? 0 : 1 + unit(random)}});
    }
    Vec3d momentum;
    double energy = 0;
    const auto add = [&](double sign) {
      for (const PairBody& b : balls) {
        momentum += b.velocity * (sign / b.mobility.x);
        energy += 0.5 * sign * (length_squared(b.velocity) / b.mobility.x + length_squared(b.spin) / b.turnability);
      }
    };
    add(-1);
    const double before = -energy;
    physim::meet(touches);
    add(1);
    EXPECT_LT(energy, 1e-12 * before) << i;
    EXPECT_LT(length(momentum), 1e-12 * before) << i;
    for (const PairTouch& t : touches) EXPECT_GT(dot(t.a.velocity - t.b.velocity, t.normal), -1e-9) << i;
  }
}

/// Two equal balls of billiards, thrown: the object ball is thrown off its line by friction, up to its coefficient, and
/// no farther than slip allows: 2/7 of the slip is shared by both (R. Cross, Am. J. Phys. 70, 1093).
TEST(PairContact, throw_of_billiards) {
  const Vec3d n{-1, 0, 0};  // from b to a
  for (const double across : {0.05, 0.5, 2.0}) {
    PairBody a = ball(0.17, 0.0286, 0.4, {1, across, 0}), b = ball(0.17, 0.0286, 0.4, {});
    meet(a, b, n, {1, 0.06});
    EXPECT_NEAR(b.velocity.x, 1, 1e-14);
    EXPECT_NEAR(b.velocity.y, std::min(0.06 * 1, across / 7), 1e-14);
  }
}

TEST(PairContact, frozen_axes_take_no_impulse) {
  PairBody a = ball(1, 0.1, 0.4, {1, 0, 0}), b = ball(1, 0.1, 0.4, {});
  a.mobility.y = 0;
  const Vec3d n = normalized(Vec3d{-1, 0.5, 0});
  meet(a, b, n, {1, 0});
  EXPECT_EQ(a.velocity.y, 0);
  EXPECT_NEAR(length_squared(a.velocity) + length_squared(b.velocity), 1, 1e-14);
}

}  // namespace physim::model_pair_contact_test
