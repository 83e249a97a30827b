// Flights and the questions that can be asked of them.
#include "support.hpp"

namespace physim::flight_flight_test {

using namespace test;

Flight shot(const Fidelity& f, const Until& until = {}) {
  return fly(bullet_308(), {.position = {0, 1.5, 0}, .speed = 800, .elevation = 0.01}, {}, f, {1e-10, 1e-10, 1e-3},
             until);
}

TEST(Flight, times_outside_give_the_nearer_end) {
  const Flight flight = shot(Fidelity::small_arms());
  EXPECT_EQ(flight.at(-5).position, flight.at(0).position);
  EXPECT_EQ(flight.at(1e9).position, flight.end().position);
  EXPECT_TRUE(near(flight.at(0).position, {0, 1.5, 0}, 1e-15));
  EXPECT_NEAR(flight.at(0).speed, 800, 1e-11);
}

TEST(Flight, is_the_same_between_its_steps_as_if_flown_to_there) {
  const Flight flight = shot(Fidelity::small_arms());
  for (const double t : {0.1, 0.5, 1.0, 1.3}) {
    const Flight shorter = shot(Fidelity::small_arms(), {.time = t});
    EXPECT_TRUE(near(flight.at(t).position, shorter.end().position, 1e-9, 1e-8)) << t;
  }
}

TEST(Flight, velocity_and_acceleration_are_derivatives_of_position) {
  Fidelity f = Fidelity::simulation();
  f.rotation = RotationModel::none;
  const Flight flight = shot(f);
  for (const double part : {0.2, 0.5, 0.8}) {
    const double t = part * flight.duration(), h = 1e-4;
    const Vec3d v = (flight.at(t + h).position - flight.at(t - h).position) * (1 / (2 * h));
    const Vec3d a = (flight.at(t + h).velocity - flight.at(t - h).velocity) * (1 / (2 * h));
    EXPECT_TRUE(near(v, flight.at(t).velocity, 1e-6));
    EXPECT_TRUE(near(a, flight.at(t).acceleration, 1e-4));
  }
}

TEST(Flight, samples_agree_with_themselves) {
  const Flight flight = shot(Fidelity::small_arms());
  const Sample s = flight.at(0.7);
  EXPECT_EQ(s.time, 0.7);
  EXPECT_NEAR(s.speed, length(s.velocity), 1e-12);
  EXPECT_NEAR(s.energy, 0.5 * bullet_308().mass * s.speed * s.speed, 1e-9);
  EXPECT_NEAR(s.mach, s.speed / 340.29, 1e-4);
}

TEST(Flight, at_range_hits_the_range_along_the_line_of_sight) {
  for (const double look : {0.0, 0.3, -0.2}) {
    const Launch launch{
        .speed = 800, .elevation = look + 0.01, .azimuth = 0.4, .sight = {.height = 0.05, .look_angle = look}};
    const Flight flight = fly(bullet_308(), launch, {}, {}, {}, {.ground = {}, .range = 900});
    for (double range = 0; range < 900; range += 37) {
      const auto s = must(flight.at_range(range), range);
      EXPECT_NEAR(s.range, range, 1e-10);
    }
  }
}

TEST(Flight, at_range_reaches_the_very_end) {
  // The flight ends at a root that may lie a rounding short of the range it was asked for.
  for (int i = 1; i <= 200; ++i) {
    const double range = 10.3 * i;
    const Flight flight = fly(bullet_308(), {.speed = 800}, {}, {}, {1e-6, 1e-6}, {.ground = {}, .range = range});
    const auto s = must(flight.at_range(range), range);
    EXPECT_NEAR(s.range, range, 1e-9);
  }
}

TEST(Flight, at_height_reaches_the_ground_it_landed_on) {
  for (int i = 1; i <= 200; ++i) {
    const double ground = -0.37 * i;
    const Flight flight = fly(bullet_308(), {.speed = 300}, {}, {}, {1e-6, 1e-6}, {.ground = ground});
    ASSERT_EQ(flight.outcome(), Outcome::landed);
    const auto s = must(flight.at_height(ground, Crossing::falling), ground);
    EXPECT_NEAR(s.time, flight.duration(), 1e-9);
  }
}

TEST(Flight, at_height_tells_rising_from_falling) {
  const Flight flight = fly({}, {.speed = 100, .elevation = 1}, constant_gravity(), vacuum());
  const double vy = 100 * std::sin(1.0), g = 9.80665;
  const double root = std::sqrt(vy * vy - 2 * g * 200);
  EXPECT_NEAR(flight.at_height(200, Crossing::rising)->time, (vy - root) / g, 1e-11);
  EXPECT_NEAR(flight.at_height(200, Crossing::falling)->time, (vy + root) / g, 1e-11);
  EXPECT_NEAR(flight.at_height(200)->time, (vy - root) / g, 1e-11);
  // Just below the apex, between two steps.
  const double top = vy * vy / (2 * g);
  EXPECT_NEAR(flight.at_height(top - 1e-6)->position.y, top - 1e-6, 1e-9);
}

TEST(Flight, places_never_reached_are_errors_with_a_message) {
  const Flight flight = shot(Fidelity::small_arms(), {.range = 300});
  for (const auto& answer : {flight.at_range(301), flight.at_range(-1), flight.at_height(1e4)}) {
    ASSERT_FALSE(answer);
    EXPECT_NE(answer.error().message.find("never reaches"), std::string::npos) << answer.error().text();
  }
}

TEST(Flight, a_refused_one_answers_everything_harmlessly) {
  const Flight flight = fly(bullet_308(), {.speed = -1}, {});
  ASSERT_EQ(flight.outcome(), Outcome::refused);
  ASSERT_TRUE(flight.error());
  EXPECT_EQ(flight.duration(), 0);
  EXPECT_EQ(flight.at(1).position, (Vec3d{0, 0, 0}));
  EXPECT_EQ(flight.end().speed, 0);
  EXPECT_FALSE(flight.at_range(5));
  EXPECT_FALSE(flight.at_height(5));
  EXPECT_EQ(flight.accelerations(0).total, (Vec3d{0, 0, 0}));
  EXPECT_TRUE(flight.events().empty());
  EXPECT_TRUE(flight.step_times().empty());
}

TEST(Flight, step_times_rise_from_zero_to_the_end) {
  for (const Integrator integrator : kIntegrators) {
    Fidelity f = vacuum(integrator);
    const Flight flight = fly({}, {.speed = 30, .elevation = 1}, constant_gravity(), f, {.step = 0.01});
    const auto times = flight.step_times();
    ASSERT_GE(times.size(), 2u);
    EXPECT_EQ(times.front(), 0);
    EXPECT_EQ(times.back(), flight.duration());
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  }
}

TEST(Flight, fixed_steps_are_counted_so_that_time_gathers_no_rounding) {
  Fidelity f = vacuum(Integrator::rk4);
  const Flight flight = fly({}, {}, constant_gravity(), f, {.step = 0.1}, {.ground = {}, .time = 1000.05});
  const auto times = flight.step_times();
  for (std::size_t i = 0; i + 1 < times.size(); ++i) ASSERT_EQ(times[i], static_cast<double>(i) * 0.1);
}

TEST(Flight, a_planar_one_never_leaves_the_vertical_plane_of_fire) {
  Environment e{.wind = {.profile = {{0, {3, 1, -9}}, {100, {-4, 0, 12}}}}, .earth = {.latitude = 1}};
  ProjectileDef p = bullet_308();
  p.drag.k1 = 1e-3;
  p.drag.damping = 0.7;
  p.force = {0.01, 0.01, 0.05};
  for (const double azimuth : {0.0, 0.9})
    for (const Integrator integrator : kIntegrators)
      for (const Motion motion : {Motion::closed_form, Motion::velocity, Motion::force})
        for (const DragModel drag : {DragModel::damping, DragModel::linear_quadratic, DragModel::equation}) {
          Fidelity f = Fidelity::simulation();
          f.integrator = integrator;
          f.motion = motion;
          f.drag = drag;
          f.planar = true;
          const Launch launch{
              .position = {0, 2, 0}, .speed = 400, .elevation = 0.1, .azimuth = azimuth, .sight = {.cant = 0.3}};
          const Flight flight = fly(p, launch, e, f, {1e-8, 1e-8, 0.01}, {.time = 2});
          ASSERT_FALSE(flight.error());
          for (const double part : {0.3, 0.7, 1.0}) {
            const Sample s = flight.at(part * flight.duration());
            EXPECT_NEAR(s.windage, 0, 1e-9) << text(integrator) << ' ' << name(motion) << ' ' << name(drag);
          }
        }
}

TEST(Flight, planar_changes_nothing_where_nothing_acts_sideways) {
  Fidelity f{.rotation = RotationModel::none};
  const Flight free = shot(f);
  f.planar = true;
  EXPECT_TRUE(near(shot(f).end().position, free.end().position, 1e-12));
}

TEST(Flight, float32_agrees_with_float64_to_its_rounding) {
  for (const Integrator integrator : kIntegrators) {
    Fidelity f{.integrator = integrator};
    const Until until{.ground = {}, .time = 1.2};
    const Tolerance tolerance{2e-6, 2e-6, 1.0 / 512};
    const auto fly_in = [&](Precision precision) {
      f.precision = precision;
      return fly(bullet_308(), {.speed = 800, .elevation = 0.05}, {}, f, tolerance, until).end();
    };
    const Sample d = fly_in(Precision::float64), s = fly_in(Precision::float32);
    // Some hundred steps, each with a few roundings of 6e-8; adaptive ones also with their tolerance.
    EXPECT_TRUE(near(s.position, d.position, 2e-5)) << text(integrator);
    EXPECT_TRUE(near(s.velocity, d.velocity, 2e-5)) << text(integrator);
    EXPECT_NE(s.position.x, d.position.x) << "not really float32";
  }
}

TEST(Flight, integrators_agree_with_each_other_and_with_closed_forms) {
  ProjectileDef p{.drag = {.k1 = 0.2}};
  Environment e = constant_gravity();
  e.wind.velocity = {4, 0, -3};
  Fidelity f = vacuum();
  f.drag = DragModel::linear_quadratic;
  f.wind = WindModel::constant;
  f.motion = Motion::closed_form;
  const Launch launch{.position = {0, 3, 0}, .speed = 60, .elevation = 0.7};
  const Flight exact = fly(p, launch, e, f);
  f.motion = Motion::force;
  for (const auto& [integrator, gate] : {std::pair{Integrator::explicit_euler, 0.1},
                                         {Integrator::semi_implicit_euler, 0.1},
                                         {Integrator::heun, 1e-4},
                                         {Integrator::rk4, 1e-9},
                                         {Integrator::rk43, 1e-8},
                                         {Integrator::tsit5, 1e-8},
                                         {Integrator::dop853, 1e-8}}) {
    f.integrator = integrator;
    const Flight flight = fly(p, launch, e, f, {1e-11, 1e-11, 1e-3});
    EXPECT_LT(length(flight.end().position - exact.end().position), gate) << text(integrator);
    EXPECT_EQ(flight.outcome(), Outcome::landed);
  }
}

TEST(Flight, motion_velocity_and_motion_force_agree_where_both_know_the_effects) {
  ProjectileDef p{.drag = {.damping = 0.6}};
  for (const Integrator integrator : {Integrator::semi_implicit_euler, Integrator::rk4, Integrator::tsit5}) {
    Fidelity f = vacuum(integrator);
    f.drag = DragModel::damping;
    f.motion = Motion::velocity;
    const Launch launch{.speed = 60, .elevation = 0.7};
    const Flight a = fly(p, launch, constant_gravity(), f, {.step = 0.01});
    f.motion = Motion::force;
    const Flight b = fly(p, launch, constant_gravity(), f, {.step = 0.01});
    EXPECT_TRUE(near(a.end().position, b.end().position, 1e-14)) << text(integrator);
  }
}

TEST(Flight, uses_the_projectiles_own_fidelity_where_a_call_gives_none) {
  ProjectileDef p = bullet_308();
  p.fidelity = Fidelity::arcade();
  EXPECT_EQ(fly(p, {.speed = 100, .elevation = 1}).fidelity_in_use().fidelity.motion, Motion::closed_form);
}

TEST(Flight, copies_share_their_record) {
  const Flight a = shot(Fidelity::small_arms());
  const Flight b = a;
  EXPECT_EQ(a.events().data(), b.events().data());
}

TEST(Flight, at_range_takes_the_end_for_a_range_that_is_rounding_longer) {
  const double end = 1500 * 0.9144;
  const Flight flight = fly(bullet_308(), {.speed = 800, .elevation = 0.03}, {}, {}, {}, {.ground = {}, .range = end});
  const auto there = must(flight.at_range(end * (1 + 4e-16)));
  EXPECT_EQ(there.time, flight.duration());
  EXPECT_FALSE(flight.at_range(end * (1 + 1e-9)));
}

}  // namespace physim::flight_flight_test
