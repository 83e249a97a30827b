// Balls on a surface: sliding until they roll, in one piece and as long as the closed form says.
#include "model/ball_rolling.hpp"

#include "support.hpp"

namespace physim::model_ball_rolling_test {

using test::near;

constexpr Vec3d kUp{0, 1, 0}, kGravity{0, -10, 0};

/// A ball that is thrown along a floor without spin rolls after v k / (mu g (1 + k)), at v / (1 + k): 2 v / 7 mu g and
/// 5 v / 7 for a solid one (Kleppner and Kolenkow, ch. 7).
TEST(BallRolling, a_slide_ends_where_the_closed_form_says) {
  for (const double k : {0.4, 2.0 / 3}) {
    const BallGrip grip{0.3, 0};
    const double v = 5, ends = v * k / (0.3 * 10 * (1 + k)), rolls = v / (1 + k);
    const BallWay slide = slid_or_rolled({{v, 0, 0}, {}}, kGravity, kUp, {0.1, k}, grip, 10);
    EXPECT_NEAR(slide.time, ends, 1e-14);
    EXPECT_TRUE(near(slide.motion.velocity, {rolls, 0, 0}, 1e-14));
    EXPECT_TRUE(near(slide.motion.spin, {0, 0, -rolls / 0.1}, 1e-12));
    EXPECT_TRUE(near(slide.way, {0.5 * (v + rolls) * ends, 0, 0}, 1e-14));
    const BallWay part = slid_or_rolled({{v, 0, 0}, {}}, kGravity, kUp, {0.1, k}, grip, 0.1);
    EXPECT_EQ(part.time, 0.1);
    EXPECT_TRUE(near(part.motion.velocity, {v - 0.3, 0, 0}, 1e-14));
    const BallWay roll = slid_or_rolled(slide.motion, kGravity, kUp, {0.1, k}, grip, 2);
    EXPECT_EQ(roll.time, 2);
    EXPECT_TRUE(near(roll.way, {2 * rolls, 0, 0}, 1e-12));
  }
}

/// On a slope that grips a solid ball rolls with 5/7 of what pulls it; where it slips, with what friction leaves.
TEST(BallRolling, on_a_slope_it_rolls_or_slides) {
  const Vec3d down{6, -8, 0};  // gravity, as seen from a slope whose normal is up
  const BallWay rolls = slid_or_rolled({}, down, kUp, {0.1, 0.4}, {1, 0}, 1);
  EXPECT_TRUE(near(rolls.motion.velocity, {6 * 5.0 / 7, 0, 0}, 1e-14));
  const BallWay slides = slid_or_rolled({}, down, kUp, {0.1, 0.4}, {0.1, 0}, 1);
  EXPECT_TRUE(near(slides.motion.velocity, {6 - 0.8, 0, 0}, 1e-14));
  EXPECT_TRUE(near(slides.motion.spin, {0, 0, -0.8 / (0.4 * 0.1)}, 1e-12));
}

/// What cannot turn slides to rest after v / (mu g), and then friction holds it; about z alone it rolls along x.
TEST(BallRolling, what_cannot_turn_slides_to_rest) {
  const Ball stiff{0.1, 0.4, {0.0, 0.0, 0.0}}, wheel{0.1, 0.4, {0.0, 0.0, 1.0}};
  const BallGrip grip{0.3, 0};
  const BallWay slide = slid_or_rolled({{3, 0, 4}, {}}, kGravity, kUp, stiff, grip, 10);
  EXPECT_NEAR(slide.time, 5 / 3.0, 1e-14);
  EXPECT_TRUE(near(slide.way, {2.5, 0, 2.5 / 3 * 4}, 1e-14));
  EXPECT_LT(length(slide.motion.velocity), 1e-14);
  EXPECT_EQ(slide.motion.spin, Vec3d{});
  const BallWay held = slid_or_rolled({}, Vec3d{2.9, -10, 0}, kUp, stiff, grip, 1);
  EXPECT_EQ(held.way, Vec3d{});
  EXPECT_TRUE(near(slid_or_rolled({}, Vec3d{3.1, -10, 0}, kUp, stiff, grip, 1).motion.velocity, {0.1, 0, 0}, 1e-14));
  EXPECT_TRUE(near(slid_or_rolled({}, Vec3d{2.8, -10, 0}, kUp, wheel, grip, 1).motion.velocity, {2, 0, 0}, 1e-14));
  EXPECT_LT(length(slid_or_rolled({}, Vec3d{0, -10, 2.8}, kUp, wheel, grip, 1).motion.velocity), 1e-14);
}

/// A point against friction on a slope: up for v / (a + f), and back with a - f.
TEST(BallRolling, a_point_that_turns_around_stops_first) {
  const Surface rough{0, 0.3, 0};
  const Rolled on = rolled({5, 0, 0}, Vec3d{-7, -10, 0}, kUp, rough, 1);
  const double up = 5 / 10.0, back = 1 - up;
  EXPECT_NEAR(on.way.x, 0.5 * 5 * up - 0.5 * 4 * back * back, 1e-14);
  EXPECT_NEAR(on.velocity.x, -4 * back, 1e-14);
  const Rolled stays = rolled({5, 0, 0}, Vec3d{-2, -10, 0}, kUp, rough, 3);
  EXPECT_NEAR(stays.way.x, 2.5, 1e-14);
  EXPECT_EQ(stays.velocity, Vec3d{});
}

/// Where nothing rubs, a slip that passes through zero ends nothing; one that is rounding rolls.
TEST(BallRolling, a_slip_ends_a_way_only_where_something_rubs) {
  const Ball ball{0.1, 0.4};
  const Vec3d a{-0.5, -10, 0};
  const BallWay smooth = slid_or_rolled({{1e-8, 0, 0}, {}}, a, kUp, ball, {0, 0}, 1);
  EXPECT_EQ(smooth.time, 1);
  EXPECT_NEAR(smooth.motion.velocity.x, -0.5, 1e-7);
  EXPECT_LT(slid_or_rolled({{1e-8, 0, 0}, {}}, a, kUp, ball, {1, 0}, 1).time, 1e-8);
  EXPECT_EQ(slid_or_rolled({{1e-8, 0, 0}, {}}, a, kUp, ball, {1, 0, 1e-7}, 1).time, 1);
}

}  // namespace physim::model_ball_rolling_test
