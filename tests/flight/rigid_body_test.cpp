// Rigid bodies without torque, through every door.
#include "rigid.hpp"
#include "solve/problems.hpp"

namespace physim::flight_rigid_body_test {

using namespace test;

constexpr Integrator kIntegrators[] = {Integrator::explicit_euler, Integrator::semi_implicit_euler,
                                       Integrator::heun,           Integrator::rk4,
                                       Integrator::rk43,           Integrator::tsit5,
                                       Integrator::dop853};

Environment still_place() {
  Environment e = constant_gravity();
  e.gravity.acceleration = 0;
  return e;
}

Flight spun(Integrator integrator, double time, const Tolerance& tolerance = {}, const Environment& e = still_place()) {
  return fly(nasa_brick(), spun_launch(), e, rigid(integrator), tolerance, {.ground = {}, .time = time});
}

Vec3d momentum_in_W(const Sample& s) {
  return rotate(s.orientation, component_product(nasa_brick().inertia.moments, s.angular_velocity));
}
double energy(const Sample& s) {
  return 0.5 * dot(s.angular_velocity, component_product(nasa_brick().inertia.moments, s.angular_velocity));
}

// Jacobi elliptic functions, 20 digits: rates 10, 20, 30 deg/s of the NASA brick without torque.
struct Row {
  double time, p, q, r;
};
constexpr Row kFreeBrick[] = {{2, -1.7508153285528998745, 23.649557759850332789, 28.071320044918197627},
                              {10, -2.4189022216928768839, -23.552569519560503285, 28.128592630041436688},
                              {30, 12.618390775914219729, -17.397474761611393113, 31.119588886944344407},
                              {1000, -7.812436371150913675, -21.541497874462120213, 29.240003162824880293}};

TEST(RigidBody, free_brick_turns_as_the_elliptic_functions_say) {
  const Flight flight = spun(Integrator::dop853, 1001, {1e-14, 1e-14});
  ASSERT_EQ(flight.fidelity_in_use().fidelity.rotation, RotationModel::rigid_body);
  EXPECT_EQ(flight.fidelity_in_use().fidelity.body_form, BodyForm::quaternion);
  for (const Row& row : kFreeBrick) {
    const Vec3d exact = body_rates(row.p, row.q, row.r) * kDegree;
    EXPECT_TRUE(near(flight.at(row.time).angular_velocity, exact, row.time > 100 ? 1e-9 : 1e-11)) << row.time;
  }
}

TEST(RigidBody, energy_momentum_and_the_length_of_the_quaternion_are_kept) {
  const Flight flight = spun(Integrator::dop853, 1000, {1e-13, 1e-13});
  const Sample first = flight.at(0);
  EXPECT_TRUE(near(energy(first), 0.0018893006752780217, 1e-12));
  EXPECT_TRUE(near(length(momentum_in_W(first)), 0.0059100190096278274, 1e-12));
  for (double t = 0; t <= 1000; t += 7.3) {
    const Sample s = flight.at(t);
    EXPECT_TRUE(near(energy(s), energy(first), 1e-10));
    EXPECT_TRUE(near(momentum_in_W(s), momentum_in_W(first), 1e-10)) << t;
    EXPECT_NEAR(norm(s.orientation), 1, 4e-16);
  }
}

/// The brick after 10 s in n fixed steps.
Attitude turned(Integrator integrator, int n) {
  const Prepared p(nasa_brick(), spun_launch(), still_place(), rigid(integrator));
  Flyer<double> flyer{};
  flyer.body = p.body;
  *flyer.rotor = p.rotor;
  Step<double>& s = flyer.step;
  s.start = p.body.launch;
  s.turn->start = p.rotor.launch;
  s.h = 10.0 / n;
  set_slope(p.conditions(), flyer, 0);
  for (int i = 0; i < n; ++i) {
    s.t = i * s.h;
    s.t_end = s.t + s.h;
    take_step(p.conditions(), flyer, 1e-9, 1e-9);
    s.start = s.end;
    s.slope[0] = s.slope[end_slope(integrator)];
    s.turn->start = s.turn->end;
    s.turn->slope[0] = s.turn->slope[end_slope(integrator)];
  }
  return attitude_of(p.conditions(), p.body, p.rotor, 10, s.start, s.turn->start);
}

/// How far rates are off the elliptic functions, and the attitude off the method of order 8 at small steps.
double error_after(Integrator integrator, int n) {
  static const Attitude exact = turned(Integrator::dop853, 80);
  const Row& row = kFreeBrick[1];
  const Attitude a = turned(integrator, n);
  return length(a.omega - body_rates(row.p, row.q, row.r) * kDegree) +
         length(rotate(a.q_WB, Vec3d{1, 2, 3}) - rotate(exact.q_WB, Vec3d{1, 2, 3}));
}

TEST(RigidBody, every_integrator_has_its_order) {
  struct Promise {
    Integrator integrator;
    int order, steps;
  };
  for (const auto& [integrator, order, n] :
       {Promise{Integrator::explicit_euler, 1, 8000}, Promise{Integrator::semi_implicit_euler, 1, 8000},
        Promise{Integrator::heun, 2, 1000}, Promise{Integrator::rk4, 4, 120}, Promise{Integrator::rk43, 4, 120},
        Promise{Integrator::tsit5, 5, 120}, Promise{Integrator::dop853, 8, 16}})
    EXPECT_NEAR(observed_order(error_after(integrator, n), error_after(integrator, n * 3 / 2), 1.5), order, 0.1)
        << text(integrator);
}

TEST(RigidBody, dense_output_is_no_less_accurate_than_the_steps) {
  const Flight exact = spun(Integrator::dop853, 10, {1e-15, 1e-15});
  const auto error = [&](const Flight& f) {
    double worst = 0;
    for (double t = 0; t < 10; t += 0.0137)
      worst = std::max(
          worst, length(rotate(f.at(t).orientation, Vec3d{1, 2, 3}) - rotate(exact.at(t).orientation, Vec3d{1, 2, 3})));
    return worst;
  };
  const double coarse = error(spun(Integrator::rk4, 10, {.step = 0.1})),
               fine = error(spun(Integrator::rk4, 10, {.step = 0.05}));
  EXPECT_GT(observed_order(coarse, fine, 2), 3.8) << coarse << ' ' << fine;
  for (const double tolerance : {1e-6, 1e-9, 1e-12})
    for (const Integrator i : kAdaptive)
      EXPECT_LT(error(spun(i, 10, {tolerance, tolerance})), 300 * tolerance) << text(i);
}

TEST(RigidBody, both_forms_fly_the_same) {
  ProjectileDef shell{.twist = 2, .inertia = {.moments = {0.02, 0.2, 0.2}}};
  Launch launch{.speed = 50, .elevation = 0.4};
  launch.attitude = {.yaw = 0.1, .pitch = 0.2, .roll = 0.3, .rates = {1, 2, -0.7}};
  Environment e{.earth = {.latitude = 0.8, .azimuth = 1, .rotation_rate = 0.05}};
  Fidelity f = rigid(Integrator::dop853);
  f.earth = EarthModel::flat_coriolis;
  const auto flown = [&](BodyForm form) {
    f.body_form = form;
    return fly(shell, launch, e, f, {1e-13, 1e-13}, {.ground = {}, .time = 3});
  };
  const Flight axis = flown(BodyForm::automatic), quaternion = flown(BodyForm::quaternion);
  EXPECT_EQ(axis.fidelity_in_use().fidelity.body_form, BodyForm::axis);
  EXPECT_EQ(quaternion.fidelity_in_use().fidelity.body_form, BodyForm::quaternion);
  for (const double t : {0.0, 0.7, 3.0}) {
    const Sample a = axis.at(t), q = quaternion.at(t);
    for (const Vec3d& v : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
      EXPECT_TRUE(near(rotate(a.orientation, v), rotate(q.orientation, v), 1e-9)) << t;
    EXPECT_TRUE(near(a.angular_velocity, q.angular_velocity, 1e-10)) << t;
  }
}

/// Its rates across the axis die away by their own coefficients: exp(-q S d^2 C t / I) each, whatever form is asked
/// for.
TEST(RigidBody, a_yaw_damping_of_its_own_is_felt_where_the_axis_form_is_asked_for) {
  ProjectileDef p = test::nasa_brick();
  p.inertia.moments = {0.01, 0.1, 0.1};
  p.twist = 1e9;  // no spin to speak of
  p.diameter = 0.2;
  p.aero.pitch_damping = {{0, 0, -2}};
  p.aero.yaw_damping = {{0, 0, -6}};
  Launch launch{.speed = 100, .attitude = {.rates = {0, 0.1, 0.1}}};
  Environment air{.gravity = {.model = GravityModel::off},
                  .atmosphere = {.model = AirModel::constant, .density = 1.2, .sound_speed = 340.0}};
  const double area = 0.25 * 3.14159265358979323846 * 0.2 * 0.2, rate = 0.5 * 1.2 * 100 * area * 0.2 * 0.2 / 0.1;
  for (const BodyForm form : {BodyForm::automatic, BodyForm::axis, BodyForm::quaternion}) {
    Fidelity f = test::rigid(Integrator::dop853, form);
    f.air = AirModel::constant, f.drag = DragModel::equation;
    const Flight flight = fly(p, launch, air, f, {1e-11, 1e-12}, {.ground = {}, .time = 1});
    const Vec3d turning = flight.end().angular_velocity;
    EXPECT_NEAR(turning.y, 0.1 * std::exp(-6 * rate), 1e-4) << static_cast<int>(form);
    EXPECT_NEAR(turning.z, 0.1 * std::exp(-2 * rate), 1e-4) << static_cast<int>(form);
  }
}

TEST(RigidBody, stands_still_among_the_stars_while_the_earth_turns) {
  Environment e{.earth = {.latitude = 0.7, .longitude = 0.3, .azimuth = 0.5, .rotation_rate = 0.1}};
  Launch launch{.speed = 10, .elevation = 1};
  launch.attitude = {.frame = AttitudeFrame::world, .yaw = 1, .pitch = 0.5, .rate_frame = RateFrame::inertial};
  for (const EarthModel earth : {EarthModel::flat_coriolis, EarthModel::ellipsoid})
    for (const BodyForm form : {BodyForm::axis, BodyForm::quaternion}) {
      ProjectileDef ball{.inertia = {.moments = {1, 1, 1}}};
      Fidelity f = rigid(Integrator::dop853, form);
      f.earth = earth;
      f.gravity = GravityModel::off;
      const Flight flight = fly(ball, launch, e, f, {1e-12, 1e-12}, {.ground = {}, .time = 20});
      const EarthFrames frames(e, EarthModel::ellipsoid);
      const auto nose_in_I = [&](double t) {
        const Vec3d nose = rotate(flight.at(t).orientation, Vec3d{1, 0, 0});
        return frames.inertial({}, nose, t).velocity - frames.inertial({}, {}, t).velocity;
      };
      EXPECT_TRUE(near(nose_in_I(20), nose_in_I(0), 1e-9));
      EXPECT_LT(length(flight.end().angular_velocity), 1e-12);
    }
}

// So long a step overflows on its way: its error is not a number.
TEST(RigidBody, a_step_that_overflows_is_not_accepted) {
  ProjectileDef p{.mass = 10, .twist = 0.02, .inertia = {.moments = {0.007, 0.025, 0.025}}};
  Launch launch{.speed = 400, .attitude = {.yaw = 0.1, .rates = {0, 1, 2}}};
  for (const Integrator integrator : kAdaptive) {
    Fidelity f = rigid(integrator, BodyForm::axis);
    f.precision = Precision::float32;
    const Flight flight = fly(p, launch, still_place(), f, {1e-4, 1e-4}, {.ground = {}, .time = 0.05});
    const double spin = 2 * 3.14159265358979323846 * 400 / 0.02;
    for (const double t : {0.0, 0.01, 0.03, 0.05}) EXPECT_NEAR(flight.at(t).angular_velocity.x, spin, 1e-3 * spin) << t;
    EXPECT_TRUE(near(flight.at(0.03).position, Vec3d{12, 0, 0}, 1e-5));
  }
}

TEST(RigidBody, launch_points_along_the_bore_with_the_spin_of_its_rifling) {
  ProjectileDef shell{.twist = -1.8, .inertia = {.moments = {0.02, 0.2, 0.2}}};
  const Flight flight = fly(shell, {.speed = 100, .elevation = 0.5, .azimuth = 0.3}, {}, rigid(Integrator::tsit5));
  const Sample s = flight.at(0);
  EXPECT_TRUE(near(rotate(s.orientation, Vec3d{1, 0, 0}), s.velocity * 0.01, 1e-14));
  EXPECT_TRUE(near(s.angular_velocity, Vec3d{-2 * 3.14159265358979323846 * 100 / 1.8, 0, 0}, 1e-13));
  EXPECT_LT(s.angle_of_attack, 1e-13);
  EXPECT_NEAR(rotate(s.orientation, Vec3d{0, 0, 1}).y, 0, 1e-15);  // z level to the right
}

TEST(RigidBody, what_cannot_turn_is_granted_less_with_a_reason) {
  const auto in_use = [](const ProjectileDef& p, const Fidelity& f) { return grant(f, p, {}); };
  const auto refused = [&](const ProjectileDef& p, const Fidelity& f) {
    const FidelityInUse granted = in_use(p, f);
    return granted.fidelity.rotation == RotationModel::none && granted.notes.back().effect == "rotation";
  };
  EXPECT_TRUE(refused(ProjectileDef{}, rigid(Integrator::rk4)));
  EXPECT_TRUE(refused(nasa_brick(), rigid(Integrator::classic)));
  Fidelity f = rigid(Integrator::rk4);
  f.planar = true;
  EXPECT_TRUE(refused(nasa_brick(), f));
  f = rigid(Integrator::rk4);
  f.motion = Motion::velocity;
  EXPECT_TRUE(refused(nasa_brick(), f));
  f = rigid(Integrator::rk4, BodyForm::axis);
  EXPECT_EQ(in_use(nasa_brick(), f).fidelity.body_form, BodyForm::quaternion);
  EXPECT_EQ(in_use(nasa_brick(), f).notes.back().effect, "body_form");
}

TEST(RigidBody, impossible_inertia_is_refused) {
  for (const Inertia& bad :
       {Inertia{{1, 1, 3}, {}}, Inertia{{-1, 1, 1}, {}}, Inertia{{1, 1, 1}, {2, 0, 0}}, Inertia{{kNan, 1, 1}, {}}}) {
    const Flight flight = fly({.inertia = bad}, {}, {}, rigid(Integrator::rk4));
    EXPECT_EQ(flight.outcome(), Outcome::refused);
    EXPECT_EQ(flight.error()->place.substr(0, 18), "projectile.inertia");
  }
}

TEST(RigidBody, products_of_inertia_are_a_turned_body) {
  // The brick's tensor seen from axes that are turned by r: the same motion, seen from them.
  const Quatd r = quat_from_yaw_pitch_roll(0.3, -0.5, 0.8);
  const Vec3d m = nasa_brick().inertia.moments;
  const auto moment = [&](const Vec3d& a, const Vec3d& b) {
    return dot(rotate(conjugate(r), a), component_product(m, rotate(conjugate(r), b)));
  };
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  ProjectileDef turned = nasa_brick();
  turned.inertia = {{moment(x, x), moment(y, y), moment(z, z)}, {moment(x, y), moment(x, z), moment(y, z)}};
  Launch launch = spun_launch();
  launch.attitude.rates = rotate(r, launch.attitude.rates);
  const Tolerance tolerance{1e-13, 1e-13};
  const Flight a = spun(Integrator::dop853, 30, tolerance);
  const Flight b = fly(turned, launch, still_place(), rigid(Integrator::dop853), tolerance, {.ground = {}, .time = 30});
  EXPECT_TRUE(near(b.end().angular_velocity, rotate(r, a.end().angular_velocity), 1e-9));
}

// ------------------------------------------------------------------------------------------- doors
/// Bodies of all kinds that fall a few seconds onto the ground.
std::vector<Shot> some_shots() {
  std::vector<Shot> shots;
  for (int i = 0; i < 37; ++i) {
    Shot s{nasa_brick(), spun_launch()};
    if (i % 3 == 0) s.projectile.inertia.moments = {0.01, 0.1, 0.1}, s.projectile.twist = 3 + i;
    s.projectile.drag.coefficient = 0.4;
    s.launch.position = {0, 1.0 + i, 0};
    s.launch.speed = 3 + i;
    s.launch.elevation = 0.02 * i;
    s.launch.attitude.yaw = 0.1 * i;
    shots.push_back(s);
  }
  return shots;
}
Fidelity falling(Integrator integrator, Precision precision) {
  Fidelity f = rigid(integrator);
  f.drag = DragModel::equation;
  f.air = AirModel::isa;
  f.earth = EarthModel::flat_coriolis;
  f.precision = precision;
  return f;
}

TEST(RigidBody, batches_fly_as_single_flights) {
  const auto shots = some_shots();
  for (const std::string& kernel : kernels()) {
    ASSERT_TRUE(use_kernel(kernel));
    for (const Integrator i : kIntegrators)
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        const Fidelity f = falling(i, precision);
        const Tolerance tolerance{.relative = 1e-6, .step = 0.05};
        const BatchResult batch = fly_batch(shots, {}, f, tolerance);
        for (std::size_t k = 0; k < shots.size(); ++k) {
          const Sample end = fly(shots[k].projectile, shots[k].launch, {}, f, tolerance).end();
          const ShotAttitude& r = batch.attitudes[k];
          ASSERT_TRUE(same_bits(batch.shots[k].position, end.position)) << kernel << text(i) << k;
          ASSERT_TRUE(same_bits(r.angular_velocity, end.angular_velocity)) << kernel << text(i) << k;
          ASSERT_TRUE(same_bits(r.orientation.w, end.orientation.w) && same_bits(r.orientation.y, end.orientation.y));
        }
      }
  }
  use_kernel("");
}

TEST(RigidBody, worlds_turn_as_flights_do) {
  const auto shots = some_shots();
  const double h = 1.0 / 64;
  for (const Integrator i :
       {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun, Integrator::rk4})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      World world;
      std::vector<ProjectileId> ids;
      for (const Shot& s : shots) {
        ProjectileDef p = s.projectile;
        p.fidelity = falling(i, precision);
        ids.push_back(*world.spawn(p, s.launch));
        ASSERT_TRUE(ids.back());
      }
      for (int step = 0; step < 16; ++step) ASSERT_TRUE(world.step(h));
      for (std::size_t k = 0; k < shots.size(); ++k) {
        if (!world[ids[k]].is_alive()) continue;
        const Flight flight =
            fly(shots[k].projectile, shots[k].launch, {}, falling(i, precision), {.step = h}, {.time = 16 * h});
        const Sample end = flight.end();
        ASSERT_TRUE(same_bits(world[ids[k]].position(), end.position)) << text(i) << k;
        const Quatd q = world[ids[k]].orientation();
        ASSERT_TRUE(same_bits(q.w, end.orientation.w) && same_bits(q.x, end.orientation.x)) << text(i) << k;
        const Conditions<double> c = prepare_conditions({}, flight.fidelity_in_use().fidelity);
        EXPECT_TRUE(near(world[ids[k]].angular_velocity(), rotate(q, end.angular_velocity) - c.omega, 1e-6));
      }
    }
}

// Without torque a body turns as its moments are to each other: their size changes no bit.
TEST(RigidBody, a_body_of_any_inertia_turns_as_one_of_its_proportions) {
  ProjectileDef plain = nasa_brick();
  plain.inertia.products = plain.inertia.moments * 0.05;
  const Until until{.ground = {}, .time = 10};
  const auto flown = [&](double scale) {
    ProjectileDef p = plain;
    p.inertia.moments = p.inertia.moments * scale, p.inertia.products = p.inertia.products * scale;
    return fly(p, spun_launch(), still_place(), rigid(Integrator::rk4), {.step = 0.01}, until);
  };
  const Sample end = flown(1).end();
  for (const int power : {-400, -120, 120, 400}) {  // their third powers are no numbers
    const Flight flight = flown(std::ldexp(1.0, power));
    ASSERT_EQ(flight.outcome(), Outcome::time_limit) << power << (flight.error() ? flight.error()->text() : "");
    EXPECT_TRUE(same_bits(flight.end().angular_velocity, end.angular_velocity)) << power;
    EXPECT_TRUE(same_bits(flight.end().orientation.w, end.orientation.w)) << power;
  }
  for (const double scale : {1e-306, 1e306})
    EXPECT_EQ(flown(scale).error().value_or(Error{}).place, "projectile.inertia") << scale;
}

TEST(RigidBody, air_moves_no_body_of_1e300_kg) {
  ProjectileDef p = nasa_brick();
  p.diameter = 1e-10;
  p.mass = 1e308;  // the area over the mass is 0
  p.aero.lift = {{0, 0, 2}};
  const Flight flight =
      fly(p, {.position = {0, 10, 0}, .speed = 50}, still_place(), rigid(Integrator::rk4), {.step = 0.01}, {.time = 1});
  ASSERT_EQ(flight.outcome(), Outcome::time_limit) << (flight.error() ? flight.error()->text() : "");
  EXPECT_NEAR(flight.end().position.x, 50, 1e-9);
}

}  // namespace physim::flight_rigid_body_test
