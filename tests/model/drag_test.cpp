// Drag on every rung, against the formulas worked by hand and exact solutions.
#include "model/drag.hpp"

#include "support.hpp"

namespace physim::model_drag_test {

using test::near;
using test::Prepared;
constexpr double kPi = 3.14159265358979323846;

Fidelity with(DragModel drag, AirModel air = AirModel::constant, WindModel wind = WindModel::off) {
  return {.gravity = GravityModel::off, .drag = drag, .air = air, .wind = wind};
}

Environment air_of(double density, double sound_speed = 340) {
  Environment e = test::constant_gravity();
  e.atmosphere.model = AirModel::constant;
  e.atmosphere.density = density;
  e.atmosphere.sound_speed = sound_speed;
  return e;
}

ProjectileDef ball(double cd) { return {.mass = 0.145, .diameter = 0.0732, .drag = {.coefficient = cd}}; }

TEST(Drag, equation_with_a_constant_coefficient) {
  const Prepared p(ball(0.35), {}, air_of(1.2), with(DragModel::equation));
  const Vec3d v{30, -20, 10};
  // -1/2 rho |v| v Cd A / m
  const double k = 0.5 * 1.2 * std::sqrt(1400.0) * 0.35 * (kPi * 0.0732 * 0.0732 / 4) / 0.145;
  EXPECT_TRUE(near(p.acceleration(0, {{}, v}), v * -k, 1e-14));
  EXPECT_EQ(p.acceleration(0, {{}, {0, 0, 0}}), (Vec3d{0, 0, 0}));
}

TEST(Drag, form_factor_multiplies_the_coefficient) {
  ProjectileDef p = ball(0.35);
  p.drag.form_factor = 1.25;
  const Vec3d v{50, 5, 1};
  const Vec3d a = Prepared(p, {}, air_of(1.2), with(DragModel::equation)).acceleration(0, {{}, v});
  const Vec3d b = Prepared(ball(0.35 * 1.25), {}, air_of(1.2), with(DragModel::equation)).acceleration(0, {{}, v});
  EXPECT_TRUE(near(a, b, 1e-14));
}

TEST(Drag, ballistic_coefficient_equals_mass_over_form_and_diameter_squared) {
  ProjectileDef by_mass = test::bullet_308();
  by_mass.drag.ballistic_coefficient = 0;
  by_mass.drag.form_factor = 1.1;
  ProjectileDef by_bc = test::bullet_308();
  by_bc.drag.ballistic_coefficient = by_mass.mass / (1.1 * by_mass.diameter * by_mass.diameter);
  by_bc.mass = 77;  // plays no part then
  by_bc.diameter = 5;
  for (const double v : {100.0, 340.0, 800.0}) {
    const State<double> s{{0, 100, 0}, {v, 1, 2}};
    EXPECT_TRUE(near(Prepared(by_mass, {}, {}, with(DragModel::equation, AirModel::isa)).acceleration(0, s),
                     Prepared(by_bc, {}, {}, with(DragModel::equation, AirModel::isa)).acceleration(0, s), 1e-14));
  }
}

TEST(Drag, a_g7_bullet_by_hand) {
  const Prepared p(test::bullet_308(), {}, air_of(1.225, 340.294), with(DragModel::equation));
  // Mach 2.5: Cd of G7 0.2697; a = rho v^2 Cd pi / (8 BC); BC 0.218 lb/in2 = 153.269 kg/m2.
  const double v = 2.5 * 340.294;
  const double a = 1.225 * v * v * 0.2697 * kPi / (8 * 0.218 * 0.45359237 / (0.0254 * 0.0254));
  EXPECT_TRUE(near(p.acceleration(0, {{}, {v, 0, 0}}), {-a, 0, 0}, 1e-12));
}

TEST(Drag, bands_hold_from_their_speed_upwards) {
  ProjectileDef p = test::bullet_308();
  p.drag.table = DragTable::constant;
  p.drag.coefficient = 0.3;
  p.drag.bands = {{600, 400}, {0, 200}, {300, 300}};  // in any order
  const Prepared banded(p, {}, air_of(1.2), with(DragModel::equation));
  const auto expect = [&](double v, double bc) {
    EXPECT_TRUE(near(banded.acceleration(0, {{}, {v, 0, 0}}), {-1.2 * v * v * 0.3 * kPi / (8 * bc), 0, 0}, 1e-14)) << v;
  };
  expect(100, 200);
  expect(299.999, 200);
  expect(300, 300);
  expect(599, 300);
  expect(600, 400);
  expect(1500, 400);
}

TEST(Drag, below_the_lowest_band_its_coefficient_holds) {
  ProjectileDef p = test::bullet_308();
  p.drag.table = DragTable::constant;
  p.drag.coefficient = 0.3;
  p.drag.bands = {{500, 400}, {300, 300}};
  const Prepared banded(p, {}, air_of(1.2), with(DragModel::equation));
  EXPECT_TRUE(near(banded.acceleration(0, {{}, {200, 0, 0}}), {-1.2 * 200 * 200 * 0.3 * kPi / (8 * 300), 0, 0}, 1e-14));
}

TEST(Drag, acts_on_the_velocity_through_the_air) {
  Environment e = air_of(1.2);
  e.wind.velocity = {3, 1, -4};
  const Fidelity f = with(DragModel::equation, AirModel::constant, WindModel::constant);
  const Prepared windy(ball(0.35), {}, e, f);
  const Prepared calm(ball(0.35), {}, air_of(1.2), f);
  EXPECT_TRUE(near(windy.acceleration(0, {{}, {23, 11, -4}}), calm.acceleration(0, {{}, {20, 10, 0}}), 1e-14));
  EXPECT_EQ(windy.acceleration(0, {{}, {3, 1, -4}}), (Vec3d{0, 0, 0})) << "drifting with the wind";
}

TEST(Drag, mach_number_is_that_of_the_air_at_height) {
  const Prepared p(test::bullet_308(), {}, {}, with(DragModel::equation, AirModel::isa));
  const double z = 9000;
  const auto air = air_at({}, z);
  const double v = 1.0 * air->sound_speed;  // G7 at Mach 1: 0.3803
  const double a = air->density * v * v * 0.3803 * kPi / (8 * test::bullet_308().drag.ballistic_coefficient);
  EXPECT_TRUE(near(p.acceleration(0, {{0, z, 0}, {v, 0, 0}}), {-a, 0, 0}, 1e-11));
}

TEST(Drag, spheres_read_the_reynolds_number) {
  ProjectileDef p = ball(9);
  p.drag.table = DragTable::sphere;
  for (const double v : {0.01, 1.0, 40.0}) {
    const Prepared prepared(p, {}, {}, with(DragModel::equation, AirModel::isa));
    const auto air = air_at({}, 1500);
    const double re = air->density * v * p.diameter / air->viscosity;
    const double a = 0.5 * air->density * v * v * sphere_drag_coefficient(re) * kPi * 0.0732 * 0.0732 / 4 / p.mass;
    EXPECT_TRUE(near(prepared.acceleration(0, {{0, 1500, 0}, {0, -v, 0}}), {0, a, 0}, 1e-12)) << v;
  }
}

TEST(Drag, linear_quadratic) {
  ProjectileDef p = ball(9);
  p.drag.k1 = 0.02;
  p.drag.k2 = 0.003;
  const Vec3d v{3, 4, 12};  // 13 m/s
  const Prepared prepared(p, {}, {}, with(DragModel::linear_quadratic));
  EXPECT_TRUE(near(prepared.acceleration(0, {{}, v}), v * (-(0.02 + 0.003 * 13) / 0.145), 1e-14));
}

TEST(Drag, linear_quadratic_without_constants_equals_the_equation_at_launch) {
  Launch launch{.speed = 820};
  const ProjectileDef p = test::bullet_308();
  const Prepared cheap(p, launch, air_of(1.2), with(DragModel::linear_quadratic));
  const Prepared full(p, launch, air_of(1.2), with(DragModel::equation));
  const State<double> muzzle{{}, {820, 0, 0}};
  EXPECT_TRUE(near(cheap.acceleration(0, muzzle), full.acceleration(0, muzzle), 1e-14));
  EXPECT_TRUE(near(cheap.acceleration(0, {{}, {410, 0, 0}}), cheap.acceleration(0, muzzle) * 0.25, 1e-14));
}

TEST(Drag, damping_keeps_the_given_part_of_the_velocity_per_second) {
  ProjectileDef p = ball(9);
  p.drag.damping = 0.7;
  const Prepared prepared(p, {}, {}, with(DragModel::damping));
  EXPECT_TRUE(near(prepared.acceleration(0, {{}, {10, 0, 0}}), {10 * std::log(0.7), 0, 0}, 1e-15));
  Launch launch{.velocity = Vec3d{100, 0, 0}};
  Environment none = test::constant_gravity();
  none.gravity.acceleration = 0;
  const Flight flight = fly(p, launch, none, with(DragModel::damping), {}, {.ground = {}, .time = 3});
  EXPECT_TRUE(near(flight.at(1).velocity.x, 70, 1e-8));
  EXPECT_TRUE(near(flight.at(3).velocity.x, 34.3, 1e-8));
}

// Vertical fall and ascent with quadratic drag (the closed forms of analytic/quadratic_vertical.csv).
TEST(Drag, falls_approach_the_terminal_speed_as_they_should) {
  const struct {
    double vt, t, speed, fallen;
  } rows[] = {{10, 0.5, 4.5448029389361116358, 1.1796469692523917851},
              {10, 10, 9.999999939314905519, 92.931865850971630671},
              {54, 5, 38.889832028289176953, 108.708805181401768},
              {300, 20, 172.26207120580479819, 1835.7193006403220427}};
  for (const auto& row : rows) {
    ProjectileDef p = ball(0);
    p.drag.k2 = p.mass * 9.80665 / (row.vt * row.vt);
    Fidelity f = with(DragModel::linear_quadratic);
    f.gravity = GravityModel::constant;
    const Flight flight = fly(p, {}, test::constant_gravity(), f, {1e-13, 1e-13}, {.ground = {}, .time = 60});
    EXPECT_TRUE(near(flight.at(row.t).speed, row.speed, 1e-9)) << row.vt;
    EXPECT_TRUE(near(-flight.at(row.t).position.y, row.fallen, 1e-9)) << row.vt;
  }
}

// Plane flight with quadratic drag (the closed forms of analytic/quadratic_2d_constant_density.csv), from the
// hodograph.
TEST(Drag, flights_with_quadratic_drag_in_a_plane) {
  const struct {
    double v, elevation, k, t_apex, x_apex, y_apex, time, range, vx, vy;
  } rows[] = {{50, 45, 0.005, 2.7673478941346159315, 76.339862174362432015, 43.741784964251103826, 5.944800844407399675,
               136.29160608551371698, 15.273047571849172792, -25.53459830103255473},
              {800, 35, 0.0003, 16.428026633543170421, 4464.1264333793521677, 2244.292579234092935,
               41.405428649676385366, 6742.1516686403359291, 51.33461682347928699, -150.02471824039181729}};
  for (const auto& row : rows) {
    ProjectileDef p{.drag = {.coefficient = 1, .ballistic_coefficient = 1.2 * kPi / (8 * row.k)}};
    Fidelity f = with(DragModel::equation);
    f.gravity = GravityModel::constant;
    for (const Integrator integrator : test::kAdaptive) {
      f.integrator = integrator;
      const Flight flight =
          fly(p, {.speed = row.v, .elevation = row.elevation * test::kDegree}, air_of(1.2), f, {1e-13, 1e-13});
      ASSERT_EQ(flight.outcome(), Outcome::landed);
      const Sample end = flight.end();
      EXPECT_TRUE(near(flight.duration(), row.time, 1e-9)) << row.v;
      EXPECT_TRUE(near(end.position, {row.range, 0, 0}, 1e-9)) << row.v;
      EXPECT_TRUE(near(end.velocity, {row.vx, row.vy, 0}, 1e-9)) << row.v;
      ASSERT_EQ(flight.events()[0].kind, EventKind::apex);
      EXPECT_TRUE(near(flight.events()[0].time, row.t_apex, 1e-8)) << row.v;
      EXPECT_TRUE(near(flight.events()[0].position, {row.x_apex, row.y_apex, 0}, 1e-9)) << row.v;
    }
  }
}

// Fall through exponential air (the closed forms of analytic/fall_exponential_atmosphere.csv).
TEST(Drag, falls_through_exponential_air) {
  const struct {
    double k0, scale, start, z, speed;
  } rows[] = {{0.001, 8500, 30000, 15000, 284.255544524543627},
              {0.0005, 8500, 39000, 3900, 206.06741596938544152},
              {0.0001, 7000, 20000, 2000, 432.31295074129134803}};
  for (const auto& row : rows) {
    ProjectileDef p{.drag = {.coefficient = 1, .ballistic_coefficient = 1.2 * kPi / (8 * row.k0)}};
    Environment e = air_of(1.2);
    e.atmosphere.model = AirModel::exponential;
    e.atmosphere.scale_height = row.scale;
    Fidelity f = with(DragModel::equation, AirModel::exponential);
    f.gravity = GravityModel::constant;
    const Flight flight = fly(p, {.position = {0, row.start, 0}}, e, f, {1e-13, 1e-13}, {.ground = row.z});
    EXPECT_TRUE(near(flight.end().speed, row.speed, 1e-9));
  }
}

}  // namespace physim::model_drag_test
