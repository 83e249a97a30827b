// Aerodynamic coefficients and what they do to a body.
#include "model/aero_tables.hpp"
#include "model/stability.hpp"
#include "prepare/check.hpp"
#include "random_shots.hpp"
#include "rigid.hpp"

namespace physim::model_aero_test {

using namespace test;

/// Still air of density 1.2 and sound speed 340, no gravity, no drag at zero yaw.
Environment plain_air() {
  Environment e = constant_gravity();
  e.gravity.acceleration = 0;
  e.atmosphere.model = AirModel::constant;
  e.atmosphere.density = 1.2;
  e.atmosphere.sound_speed = 340;
  return e;
}
Fidelity in_air(BodyForm form, Integrator integrator = Integrator::dop853) {
  Fidelity f = rigid(integrator, form);
  f.air = AirModel::constant;
  return f;
}
ProjectileDef shell() { return {.mass = 15, .diameter = 0.1, .twist = 2, .inertia = {.moments = {0.02, 0.2, 0.2}}}; }
constexpr double kArea = 0.25 * 3.14159265358979323846 * 0.01;

// A body that flies off to infinity was given a cell behind the last one: a row beyond the end of its table.
TEST(AeroTables, no_number_is_in_a_cell_behind_the_last) {
  AeroDef aero{.lift = {{.mach = 0.5, .value = 1}, {.mach = 1.5, .value = 2}}};
  TablePool pool;
  Rotor<double> r{};
  add_aero(aero, pool, r);
  const auto cell = [&](double mach) { return cell_of(pool.rows().data(), r.mach, mach); };
  EXPECT_EQ(cell(0.4), 0);
  EXPECT_EQ(cell(0.5), 1);
  for (const double mach : {1.5, 1e29, 1e31, 1e300, kInfinity}) EXPECT_EQ(cell(mach), 2) << mach;
  EXPECT_EQ(cell(-kInfinity), 0);
  EXPECT_LE(cell(kNan), 2);
}

AeroCoefficient random_coefficient(Random& r, bool angles) {
  AeroCoefficient c;
  double mach = r.one_in(2) ? 0 : 0.3;
  for (int i = 0, n = 1 + r.below(6); i < n; ++i, mach += r.in(0.001, 0.6)) {
    double angle = r.one_in(2) ? 0 : 0.01;
    for (int j = 0, m = angles ? 1 + r.below(4) : 1; j < m; ++j, angle += r.in(0.001, 0.1))
      c.push_back({mach, angles ? angle : 0, r.in(-2, 2)});
  }
  return c;
}

TEST(Aero, kernels_read_the_tables_as_they_are) {
  Random r(7);
  for (int i = 0; i < 50; ++i) {
    ProjectileDef p = shell();
    for (const auto member :
         {&AeroDef::drag_yaw, &AeroDef::lift, &AeroDef::lift_cubic, &AeroDef::pitching, &AeroDef::pitching_cubic,
          &AeroDef::pitch_damping, &AeroDef::yaw_damping, &AeroDef::roll_damping})
      if (!r.one_in(5)) p.aero.*member = random_coefficient(r, false);
    p.aero.magnus_force = random_coefficient(r, true);
    p.aero.magnus_moment = random_coefficient(r, true);
    ASSERT_TRUE(check(p)) << check(p).error().text();
    const Prepared prepared(p, {}, plain_air(), in_air(BodyForm::axis));
    const Conditions<double>& c = prepared.conditions();
    using P = Pack<double, 4>;
    Rotor<P> rotors;
    for (int lane = 0; lane < 4; ++lane) put_lane(prepared.rotor, rotors, lane);
    for (int k = 0; k < 100; ++k) {
      const double mach = r.in(0, 4), angle = r.in(0, 0.5);
      const AeroCoefficients<double> found = aero_coefficients(c, prepared.rotor, mach, angle);
      const AeroCoefficients<P> packs = aero_coefficients(c, rotors, P(mach), P(angle));
      EXPECT_NEAR(found.drag_yaw, coefficient_at(p.aero.drag_yaw, mach, 0), 1e-12);
      EXPECT_NEAR(found.lift, coefficient_at(p.aero.lift, mach, 0), 1e-12);
      EXPECT_NEAR(found.roll_damping, coefficient_at(p.aero.roll_damping, mach, 0), 1e-12);
      const AeroCoefficient& yaw = p.aero.yaw_damping.empty() ? p.aero.pitch_damping : p.aero.yaw_damping;
      EXPECT_NEAR(found.yaw_damping, coefficient_at(yaw, mach, 0), 1e-12);
      EXPECT_NEAR(found.magnus_force, coefficient_at(p.aero.magnus_force, mach, angle), 1e-10);
      EXPECT_NEAR(found.magnus_moment, coefficient_at(p.aero.magnus_moment, mach, angle), 1e-10);
      EXPECT_TRUE(same_bits(packs.magnus_moment[2], found.magnus_moment) && same_bits(packs.lift[3], found.lift));
    }
  }
}

TEST(Aero, tables_are_linear_in_the_angle_first_then_in_mach) {
  // Two of McCoy's sections of CMpa of the 105 mm shell.
  const AeroCoefficient c{{0.81, 0, -0.46}, {0.81, 0.1, 0.08}, {0.87, 0, 0.4175}, {0.87, 0.3, 0.053}};
  const double left = -0.46 + 0.54 * 0.5, right = 0.4175 - 0.3645 * (0.05 / 0.3);
  EXPECT_NEAR(coefficient_at(c, 0.84, 0.05), 0.5 * (left + right), 1e-15);
  EXPECT_EQ(coefficient_at(c, 0.2, 0.7), 0.08);
  EXPECT_EQ(coefficient_at(c, 3, 0.7), 0.053);
  EXPECT_EQ(coefficient_at({}, 1, 1), 0);
}

/// One evaluation at an angle of attack `angle`, nose up, flying level along x at 100 m/s with spin 50 rad/s.
struct Evaluated {
  Vec3d acceleration;  // in W
  Vec3d turning;       // I omega' in W, as far as no gyroscopic moments are in it
};
Evaluated evaluated_at(const ProjectileDef& p, BodyForm form, double angle, const Vec3d& rates) {
  Launch launch{.speed = 100, .attitude = {.pitch = angle, .rates = rates}};
  ProjectileDef unrifled = p;
  unrifled.twist = 0;
  const Prepared b(unrifled, launch, plain_air(), in_air(form));
  const AeroLoad<double> load = body_aero(b.conditions(), b.rotor, air_state(b.conditions(), b.body, b.body.launch.x),
                                          b.body.launch.v, b.rotor.launch);
  const Attitude a = attitude_of(b.conditions(), b.body, b.rotor, 0, b.body.launch, b.rotor.launch);
  return {load.acceleration, form == BodyForm::axis ? load.moment : rotate(a.q_WB, load.moment)};
}

TEST(Aero, every_coefficient_does_what_its_name_says) {
  const double q = 0.5 * 1.2 * 1e4, s = std::sin(0.2), c = std::cos(0.2);
  const Vec3d nose{c, s, 0}, side{0, 0, 1}, normal{-s, c, 0};  // side: u x nose is along z
  for (const BodyForm form : {BodyForm::axis, BodyForm::quaternion}) {
    const auto with = [&](AeroCoefficient AeroDef::*member, double value, const Vec3d& rates = {}) {
      ProjectileDef p = shell();
      p.aero.*member = {{0, 0, value}};
      return evaluated_at(p, form, 0.2, rates);
    };
    const auto expect = [&](const Evaluated& e, const Vec3d& force, const Vec3d& moment) {
      EXPECT_TRUE(near(e.acceleration * 15.0, force, 1e-12, 1e-12));
      EXPECT_TRUE(near(e.turning, moment, 1e-12, 1e-12));
    };
    expect(with(&AeroDef::drag_yaw, 3), Vec3d{-1, 0, 0} * (q * kArea * 3 * s * s), {});
    expect(with(&AeroDef::lift, 2), Vec3d{0, 1, 0} * (q * kArea * 2 * s), {});
    expect(with(&AeroDef::lift_cubic, 2), Vec3d{0, 1, 0} * (q * kArea * 2 * s * s * s), {});
    expect(with(&AeroDef::pitching, 3), {}, side * (q * kArea * 0.1 * 3 * s));
    expect(with(&AeroDef::pitching_cubic, 3), {}, side * (q * kArea * 0.1 * 3 * s * s * s));
    const double per_rate = q * kArea * 0.1 * 0.1 / 100;  // q S d (d / V)
    expect(with(&AeroDef::pitch_damping, -5, {0, 0, 2}), {}, side * (per_rate * -5 * 2));
    expect(with(&AeroDef::pitch_damping, -5, {0, 2, 0}), {}, normal * (per_rate * -5 * 2));
    expect(with(&AeroDef::roll_damping, -0.01, {50, 0, 0}), {}, nose * (per_rate * -0.01 * 50));
    expect(with(&AeroDef::magnus_force, -0.5, {50, 0, 0}), side * (q * kArea * -0.5 * (50 * 0.1 / 100) * s), {});
    // nose x (path x nose) = path - nose cos: along -normal.
    expect(with(&AeroDef::magnus_moment, 0.4, {50, 0, 0}), {}, normal * (-per_rate * 0.4 * 50 * s));
  }
}

TEST(Aero, areas_lengths_and_what_rates_are_divided_by_are_as_given) {
  ProjectileDef p = shell();
  p.inertia.moments = {0.02, 0.2, 0.3};
  p.aero = {.area = 0.5, .length = 2, .span = 3, .rate_norm = RateNorm::twice_speed};
  p.aero.pitch_damping = {{0, 0, -1}};
  p.aero.yaw_damping = {{0, 0, -2}};
  p.aero.roll_damping = {{0, 0, -4}};
  const double q = 0.5 * 1.2 * 1e4;
  const Evaluated e = evaluated_at(p, BodyForm::quaternion, 0, {10, 20, 30});
  EXPECT_TRUE(near(
      e.turning,
      Vec3d{q * 0.5 * 3 * -4 * 10 * 3 / 200, q * 0.5 * 3 * -2 * 20 * 3 / 200, q * 0.5 * 2 * -1 * 30 * 2 / 200}, 1e-12));
}

TEST(Aero, spin_dies_away_exponentially) {
  ProjectileDef p = shell();
  p.aero.roll_damping = {{0, 0, -0.02}};
  for (const BodyForm form : {BodyForm::axis, BodyForm::quaternion}) {
    const Flight flight = fly(p, {.speed = 300}, plain_air(), in_air(form), {1e-11, 1e-11}, {.ground = {}, .time = 5});
    const double rate = 0.5 * 1.2 * 300 * kArea * 0.01 * 0.02 / 0.02;
    EXPECT_NEAR(flight.end().angular_velocity.x / flight.at(0).angular_velocity.x, std::exp(-5 * rate), 1e-9);
  }
}

TEST(Aero, fins_make_it_swing_about_its_path) {
  // Small angles at constant speed: omega^2 = -M_alpha / It.
  ProjectileDef p = shell();
  p.twist = 0;
  p.aero.pitching = {{0, 0, -2}};
  Launch launch{.speed = 200, .attitude = {.pitch = 1e-4}};
  const double omega = std::sqrt(0.5 * 1.2 * 200 * 200 * kArea * 0.1 * 2 / 0.2);
  const Flight flight =
      fly(p, launch, plain_air(), in_air(BodyForm::automatic), {1e-12, 1e-12}, {.ground = {}, .time = 3});
  EXPECT_EQ(flight.fidelity_in_use().fidelity.body_form, BodyForm::quaternion);
  for (const double t : {0.3, 1.1, 3.0})
    EXPECT_NEAR(rotate(flight.at(t).orientation, Vec3d{1, 0, 0}).y, 1e-4 * std::cos(omega * t), 1e-8);
  ASSERT_TRUE(flight.stability(0));
  EXPECT_EQ(flight.stability(0)->gyroscopic, 0);
}

TEST(Aero, both_forms_fly_the_same_shell) {
  ProjectileDef p = shell();
  p.drag.coefficient = 0.2;
  p.aero.drag_yaw = {{0, 0, 3}};
  p.aero.lift = {{0, 0, 1.6}, {0.5, 0, 1.4}, {1, 0, 1.7}};
  p.aero.pitching = {{0, 0, 3.5}, {1, 0, 4}};
  p.aero.pitch_damping = {{0, 0, -5}};
  p.aero.roll_damping = {{0, 0, -0.015}};
  p.aero.magnus_force = {{0, 0, -0.3}};
  p.aero.magnus_moment = {{0, 0, -0.3}, {0, 0.01, 0.1}};
  Launch launch{.speed = 250, .elevation = 0.8, .attitude = {.rates = {0, 1, 2}}};
  Environment e{.wind = {.velocity = {-3, 0.5, 4}}, .earth = {.latitude = 0.8, .azimuth = 1}};
  const auto flown = [&](BodyForm form) {
    Fidelity f = Fidelity::simulation();
    f.integrator = Integrator::dop853;
    f.rotation = RotationModel::rigid_body;
    f.body_form = form;
    return fly(p, launch, e, f, {1e-11, 1e-11}, {.ground = {}, .time = 4});
  };
  const Flight a = flown(BodyForm::axis), b = flown(BodyForm::quaternion);
  EXPECT_TRUE(near(a.end().position, b.end().position, 1e-8));
  EXPECT_TRUE(near(rotate(a.end().orientation, Vec3d{1, 2, 3}), rotate(b.end().orientation, Vec3d{1, 2, 3}), 1e-5));
  EXPECT_NEAR(a.end().angle_of_attack, b.end().angle_of_attack, 1e-7);
}

TEST(Aero, bad_tables_are_refused_with_their_place) {
  const auto place = [](const AeroDef& aero) {
    ProjectileDef p = shell();
    p.aero = aero;
    const Status status = check(p);
    return status ? std::string() : status.error().place;
  };
  EXPECT_EQ(place({.area = -1}), "projectile.aero.area");
  EXPECT_EQ(place({.lift = {{1, 0, 1}, {0.5, 0, 1}}}), "projectile.aero.lift[1]");
  EXPECT_EQ(place({.lift = {{1, 0, 1}, {1, 0.1, 1}}}), "projectile.aero.lift[1]");
  EXPECT_EQ(place({.magnus_moment = {{1, 0.1, 1}, {1, 0, 1}}}), "projectile.aero.magnus_moment[1]");
  EXPECT_EQ(place({.roll_damping = {{0, 0, kNan}}}), "projectile.aero.roll_damping[0]");
  EXPECT_EQ(place({.lift = {{1, 0, 1}}, .pitching = {{1.00001, 0, 1}}}), "projectile.aero");
  EXPECT_EQ(place({.magnus_force = {{1, 0, 1}, {1, 1e-6, 1}}}), "projectile.aero.magnus_force");
}

/// Through every door, to the bit.
void expect_same_everywhere(RotationModel rotation) {
  std::vector<Shot> shots;
  Random r(11);
  for (int i = 0; i < 20; ++i) {
    Shot s{shell(), {.speed = 100 + 20.0 * i, .elevation = 0.3}};
    if (i % 3 != 0) s.projectile.aero.lift = random_coefficient(r, false);
    if (i % 4 != 0) s.projectile.aero.magnus_moment = random_coefficient(r, true);
    s.projectile.aero.pitching = {{0, 0, 3}};
    s.launch.attitude.rates = {0, 1, 1};
    if (i % 5 == 0) s.projectile.twist = 0;
    shots.push_back(s);
  }
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Fidelity f = Fidelity::simulation();
    f.integrator = Integrator::rk4;
    f.rotation = rotation;
    f.precision = precision;
    const Tolerance tolerance{.step = 1.0 / 256};
    const Until until{.time = 0.25};
    for (const std::string& kernel : kernels()) {
      ASSERT_TRUE(use_kernel(kernel));
      const BatchResult batch = fly_batch(shots, {}, f, tolerance, until);
      World world;
      for (const Shot& s : shots) {
        ProjectileDef p = s.projectile;
        p.fidelity = f;
        ASSERT_TRUE(world.spawn(p, s.launch));
      }
      for (int step = 0; step < 64; ++step) ASSERT_TRUE(world.step(1.0 / 256));
      const auto ids = world.ids();
      for (std::size_t k = 0; k < shots.size(); ++k) {
        const Sample end = fly(shots[k].projectile, shots[k].launch, {}, f, tolerance, until).end();
        ASSERT_EQ(world[ids[k]].fidelity_in_use().fidelity.rotation, rotation) << k;
        ASSERT_TRUE(same_bits(batch.shots[k].position, end.position)) << kernel << k;
        ASSERT_TRUE(same_bits(batch.attitudes[k].angular_velocity, end.angular_velocity)) << kernel << k;
        ASSERT_TRUE(same_bits(world[ids[k]].position(), end.position)) << kernel << k;
        const double gate = precision == Precision::float32 ? 1e-4 : 1e-12;
        EXPECT_TRUE(near(world[ids[k]].accelerations().total, end.acceleration, gate)) << kernel << k;
      }
    }
  }
  use_kernel("");
}
TEST(Aero, batches_and_worlds_fly_tables_as_flights_do) { expect_same_everywhere(RotationModel::rigid_body); }
TEST(ModifiedPointMass, batches_and_worlds_fly_as_flights_do) {
  expect_same_everywhere(RotationModel::modified_point_mass);
}

/// Leaves numbers in memory that would lead a look-up astray. (g++ 12 clears such lanes anyway; clang does not.)
template <class S>
[[gnu::noinline]] void soil_stack() {
  volatile S soiled[(1 << 19) / sizeof(S)];
  for (volatile S& x : soiled) x = S(4e6);
}

TEST(Aero, lanes_that_hold_no_flight_read_no_table) {
  Shot shot{shell(), {.speed = 300}};
  shot.projectile.aero.lift = {{0, 0, 1}, {0.8, 0, 2}};
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::rigid_body;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    f.precision = precision;
    const Until until{.ground = {}, .time = 0.2, .events = {{EventKind::speed, 299.9}}};
    const Flight alone = fly(shot.projectile, shot.launch, {}, f, {}, until);
    for (const std::string& kernel : kernels()) {
      ASSERT_TRUE(use_kernel(kernel));
      precision == Precision::float64 ? soil_stack<double>() : soil_stack<float>();
      const BatchResult batch = fly_batch(std::vector<Shot>{shot}, {}, f, {}, until);
      EXPECT_TRUE(same_bits(batch.shots[0].position, alone.end().position)) << kernel;
    }
  }
  use_kernel("");
}

}  // namespace physim::model_aero_test
