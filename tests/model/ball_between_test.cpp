// A ball that two surfaces keep out, against closed forms of grooves and of a floor along a wall.
#include "model/ball_between.hpp"

#include "support.hpp"

namespace physim::model_ball_between_test {

using test::near;

constexpr Vec3d kGravity{0, -10, 0};
constexpr Ball kBall{0.1, 0.4};

/// A groove along x whose walls rise by an angle to both sides.
std::array<BallFace, 2> groove(double angle, const BallGrip& grip) {
  const double s = std::sin(angle), c = std::cos(angle);
  return {BallFace{{0, c, s}, {}, {}, grip}, BallFace{{0, c, -s}, {}, {}, grip}};
}

/// Both walls press with g / (2 cos b), so that a slide is braked by mu g / cos b; the ball rolls about the line
/// through both points of contact, r cos b below its middle: with v / (1 + k / cos^2 b), after k / cos^2 b of that.
TEST(BallBetween, a_slide_in_a_groove_ends_in_rolling) {
  for (const double angle : {0.1, 0.7, 1.4}) {
    const double c = std::cos(angle), k = 0.4 / (c * c), braked = 0.2 * 10 / c, rolls = 2 / (1 + k);
    const BallWay slide = moved_between({{2, 0, 0}, {}}, kGravity, groove(angle, {0.2, 0}), kBall, 0.05);
    EXPECT_TRUE(near(slide.motion.velocity, {2 - 0.05 * braked, 0, 0}, 1e-12)) << angle;
    EXPECT_TRUE(near(slide.way, {0.1 - 0.5 * 0.05 * 0.05 * braked, 0, 0}, 1e-12)) << angle;
    BallMotion motion{{2, 0, 0}, {}};
    for (int i = 0; i < 60; ++i)
      motion = moved_between(motion, kGravity, groove(angle, {0.2, 0}), kBall, 1.0 / 60).motion;
    EXPECT_TRUE(near(motion.velocity, {rolls, 0, 0}, 1e-9)) << angle;
    EXPECT_TRUE(near(motion.spin, {0, 0, -rolls / (0.1 * c)}, 1e-8)) << angle;
  }
}

TEST(BallBetween, nothing_stops_it_in_a_smooth_groove) {
  for (const double angle : {0.1, 0.8, 1.4, 1.55}) {
    const BallWay way = moved_between({{2, 0, 0}, {3, 4, 5}}, kGravity, groove(angle, {0, 0}), kBall, 1);
    EXPECT_TRUE(near(way.way, {2, 0, 0}, 1e-10)) << angle;
    EXPECT_EQ(way.motion.spin, (Vec3d{3, 4, 5})) << angle;
  }
}

/// In a corner of floor and wall, pressed to both, it rolls with 1 / (1 + 2 k) of its speed: about y and z alike.
TEST(BallBetween, on_a_floor_along_a_wall_it_rolls_on_both) {
  const std::array<BallFace, 2> corner{BallFace{{0, 1, 0}, {}, {}, {0.5, 0}}, BallFace{{0, 0, 1}, {}, {}, {0.5, 0}}};
  const BallWay way = moved_between({{1.8, 0, 0}, {}}, {0, -10, -10}, corner, kBall, 1);
  EXPECT_TRUE(near(way.motion.velocity, {1, 0, 0}, 1e-9));
  EXPECT_TRUE(near(way.motion.spin, {0, 10, -10}, 1e-8));
}

/// A wall that presses on nothing does not rub: the floor alone brakes, as in model/ball_rolling.hpp.
TEST(BallBetween, a_wall_that_is_only_grazed_takes_nothing) {
  const std::array<BallFace, 2> corner{BallFace{{0, 1, 0}, {}, {}, {0.3, 0}}, BallFace{{0, 0, 1}, {}, {}, {1, 0}}};
  const BallWay way = moved_between({{2, 0, 0}, {}}, kGravity, corner, kBall, 0.1);
  const BallWay alone = slid_or_rolled({{2, 0, 0}, {}}, kGravity, {0, 1, 0}, kBall, {0.3, 0}, 0.1);
  EXPECT_TRUE(near(way.motion.velocity, alone.motion.velocity, 1e-12));
  EXPECT_TRUE(near(way.motion.spin, alone.motion.spin, 1e-10));
  EXPECT_TRUE(near(way.way, alone.way, 1e-12));
}

/// A belt brings the ball to a smooth wall, where it turns with the belt.
TEST(BallBetween, a_belt_turns_it_at_a_wall) {
  const BallFace belt{{0, 1, 0}, {}, {1, 0, 0}, {0.5, 0}}, wall{{-1, 0, 0}, {}, {}, {0, 0}};
  const BallWay way = moved_between({}, kGravity, {belt, wall}, kBall, 2);
  EXPECT_LT(length(way.motion.velocity), 1e-12);
  EXPECT_TRUE(near(way.motion.spin, {0, 0, 10}, 1e-9));
}

/// Rolling resistance c brakes by c g / cos b over 1 + k / cos^2 b: the torques of both walls against the spin across
/// their normals add up to c g r.
TEST(BallBetween, resistance_slows_what_rolls) {
  const double c = std::cos(0.5), k = 0.4 / (c * c), rolls = 2 / (1 + k), braked = 0.02 * 10 / c / (1 + k);
  const BallMotion rolling{{rolls, 0, 0}, {0, 0, -rolls / (0.1 * c)}};
  const BallWay way = moved_between(rolling, kGravity, groove(0.5, {1, 0.02}), kBall, 0.5);
  EXPECT_NEAR(way.motion.velocity.x, rolls - 0.5 * braked, 0.03 * braked);
}

}  // namespace physim::model_ball_between_test
