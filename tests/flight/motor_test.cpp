// Motors against closed forms: Tsiolkovsky's equation and its integral; the order of integrators over tables whose
// points their steps miss.
#include "flight/motor_support.hpp"

namespace physim::flight_motor_test {

using namespace test;

TEST(Motor, impulse_mass_and_thrust_of_a_table) {
  const MotorDef m = rocket().motor;
  EXPECT_EQ(burn_time(m), kBurn);
  EXPECT_NEAR(total_impulse(m), 1500, 1e-12);
  EXPECT_NEAR(specific_impulse(m), kExhaust / kG, 1e-12);
  EXPECT_EQ(thrust_at(m, -1), 0);
  EXPECT_EQ(thrust_at(m, 2), kThrust);
  EXPECT_EQ(thrust_at(m, 5.1), 0);
  EXPECT_NEAR(propellant_left(m, 2), kPropellant - 2 * kFlow, 1e-12);
  EXPECT_EQ(propellant_left(m, 9), 0);
  EXPECT_EQ(total_impulse({}), 0);
  // A triangle of 2 s and 10 N: half of its impulse, 5 N s, is delivered at 1 s; a quarter of it at sqrt(1/2) s.
  MotorDef triangle{.thrust = {{0, 0}, {1, 10}, {2, 0}}, .propellant_mass = 1};
  EXPECT_NEAR(total_impulse(triangle), 10, 1e-12);
  EXPECT_NEAR(propellant_left(triangle, 1), 0.5, 1e-12);
  EXPECT_NEAR(propellant_left(triangle, std::sqrt(0.5)), 0.75, 1e-12);
}

TEST(Motor, without_weight_and_air_tsiolkovskys_equation_holds) {
  for (const Integrator integrator : {Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    Launch launch{.elevation = 0.3, .rail_length = kFar};
    Tolerance tolerance{1e-12, 1e-12, 0.03};  // 5 s are no whole number of steps
    const Flight flight = fly(rocket(), launch, constant_gravity(), weightless(integrator), tolerance, {.time = 8});
    ASSERT_FALSE(flight.error()) << flight.error()->text();
    for (const double t : {0.0, 1.234, 4.9, kBurn}) {
      SCOPED_TRACE(text(integrator) + " " + std::to_string(t));
      const Sample s = flight.at(t);
      EXPECT_NEAR(s.speed, tsiolkovsky_speed(t), 2e-8);
      EXPECT_NEAR(length(s.position), tsiolkovsky_way(t), 1e-8);
      EXPECT_NEAR(s.mass, kMass - kFlow * t, 1e-12);
    }
    const Vec3d along{std::cos(0.3), std::sin(0.3), 0};
    EXPECT_TRUE(near(flight.at(4).velocity, along * tsiolkovsky_speed(4), 1e-9));
    EXPECT_EQ(flight.at(4).thrust, kThrust);
    EXPECT_EQ(flight.at(7).thrust, 0);
    EXPECT_NEAR(flight.at(7).mass, kMass - kPropellant, 1e-12);
    EXPECT_NEAR(flight.at(7).speed, tsiolkovsky_speed(kBurn), 2e-8);
    EXPECT_NEAR(length(flight.at(7).position), tsiolkovsky_way(kBurn) + 2 * tsiolkovsky_speed(kBurn), 2e-8);
  }
}

TEST(Motor, straight_up_against_gravity) {
  Launch launch{.elevation = 90 * kDegree, .rail_length = 2};
  ProjectileDef p = rocket();
  p.motor.ignition_delay = 0.7;
  for (const Integrator integrator : {Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    SCOPED_TRACE(text(integrator));
    const Flight flight = fly(p, launch, constant_gravity(), vacuum(integrator), {1e-12, 1e-12, 0.01}, {.time = 60});
    ASSERT_FALSE(flight.error()) << flight.error()->text();
    EXPECT_EQ(flight.at(0.6).position, Vec3d());  // held by the rail
    const double t = kBurn;
    const Sample burnt = flight.at(0.7 + t);
    EXPECT_NEAR(burnt.velocity.y, tsiolkovsky_speed(t) - kG * t, 1e-8);
    EXPECT_NEAR(burnt.position.y, tsiolkovsky_way(t) - 0.5 * kG * t * t, 1e-8);
    EXPECT_NEAR(burnt.position.x, 0, 1e-9);
    const double top = burnt.position.y + burnt.velocity.y * burnt.velocity.y / (2 * kG);
    const auto apex = of_kind(flight, EventKind::apex);
    ASSERT_EQ(apex.size(), 1u);
    EXPECT_NEAR(apex[0].position.y, top, 1e-7);
    const auto ignition = of_kind(flight, EventKind::ignition);
    const auto burnout = of_kind(flight, EventKind::burnout);
    const auto exit = of_kind(flight, EventKind::rail_exit);
    ASSERT_EQ(ignition.size(), 1u);
    ASSERT_EQ(burnout.size(), 1u);
    ASSERT_EQ(exit.size(), 1u);
    EXPECT_EQ(ignition[0].time, 0.7);
    EXPECT_EQ(burnout[0].time, 0.7 + kBurn);
    EXPECT_NEAR(exit[0].position.y, 2, 1e-9);
    const double since = exit[0].time - 0.7;
    EXPECT_NEAR(tsiolkovsky_way(since) - 0.5 * kG * since * since, 2, 1e-8);
    EXPECT_NEAR(exit[0].velocity.y, tsiolkovsky_speed(since) - kG * since, 1e-8);
    EXPECT_TRUE(std::is_sorted(flight.events().begin(), flight.events().end(),
                               [](const Event& a, const Event& b) { return a.time < b.time; }));
  }
}

TEST(Motor, no_event_without_a_motor_and_one_at_launch_without_a_delay) {
  EXPECT_TRUE(of_kind(fly({}, {.speed = 10, .elevation = 1}), EventKind::ignition).empty());
  const Flight flight = fly(rocket(), {.elevation = 1, .rail_length = 1}, {}, vacuum());
  ASSERT_EQ(of_kind(flight, EventKind::ignition).size(), 1u);
  EXPECT_EQ(of_kind(flight, EventKind::ignition)[0].time, 0);
}

/// Error at the end of a burn, after a number of steps.
double error_after(Integrator integrator, int steps) {
  ProjectileDef p;
  p.mass = 0.1;
  p.diameter = 0.025;
  p.drag.coefficient = 0.6;
  p.motor = peaked_motor();
  p.motor.drag_factor = 0.8;
  Launch launch{.elevation = 80 * kDegree, .rail_length = 0.9};
  Fidelity f = Fidelity::constant_air();
  Tolerance tolerance{1e-13, 1e-13, 0};
  f.integrator = Integrator::dop853;
  static const Vec3d exact = fly(p, launch, {}, f, tolerance, {.time = 2.2}).end().position;
  f.integrator = integrator;
  tolerance.step = 2.2 / steps;
  const Flight flight = fly(p, launch, {}, f, tolerance, {.time = 2.2});
  EXPECT_EQ(flight.outcome(), Outcome::time_limit);
  return length(flight.end().position - exact);
}

TEST(Motor, integrators_keep_their_order_over_a_burn) {
  struct Case {
    Integrator integrator;
    double order;
    int steps;
  };
  // Errors of semi-implicit Euler at the launch and of its braked drag have opposite signs: long steps look better.
  for (const auto& [integrator, order, steps] : {Case{Integrator::explicit_euler, 1.0, 220},
                                                 {Integrator::semi_implicit_euler, 1.0, 14080},
                                                 {Integrator::heun, 2.0, 220},
                                                 {Integrator::rk4, 4.0, 220}}) {
    SCOPED_TRACE(text(integrator));
    const double coarse = error_after(integrator, steps);
    const double fine = error_after(integrator, 4 * steps);
    EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), order, 0.25) << coarse << " " << fine;
  }
}

TEST(Motor, adaptive_integrators_stay_within_tolerance) {
  ProjectileDef p{.mass = 0.1, .diameter = 0.03, .drag = {.table = DragTable::g1}, .motor = peaked_motor()};
  for (int i = 0; i < 60; ++i) {
    const Launch launch{.elevation = 85 * kDegree, .rail_length = 0.2 + 0.05 * i};
    Fidelity f = Fidelity::simulation();
    f.interpolation = Interpolation::linear;
    const auto end = [&](Integrator integrator, double tolerance) {
      f.integrator = integrator;
      return fly(p, launch, {}, f, {tolerance, tolerance}, {.time = 3}).end().position;
    };
    const Vec3d exact = end(Integrator::dop853, 1e-13);
    for (const Integrator integrator : kAdaptive)
      EXPECT_LT(length(end(integrator, 1e-9) - exact), 2e-6) << text(integrator) << " " << launch.rail_length;
  }
}

TEST(Motor, steps_end_at_every_point_of_the_table) {
  ProjectileDef p;
  p.mass = 0.1;
  p.motor = peaked_motor();
  p.motor.ignition_delay = 0.123;
  for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5}) {
    const Flight flight = fly(p, {.elevation = 1.5, .rail_length = 1}, {}, vacuum(integrator), {1e-9, 1e-9, 0.05});
    const std::vector<double> times = flight.step_times();
    for (const ThrustPoint& point : p.motor.thrust)
      EXPECT_EQ(std::count(times.begin(), times.end(), 0.123 + point.time), 1) << point.time;
    EXPECT_EQ(std::count(times.begin(), times.end(), 20 * 0.05), integrator == Integrator::rk4 ? 1 : 0);
  }
}

TEST(Motor, mass_may_have_a_table_of_its_own) {
  ProjectileDef p = rocket();
  p.motor.propellant = {{0, kPropellant}, {1, 3}, {2.5, 0.5}, {kBurn, 0}};
  const Flight flight = fly(p, {.elevation = 1, .rail_length = 1}, {}, vacuum());
  EXPECT_NEAR(flight.at(0.5).mass, kMass - 0.5, 1e-12);
  EXPECT_NEAR(flight.at(1.75).mass, kMass - 2.25, 1e-12);
  EXPECT_NEAR(flight.at(20).mass, kMass - kPropellant, 1e-12);
  EXPECT_TRUE(near(length(flight.accelerations(1.75).thrust), kThrust / (kMass - 2.25), 1e-12));
}

TEST(Motor, drag_differs_while_it_burns_and_grows_as_the_mass_falls) {
  ProjectileDef p = rocket();
  p.drag.coefficient = 0.5;
  p.drag.form_factor = 1.2;
  Fidelity f = Fidelity::constant_air();
  f.integrator = Integrator::dop853;
  const auto cd_now = [&](const Flight& flight, double t) {
    const Sample s = flight.at(t);
    const double area = 3.14159265358979323846 / 4 * p.diameter * p.diameter;
    return length(flight.accelerations(t).drag) * s.mass / (0.5 * 1.225 * s.speed * s.speed * area);
  };
  const Launch launch{.elevation = 1.4, .rail_length = 3};
  const Flight plain = fly(p, launch, {}, f);
  EXPECT_NEAR(cd_now(plain, 3), 0.6, 1e-6);
  EXPECT_NEAR(cd_now(plain, 8), 0.6, 1e-6);
  p.motor.drag_factor = 0.5;
  const Flight factor = fly(p, launch, {}, f);
  EXPECT_NEAR(cd_now(factor, 3), 0.3, 1e-6);
  EXPECT_NEAR(cd_now(factor, 8), 0.6, 1e-6);
  p.motor.drag_curve = {{0, 0.4}};
  const Flight curve = fly(p, launch, {}, f);
  EXPECT_NEAR(cd_now(curve, 3), 0.24, 1e-6);
  EXPECT_NEAR(cd_now(curve, 8), 0.6, 1e-6);
}

TEST(Motor, thrust_points_along_the_velocity_through_the_air) {
  Environment windy{.wind = {.velocity = {-4, 0, 3}}};
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;
  const Flight flight = fly(rocket(), {.elevation = 1.3, .rail_length = 2}, windy, f);
  const double exit = of_kind(flight, EventKind::rail_exit).at(0).time;
  const Vec3d bore{std::cos(1.3), std::sin(1.3), 0};
  const Vec3d on_rail = flight.accelerations(0.5 * exit).thrust;
  EXPECT_TRUE(near(on_rail * (1 / length(on_rail)), bore, 1e-12));
  for (const double t : {exit + 0.01, 1.0, 4.0}) {
    const Accelerations a = flight.accelerations(t);
    const Vec3d u = flight.at(t).velocity - windy.wind.velocity;
    EXPECT_LT(length(cross(a.thrust, u)) / (length(a.thrust) * length(u)), 1e-12);
    EXPECT_GT(dot(a.thrust, u), 0);
    EXPECT_TRUE(near(a.total, a.gravity + a.drag + a.coriolis + a.centrifugal + a.thrust, 1e-12));
    EXPECT_EQ(a.constraint, Vec3d());
  }
}

TEST(Motor, pushes_a_rigid_body_along_its_axis) {
  ProjectileDef p = rocket();
  p.inertia.moments = {1, 20, 20};
  Launch launch{.speed = 50, .elevation = 0.5, .rail_length = 4, .attitude = {.pitch = 0.2}};
  for (const BodyForm form : {BodyForm::quaternion, BodyForm::axis})
    for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5}) {
      Fidelity f = vacuum(integrator);
      f.rotation = RotationModel::rigid_body;
      f.body_form = form;
      const Flight flight = fly(p, launch, constant_gravity(), f, {1e-9, 1e-9, 0.01}, {.time = 8});
      ASSERT_EQ(flight.fidelity_in_use().fidelity.rotation, RotationModel::rigid_body);
      ASSERT_EQ(of_kind(flight, EventKind::rail_exit).size(), 1u);
      const Accelerations a = flight.accelerations(2);
      EXPECT_TRUE(near(a.thrust, Vec3d{std::cos(0.7), std::sin(0.7), 0} * (kThrust / flight.at(2).mass), 1e-9));
      EXPECT_TRUE(near(a.total, a.gravity + a.thrust, 1e-12));
      EXPECT_EQ(flight.accelerations(6).thrust, Vec3d());
    }
}

TEST(Motor, after_burnout_energy_is_kept_in_vacuum) {
  Fidelity f = vacuum(Integrator::dop853);
  const Flight flight = fly(rocket(), {.elevation = 1.3, .rail_length = 2}, constant_gravity(), f, {1e-13, 1e-13});
  const auto energy = [&](double t) {
    const Sample s = flight.at(t);
    return s.energy + s.mass * kG * s.position.y;
  };
  EXPECT_NEAR(energy(20) / energy(kBurn + 0.1), 1, 1e-12);
  // Before, it grows by the power of the thrust less what the propellant carries away: m dv/dt . v + m g vy = F v.
  const double h = 1e-4, t = 3;
  const auto per_mass = [&](double at) { return energy(at) / flight.at(at).mass; };
  const Sample s = flight.at(t);
  EXPECT_NEAR((per_mass(t + h) - per_mass(t - h)) / (2 * h), kThrust * s.speed / s.mass, 1e-3);
}

TEST(Motor, straight_up_with_drag_as_fehskens_and_malewicki_solved_it) {
  // Constant thrust, mass and k = rho Cd A / 2: v = q tanh(q k t / m), q = sqrt((F - m g) / k); then a coast.
  ProjectileDef p{
      .mass = 0.05, .diameter = 0.025, .drag = {.coefficient = 0.75}, .motor = {.thrust = {{0, 4.7}, {1.8, 4.7}}}};
  const double k = 0.5 * 1.225 * 0.75 * 3.14159265358979323846 / 4 * 0.025 * 0.025, weight = 0.05 * kG;
  const double q = std::sqrt((4.7 - weight) / k);
  const double v = q * std::tanh(q * k * 1.8 / 0.05);
  const double burnt = -0.05 / (2 * k) * std::log((4.7 - weight - k * v * v) / (4.7 - weight));
  const double top = burnt + 0.05 / (2 * k) * std::log((weight + k * v * v) / weight);
  Environment air = constant_gravity();
  air.atmosphere.model = AirModel::constant;
  air.atmosphere.density = 1.225;
  for (const Integrator integrator : {Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    Fidelity f = Fidelity::constant_air();
    f.integrator = integrator;
    const Flight flight =
        fly(p, {.elevation = 90 * kDegree, .rail_length = 1}, air, f, {1e-12, 1e-12, 0.007}, {.time = 20});
    EXPECT_NEAR(flight.at(1.8).speed, v, 1e-7) << text(integrator);
    EXPECT_NEAR(flight.at(1.8).position.y, burnt, 1e-7);
    EXPECT_NEAR(of_kind(flight, EventKind::apex).at(0).position.y, top, 1e-6);
  }
}

/// Rockets and bullets of many kinds.
std::vector<Shot> fleet() {
  std::vector<Shot> shots;
  for (int i = 0; i < 37; ++i) {
    Shot s;
    s.projectile.mass = 0.1 + 0.01 * i;
    s.projectile.diameter = 0.03;
    s.projectile.motor = peaked_motor();
    s.projectile.motor.ignition_delay = 0.05 * (i % 4);
    if (i % 3 == 0) s.projectile.motor.drag_curve = {{0, 0.3}, {0.5, 0.35}, {1, 0.6}};
    s.launch.elevation = (60 + i % 30) * kDegree;
    s.launch.rail_length = 0.5 + 0.1 * (i % 7);
    if (i % 5 == 0) s.projectile.motor = {}, s.launch.speed = 100;
    if (i % 10 == 0) s.launch.rail_length = 0;
    shots.push_back(s);
  }
  return shots;
}

TEST(Motor, a_batch_flies_the_bits_of_single_flights) {
  const std::vector<Shot> shots = fleet();
  Environment windy{.wind = {.velocity = {3, 0.5, -2}}};
  Until until{.time = 30,
              .events = {{EventKind::apex}, {EventKind::ignition}, {EventKind::burnout}, {EventKind::rail_exit}}};
  for (const Integrator integrator :
       {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853})
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (const std::string& kernel : kernels()) {
        SCOPED_TRACE(text(integrator) + " " + kernel);
        Fidelity f = Fidelity::simulation();
        f.rotation = RotationModel::none;
        f.integrator = integrator;
        f.precision = precision;
        const Tolerance tolerance{1e-6, 1e-6, 0.01};
        ASSERT_TRUE(use_kernel(kernel));
        const BatchResult batch = fly_batch(shots, windy, f, tolerance, until);
        ASSERT_FALSE(batch.error) << batch.error->text();
        std::size_t event = 0;
        for (std::uint32_t i = 0; i < shots.size(); ++i) {
          SCOPED_TRACE(i);
          const Flight flight = fly(shots[i].projectile, shots[i].launch, windy, f, tolerance, {.time = 30});
          EXPECT_EQ(batch.shots[i].outcome, flight.outcome());
          EXPECT_TRUE(same_bits(batch.shots[i].position, flight.end().position));
          EXPECT_TRUE(same_bits(batch.shots[i].velocity, flight.end().velocity));
          EXPECT_EQ(batch.shots[i].cost.steps, flight.cost().steps);
          for (const Event& e : flight.events()) {
            if (e.kind == EventKind::time) continue;
            if (e.kind == EventKind::ignition && e.time == 0) continue;  // before the first step
            while (event < batch.events.size() && batch.events[event].event.kind == EventKind::time) ++event;
            ASSERT_LT(event, batch.events.size());
            EXPECT_EQ(batch.events[event].shot, i);
            EXPECT_EQ(batch.events[event].event.kind, e.kind);
            EXPECT_TRUE(same_bits(batch.events[event].event.time, e.time));
            EXPECT_TRUE(same_bits(batch.events[event].event.position, e.position));
            ++event;
          }
        }
      }
  use_kernel("");
}

TEST(Motor, low_rungs_leave_it_out_and_say_so) {
  for (const Fidelity& f : {Fidelity::arcade(), Fidelity::classic()}) {
    const Flight flight = fly(rocket(), {.speed = 10, .elevation = 1, .rail_length = 1}, {}, f);
    ASSERT_FALSE(flight.error());
    std::string reasons;
    for (const FidelityNote& note : flight.fidelity_in_use().notes) reasons += note.reason + "\n";
    EXPECT_NE(reasons.find("motor is left out"), std::string::npos) << reasons;
    EXPECT_NE(reasons.find("rail is left out"), std::string::npos) << reasons;
    EXPECT_EQ(flight.at(1).thrust, 0);
  }
}

TEST(Motor, flies_over_a_round_turning_earth) {
  Environment earth{.earth = {.latitude = 0.7}};
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;
  f.earth = EarthModel::ellipsoid;
  f.gravity = GravityModel::wgs84;
  const Flight flight = fly(rocket(), {.elevation = 88 * kDegree, .rail_length = 5}, earth, f);
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  EXPECT_EQ(of_kind(flight, EventKind::rail_exit).size(), 1u);
  const Accelerations a = flight.accelerations(3);
  EXPECT_TRUE(near(a.total, a.gravity + a.drag + a.coriolis + a.centrifugal + a.thrust, 1e-12));
}

struct Bad {
  const char* what;
  const char* place;
  const char* message;
  void (*spoil)(ProjectileDef&, Launch&);
};

TEST(Motor, bad_input_is_refused_with_its_place) {
  constexpr Bad kBad[] = {
      {"one point", "projectile.motor.thrust", "too few",
       [](auto& p, auto&) {
         p.motor.thrust = {{0, 1}};
       }},
      {"late start", "projectile.motor.thrust[0]", "time 0",
       [](auto& p, auto&) {
         p.motor.thrust = {{1, 1}, {2, 1}};
       }},
      {"unsorted", "projectile.motor.thrust[2]", "must rise",
       [](auto& p, auto&) {
         p.motor.thrust = {{0, 1}, {2, 1}, {1, 0}};
       }},
      {"three equal times", "projectile.motor.thrust[2]", "third point",
       [](auto& p, auto&) {
         p.motor.thrust = {{0, 1}, {0, 2}, {0, 3}, {1, 0}};
       }},
      {"negative", "projectile.motor.thrust[1]", "zero or positive",
       [](auto& p, auto&) {
         p.motor.thrust = {{0, 1}, {2, -1}};
       }},
      {"nan", "projectile.motor.thrust[1]", "finite",
       [](auto& p, auto&) {
         p.motor.thrust = {{0, 1}, {kNan, 1}};
       }},
      {"no impulse", "projectile.motor.thrust", "no impulse",
       [](auto& p, auto&) {
         p.motor.thrust = {{0, 0}, {2, 0}};
       }},
      {"too much propellant", "projectile.motor.propellant_mass", "not less",
       [](auto& p, auto&) { p.motor.propellant_mass = p.mass; }},
      {"negative propellant", "projectile.motor.propellant_mass", "zero or positive",
       [](auto& p, auto&) { p.motor.propellant_mass = -1; }},
      {"negative delay", "projectile.motor.ignition_delay", "between",
       [](auto& p, auto&) { p.motor.ignition_delay = -1; }},
      {"bad factor", "projectile.motor.drag_factor", "between", [](auto& p, auto&) { p.motor.drag_factor = kNan; }},
      {"propellant grows", "projectile.motor.propellant[2]", "grow",
       [](auto& p, auto&) {
         p.motor.propellant = {{0, 4}, {1, 1}, {2, 2}, {5, 0}};
       }},
      {"propellant is left", "projectile.motor.propellant", "over the burn",
       [](auto& p, auto&) {
         p.motor.propellant = {{0, 4}, {5, 1}};
       }},
      {"curve and bands", "projectile.motor.drag_curve", "bands",
       [](auto& p, auto&) {
         p.motor.drag_curve = {{0, 1}}, p.drag.bands = {{0, 100}};
       }},
      {"unsorted curve", "projectile.motor.drag_curve[1]", "must rise",
       [](auto& p, auto&) {
         p.motor.drag_curve = {{1, 1}, {0, 1}};
       }},
      {"rail", "launch.rail_length", "zero or positive", [](auto&, auto& l) { l.rail_length = -1; }},
      {"rest without rail", "launch.rail_length", "needs a rail", [](auto&, auto& l) { l.rail_length = 0; }},
  };
  for (const Bad& bad : kBad) {
    SCOPED_TRACE(bad.what);
    ProjectileDef p = rocket();
    Launch launch{.elevation = 1, .rail_length = 1};
    ASSERT_FALSE(fly(p, launch).error());
    bad.spoil(p, launch);
    const Flight flight = fly(p, launch);
    ASSERT_TRUE(flight.error());
    EXPECT_EQ(flight.outcome(), Outcome::refused);
    EXPECT_EQ(flight.error()->place, bad.place);
    EXPECT_NE(flight.error()->message.find(bad.message), std::string::npos) << flight.error()->message;
    EXPECT_TRUE(fly_batch(std::vector<Shot>{{p, launch}}, {}, {}).error);
  }
}

}  // namespace physim::flight_motor_test
