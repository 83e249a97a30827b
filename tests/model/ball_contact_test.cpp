// Bounces of balls that spin: the closed forms of Garwin and Cross, what is kept, and what never grows.
#include "model/ball_contact.hpp"

#include <random>

#include "model/contact.hpp"
#include "support.hpp"

namespace physim::model_ball_contact_test {

using test::near;

constexpr Vec3d kUp{0, 1, 0}, kDown{0, -1, 0};
constexpr double kSolid = 0.4, kHollow = 2.0 / 3;

TEST(BallContact, without_friction_nothing_but_the_normal_speed_changes) {
  const BallMotion after = bounced({{5, -3, 1}, {7, 8, 9}}, kUp, {0.1, kSolid}, {0.8, 0, 1});
  EXPECT_TRUE(near(after.velocity, {5, 2.4, 1}, 1e-15));
  EXPECT_EQ(after.spin, (Vec3d{7, 8, 9}));
}

TEST(BallContact, straight_down_without_spin_comes_straight_up) {
  const BallMotion after = bounced({{0, -4, 0}, {}}, kUp, {0.1, kSolid}, {0.5, 0.7, 1});
  EXPECT_EQ(after.velocity, (Vec3d{0, 2, 0}));
  EXPECT_EQ(after.spin, (Vec3d{}));
}

TEST(BallContact, spin_about_the_normal_is_left_alone) {
  const BallMotion after = bounced({{0, -4, 0}, {0, 50, 0}}, kUp, {0.1, kSolid}, {0.5, 0.7, 0});
  EXPECT_EQ(after.velocity, (Vec3d{0, 2, 0}));
  EXPECT_EQ(after.spin, (Vec3d{0, 50, 0}));
}

// A ball that grips and does not spring back rolls: Brody's 5/7 of a solid ball, 3/5 of a hollow one.
TEST(BallContact, gripping_leaves_a_rolling_ball) {
  constexpr double radius = 0.033;
  for (const auto& [inertia, kept] : {std::pair(kSolid, 5.0 / 7), std::pair(kHollow, 3.0 / 5)}) {
    const BallMotion after = bounced({{3, -9, 0}, {}}, kUp, {radius, inertia}, {0.7, 0.9, 0});
    EXPECT_TRUE(near(after.velocity, {3 * kept, 6.3, 0}, 1e-15));
    EXPECT_TRUE(near(after.spin, {0, 0, -3 * kept / radius}, 1e-14)) << "rolls forwards: clockwise seen from z";
  }
}

// The impulse of friction is mu times that of the normal, whatever the slip.
TEST(BallContact, sliding_takes_a_part_of_the_normal_impulse) {
  constexpr double radius = 0.02, friction = 0.1, restitution = 0.6;
  const double impulse = friction * (1 + restitution) * 2;
  for (const double forwards : {5.0, 50.0}) {
    const BallMotion after = bounced({{forwards, -2, 0}, {}}, kUp, {radius, kHollow}, {restitution, friction, 0.5});
    EXPECT_TRUE(near(after.velocity, {forwards - impulse, 1.2, 0}, 1e-15));
    EXPECT_TRUE(near(after.spin, {0, 0, -impulse / (kHollow * radius)}, 1e-14));
  }
}

TEST(BallContact, sliding_ends_where_gripping_begins) {
  // Slip over normal speed at which both impulses agree: mu (1 + e) (1 + 1 / k) / (1 + g).
  constexpr double friction = 0.3, restitution = 0.7, grip = 0.2;
  const double border = friction * (1 + restitution) * (1 + 1 / kSolid) / (1 + grip);
  const auto slip_after = [&](double ratio) {
    const BallMotion after = bounced({{ratio, -1, 0}, {}}, kUp, {1, kSolid}, {restitution, friction, grip});
    return (after.velocity.x + after.spin.z) / ratio;
  };
  EXPECT_NEAR(slip_after(border * 0.5), -grip, 1e-15);
  EXPECT_NEAR(slip_after(border), -grip, 1e-14);
  EXPECT_GT(slip_after(border * 1.1), -grip + 0.05);
  EXPECT_GT(slip_after(border * 100), 0.98);
}

TEST(BallContact, topspin_speeds_up_and_backspin_turns_around) {
  const Ball ball{0.0335, kHollow};
  const BallSurface court{0.75, 0.6, 0};
  const double rolling = 10 / ball.radius;  // spin without slip at 10 m/s; topspin is clockwise seen from z
  EXPECT_GT(bounced({{10, -8, 0}, {0, 0, -1.5 * rolling}}, kUp, ball, court).velocity.x, 10.5);
  EXPECT_NEAR(bounced({{10, -8, 0}, {0, 0, -rolling}}, kUp, ball, court).velocity.x, 10, 1e-13);
  EXPECT_LT(bounced({{10, -8, 0}, {0, 0, 3 * rolling}}, kUp, ball, court).velocity.x, 2);
  EXPECT_LT(bounced({{1, -8, 0}, {0, 0, 3 * rolling}}, kUp, ball, court).velocity.x, -3);
}

// Garwin 1969: a solid superball takes (v, r w) to ((3 v - 4 r w) / 7, (-10 v - 3 r w) / 7), and comes back from
// under a table, after floor, table and floor, with 333/343 of its speed along them.
TEST(BallContact, a_superball_comes_back_from_under_a_table) {
  const Ball ball{0.025, kSolid};
  const BallSurface rough{1, 10, 1};
  BallMotion motion{{4, -6, 0}, {}};
  motion = bounced(motion, kUp, ball, rough);
  EXPECT_TRUE(near(motion.velocity, {4 * 3.0 / 7, 6, 0}, 1e-14));
  EXPECT_TRUE(near(motion.spin, {0, 0, -4 * (10.0 / 7) / ball.radius}, 1e-14));
  motion = bounced(motion, kDown, ball, rough);
  EXPECT_TRUE(near(motion.velocity, {-4 * 31.0 / 49, -6, 0}, 1e-14));
  motion = bounced(motion, kUp, ball, rough);
  EXPECT_TRUE(near(motion.velocity, {-4 * 333.0 / 343, 6, 0}, 1e-14));
}

// Cross 2002, tables I and II: a superball of 46 mm met a block with 2.69 m/s at 36 degrees, kept 0.59 of its speed
// along it and 0.91 across it, and left with 98.4 rad/s; errors of 2 to 3 %. The grip follows from 0.59, the spin from
// it.
TEST(BallContact, the_spin_of_a_superball_is_what_cross_measured) {
  const double along = 2.69 * std::cos(36 * test::kDegree), across = 2.69 * std::sin(36 * test::kDegree);
  const double grip = (1 - 0.59) * (1 + kSolid) / kSolid - 1;
  const BallMotion after = bounced({{along, -across, 0}, {}}, kUp, {0.023, kSolid}, {0.91, 10, grip});
  EXPECT_NEAR(after.velocity.x / along, 0.59, 1e-14);
  EXPECT_NEAR(after.velocity.y / across, 0.91, 1e-14);
  EXPECT_NEAR(-after.spin.z, 98.4, 0.03 * 98.4);
}

Vec3d random_vector(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(random), uniform(random), uniform(random)};
}

TEST(BallContact, energy_never_grows_and_angular_momentum_about_the_contact_is_kept) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const Vec3d normal = normalized(random_vector(random, 1));
    const Ball ball{0.01 + unit(random), 0.1 + unit(random)};
    const BallSurface surface{unit(random), 2 * unit(random), unit(random)};
    BallMotion before{random_vector(random, 100), random_vector(random, 300)};
    if (dot(before.velocity, normal) > 0) before.velocity = -before.velocity;
    const BallMotion after = bounced(before, normal, ball, surface);
    const auto energy = [&](const BallMotion& m) {
      return length_squared(m.velocity) + ball.inertia * ball.radius * ball.radius * length_squared(m.spin);
    };
    const auto momentum = [&](const BallMotion& m) {
      return cross(normal * ball.radius, m.velocity) + m.spin * (ball.inertia * ball.radius * ball.radius);
    };
    EXPECT_LE(energy(after), energy(before) * (1 + 1e-13));
    EXPECT_TRUE(near(momentum(after), momentum(before), 1e-12));
    EXPECT_TRUE(near(dot(after.velocity, normal), -surface.restitution * dot(before.velocity, normal), 1e-9, 1e-12));
  }
}

TEST(BallContact, a_rough_elastic_ball_keeps_its_energy) {
  std::mt19937_64 random(18);
  for (int i = 0; i < 1000; ++i) {
    BallMotion motion{random_vector(random, 10), random_vector(random, 100)};
    motion.velocity.y = -std::abs(motion.velocity.y);
    const auto energy = [](const BallMotion& m) {
      return length_squared(m.velocity) + kSolid * 0.0025 * length_squared(m.spin);
    };
    EXPECT_TRUE(near(energy(bounced(motion, kUp, {0.05, kSolid}, {1, 1e9, 1})), energy(motion), 1e-12));
  }
}

TEST(BallContact, a_ball_that_nothing_spins_is_the_point_of_the_ground) {
  std::mt19937_64 random(19);
  for (int i = 0; i < 1000; ++i) {
    Vec3d v = random_vector(random, 10);
    v.y = -std::abs(v.y);
    const BallMotion ball = bounced({v, {}}, kUp, {1, 1e12}, {0.6, 0.3, 0});
    EXPECT_TRUE(near(ball.velocity, bounced(v, kUp, Surface{0.6, 0.3, 0}), 1e-11));
  }
}

}  // namespace physim::model_ball_contact_test
