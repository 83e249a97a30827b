// NASA's check-cases for flight simulators, as far as a point mass goes: where the ball is and how fast.
//
// Source: E. B. Jackson, R. E. Shelton, A. A. Jackson, M. C. Pettus, Check-Cases for Verification of
// 6-Degree-of-Freedom Flight Vehicle Simulations, NASA/TM-2015-218675, cases 1, 4, 6, 7 and 9. The figures are of
// converged solutions of those definitions (Runge-Kutta of order 4 at 1 ms in long double).
#include "support.hpp"

namespace physim::flight_nesc_point_mass_test {

using namespace test;

constexpr double kFoot = 0.3048, kSlug = 14.5939029372;

struct Row {
  double time, altitude, longitude, north, east, down, mach;  // [s, m, deg, m/s, m/s, m/s, -]
};

struct Case {
  ProjectileDef ball;
  Environment place;
  Launch launch;
  Fidelity fidelity;

  explicit Case(double drag_coefficient) {
    ball.mass = kSlug;
    ball.diameter = kFoot * std::sqrt(4 * 0.1963495 / 3.14159265358979323846);
    ball.drag.coefficient = drag_coefficient;
    place.altitude = 30000 * kFoot;
    place.earth.azimuth = 90 * kDegree;
    launch.velocity = Vec3d{};
    fidelity = {.integrator = Integrator::dop853,
                .gravity = GravityModel::j2,
                .drag = drag_coefficient > 0 ? DragModel::equation : DragModel::off,
                .earth = EarthModel::ellipsoid};
  }

  void expect(std::initializer_list<Row> rows) const {
    const Flight flight =
        fly(ball, launch, place, fidelity, {.relative = 1e-13, .absolute = 1e-12}, {.ground = {}, .time = 30});
    ASSERT_EQ(flight.outcome(), Outcome::time_limit);
    EXPECT_TRUE(flight.fidelity_in_use().fidelity.earth == fidelity.earth);
    EXPECT_TRUE(flight.fidelity_in_use().fidelity.gravity == fidelity.gravity);
    const EarthFrames frames = flight.earth_frames();
    for (const Row& row : rows) {
      const Sample s = flight.at(row.time);
      const Geodetic g = frames.geodetic(s.position);
      const Vec3d v = frames.local(s.position, s.velocity);
      EXPECT_NEAR(g.height, row.altitude, 1e-8) << row.time;  // the gates of the definition: 3e-6 m,
      EXPECT_NEAR(g.latitude / kDegree, 0, 1e-13) << row.time;
      EXPECT_NEAR(g.longitude / kDegree, row.longitude, 1e-13) << row.time;  // 1e-11 deg,
      EXPECT_NEAR(v.y, row.north, 1e-9) << row.time;                         // 3e-7 m/s
      EXPECT_NEAR(v.x, row.east, 1e-9) << row.time;
      EXPECT_NEAR(v.z, -row.down, 1e-9) << row.time;
      EXPECT_NEAR(s.mach, row.mach, 1e-10) << row.time;
    }
  }
};

TEST(Nesc, case_1_a_dropped_sphere_without_drag) {
  Case(0).expect({{10, 8656.3822013925340, 2.1265413372214559e-06, 0, 0.0711180160192265745, 97.526041292155529,
                   0.31942508077685381},
                  {20, 7193.3798863081798, 1.7016618097188434e-05, 0, 0.2845263763835503524, 195.08187060784796,
                   0.62627107659365897},
                  {30, 4754.5460465896268, 5.7455221335505268e-05, 0, 0.6403881790599462202, 292.69732606189989,
                   0.91029326372755493}});
}

TEST(Nesc, case_4_a_dropped_sphere_over_a_round_earth_that_stands_still) {
  Case c(0.1);
  c.place.gravity.radius = 6371007.1809;
  c.place.gravity.acceleration = 3.986004418e14 / (6371007.1809 * 6371007.1809);
  c.fidelity.gravity = GravityModel::inverse_square;
  c.fidelity.earth = EarthModel::sphere;
  c.expect({{10, 8656.7116818682348, 0, 0, 0, 96.987000720928859, 0.31766095003548114},
            {20, 7224.3672343230732, 0, 0, 0, 187.86088818309181, 0.60334006471996938},
            {30, 4947.3020305925757, 0, 0, 0, 264.29358646714789, 0.82396097520352627}});
}

TEST(Nesc, case_6_a_dropped_sphere_with_drag) {
  Case(0.1).expect({{10, 8658.6922686324036, 2.1114393050075636e-06, 0, 0.070271248295528406, 96.594775982040700,
                     0.3163851384305135},
                    {20, 7232.0406503292784, 1.6512081135405712e-05, 0, 0.270164568358638989, 187.12870902740586,
                     0.60105119653501512},
                    {30, 4963.4984469165592, 5.3379825430245413e-05, 0, 0.561725337594126237, 263.35052941894196,
                     0.821191365763154}});
}

TEST(Nesc, case_7_a_dropped_sphere_in_steady_wind) {
  Case c(0.1);
  c.place.wind.velocity = {20 * kFoot, 0, 0};  // towards the east
  c.expect({{10, 8658.7168183663615, 4.7774904162372686e-06, 0, 0.158339948076062202, 96.589706366495674,
             0.31696576211682772},
            {20, 7232.1408818423128, 3.7964239301200811e-05, 0, 0.635582474296717138, 187.11877014503932,
             0.60127530531468145},
            {30, 4963.7171333646525, 0.00012854173478559486, 0, 1.435112875638984601, 263.33713994458335,
             0.82127863213900028}});
}

TEST(Nesc, case_9_a_cannonball_to_the_east) {
  Case c(0.1);
  c.place.altitude = 0;
  c.launch.velocity = Vec3d{1000 * kFoot, 1000 * kFoot, 0};
  c.expect(
      {{10, 2227.0537732890602, 0.024025631650305971, 0, 239.668482540561829, -152.42413852682989, 0.85644806805655858},
       {20, 3177.2219372785636, 0.043990591862854309, 0, 207.881773202536707, -41.145249718029747, 0.64631897066021729},
       {30, 3097.0707864516040, 0.061647863356258809, 0, 186.155617797067648, 55.396822758122608,
        0.59178728301560518}});
}

TEST(Nesc, the_azimuth_of_the_world_frame_changes_nothing) {
  Case east(0.1), oblique(0.1);
  for (Case* c : {&east, &oblique}) c->place.earth.latitude = 37 * kDegree;
  oblique.place.earth.azimuth = -153 * kDegree;
  east.launch.velocity = Vec3d{200, 50, -30};  // east, up, south
  const double a = oblique.place.earth.azimuth - 90 * kDegree;
  oblique.launch.velocity = Vec3d{200 * std::cos(a) - 30 * std::sin(a), 50, -200 * std::sin(a) - 30 * std::cos(a)};
  const auto end_of = [](const Case& c) {
    const Flight f =
        fly(c.ball, c.launch, c.place, c.fidelity, {.relative = 1e-13, .absolute = 1e-12}, {.ground = {}, .time = 30});
    return f.earth_frames().earth_fixed(f.end().position, f.end().velocity);
  };
  EXPECT_TRUE(near(end_of(east).position, end_of(oblique).position, 0, 2e-8));
  EXPECT_TRUE(near(end_of(east).velocity, end_of(oblique).velocity, 0, 2e-9));
}

}  // namespace physim::flight_nesc_point_mass_test
