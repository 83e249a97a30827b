// The line of sight: directions, cant, look angle, and what range, drop and windage mean.
#include "model/sight.hpp"

#include "support.hpp"

namespace physim::model_sight_test {

using test::kDegree;
using test::near;

Vec3d launch_velocity(const Launch& launch, double elevation) {
  return physim::launch_velocity(launch, sight_frame(launch), elevation);
}

TEST(Sight, frame_is_orthonormal_and_right_handed) {
  for (const double azimuth : {-2.0, 0.0, 0.4, 3.0})
    for (const double look : {-0.6, 0.0, 1.2})
      for (const double cant : {-0.5, 0.0, 2.0}) {
        Launch launch{.azimuth = azimuth, .sight = {.height = 0.05, .look_angle = look, .cant = cant}};
        const SightFrame s = sight_frame(launch);
        EXPECT_NEAR(length(s.forward), 1, 1e-15);
        EXPECT_NEAR(length(s.right), 1, 1e-15);
        EXPECT_TRUE(near(cross(s.right, s.forward), s.up, 1e-15));
        EXPECT_NEAR(dot(s.forward, s.right), 0, 1e-15);
        EXPECT_EQ(s.right.y, 0) << "right is horizontal";
        EXPECT_GT(s.up.y, 0);
        EXPECT_NEAR(s.forward.y, std::sin(look), 1e-15);
        EXPECT_NEAR(length(s.start - s.muzzle), 0.05, 1e-15);
      }
}

TEST(Sight, x_is_downrange_y_up_z_right) {
  const SightFrame s = sight_frame({});
  EXPECT_EQ(s.forward, (Vec3d{1, 0, 0}));
  EXPECT_EQ(s.up, (Vec3d{0, 1, 0}));
  EXPECT_EQ(s.right, (Vec3d{0, 0, 1}));
}

TEST(Sight, launch_velocity_has_the_given_speed_elevation_and_azimuth) {
  for (const double elevation : {-0.3, 0.0, 0.8, 1.5707963267948966})
    for (const double azimuth : {0.0, 0.7, -2.5}) {
      const Vec3d v = launch_velocity({.speed = 300, .azimuth = azimuth}, elevation);
      const Vec3d expected{300 * std::cos(elevation) * std::cos(azimuth), 300 * std::sin(elevation),
                           300 * std::cos(elevation) * std::sin(azimuth)};
      EXPECT_TRUE(near(v, expected, 1e-14)) << elevation << ' ' << azimuth;
    }
}

TEST(Sight, the_look_angle_does_not_change_where_an_upright_bore_points) {
  const Vec3d level = launch_velocity({.speed = 300, .azimuth = 0.3}, 0.5);
  const Vec3d uphill = launch_velocity({.speed = 300, .azimuth = 0.3, .sight = {.look_angle = 0.4}}, 0.5);
  EXPECT_TRUE(near(uphill, level, 1e-14));
}

TEST(Sight, cant_swings_the_bore_to_its_side) {
  // Rolled by 90 degrees clockwise, an elevation over the line of sight points right instead of up.
  const Launch canted{.speed = 100, .sight = {.cant = 90 * kDegree}};
  EXPECT_TRUE(near(launch_velocity(canted, 0.01), {100 * std::cos(0.01), 0, 100 * std::sin(0.01)}, 1e-14));
  // Any cant keeps the angle between bore and line of sight.
  for (const double cant : {-1.0, 0.3, 2.5}) {
    const Launch launch{.speed = 1, .azimuth = 0.4, .sight = {.look_angle = 0.2, .cant = cant}};
    EXPECT_NEAR(dot(launch_velocity(launch, 0.26), sight_frame(launch).forward), std::cos(0.06), 1e-14);
  }
}

TEST(Sight, a_given_velocity_sets_the_plane_of_fire) {
  Launch launch{.velocity = Vec3d{-30, 40, 30}};
  EXPECT_EQ(launch_velocity(launch, 0.9), (Vec3d{-30, 40, 30}));
  const SightFrame s = sight_frame(launch);
  EXPECT_TRUE(near(s.forward, {-std::sqrt(0.5), 0, std::sqrt(0.5)}, 1e-15));
  launch.velocity = Vec3d{0, 10, 0};  // straight up: the azimuth decides
  launch.azimuth = 1;
  EXPECT_TRUE(near(sight_frame(launch).forward, {std::cos(1), 0, std::sin(1)}, 1e-15));
}

TEST(Sight, range_drop_and_windage_are_coordinates_along_the_sight) {
  const Launch launch{.position = {5, 2, -1},
                      .speed = 200,
                      .elevation = 0.5,
                      .azimuth = 0.3,
                      .sight = {.height = 0.06, .look_angle = 0.35, .cant = 0.2}};
  Environment e = test::constant_gravity();
  const Flight flight = fly({}, launch, e, test::vacuum());
  const SightFrame frame = sight_frame(launch);
  for (const double t : {0.0, 1.0, 5.0}) {
    const Sample s = flight.at(t);
    const Vec3d again = frame.start + frame.forward * s.range + frame.up * s.drop + frame.right * s.windage;
    // Range starts at the muzzle, drop and windage at the sight: both lie in the plane across the sight.
    EXPECT_TRUE(near(again, s.position, 1e-13)) << t;
  }
  const Sample muzzle = flight.at(0);
  EXPECT_NEAR(muzzle.range, 0, 1e-15);
  EXPECT_NEAR(muzzle.drop, -0.06 * std::cos(0.2), 1e-15);
  EXPECT_NEAR(muzzle.windage, -0.06 * std::sin(0.2), 1e-15);
}

}  // namespace physim::model_sight_test
