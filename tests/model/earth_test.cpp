// The turning and the round Earth, and the sum of all effects.
#include "model/earth.hpp"

#include "model/acceleration.hpp"
#include "support.hpp"

namespace physim::model_earth_test {

using test::kDegree;
using test::near;
using test::Prepared;

Environment turning(double latitude, double azimuth) {
  Environment e = test::constant_gravity();
  e.earth = {.latitude = latitude * kDegree, .azimuth = azimuth * kDegree, .rotation_rate = 7.292115e-5};
  return e;
}

Fidelity coriolis_only() {
  Fidelity f = test::vacuum(Integrator::dop853);
  f.earth = EarthModel::flat_coriolis;
  return f;
}

TEST(Coriolis, is_minus_two_omega_cross_v) {
  // Northern hemisphere, firing north (x north, y up, z east): Omega = w (cos phi, sin phi, 0).
  const Prepared p({}, {}, turning(30, 0), coriolis_only());
  const double w = 7.292115e-5, c = std::cos(30 * kDegree), s = std::sin(30 * kDegree);
  const Vec3d v{700, 100, -50};
  const Vec3d omega{w * c, w * s, 0};
  EXPECT_TRUE(near(coriolis(p.conditions(), v), cross(omega, v) * -2.0, 1e-15));
  // In words: going north drifts right (east), going east lifts, going up drifts west.
  EXPECT_GT(coriolis(p.conditions(), Vec3d{1, 0, 0}).z, 0);
  EXPECT_GT(coriolis(p.conditions(), Vec3d{0, 0, 1}).y, 0);
  EXPECT_LT(coriolis(p.conditions(), Vec3d{0, 1, 0}).z, 0);
}

TEST(Coriolis, turns_with_the_azimuth_of_fire) {
  // Firing east the x axis is east and z is south: the same vector in other components.
  const Prepared north({}, {}, turning(52, 0), coriolis_only());
  const Prepared east({}, {}, turning(52, 90), coriolis_only());
  const Vec3d v_north_up_east{300, 40, 70};
  const Vec3d a = coriolis(north.conditions(), v_north_up_east);
  const Vec3d b = coriolis(east.conditions(), Vec3d{70, 40, -300});
  EXPECT_TRUE(near(b, {a.z, a.y, -a.x}, 1e-14));
}

// Exact solutions (the closed forms of analytic/coriolis_uniform_g.csv): v' = g - 2 w x v, in east, north, up.
TEST(Coriolis, flights_follow_the_exact_solution) {
  const struct {
    double latitude, height, speed, elevation, azimuth, time, east, north, up;
  } rows[] = {{0, 100, 0, 0, 0, 4.5160076391422314336, 0.021954165014450011277, 0, -100},
              {45, 1000, 0, 0, 0, 14.280871102884894014, 0.49091006426309026276, -0.000180744537997246908, -1000},
              {45, 0, 800, 2, 90, 5.7422920712331546133, 4591.0191260196463293, -1.3593550478811148701, 0},
              {45, 0, 500, 45, 90, 72.37356981706636215, 25555.853992199431589, -95.369810606304283136, 0},
              {0, 0, 500, 45, 90, 72.485278586165433072, 25582.262899527227966, 0, 0}};
  for (const auto& row : rows) {
    Launch launch{.position = {0, row.height, 0}, .speed = row.speed, .elevation = row.elevation * kDegree};
    const Flight flight = fly({}, launch, turning(row.latitude, row.azimuth), coriolis_only(), {1e-14, 1e-12});
    ASSERT_EQ(flight.outcome(), Outcome::landed);
    const Vec3d moved = flight.end().position - launch.position;
    const double a = row.azimuth * kDegree;
    const double north = moved.x * std::cos(a) - moved.z * std::sin(a);
    const double east = moved.x * std::sin(a) + moved.z * std::cos(a);
    EXPECT_TRUE(near(flight.duration(), row.time, 1e-11));
    EXPECT_TRUE(near(Vec3d{east, north, moved.y}, Vec3d{row.east, row.north, row.up}, 1e-11, 1e-9)) << row.latitude;
  }
}

TEST(Earth, heights_over_a_sphere_lose_no_digits) {
  Environment e{.altitude = 250};
  Fidelity f = test::vacuum();
  f.earth = EarthModel::sphere;
  const Conditions<double> c = prepare_conditions(e, f);
  EXPECT_EQ(altitude(c, Vec3d{0, 0, 0}), 250);
  EXPECT_NEAR(height(c, Vec3d{0, 1e-3, 0}), 1e-3, 1e-12);
  // At 10 km the ground lies x^2 / 2R lower (to second order x^4 / 8R^3).
  const double r = 6356766 + 250.0;
  EXPECT_NEAR(height(c, Vec3d{10000, 0, 0}), 1e8 / (2 * r) - 1e16 / (8 * r * r * r), 1e-8);
}

TEST(Earth, climb_rate_over_a_sphere_is_that_of_the_height) {
  Fidelity f = test::vacuum();
  f.earth = EarthModel::sphere;
  const Conditions<double> c = prepare_conditions({}, f);
  const State<double> s{{3e5, 2e4, -1e5}, {500, 200, -100}};
  const double dt = 1e-3;
  const double difference = (height(c, s.x + s.v * dt) - height(c, s.x - s.v * dt)) / (2 * dt);
  EXPECT_NEAR(climb_rate(c, s), difference, 1e-5);
}

TEST(Acceleration, is_the_sum_of_all_effects) {
  ProjectileDef p = test::bullet_308();
  p.force = {1e-3, 2e-3, -3e-3};
  Environment e = turning(40, 120);
  e.gravity.model = GravityModel::inverse_square;
  e.wind.velocity = {3, 0, -4};
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;
  const Flight flight = fly(p, {.speed = 800, .elevation = 0.3}, e, f);
  for (const double part : {0.0, 0.3, 0.7, 1.0}) {
    const Accelerations a = flight.accelerations(part * flight.duration());
    EXPECT_TRUE(near(a.gravity + a.drag + a.coriolis + a.applied, a.total, 1e-14));
    EXPECT_TRUE(near(flight.at(part * flight.duration()).acceleration, a.total, 1e-14));
    EXPECT_TRUE(near(a.applied, p.force * (1 / p.mass), 1e-14));
    EXPECT_GT(length(a.drag), 1);
    EXPECT_GT(length(a.coriolis), 1e-3);
    EXPECT_NEAR(length(a.gravity), 9.8, 0.01);
  }
}

TEST(Acceleration, applied_force_ends_in_time) {
  // Thrust of 2 g for 3 s straight up: v = g (2 - 1) 3 at burnout, then free flight; heights by hand.
  const double g = 9.80665;
  ProjectileDef p{.mass = 4, .force = {0, 8 * g, 0}, .force_duration = 3};
  const Flight flight = fly(p, {}, test::constant_gravity(), test::vacuum(), {1e-11, 1e-11});
  ASSERT_EQ(flight.outcome(), Outcome::landed);
  EXPECT_TRUE(near(flight.at(3).velocity.y, 3 * g, 1e-9));
  EXPECT_TRUE(near(flight.at(3).position.y, 4.5 * g, 1e-9));
  EXPECT_TRUE(near(flight.at(6).position.y, 9 * g, 1e-9)) << "apex";
  EXPECT_TRUE(near(flight.duration(), 6 + std::sqrt(18.0), 1e-9));
}

}  // namespace physim::model_earth_test
