// Shots that once went wrong: on and under the ground, across a value twice, in air that is hardly there.
#include "support.hpp"

namespace physim::flight_edge_cases_test {

constexpr double kG = 9.80665;

Environment still(double density) {
  return {.gravity = {.model = GravityModel::constant},
          .atmosphere = {.model = AirModel::constant, .density = density, .sound_speed = 340}};
}

TEST(EdgeCases, a_level_shot_from_the_ground_has_landed) {
  for (const auto preset : fidelity_presets()) {
    const Fidelity f = *fidelity_preset(preset);
    for (const double speed : {0.0, 100.0}) {
      const Shot shot{{}, {.speed = speed}};
      EXPECT_EQ(fly(shot.projectile, shot.launch, {}, f).outcome(), Outcome::landed) << preset;
      EXPECT_EQ(fly(shot.projectile, shot.launch, {}, f).duration(), 0) << preset;
      EXPECT_EQ(fly_batch({&shot, 1}, {}, f).shots[0].outcome, Outcome::landed) << preset;
    }
  }
}

TEST(EdgeCases, a_shot_that_never_leaves_the_underground_lands_at_its_apex) {
  for (const auto preset : {"arcade", "constant_air", "simulation", "reference"}) {
    const Shot shot{{}, {.position = {0, -100, 0}, .speed = 10, .elevation = 1.5707963267948966}};
    const Flight flight = fly(shot.projectile, shot.launch, {}, *fidelity_preset(preset));
    EXPECT_EQ(flight.outcome(), Outcome::landed) << preset;
    EXPECT_NEAR(flight.duration(), 10 / kG, 0.02) << preset;
    const BatchResult batch = fly_batch({&shot, 1}, {}, *fidelity_preset(preset));
    EXPECT_EQ(batch.shots[0].time, flight.duration()) << preset;
  }
}

TEST(EdgeCases, thrust_lifts_a_level_shot_off_the_ground) {
  ProjectileDef rocket{.force = {0, 2 * kG, 0}, .force_duration = 1};
  const Flight flight = fly(rocket, {.speed = 10}, still(0), Fidelity::constant_air());
  EXPECT_EQ(flight.outcome(), Outcome::landed);
  // Up with g for 1 s, then a lob from g/2 with speed g: t = 1 + (1 + sqrt(2)).
  EXPECT_NEAR(flight.duration(), 2 + std::sqrt(2.0), 2e-3);
}

TEST(EdgeCases, a_range_crossed_out_and_back_in_one_step_is_seen) {
  ProjectileDef grain{.drag = {.k1 = 0.5}};
  Environment e = still(1.2);
  e.wind.velocity = {-60, 0, 0};
  Fidelity f = Fidelity::arcade();
  f.precision = Precision::float64;
  f.drag = DragModel::linear_quadratic;
  f.wind = WindModel::constant;
  Until until;
  until.ground.reset();
  until.time = 60;
  until.range = 50;
  const Flight flight = fly(grain, {.speed = 100, .elevation = 0.7}, e, f, {}, until);
  ASSERT_EQ(flight.outcome(), Outcome::reached_range);
  EXPECT_NEAR(flight.end().range, 50, 1e-9);
  EXPECT_GT(flight.end().velocity.x, 0);
}

TEST(EdgeCases, a_speed_passed_twice_in_one_step_is_seen_twice) {
  const double slowest = 100 * std::cos(0.5235987755982988);
  Until until{.events = {{EventKind::speed, slowest + 0.1}}};
  for (const Integrator integrator : test::kAdaptive) {
    Fidelity f = Fidelity::simulation();
    f.integrator = integrator;
    f.drag = DragModel::off;
    const Flight flight = fly({}, {.speed = 100, .elevation = 0.5235987755982988}, still(0), f, {}, until);
    int passed = 0;
    for (const Event& e : flight.events()) passed += e.kind == EventKind::speed;
    EXPECT_EQ(passed, 2);
  }
}

TEST(EdgeCases, the_start_counts_as_a_crossing_of_its_height_only_for_any_direction) {
  const Flight lob = fly({}, {.speed = 50, .elevation = 1}, still(0), Fidelity::arcade());
  EXPECT_EQ(lob.at_height(0)->time, 0);
  EXPECT_NEAR(lob.at_height(0, Crossing::falling)->time, lob.duration(), 1e-5);
}

TEST(EdgeCases, a_zero_beyond_thirty_degrees_is_found) {
  Fidelity f = Fidelity::constant_air();
  f.drag = DragModel::off;
  const auto elevation = must(zero_elevation({}, {.speed = 100}, still(0), f, 950));
  EXPECT_NEAR(elevation, 0.5 * std::asin(950 * kG / 1e4), 1e-7);
  EXPECT_FALSE(zero_elevation({}, {.speed = 100}, still(0), f, 1030));
}

TEST(EdgeCases, a_spline_that_would_overshoot_is_not_granted) {
  ProjectileDef p;
  p.drag = {.table = DragTable::custom, .curve = {{0, .12}, {.8, .12}, {1, .4}, {1.2, .35}, {2, .25}, {3, .2}}};
  const Flight flight = fly(p, {.speed = 900, .elevation = 1}, {}, Fidelity::simulation());
  EXPECT_EQ(flight.fidelity_in_use().fidelity.interpolation, Interpolation::pchip);
  const auto& notes = flight.fidelity_in_use().notes;
  EXPECT_EQ(std::ranges::count(notes, "interpolation", &FidelityNote::effect), 1);
}

TEST(EdgeCases, spin_drift_needs_air_and_a_stability_that_means_something) {
  ProjectileDef bullet{.mass = 0.0109, .diameter = 0.00782, .length = 0.031, .twist = 0.3};
  Environment e = still(0);
  for (const AirModel model : {AirModel::vacuum, AirModel::constant}) {
    e.atmosphere.model = model;
    const Flight flight = fly(bullet, {.speed = 800, .elevation = 0.1}, e, Fidelity::small_arms());
    EXPECT_EQ(flight.fidelity_in_use().fidelity.rotation, RotationModel::none);
    EXPECT_EQ(flight.end().windage, 0);
  }
  Environment high{.altitude = 80000};
  EXPECT_EQ(fly(bullet, {.speed = 800, .elevation = 0.1}, high, Fidelity::small_arms()).end().windage, 0);
}

TEST(EdgeCases, more_vapour_than_air_is_refused) {
  Environment e{.atmosphere = {.temperature = 350, .pressure = 200, .humidity = 1}};
  const Flight flight = fly({}, {.speed = 100, .elevation = 0.5}, e, Fidelity::simulation());
  ASSERT_TRUE(flight.error());
  EXPECT_EQ(flight.error()->place, "environment.atmosphere.humidity");
}

TEST(EdgeCases, derived_k2_equals_the_drag_equation_at_launch_with_wind_and_bands) {
  ProjectileDef p{.drag = {.table = DragTable::g7, .bands = {{0, 100}, {600, 200}}}};
  Environment e = still(1.2);
  e.wind.velocity = {-20, 0, 5};
  Fidelity exact = Fidelity::constant_air();
  Fidelity cheap = Fidelity::game();
  cheap.precision = exact.precision;
  const Launch launch{.speed = 800, .elevation = 0.3};
  const Vec3d want = fly(p, launch, e, exact, {.step = 0.01}).accelerations(0).drag;
  const Vec3d got = fly(p, launch, e, cheap, {.step = 0.01}).accelerations(0).drag;
  EXPECT_NEAR(length(got - want), 0, 1e-9 * length(want));
}

TEST(EdgeCases, planar_effects_add_up) {
  Environment e{.wind = {.velocity = {0, 0, 10}}};
  Fidelity f = Fidelity::artillery();
  f.planar = true;
  const Accelerations a = fly({}, {.speed = 300, .elevation = 0.7}, e, f).accelerations(3);
  EXPECT_LT(length(a.gravity + a.drag + a.coriolis + a.applied + a.constraint - a.total), 1e-13);
  EXPECT_NEAR(a.total.z, 0, 1e-13);
  EXPECT_NEAR(a.constraint.z, -(a.drag.z + a.coriolis.z), 1e-13) << "it takes up crosswind and Coriolis";
  EXPECT_GT(std::abs(a.constraint.z), 1);
}

/// The end of a shot at a tolerance.
Sample end_within(const ProjectileDef& p, const Launch& launch, const Environment& e, double tolerance) {
  return fly(p, launch, e, Fidelity::simulation(), {tolerance, tolerance}).end();
}

TEST(EdgeCases, a_path_that_peeks_over_an_edge_of_the_wind_feels_it) {
  const ProjectileDef ball{.mass = 4, .diameter = 0.15};
  const Launch launch{.position = {0, 1, 0}, .speed = 120, .elevation = 1};
  Environment e;
  const Flight calm = fly(ball, launch, e, Fidelity::simulation());
  double apex = 0;
  for (const Event& event : calm.events())
    if (event.kind == EventKind::apex) apex = event.position.y;
  // Inside one step the path is 2 cm above the edge for an eighth of a second.
  e.wind.profile = {{-100, {}}, {apex - 0.02, {0, 0, 60}}};
  e.wind.interpolation = WindInterpolation::step;
  const Sample exact = end_within(ball, launch, e, 1e-13);
  EXPECT_GT(exact.position.z, calm.end().position.z + 0.1);
  // Where in a step the edge lies is known to the dense output's accuracy, and 60 m/s stand behind it.
  for (const double tolerance : {1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 1e-8, 1e-9})
    EXPECT_NEAR(end_within(ball, launch, e, tolerance).position.z, exact.position.z, std::min(2e4 * tolerance, 0.025))
        << tolerance;
  const Shot shot{ball, launch};
  EXPECT_EQ(fly_batch({&shot, 1}, e, Fidelity::simulation()).shots[0].position,
            fly(ball, launch, e, Fidelity::simulation()).end().position);
}

TEST(EdgeCases, a_path_that_dips_under_an_edge_of_the_bands_feels_it) {
  ProjectileDef shell{.mass = 4, .diameter = 0.15, .drag = {.table = DragTable::g1, .ballistic_coefficient = 200}};
  const Launch launch{.position = {0, 1, 0}, .speed = 300, .elevation = 1};
  const Flight plain = fly(shell, launch, {}, Fidelity::simulation());
  double slowest = 1e9;
  for (double t = 0; t < plain.duration(); t += 1e-3) slowest = std::min(slowest, plain.at(t).speed);
  shell.drag.bands = {{0, 1}, {slowest + 0.02, 200}};
  const double exact = end_within(shell, launch, {}, 1e-13).position.x;
  EXPECT_LT(exact, plain.end().position.x - 1);
  for (const double tolerance : {1e-6, 1e-9})
    EXPECT_NEAR(end_within(shell, launch, {}, tolerance).position.x, exact, 0.01) << tolerance;
}

TEST(EdgeCases, precision_alone_may_be_lowered) {
  for (const Integrator integrator : {Integrator::rk43, Integrator::tsit5, Integrator::dop853, Integrator::rk4}) {
    Fidelity f = Fidelity::simulation();
    f.integrator = integrator;
    const Launch launch{.speed = 300, .elevation = 0.5};
    const Flight exact = fly({}, launch, {}, f);
    f.precision = Precision::float32;
    const Flight rough = fly({}, launch, {}, f);
    ASSERT_FALSE(rough.error()) << rough.error()->text();
    EXPECT_NEAR(rough.end().range, exact.end().range, 1e-4 * exact.end().range);
  }
}

TEST(EdgeCases, what_is_left_out_is_said) {
  const Flight flight = fly({.force = {1, 0, 0}}, {.speed = 10, .elevation = 1}, {}, Fidelity::arcade());
  bool said = false;
  for (const FidelityNote& note : flight.fidelity_in_use().notes) said = said || note.effect == "motion";
  EXPECT_TRUE(said);
}

/// Ends of a flight that starts at rest on a knot, and of one that starts `aside` of it; both fly 20 s.
void expect_gets_away(const ProjectileDef& p, const Launch& launch, const Launch& aside, const Environment& e,
                      const Fidelity& fidelity, const std::string& what) {
  const Tolerance tolerance{.max_steps = 20'000};
  const Flight flight = fly(p, launch, e, fidelity, tolerance, {.ground = {}, .time = 20});
  const Flight beside = fly(p, aside, e, fidelity, tolerance, {.ground = {}, .time = 20});
  ASSERT_FALSE(flight.error()) << what << ": " << flight.error()->text();
  EXPECT_EQ(flight.outcome(), Outcome::time_limit) << what << " after " << flight.duration();
  EXPECT_LT(flight.cost().steps + flight.cost().rejected, 1000) << what;
  const double moved = length(beside.end().position - aside.position);
  EXPECT_GT(moved, 10) << what;
  const double bound = (fidelity.precision == Precision::float64 ? 1e-5 : 1e-3) * moved + 1e-3;
  EXPECT_NEAR(length(flight.end().position - beside.end().position), 0, bound) << what;
}

std::vector<Fidelity> adaptive_in_both_precisions() {
  std::vector<Fidelity> all;
  for (const Integrator integrator : {Integrator::rk43, Integrator::tsit5, Integrator::dop853})
    for (const Precision precision : {Precision::float64, Precision::float32}) {
      Fidelity f = Fidelity::simulation();
      f.integrator = integrator, f.precision = precision;
      all.push_back(f);
    }
  return all;
}

std::string name_of(const Fidelity& f) {
  return std::string(name(f.integrator)) + (f.precision == Precision::float64 ? " float64" : " float32");
}

// By less than its place is rounded, a flight from rest moves for 0.1 us: cuts of its steps to the knot that it starts
// on do not move it, however many follow each other.
TEST(EdgeCases, a_flight_that_starts_at_rest_on_a_knot_of_the_wind_gets_away) {
  ProjectileDef chute{.mass = 1, .diameter = 0.737304, .drag = {.coefficient = 1.5}};
  for (Fidelity f : adaptive_in_both_precisions())
    for (const Vec3d push : {Vec3d{0, 0, 0}, Vec3d{0, 30, 0}, Vec3d{30, kG, 0}, Vec3d{-30, kG, 0}}) {
      f.wind = WindModel::profile;
      Environment e = still(1.225);
      const bool along = push.x != 0;
      const double knot = along ? 300 : 1000;
      e.wind = {.profile = {{0, {1, 0, 9}}, {knot, {-1, 0, 9}}, {2 * knot, {1, 0, 5}}},
                .by = along ? WindAxis::range : WindAxis::height};
      chute.force = push;
      const Launch launch{.position = {along ? knot : 0, 1000, 0}};
      Launch aside = launch;
      const double off = f.precision == Precision::float64 ? 1e-6 : 1e-3;
      if (along) aside.position.x += push.x > 0 ? off : -off;
      if (!along) aside.position.y += push.y > 0 ? off : -off;
      const std::string what = name_of(f) + ' ' + std::to_string(push.x) + ' ' + std::to_string(push.y);
      expect_gets_away(chute, launch, aside, e, f, what);
    }
}

TEST(EdgeCases, a_flight_that_starts_at_rest_on_a_knot_of_its_drag_gets_away) {
  // The wind alone flows past it, with the Mach number of the knot: faster, slower, and across.
  ProjectileDef ball{
      .mass = 1, .diameter = 0.3, .drag = {.table = DragTable::custom, .curve = {{0, 0.4}, {0.1, 0.5}, {0.2, 1.5}}}};
  for (Fidelity f : adaptive_in_both_precisions())
    for (const Vec3d push : {Vec3d{-20, 0, 0}, Vec3d{20, 0, 0}, Vec3d{0, 0, 0}}) {
      f.interpolation = Interpolation::linear;
      Environment e = still(1.225);
      e.wind.velocity = {34, 0, 0};
      ball.force = push;
      const Launch launch{.position = {0, 9000, 0}};
      Launch aside = launch;
      aside.velocity = Vec3d{f.precision == Precision::float64 ? 1e-7 : 1e-4, 0, 0};
      expect_gets_away(ball, launch, aside, e, f, name_of(f) + ' ' + std::to_string(push.x));
    }
}

TEST(EdgeCases, a_body_that_starts_at_rest_on_a_knot_of_its_aerodynamics_gets_away) {
  ProjectileDef body{
      .mass = 1,
      .diameter = 0.3,
      .drag = {.coefficient = 0.5},
      .inertia = {.moments = {0.01, 0.01, 0.01}},
      .aero = {.drag_yaw = {{.mach = 0, .value = 0.2}, {.mach = 0.1, .value = 0.4}, {.mach = 0.2, .value = 2}}}};
  for (Fidelity f : adaptive_in_both_precisions())
    for (const Vec3d push : {Vec3d{-20, 0, 0}, Vec3d{20, 0, 0}, Vec3d{0, 0, 0}}) {
      f.rotation = RotationModel::rigid_body;
      Environment e = still(1.225);
      e.wind.velocity = {34, 0, 0};
      body.force = push;
      const Launch launch{.position = {0, 9000, 0}};
      Launch aside = launch;
      aside.velocity = Vec3d{f.precision == Precision::float64 ? 1e-7 : 1e-4, 0, 0};
      expect_gets_away(body, launch, aside, e, f, name_of(f) + ' ' + std::to_string(push.x));
    }
}

}  // namespace physim::flight_edge_cases_test
