// Gravity: its size and direction on every rung, flat and round.
#include "model/gravity.hpp"

#include "support.hpp"

namespace physim::model_gravity_test {

using test::near;
using test::Prepared;

Fidelity with(GravityModel gravity, EarthModel earth) {
  Fidelity f = test::vacuum();
  f.gravity = gravity;
  f.earth = earth;
  return f;
}

/// The acceleration at a place in an environment whose field is Newton's.
Vec3d pull(GravityModel model, EarthModel earth, const Vec3d& x, double altitude = 0) {
  const Prepared p({}, {}, {.altitude = altitude}, with(model, earth));
  return p.acceleration(0, {x, {1, 2, 3}});
}

TEST(Gravity, off_is_nothing) {
  EXPECT_EQ(pull(GravityModel::off, EarthModel::flat, {1, 2, 3}), (Vec3d{0, 0, 0}));
  EXPECT_EQ(pull(GravityModel::off, EarthModel::sphere, {1, 2, 3}), (Vec3d{0, 0, 0}));
}

TEST(Gravity, constant_is_the_same_everywhere_over_flat_earth) {
  EXPECT_EQ(pull(GravityModel::constant, EarthModel::flat, {1e5, 3e4, -7}), (Vec3d{0, -9.80665, 0}));
}

TEST(Gravity, constant_points_to_the_centre_of_a_sphere) {
  const Vec3d x{2e6, 1e5, -1e6};
  const Vec3d a = pull(GravityModel::constant, EarthModel::sphere, x);
  EXPECT_NEAR(length(a), 9.80665, 1e-14);
  const Vec3d r{x.x, x.y + 6356766, x.z};
  EXPECT_LT(length(cross(a, r)) / length(r), 1e-14);
  EXPECT_LT(dot(a, r), 0);
}

// U.S. Standard Atmosphere, 1976: gravity at geometric altitudes (the exact figures of us76_exact.csv).
TEST(Gravity, inverse_square_is_that_of_the_standard_atmosphere) {
  const struct {
    double z, g;
  } rows[] = {{-4000, 9.819003343238312134},
              {0, 9.80665},
              {2000, 9.8004820688167050911},
              {20000, 9.7452315864667771849},
              {86000, 9.5465930282917391516}};
  for (const auto& row : rows) {
    EXPECT_TRUE(near(pull(GravityModel::inverse_square, EarthModel::flat, {5, row.z, 7}), {0, -row.g, 0}, 1e-15));
    EXPECT_TRUE(
        near(pull(GravityModel::inverse_square, EarthModel::flat, {5, row.z - 3000, 7}, 3000), {0, -row.g, 0}, 1e-15))
        << "the origin's altitude counts";
    EXPECT_TRUE(near(pull(GravityModel::inverse_square, EarthModel::sphere, {0, row.z, 0}), {0, -row.g, 0}, 1e-15));
  }
}

TEST(Gravity, inverse_square_over_a_sphere_falls_with_the_distance_in_every_direction) {
  const double radius = 6356766;
  const Vec3d x{3e6, 2e6, -4e6};
  const Vec3d r{x.x, x.y + radius, x.z};
  const double size = 9.80665 * radius * radius / dot(r, r);
  EXPECT_TRUE(near(pull(GravityModel::inverse_square, EarthModel::sphere, x), r * (-size / length(r)), 4e-15));
}

/// Largest change of the total energy per mass along a flight.
double energy_error(const Fidelity& fidelity, double (*potential)(const Vec3d&)) {
  Launch launch{.speed = 3000, .elevation = 50 * test::kDegree};
  const Flight flight = fly({}, launch, {}, fidelity, {.relative = 1e-12, .absolute = 1e-12});
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  const auto energy = [&](double t) {
    const Sample s = flight.at(t);
    return 0.5 * dot(s.velocity, s.velocity) + potential(s.position);
  };
  double worst = 0;
  for (int i = 1; i <= 50; ++i) worst = std::max(worst, std::abs(energy(flight.duration() * i / 50) - energy(0)));
  return worst / energy(0);
}

constexpr double kGm = 9.80665 * 6356766 * 6356766;

TEST(Gravity, conserves_energy) {
  constexpr double kR = 6356766;
  EXPECT_LT(energy_error(with(GravityModel::constant, EarthModel::flat), [](const Vec3d& x) { return 9.80665 * x.y; }),
            1e-11);
  EXPECT_LT(energy_error(with(GravityModel::inverse_square, EarthModel::flat),
                         [](const Vec3d& x) { return kGm / kR - kGm / (kR + x.y); }),
            1e-9);
  EXPECT_LT(energy_error(with(GravityModel::inverse_square, EarthModel::sphere),
                         [](const Vec3d& x) {
                           return kGm / kR - kGm / length(Vec3d{x.x, x.y + kR, x.z});
                         }),
            1e-9);
}

// Exact ellipses (the closed forms of analytic/newton_gravity_range.csv): GM 3.986004418e14, R 6371000 m.
TEST(Gravity, flights_over_a_round_earth_are_ellipses) {
  const struct {
    double speed, elevation, range, apex, time;
  } rows[] = {{300, 45, 9171.3306118567265874, 2293.6582070857876871, 43.25482185583089303},
              {1600, 45, 266091.83365850122973, 67227.357761363560224, 238.51017685317325611},
              {3000, 30, 888233.16999954879487, 130892.40819178386891, 351.28398500860024296},
              {6000, 35, 5285745.0095544132849, 1101018.1419700107104, 1330.8237711212701524}};
  Environment environment{.gravity = {.acceleration = 3.986004418e14 / (6371000.0 * 6371000.0), .radius = 6371000}};
  for (const auto& row : rows) {
    Launch launch{.speed = row.speed, .elevation = row.elevation * test::kDegree};
    const Flight flight = fly({}, launch, environment, with(GravityModel::inverse_square, EarthModel::sphere),
                              {.relative = 1e-13, .absolute = 1e-10});
    ASSERT_EQ(flight.outcome(), Outcome::landed);
    const Vec3d end = flight.end().position;
    const double range = 6371000 * std::atan2(end.x, end.y + 6371000);
    EXPECT_TRUE(near(range, row.range, 1e-9)) << row.speed;
    EXPECT_TRUE(near(flight.duration(), row.time, 1e-9)) << row.speed;
    double apex = -1;
    for (const Event& e : flight.events())
      if (e.kind == EventKind::apex) apex = length(Vec3d{e.position.x, e.position.y + 6371000, 0}) - 6371000;
    EXPECT_TRUE(near(apex, row.apex, 1e-9)) << row.speed;
  }
}

// Radial fall from rest (the closed forms of analytic/radial_fall_newton.csv), on both kinds of Earth.
TEST(Gravity, radial_fall) {
  const struct {
    double h, t, v;
  } rows[] = {{1000, 14.272843940371456831, 140.13357435222128722},
              {400000, 300.32577285167712966, 2718.8401328083859166},
              {6371000, 2070.6666577639332647, 7909.7924026540853445}};
  Environment environment{.gravity = {.acceleration = 3.986004418e14 / (6371000.0 * 6371000.0), .radius = 6371000}};
  for (const EarthModel earth : {EarthModel::flat, EarthModel::sphere})
    for (const auto& row : rows) {
      const Flight flight = fly({}, {.position = {0, row.h, 0}}, environment, with(GravityModel::inverse_square, earth),
                                {.relative = 1e-13, .absolute = 1e-10});
      EXPECT_TRUE(near(flight.duration(), row.t, 1e-9));
      EXPECT_TRUE(near(flight.end().speed, row.v, 1e-9));
    }
}

}  // namespace physim::model_gravity_test
