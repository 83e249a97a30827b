// Wind: constant, and profiles by height and by range.
#include "model/wind.hpp"

#include "support.hpp"

namespace physim::model_wind_test {

using test::near;

Wind profile(WindAxis by, WindInterpolation interpolation) {
  return {.profile = {{-10, {1, 0, 0}}, {0, {2, 1, -3}}, {50, {12, 1, 3}}, {200, {0, -2, 8}}},
          .by = by,
          .interpolation = interpolation};
}

Vec3d wind_at(const Wind& wind, const Vec3d& x, WindModel model = WindModel::profile,
              EarthModel earth = EarthModel::flat) {
  Environment e{.wind = wind};
  Fidelity f{.wind = model, .earth = earth};
  ProfileTables tables;
  return physim::wind(prepare_conditions(e, f, tables), Body<double>{}, 0.0, x);
}

TEST(Wind, linear_profile_by_height) {
  const Wind w = profile(WindAxis::height, WindInterpolation::linear);
  EXPECT_TRUE(near(wind_at(w, {999, 0, 5}), {2, 1, -3}, 1e-15));
  EXPECT_TRUE(near(wind_at(w, {999, 25, 5}), {7, 1, 0}, 1e-14));
  EXPECT_TRUE(near(wind_at(w, {0, 125, 0}), {6, -0.5, 5.5}, 1e-14));
  EXPECT_TRUE(near(wind_at(w, {0, -5, 0}), {1.5, 0.5, -1.5}, 1e-14));
  EXPECT_TRUE(near(wind_at(w, {0, -100, 0}), {1, 0, 0}, 1e-15)) << "held below";
  EXPECT_TRUE(near(wind_at(w, {0, 1e6, 0}), {0, -2, 8}, 1e-13)) << "held above";
}

TEST(Wind, linear_profile_by_range) {
  const Wind w = profile(WindAxis::range, WindInterpolation::linear);
  EXPECT_TRUE(near(wind_at(w, {25, 999, 5}), {7, 1, 0}, 1e-14));
  EXPECT_TRUE(near(wind_at(w, {1e6, 0, 5}), {0, -2, 8}, 1e-13));
}

TEST(Wind, steps_hold_from_their_place_on) {
  const Wind w = profile(WindAxis::range, WindInterpolation::step);
  EXPECT_EQ(wind_at(w, {-11, 0, 0}), (Vec3d{1, 0, 0}));
  EXPECT_EQ(wind_at(w, {-0.001, 0, 0}), (Vec3d{1, 0, 0}));
  EXPECT_EQ(wind_at(w, {0, 0, 0}), (Vec3d{2, 1, -3}));
  EXPECT_EQ(wind_at(w, {49.999, 0, 0}), (Vec3d{2, 1, -3}));
  EXPECT_EQ(wind_at(w, {50, 0, 0}), (Vec3d{12, 1, 3}));
  EXPECT_EQ(wind_at(w, {1e9, 0, 0}), (Vec3d{0, -2, 8}));
}

TEST(Wind, a_profile_in_single_precision_has_all_its_points) {
  std::vector<WindPoint> longest;
  for (int i = 0; i < 1000; ++i) longest.push_back({7.0 * i, {1.0 * i, -2.0 * i, 0.5 * i * i}});
  const Wind plain = {.velocity = {3, 0, -4}}, single = {.profile = {{20, {1, 2, 3}}}};
  const Wind stepped = profile(WindAxis::range, WindInterpolation::step);
  Fidelity f;
  for (const Wind& wind : {plain, single, stepped, Wind{.profile = longest}}) {
    Environment e{.wind = wind};
    f.wind = wind.profile.empty() ? WindModel::constant : WindModel::profile;
    ProfileTables tables;
    const Conditions<double> c = prepare_conditions(e, f, tables);
    const Conditions<float> c32 = to_float(c, tables);
    for (const Vec3d& x : {Vec3d{-30, -30, 0}, Vec3d{13, 13, 0}, Vec3d{125, 125, 0}, Vec3d{900, 900, 0}})
      EXPECT_TRUE(near(vec_cast<double>(physim::wind(c32, Body<float>{}, 0.0f, vec_cast<float>(x))),
                       physim::wind(c, Body<double>{}, 0.0, x), 1e-4));
  }
}

/// A sounding has 60 to 150 levels; those on a straight line say no more than its two ends.
TEST(Wind, a_sounding_blows_as_the_line_that_its_levels_lie_on) {
  std::vector<WindPoint> levels;
  for (int i = 0; i <= 150; ++i) levels.push_back({200.0 * i, {0.1 * i, -0.02 * i, 0.3 * i}});
  const Wind sounding{.profile = levels}, line{.profile = {levels.front(), levels.back()}};
  for (const double height : {-5.0, 0.0, 1.0, 199.9, 200.0, 12345.6, 29999.0, 30000.0, 5e4})
    EXPECT_TRUE(near(wind_at(sounding, {0, height, 0}), wind_at(line, {0, height, 0}), 1e-12, 1e-12)) << height;
}

TEST(Wind, height_over_a_sphere_is_above_the_sphere) {
  const Wind w = profile(WindAxis::height, WindInterpolation::linear);
  const double x = 20000, r = 6356766;  // the ground lies 31.463 m lower there
  const double y = std::sqrt((r + 25) * (r + 25) - x * x) - r;
  EXPECT_NEAR(y, 25 - 31.463, 1e-3);
  // (7, 1, 0) in the frame of the vertical there, which leans forward by asin(x / (r + 25)).
  const double s = x / (r + 25), c = std::sqrt(1 - s * s);
  EXPECT_TRUE(near(wind_at(w, {x, y, 0}, WindModel::profile, EarthModel::sphere), {7 * c + s, c - 7 * s, 0}, 1e-9));
}

TEST(Wind, a_low_rung_has_one_wind) {
  Wind w = profile(WindAxis::height, WindInterpolation::linear);
  EXPECT_EQ(wind_at(w, {0, 100, 0}, WindModel::constant), (Vec3d{1, 0, 0})) << "the profile's first point";
  w.velocity = {0, 0, -4};
  EXPECT_EQ(wind_at(w, {0, 100, 0}, WindModel::constant), (Vec3d{0, 0, -4}));
  EXPECT_EQ(wind_at(w, {0, 100, 0}, WindModel::off), (Vec3d{0, 0, 0}));
}

TEST(Wind, an_updraught_carries_a_falling_ball) {
  // At its terminal speed of 20 m/s in an updraught of 20 m/s a ball hovers.
  ProjectileDef p{.drag = {.k2 = 9.80665 / 400}};
  Environment e = test::constant_gravity();
  e.wind.velocity = {0, 20, 0};
  Fidelity f = test::vacuum();
  f.drag = DragModel::linear_quadratic;
  f.wind = WindModel::constant;
  const Flight flight = fly(p, {.position = {0, 100, 0}}, e, f, {1e-12, 1e-12}, {.ground = {}, .time = 60});
  EXPECT_TRUE(near(flight.end().position, {0, 100, 0}, 1e-12));
}

// Wind drift of flat fire: the lag rule, z = w (t - x / v0), is exact where drag grows with the square of the speed and
// the crosswind is small (R. L. McCoy, Modern Exterior Ballistics (1999), sec. 7.2).
TEST(Wind, crosswind_drift_follows_the_lag_rule) {
  ProjectileDef p{.drag = {.coefficient = 0.3, .ballistic_coefficient = 150}};
  Environment e = test::constant_gravity();
  e.gravity.acceleration = 0;
  e.atmosphere = {.model = AirModel::constant, .density = 1.2, .sound_speed = 340};
  e.wind.velocity = {0, 0, 0.001};
  Fidelity f = test::vacuum();
  f.drag = DragModel::equation;
  f.air = AirModel::constant;
  f.wind = WindModel::constant;
  const Flight flight = fly(p, {.speed = 800}, e, f, {1e-13, 1e-13}, {.ground = {}, .range = 500});
  EXPECT_TRUE(near(flight.end().windage, 0.001 * (flight.duration() - 500.0 / 800), 1e-6));
}

TEST(Wind, adaptive_steps_end_at_the_points_of_a_profile) {
  Environment e = test::constant_gravity();
  e.wind = profile(WindAxis::range, WindInterpolation::step);
  Fidelity f{.gravity = GravityModel::constant};
  const Flight flight =
      fly(test::bullet_308(), {.position = {-20, 1, 0}, .speed = 800}, e, f, {}, {.ground = {}, .time = 1});
  for (const double place : {-10.0, 0.0, 50.0, 200.0}) {
    double closest = 1e9;
    for (const double t : flight.step_times()) closest = std::min(closest, std::abs(flight.at(t).position.x - place));
    EXPECT_LT(closest, 1e-4) << place;
  }
}

}  // namespace physim::model_wind_test
