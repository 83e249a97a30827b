// Coordinates of places: round trips everywhere, published points, heights in W.
#include "math/elementary.hpp"
#include "model/earth.hpp"
#include "random_shots.hpp"
#include "support.hpp"

namespace physim::model_geodesy_test {

using namespace test;

constexpr double kPi = 3.14159265358979323846;

double degrees(double d, double m, double s) { return (d + m / 60 + s / 3600) * kDegree; }

TEST(Wgs84, derived_constants_are_those_published) {
  // NIMA TR8350.2 (2000), tables 3.3 and 3.4, printed digits.
  EXPECT_NEAR(wgs84::kPolarRadius, 6356752.3142, 5e-5);
  EXPECT_NEAR(wgs84::kEccentricitySquared, 6.69437999014e-3, 5e-15);
  EXPECT_NEAR(wgs84::kMeanRadius, 6371008.7714, 5e-5);
}

// A double near the Earth's radius is rounded to 1e-9 m, an angle near pi to 3e-9 m.
TEST(Geodesy, round_trips_lose_only_rounding) {
  for (const double h : {-5000.0, -1.0, 0.0, 2.0, 9144.0, 86000.0, 4e5, 1e6, 2e7, 1e8}) {
    const double gate = 3e-9 + 6e-16 * h;
    for (int phi = -90; phi <= 90; ++phi)
      for (int lambda = -180; lambda <= 180; lambda += 15) {
        const Geodetic place{phi * kDegree, lambda * kDegree, h};
        const Vec3d x = earth_fixed_from_geodetic(place);
        const Geodetic back = geodetic_from_earth_fixed(x);
        ASSERT_NEAR(back.height, h, gate) << phi << " " << lambda;
        ASSERT_NEAR(back.latitude, place.latitude, 4e-16) << phi << " " << lambda << " " << h;
        if (std::abs(phi) < 90 && std::abs(lambda) < 180) {
          ASSERT_NEAR(back.longitude, place.longitude, 1e-15) << phi << " " << lambda;
        }
        ASSERT_LT(length(earth_fixed_from_geodetic(back) - x), gate) << phi << " " << lambda << " " << h;
      }
  }
}

TEST(Geodesy, next_to_the_poles_and_the_equator) {
  for (const double off : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15})
    for (const double h : {-5000.0, 0.0, 4e5, 1e8}) {
      for (const double phi : {kPi / 2 - off, -kPi / 2 + off, off, -off}) {
        const Geodetic place{phi, 2.5, h};
        const Geodetic back = geodetic_from_earth_fixed(earth_fixed_from_geodetic(place));
        EXPECT_NEAR(back.latitude, phi, 4e-16) << off;
        EXPECT_NEAR(back.height, h, 3e-9 + 6e-16 * h) << off;
        if (std::abs(phi) < 1.57 || off > 1e-7) {
          EXPECT_NEAR(back.longitude, 2.5, 1e-9) << off;
        }
      }
    }
  const Geodetic pole = geodetic_from_earth_fixed({0, 0, -wgs84::kPolarRadius - 10});
  EXPECT_EQ(pole.latitude, -kPi / 2);
  EXPECT_EQ(pole.longitude, 0) << "it has none; 0 is one";
  EXPECT_NEAR(pole.height, 10, 2e-9);
  const Geodetic equator = geodetic_from_earth_fixed({0, wgs84::kEquatorialRadius + 10, 0});
  EXPECT_EQ(equator, (Geodetic{0, kPi / 2, 10}));
}

TEST(Geodesy, published_points) {
  // IOGP publication 373-7-2 (Geomatics Guidance Note 7, part 2), EPSG methods 9602 and 9837, printed digits.
  const Geodetic place{degrees(53, 48, 33.820), degrees(2, 7, 46.380), 73};
  const Vec3d x = earth_fixed_from_geodetic(place);
  EXPECT_TRUE(near(x, {3771793.968, 140253.342, 5124304.349}, 0, 9e-4));
  const Geodetic origin{degrees(55, 0, 0), degrees(5, 0, 0), 200};
  const Vec3d local = local_from_earth_fixed(x - earth_fixed_from_geodetic(origin), origin);
  EXPECT_TRUE(near(local, {-189013.869, -128642.040, -4220.171}, 0, 9e-4));
  // D. A. Vallado, Fundamentals of Astrodynamics and Applications (2007), example 3-3: printed digits.
  const Geodetic high = geodetic_from_earth_fixed({6524834, 6862875, 6448296});
  EXPECT_NEAR(high.latitude / kDegree, 34.352496, 5e-6);
  EXPECT_NEAR(high.longitude / kDegree, 46.4464, 5e-5);
  EXPECT_NEAR(high.height, 5085220, 10);
}

TEST(Geodesy, frames_turn_there_and_back) {
  Random r(5);
  for (int i = 0; i < 100; ++i) {
    const Vec3d v = r.vector(1000);
    const Geodetic place{r.in(-1.57, 1.57), r.in(-3, 3), 0};
    const double angle = r.in(-10, 10);
    EXPECT_TRUE(near(earth_fixed_from_local(local_from_earth_fixed(v, place), place), v, 1e-15));
    EXPECT_TRUE(near(earth_fixed_from_inertial(inertial_from_earth_fixed(v, angle), angle), v, 1e-15));
  }
  // A quarter turn to the east takes what stood at longitude 0 to where longitude 90 was.
  EXPECT_TRUE(near(inertial_from_earth_fixed({1, 0, 2}, kPi / 2), {0, 1, 2}, 1e-15));
  EXPECT_TRUE(near(local_from_earth_fixed({0, 0, 1}, {0, 1, 0}), {0, 1, 0}, 1e-15)) << "the axis points north";
}

// ------------------------------------------------------------------------------------------------------ heights in W
/// By another way: the place in E by sines and cosines, then the iteration to its end, in long double.
long double exact_height(const Environment& e, const Vec3d& x) {
  const long double a = 6378137, f = 1 / 298.257223563L, e2 = f * (2 - f);
  const long double sp = sinl(e.earth.latitude), cp = cosl(e.earth.latitude);
  const long double sa = sinl(e.earth.azimuth), ca = cosl(e.earth.azimuth);
  const long double n = a / sqrtl(1 - e2 * sp * sp);
  const long double north = x.x * ca - x.z * sa, east = x.x * sa + x.z * ca;
  const long double across = (n + e.altitude + x.y) * cp - north * sp;
  const long double z = (n * (1 - e2) + e.altitude + x.y) * sp + north * cp;
  const long double p = sqrtl(across * across + east * east);
  long double phi = atan2l(z, p);
  for (int i = 0; i < 30; ++i) phi = atan2l(z + e2 * a * sinl(phi) / sqrtl(1 - e2 * sinl(phi) * sinl(phi)), p);
  const long double s = sinl(phi), m = a / sqrtl(1 - e2 * s * s);
  const long double from_axis = p - m * cosl(phi), from_equator = z - m * (1 - e2) * s;
  return from_axis * cosl(phi) + from_equator * s - e.altitude;
}

Conditions<double> over_ellipsoid(const Environment& e) {
  Fidelity f = vacuum();
  f.earth = EarthModel::ellipsoid;
  return prepare_conditions(e, f);
}

Environment somewhere(Random& r) {
  Environment e{.altitude = r.one_in(3)   ? 0
                            : r.one_in(2) ? r.in(-4000, 10000)
                                          : r.in(0, 1e6),
                .earth = {.latitude = r.in(-1.57, 1.57), .azimuth = r.in(-3, 3)}};
  if (r.one_in(8)) e.earth.latitude = 0;
  if (r.one_in(8)) e.earth.latitude = r.one_in(2) ? kPi / 2 : -kPi / 2;
  return e;
}

TEST(Heights, over_the_ellipsoid_keep_their_digits) {
  Random r(11);
  for (const double size : {1e-3, 1.0, 1e3, 3e4, 1e6, 1e7, 1e8}) {
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
      const Environment e = somewhere(r);
      const Vec3d x = r.vector(size);
      const long double exact = exact_height(e, x);
      if (exact + e.altitude < -6000) continue;
      worst = std::max(worst, std::abs(static_cast<double>(height(over_ellipsoid(e), x) - exact)));
    }
    EXPECT_LT(worst, 4e-12 + 1e-15 * size) << size;
  }
}

TEST(Heights, the_origin_has_height_zero_to_the_bit) {
  Random r(12);
  for (int i = 0; i < 500; ++i) {
    const Environment e = somewhere(r);
    const Conditions<double> c = over_ellipsoid(e);
    EXPECT_EQ(height(c, Vec3d{}), 0);
    EXPECT_EQ(altitude(c, Vec3d{}), e.altitude);
    EXPECT_EQ(height(to_float(c, {}), Vec3f{}), 0);
    EXPECT_NEAR(vertical_at(c, Vec3d{}).y, 1, 1e-15);
  }
}

TEST(Heights, floats_keep_their_digits_too) {
  Random r(13);
  for (const double size : {1.0, 1e4, 1e6})
    for (int i = 0; i < 500; ++i) {
      const Environment e = somewhere(r);
      const Vec3f x = vec_cast<float>(r.vector(size));
      const Conditions<double> c = over_ellipsoid(e);
      if (altitude(c, vec_cast<double>(x)) < -6000) continue;
      EXPECT_NEAR(height(to_float(c, {}), x), height(c, vec_cast<double>(x)), 4e-7 * size);
    }
}

TEST(Heights, are_finite_at_the_antipode) {
  Random r(14);
  for (int i = 0; i < 200; ++i) {
    const Environment e = somewhere(r);
    const Conditions<double> c = over_ellipsoid(e);
    const double height_there = r.in(0, 1e5);
    // Opposite: the same distances from axis and equator, turned round.
    const Vec3d up = vertical_at(c, Vec3d{});
    const Vec3d there = c.globe.origin * -2.0 - up * (height_there - e.altitude);
    EXPECT_NEAR(altitude(c, there), height_there, 4e-8);
  }
}

}  // namespace physim::model_geodesy_test
