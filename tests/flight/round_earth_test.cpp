// Long flights over the round Earth: what they must conserve, what orbits must do, and the frames they are seen in.
#include "random_shots.hpp"
#include "support.hpp"

namespace physim::flight_round_earth_test {

using namespace test;

constexpr double kPi = 3.14159265358979323846;
constexpr Tolerance kTight{.relative = 1e-13, .absolute = 1e-9};

Fidelity over(EarthModel earth, GravityModel gravity, Integrator integrator = Integrator::dop853) {
  Fidelity f = vacuum(integrator);
  f.earth = earth;
  f.gravity = gravity;
  return f;
}

/// The Earth as a point mass under a sphere.
Environment round_world(double latitude, double longitude, double azimuth) {
  return {.gravity = {.acceleration = wgs84::kGM / (6371000.0 * 6371000.0), .radius = 6371000},
          .earth = {.latitude = latitude * kDegree, .longitude = longitude * kDegree, .azimuth = azimuth * kDegree}};
}

FrameState inertial_at(const Flight& flight, double time) {
  const Sample s = flight.at(time);
  return flight.earth_frames().inertial(s.position, s.velocity, time);
}

// ------------------------------------------------------------------------------------------------------ frames
TEST(Frames, every_way_there_leads_back) {
  Random r(21);
  for (int i = 0; i < 300; ++i) {
    Environment e{.altitude = r.in(-1000, 1e6),
                  .earth = {.latitude = r.in(-1.57, 1.57), .longitude = r.in(-3.1, 3.1), .azimuth = r.in(-3, 3)}};
    if (i % 9 == 0) e.earth.latitude = kPi / 2;
    if (i % 9 == 1) e.earth.latitude = 0;
    const EarthFrames frames(e, static_cast<EarthModel>(r.below(5)));
    const Vec3d x = r.vector(2e6) + Vec3d{0, 2e6, 0};
    const Vec3d v = r.vector(8000);
    const double t = r.in(0, 1e5);
    const FrameState E = frames.earth_fixed(x, v), I = frames.inertial(x, v, t);
    EXPECT_TRUE(near(frames.from_earth_fixed(E).position, x, 0, 6e-9));
    EXPECT_TRUE(near(frames.from_earth_fixed(E).velocity, v, 1e-15));
    EXPECT_TRUE(near(frames.from_inertial(I, t).position, x, 0, 1e-8));
    EXPECT_TRUE(near(frames.from_inertial(I, t).velocity, v, 1e-15));
    EXPECT_TRUE(near(frames.position(frames.geodetic(x)), x, 0, 1e-8));
    EXPECT_TRUE(near(frames.from_local(x, frames.local(x, v)), v, 2e-15));
    EXPECT_NEAR(length(E.position), length(I.position), 6e-9);
  }
}

TEST(Frames, of_the_origin) {
  Environment e{.altitude = 700,
                .earth = {.latitude = 47 * kDegree, .longitude = 8 * kDegree, .azimuth = 30 * kDegree}};
  for (const EarthModel earth : {EarthModel::flat, EarthModel::sphere, EarthModel::ellipsoid}) {
    const EarthFrames frames(e, earth);
    const Geodetic g = frames.geodetic({});
    EXPECT_NEAR(g.latitude, 47 * kDegree, 2e-16);
    EXPECT_NEAR(g.longitude, 8 * kDegree, 1e-16);
    EXPECT_EQ(g.height, 700);
    // Downrange is 30 degrees east of north, right of it is 30 degrees south of east.
    EXPECT_TRUE(near(frames.local({}, {1, 0, 0}), {0.5, std::cos(30 * kDegree), 0}, 1e-15));
    EXPECT_TRUE(near(frames.local({}, {0, 0, 1}), {std::cos(30 * kDegree), -0.5, 0}, 1e-15));
    EXPECT_TRUE(near(frames.local({}, {0, 1, 0}), {0, 0, 1}, 1e-15));
  }
  const EarthFrames frames(e, EarthModel::ellipsoid);
  EXPECT_TRUE(
      near(frames.earth_fixed({}, {}).position, earth_fixed_from_geodetic({47 * kDegree, 8 * kDegree, 700}), 0, 2e-9));
}

TEST(Frames, rest_on_the_ground_is_motion_in_space) {
  Environment e{.earth = {.latitude = 60 * kDegree, .longitude = 20 * kDegree, .azimuth = 0}};
  const EarthFrames turning(e, EarthModel::ellipsoid);
  const FrameState start = turning.inertial({}, {}, 0), day = turning.inertial({}, {}, 2 * kPi / 7.292115e-5);
  const double p = std::hypot(start.position.x, start.position.y);
  EXPECT_NEAR(length(start.velocity), 7.292115e-5 * p, 1e-12);
  EXPECT_NEAR(start.velocity.z, 0, 1e-13);
  EXPECT_TRUE(near(day.position, start.position, 0, 2e-8)) << "after a sidereal day";
  EXPECT_EQ(turning.rotation_rate(), 7.292115e-5);
  EXPECT_EQ(EarthFrames(e, EarthModel::sphere).rotation_rate(), 0);
  EXPECT_EQ(EarthFrames(e, EarthModel::sphere).inertial({}, {}, 5).velocity, Vec3d{});
}

// -------------------------------------------------------------------------------------------- rotation and none
TEST(RoundEarth, a_flight_is_the_same_whether_its_frame_turns_or_not) {
  // The same orbit, in W that stands still and in W that turns.
  const Environment e = round_world(33, -70, 110);
  const EarthFrames still(e, EarthModel::sphere), turning(e, EarthModel::sphere_rotating);
  const Vec3d x{0, 500e3, 0}, v{6900, 200, 2500};  // in the frame that stands still
  const FrameState moved = turning.from_inertial(still.inertial(x, v, 0), 0);
  const double period = 6000;
  const Until until{.ground = {}, .time = period};
  const Flight a =
      fly({}, {.position = x, .velocity = v}, e, over(EarthModel::sphere, GravityModel::inverse_square), kTight, until);
  const Flight b = fly({}, {.position = moved.position, .velocity = moved.velocity}, e,
                       over(EarthModel::sphere_rotating, GravityModel::inverse_square), kTight, until);
  for (const double t : {100.0, 1500.0, 3000.0, 4500.0, 6000.0}) {
    EXPECT_TRUE(near(inertial_at(b, t).position, inertial_at(a, t).position, 0, 1e-5)) << t;
    EXPECT_TRUE(near(inertial_at(b, t).velocity, inertial_at(a, t).velocity, 0, 1e-8)) << t;
  }
}

TEST(RoundEarth, without_gravity_a_turning_frame_sees_a_straight_line) {
  const Environment e = round_world(-41, 10, 250);
  const Flight flight = fly({}, {.speed = 900, .elevation = 0.4}, e,
                            over(EarthModel::sphere_rotating, GravityModel::off), kTight, {.ground = {}, .time = 4000});
  const FrameState start = inertial_at(flight, 0);
  for (const double t : {500.0, 2000.0, 4000.0})
    EXPECT_TRUE(near(inertial_at(flight, t).position, start.position + start.velocity * t, 0, 1e-6)) << t;
}

// A ball dropped at the equator is a Kepler orbit from its apocentre: it lands east by R (angle swept - Omega t).
TEST(RoundEarth, a_dropped_ball_falls_to_the_east_as_kepler_says) {
  const double radius = 6371000, omega = 7.292115e-5;
  for (const double height : {100.0, 1000.0, 30000.0}) {
    Environment e = round_world(0, 0, 90);
    const Flight flight = fly({}, {.position = {0, height, 0}}, e,
                              over(EarthModel::sphere_rotating, GravityModel::inverse_square), kTight);
    ASSERT_EQ(flight.outcome(), Outcome::landed);
    const long double r0 = radius + height, v0 = omega * r0, gm = e.gravity.acceleration * radius * radius;
    const long double a = 1 / (2 / r0 - v0 * v0 / gm), ecc = r0 / a - 1;
    const long double anomaly = acosl((1 - radius / a) / ecc);  // eccentric; pi at the apocentre
    const long double rate = sqrtl(gm / (a * a * a));
    const long double time = (3.14159265358979323846L - anomaly + ecc * sinl(anomaly)) / rate;
    const long double truly = 2 * atan2l(sqrtl(1 + ecc) * sinl(anomaly / 2), sqrtl(1 - ecc) * cosl(anomaly / 2));
    const long double east = radius * (3.14159265358979323846L - truly - omega * time);
    EXPECT_NEAR(flight.duration(), static_cast<double>(time), 1e-9 * flight.duration());
    const double angle = std::atan2(flight.end().position.x, flight.end().position.y + radius);
    EXPECT_NEAR(radius * angle, static_cast<double>(east), 1e-9 * static_cast<double>(east) + 2e-8) << height;
    const double first_order = omega * 9.82 * std::pow(flight.duration(), 3) / 3;
    EXPECT_NEAR(radius * angle, first_order, 0.02 * first_order) << height;
  }
}

TEST(RoundEarth, a_ball_dropped_over_the_ellipsoid_falls_east_of_the_plumb_line) {
  // First order in Omega: east = Omega g t^3 cos(phi) / 3; the southward part is of second order.
  for (const double latitude : {0.0, 48.0, -30.0}) {
    Environment e{.earth = {.latitude = latitude * kDegree, .azimuth = 90 * kDegree}};
    const Flight flight =
        fly({}, {.position = {0, 158, 0}}, e, over(EarthModel::ellipsoid, GravityModel::wgs84), kTight);
    // Gravity's slope delays a fall as if all of it happened at 5/6 of the height.
    const double g = -normal_gravity({latitude * kDegree, 0, 158 * 5.0 / 6}).z, t = flight.duration();
    EXPECT_NEAR(t, std::sqrt(2 * 158 / g), 3e-7);
    EXPECT_NEAR(flight.end().position.x, 7.292115e-5 * g * t * t * t / 3 * std::cos(latitude * kDegree), 1e-6);
    EXPECT_LT(std::abs(flight.end().position.z), 3e-5);
  }
}

// ------------------------------------------------------------------------------------------------ what is conserved
double j2_potential(const Vec3d& x) {
  const double r = length(x), s = x.z / r, a = wgs84::kEquatorialRadius / r;
  return -wgs84::kGM / r * (1 - wgs84::kJ2 * a * a * (3 * s * s - 1) / 2);
}
double ellipsoid_potential(const Vec3d& x) {
  const double a = wgs84::kEquatorialRadius, b = wgs84::kPolarRadius, e = std::sqrt(a * a - b * b);
  const double w = wgs84::kRotationRate, s = dot(x, x) - e * e;
  const double u = std::sqrt((s + std::sqrt(s * s + 4 * e * e * x.z * x.z)) / 2);
  const auto q = [](double t) { return ((1 + 3 / (t * t)) * std::atan(t) - 3 / t) / 2; };
  return -(wgs84::kGM / e * std::atan(e / u) +
           w * w * a * a / 2 * q(e / u) / q(e / b) * (x.z * x.z / (u * u) - 1.0 / 3));
}
double point_potential(const Vec3d& x) { return -wgs84::kGM / length(x); }

struct Drift {
  double energy;    // relative
  double momentum;  // about the axis, relative to its size
};

Drift drift_of(const Flight& flight, double (*potential)(const Vec3d&)) {
  const FrameState start = inertial_at(flight, 0);
  const auto energy = [&](const FrameState& s) { return 0.5 * dot(s.velocity, s.velocity) + potential(s.position); };
  const double size = length(cross(start.position, start.velocity));
  Drift worst{0, 0};
  for (int i = 1; i <= 60; ++i) {
    const FrameState s = inertial_at(flight, flight.duration() * i / 60);
    const Vec3d h = cross(s.position, s.velocity), h0 = cross(start.position, start.velocity);
    worst.energy = std::max(worst.energy, std::abs(energy(s) / energy(start) - 1));
    worst.momentum = std::max(worst.momentum, std::abs(h.z - h0.z) / size);
    if (potential == point_potential) worst.momentum = std::max(worst.momentum, length(h - h0) / size);
  }
  return worst;
}

TEST(RoundEarth, an_intercontinental_lob_keeps_energy_and_momentum) {
  Environment e{.earth = {.latitude = 34.6 * kDegree, .longitude = -120.6 * kDegree, .azimuth = 280 * kDegree}};
  const struct {
    GravityModel gravity;
    double (*potential)(const Vec3d&);
  } fields[] = {{GravityModel::inverse_square, point_potential},
                {GravityModel::j2, j2_potential},
                {GravityModel::wgs84, ellipsoid_potential}};
  for (const auto& field : fields)
    for (const auto& [integrator, gate] : {std::pair{Integrator::tsit5, 3e-11}, std::pair{Integrator::dop853, 1e-12}}) {
      const Flight flight = fly({}, {.speed = 6700, .elevation = 35 * kDegree}, e,
                                over(EarthModel::ellipsoid, field.gravity, integrator), {.relative = 1e-12});
      ASSERT_EQ(flight.outcome(), Outcome::landed);
      EXPECT_NEAR(flight.earth_frames().geodetic(flight.end().position).height, 0, 5e-9);
      const Drift drift = drift_of(flight, field.potential);
      EXPECT_LT(drift.energy, gate) << text(integrator);
      EXPECT_LT(drift.momentum, gate) << text(integrator);
    }
}

TEST(RoundEarth, a_low_orbit_keeps_energy_and_momentum_and_its_plane_turns) {
  Environment e{.altitude = 400e3,
                .earth = {.latitude = 0, .longitude = 12 * kDegree, .azimuth = (90 - 51.6) * kDegree}};
  const EarthFrames frames(e, EarthModel::ellipsoid);
  // Circular, inclined by 51.6 degrees, in inertial space.
  const FrameState here = frames.inertial({}, {}, 0);
  const double r = length(here.position), speed = std::sqrt(wgs84::kGM / r), i = 51.6 * kDegree;
  const Vec3d east = normalized(here.velocity);
  const Vec3d velocity = east * (speed * std::cos(i)) + Vec3d{0, 0, speed * std::sin(i)};
  const FrameState start = frames.from_inertial({here.position, velocity}, 0);
  const double day = 86164;
  const auto orbit = [&](GravityModel gravity) {
    return fly({}, {.position = start.position, .velocity = start.velocity}, e, over(EarthModel::ellipsoid, gravity),
               {.relative = 1e-13}, {.ground = {}, .time = day});
  };
  const Flight j2 = orbit(GravityModel::j2);
  EXPECT_LT(drift_of(j2, j2_potential).energy, 1e-11);
  EXPECT_LT(drift_of(j2, j2_potential).momentum, 1e-11);
  const Flight wgs84 = orbit(GravityModel::wgs84);
  EXPECT_LT(drift_of(wgs84, ellipsoid_potential).energy, 1e-11);
  EXPECT_LT(drift_of(wgs84, ellipsoid_potential).momentum, 1e-11);
  // The node goes west by 3/2 n J2 (a/r)^2 cos i in the mean over a revolution (Vallado 2007, eq. 9-37).
  const auto node = [&](double time) {
    const FrameState s = inertial_at(j2, time);
    const Vec3d h = cross(s.position, s.velocity);
    return std::atan2(h.x, -h.y);
  };
  const double n = speed / r, rate = -1.5 * n * wgs84::kJ2 * std::pow(wgs84::kEquatorialRadius / r, 2) * std::cos(i);
  EXPECT_NEAR((node(day) - node(0)) / day, rate, 0.01 * std::abs(rate));
  EXPECT_NEAR(rate * 86400 / kDegree, -5.0, 0.05) << "degrees a day";
}

TEST(RoundEarth, a_satellite_over_one_meridian_stands_still) {
  // Where gravitation and the centrifugal acceleration balance: r^3 = GM / Omega^2 for a point mass.
  Environment e;
  const double r = std::cbrt(wgs84::kGM / (7.292115e-5 * 7.292115e-5));
  EXPECT_NEAR(r, 42164.17e3, 10);
  e.altitude = r - wgs84::kEquatorialRadius;
  const Flight flight = fly({}, {.velocity = Vec3d{}}, e, over(EarthModel::ellipsoid, GravityModel::inverse_square),
                            kTight, {.ground = {}, .time = 86164});
  EXPECT_LT(length(flight.end().position), 1e-3);
}

// ------------------------------------------------------------------------------------------------- air and ground
TEST(RoundEarth, wind_stays_level_and_still_air_turns_with_the_ground) {
  Environment e{.wind = {.velocity = {7, 0, -3}}, .earth = {.latitude = 50 * kDegree, .azimuth = 70 * kDegree}};
  for (const EarthModel earth : {EarthModel::sphere, EarthModel::sphere_rotating, EarthModel::ellipsoid}) {
    Fidelity f = over(earth, GravityModel::inverse_square);
    f.drag = DragModel::equation;
    f.air = AirModel::constant;
    f.wind = WindModel::constant;
    const Prepared p({}, {}, e, f);
    const Conditions<double>& c = p.conditions();
    EXPECT_TRUE(near(wind(c, Body<double>{}, 0.0, Vec3d{}), {7, 0, -3}, 1e-15));
    for (const Vec3d& x : {Vec3d{5e5, 2e4, 1e5}, Vec3d{-6e6, -6.5e6, 3e6}}) {
      const Vec3d w = wind(c, Body<double>{}, 0.0, x);
      EXPECT_NEAR(dot(w, vertical_at(c, x)), 0, 1e-13);
      EXPECT_NEAR(length(w), std::sqrt(58.0), 1e-13);
    }
    // A balloon's worth of drag: what moves with the air feels none.
    const Accelerations at_rest =
        fly({}, {.velocity = Vec3d{7, 0, -3}}, e, f, {}, {.ground = {}, .time = 1e-6}).accelerations(0);
    EXPECT_LT(length(at_rest.drag), 1e-12);
  }
}

TEST(RoundEarth, along_the_great_circle_of_fire_the_wind_keeps_its_direction) {
  Fidelity f = over(EarthModel::sphere, GravityModel::inverse_square);
  f.drag = DragModel::equation;
  f.air = AirModel::constant;
  f.wind = WindModel::constant;
  Environment e = round_world(50, 0, 70);
  e.wind.velocity = {7, 0, -3};
  const Prepared p({}, {}, e, f);
  const double angle = 1.2, r = 6371000;
  const Vec3d w = wind(p.conditions(), p.body, 0.0, Vec3d{r * std::sin(angle), r * (std::cos(angle) - 1), 0});
  EXPECT_TRUE(near(w, {7 * std::cos(angle), -7 * std::sin(angle), -3}, 1e-14));
}

TEST(RoundEarth, the_ground_is_a_height_above_the_ellipsoid) {
  Environment e{.altitude = 1200,
                .earth = {.latitude = 40 * kDegree, .longitude = 179.9 * kDegree, .azimuth = 90 * kDegree}};
  const Flight flight = fly(bullet_308(), {.speed = 800, .elevation = 30 * kDegree}, e,
                            {.earth = EarthModel::ellipsoid, .rotation = RotationModel::none}, {}, {.ground = -200.0});
  ASSERT_EQ(flight.outcome(), Outcome::landed);
  const Geodetic end = flight.earth_frames().geodetic(flight.end().position);
  EXPECT_NEAR(end.height, 1000, 1e-8);
  EXPECT_NEAR(flight.at_height(100, Crossing::rising)->position.y, 100, 0.1);
}

TEST(RoundEarth, a_level_shot_from_the_ground_lands_only_when_it_comes_down) {
  Random r(31);
  for (int i = 0; i < 50; ++i) {
    Environment e{.altitude = r.one_in(2) ? 0 : r.in(0, 3000),
                  .earth = {.latitude = r.in(-1.57, 1.57), .azimuth = r.in(-3, 3)}};
    Fidelity f = over(EarthModel::ellipsoid, GravityModel::wgs84, Integrator::tsit5);
    f.precision = r.one_in(2) ? Precision::float32 : Precision::float64;
    const Flight flight = fly({}, {.speed = 500, .elevation = 0.5}, e, f);
    EXPECT_EQ(flight.outcome(), Outcome::landed);
    EXPECT_NEAR(flight.duration(), 2 * 500 * std::sin(0.5) / 9.8, 0.8);
  }
}

// ------------------------------------------------------------------------------------------------------ batches
TEST(RoundEarth, batches_give_the_numbers_of_single_flights) {
  Random r(41);
  for (int round = 0; round < 12; ++round) {
    Environment e = random_environment(r);
    e.gravity = {};
    e.earth.longitude = r.in(-3, 3);
    Fidelity f = random_fidelity(r);
    f.motion = Motion::force;
    f.integrator = round % 2 == 0 ? Integrator::tsit5 : Integrator::rk4;
    f.earth = round % 3 == 0 ? EarthModel::sphere_rotating : EarthModel::ellipsoid;
    f.gravity = static_cast<GravityModel>(1 + r.below(4));
    f.precision = r.one_in(3) ? Precision::float32 : Precision::float64;
    const Tolerance tolerance{.relative = f.precision == Precision::float32 ? 1e-5 : 1e-8, .step = 0.05};
    const Until until{.time = 20};
    const auto shots = random_shots(r, 20);
    for (const std::string& kernel : kernels()) {
      use_kernel(kernel);
      const BatchResult batch = fly_batch(shots, e, f, tolerance, until);
      for (std::size_t i = 0; i < shots.size(); ++i) {
        const Flight flight = fly(shots[i].projectile, shots[i].launch, e, f, tolerance, until);
        EXPECT_EQ(batch.shots[i].outcome, flight.outcome());
        EXPECT_TRUE(same_bits(batch.shots[i].position, flight.end().position)) << kernel << " " << i;
        EXPECT_TRUE(same_bits(batch.shots[i].time, flight.duration())) << kernel << " " << i;
      }
    }
    use_kernel("");
  }
}

}  // namespace physim::flight_round_earth_test
