// The flattened Earth's gravity: published figures, its potential, and what it is over a flat Earth.
#include "model/normal_gravity.hpp"

#include "model/gravity.hpp"
#include "random_shots.hpp"
#include "support.hpp"

namespace physim::model_normal_gravity_test {

using namespace test;

// Exact normal gravity (GeographicLib's NormalGravity::WGS84), and point mass, J2 and centrifugal acceleration: of
// ../reference/gravity, rounded to 13 digits. Up and north, by geodetic latitude and ellipsoidal height.
struct Row {
  double latitude, height, up, north, j2_up, j2_north;
};
constexpr Row kRows[] = {
    {0, 0, -9.780325335904, 0, -9.780281647277, 0},
    {45, 0, -9.806197769377, 0, -9.806245660222, -1.395433525e-5},
    {45, 20000, -9.744774795528, -1.625176439640e-4, -9.744821793178, -1.762136271e-4},
    {45, 100000, -9.504743963275, -8.051653881056e-4, -9.504787577160, -8.178822700e-4},
    {20, 5000, -9.770949821680, -2.617320782727e-5, -9.770949823453, 1.451199388e-5},
};

Accelerations felt_at(double latitude, double height, GravityModel gravity, EarthModel earth) {
  Environment e{.altitude = height, .earth = {.latitude = latitude * kDegree}};
  Fidelity f = vacuum();
  f.gravity = gravity;
  f.earth = earth;
  return fly({}, {.velocity = Vec3d{}}, e, f, {}, {.ground = {}, .time = 0.01}).accelerations(0);
}

TEST(NormalGravity, is_what_a_projectile_at_rest_feels) {
  for (const Row& row : kRows) {
    const Accelerations a = felt_at(row.latitude, row.height, GravityModel::wgs84, EarthModel::ellipsoid);
    EXPECT_NEAR(a.total.y, row.up, 1e-12) << row.latitude << " " << row.height;
    EXPECT_NEAR(a.total.x, row.north, 1e-12) << row.latitude << " " << row.height;
    EXPECT_NEAR(a.total.z, 0, 1e-12);
    EXPECT_TRUE(near(a.gravity + a.centrifugal, a.total, 1e-15));
    const Vec3d direct = normal_gravity({row.latitude * kDegree, 1, row.height});
    EXPECT_TRUE(near(Vec3d{direct.y, direct.z, direct.x}, a.total, 1e-14));
  }
}

TEST(NormalGravity, j2_is_what_simulators_without_more_have) {
  for (const Row& row : kRows) {
    const Accelerations a = felt_at(row.latitude, row.height, GravityModel::j2, EarthModel::ellipsoid);
    EXPECT_NEAR(a.total.y, row.j2_up, 1e-12) << row.latitude << " " << row.height;
    EXPECT_NEAR(a.total.x, row.j2_north, 1e-12) << row.latitude << " " << row.height;
  }
}

TEST(NormalGravity, published_constants) {
  // NIMA TR8350.2 (2000), table 3.4: at equator and pole.
  EXPECT_NEAR(-normal_gravity({0, 0, 0}).z, 9.7803253359, 5e-11);
  EXPECT_NEAR(-normal_gravity({90 * kDegree, 0, 0}).z, 9.8321849378, 2e-10);
  // Somigliana's formula on the ellipsoid, eq. 4-1, with the printed k.
  for (double phi = -90; phi <= 90; phi += 7.5) {
    const double s = std::sin(phi * kDegree);
    const double g = 9.7803253359 * (1 + 0.00193185265241 * s * s) / std::sqrt(1 - 0.00669437999014 * s * s);
    const Vec3d a = normal_gravity({phi * kDegree, 0.3, 0});
    EXPECT_NEAR(-a.z, g, 2e-10);
    EXPECT_NEAR(a.y, 0, 1e-14) << "the ellipsoid is level";
  }
}

/// Gravitational potential of the ellipsoid: Heiskanen and Moritz (1967), eq. 2-62 without the centrifugal part.
long double potential(const Vec3d& x) {
  const long double a = 6378137, f = 1 / 298.257223563L, b = a * (1 - f), e = sqrtl(a * a - b * b);
  const long double gm = 3.986004418e14L, w = 7.292115e-5L;
  const long double r2 = (long double)x.x * x.x + (long double)x.y * x.y + (long double)x.z * x.z;
  const long double s = r2 - e * e;
  const long double u = sqrtl((s + sqrtl(s * s + 4 * e * e * x.z * x.z)) / 2);
  const auto q = [&](long double t) { return ((1 + 3 / (t * t)) * atanl(t) - 3 / t) / 2; };
  const long double sine = x.z / u;
  return gm / e * atanl(e / u) + w * w * a * a / 2 * q(e / u) / q(e / b) * (sine * sine - 1 / 3.0L);
}

TEST(NormalGravity, is_the_slope_of_the_potential) {
  Random r(3);
  for (int i = 0; i < 300; ++i) {
    Vec3d x = r.vector(1);
    if (i == 0) x = {0, 0, 1};
    if (i == 1) x = {0, 1, 0};
    x = x * ((6400000 + (r.one_in(2) ? r.in(0, 1e6) : r.in(0, 1e8))) / length(x));
    const Vec3d a = ellipsoid_gravitation(Vec3d{0, 0, 1}, x);
    const double step = std::ldexp(1.0, std::ilogb(length(x)) - 11);  // a difference of order 4
    const auto slope = [&](const Vec3d& d) {
      const auto rise = [&](double n) { return potential(x + d * (n * step)) - potential(x - d * (n * step)); };
      return static_cast<double>((8 * rise(1) - rise(2)) / (12 * step));
    };
    EXPECT_TRUE(near(a, {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})}, 1e-11, 1e-12)) << i;
  }
}

TEST(NormalGravity, far_away_is_a_point_mass_with_j2) {
  const Vec3d axis{0, 0, 1};
  for (const double r : {1e8, 4e8}) {
    const Vec3d x{0.6 * r, 0, 0.8 * r};
    EXPECT_TRUE(near(ellipsoid_gravitation(axis, x), j2_gravitation(axis, x), 3e-10 * std::pow(1e8 / r, 4))) << r;
    EXPECT_TRUE(near(ellipsoid_gravitation(axis, x), x * (-wgs84::kGM / (r * r * r)), 1e-5 * std::pow(1e8 / r, 2)));
  }
}

TEST(NormalGravity, over_a_flat_earth_is_the_weight_at_the_latitude) {
  for (const EarthModel earth : {EarthModel::flat, EarthModel::flat_coriolis})
    for (const double latitude : {0.0, 37.0, -52.0, 90.0})
      for (const double height : {-3000.0, 0.0, 4000.0, 20000.0, 100000.0}) {
        const double g = -normal_gravity({latitude * kDegree, 0, height}).z;
        const Accelerations a = felt_at(latitude, height, GravityModel::wgs84, earth);
        EXPECT_NEAR(-a.gravity.y, g, height > 20000 ? 1.5e-4 : 3e-6) << latitude << " " << height;
        EXPECT_EQ(a.centrifugal, Vec3d{}) << "the weight contains it";
      }
  EXPECT_NEAR(felt_at(45, 0, GravityModel::j2, EarthModel::flat).gravity.y, -9.806245660222, 1e-12);
}

TEST(NormalGravity, constant_gravity_is_weight_and_follows_the_vertical) {
  const Accelerations a = felt_at(45, 0, GravityModel::constant, EarthModel::ellipsoid);
  EXPECT_TRUE(near(a.total, {0, -9.80665, 0}, 1e-14));
  EXPECT_EQ(a.centrifugal, Vec3d{});
}

TEST(NormalGravity, floats_are_as_good_as_floats) {
  Environment e{.earth = {.latitude = 0.7, .azimuth = 1}};
  for (const GravityModel model : {GravityModel::inverse_square, GravityModel::j2, GravityModel::wgs84}) {
    Fidelity f = vacuum();
    f.gravity = model;
    f.earth = EarthModel::ellipsoid;
    const Conditions<double> c = prepare_conditions(e, f);
    const Vec3d x{1e5, 2e5, -3e5};
    EXPECT_TRUE(near(vec_cast<double>(gravity(to_float(c, {}), vec_cast<float>(x))), gravity(c, x), 1e-6));
  }
}

}  // namespace physim::model_normal_gravity_test
