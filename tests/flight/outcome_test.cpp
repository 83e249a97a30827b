// How flights end: every outcome is reached by some input, and nothing runs for ever.
#include <chrono>

#include "support.hpp"

namespace physim::flight_outcome_test {

using namespace test;

TEST(Outcome, landed) {
  for (const Integrator integrator : kIntegrators)
    EXPECT_EQ(fly({}, {.speed = 10, .elevation = 1}, constant_gravity(), vacuum(integrator), {.step = 0.01}).outcome(),
              Outcome::landed);
}

TEST(Outcome, reached_range) {
  for (const Integrator integrator : kIntegrators)
    EXPECT_EQ(
        fly({}, {.speed = 10, .elevation = 1}, constant_gravity(), vacuum(integrator), {.step = 0.01}, {.range = 5})
            .outcome(),
        Outcome::reached_range);
}

TEST(Outcome, event) {
  for (const Integrator integrator : kIntegrators)
    EXPECT_EQ(fly({}, {.speed = 10, .elevation = 1}, constant_gravity(), vacuum(integrator), {.step = 0.01},
                  {.events = {{EventKind::height, 2, Crossing::any, true}}})
                  .outcome(),
              Outcome::event);
}

TEST(Outcome, time_limit) {
  for (const Integrator integrator : kIntegrators) {
    const Flight flight =
        fly({}, {.speed = 10, .elevation = 1}, constant_gravity(), vacuum(integrator), {.step = 0.01}, {.time = 0.7});
    EXPECT_EQ(flight.outcome(), Outcome::time_limit);
    EXPECT_NEAR(flight.duration(), 0.7, 1e-14);
  }
}

TEST(Outcome, step_limit) {
  for (const Integrator integrator : kIntegrators) {
    const Flight flight = fly(bullet_308(), {.speed = 700, .elevation = 1}, {}, {.integrator = integrator},
                              {.relative = 1e-9, .absolute = 1e-9, .step = 0.001, .max_steps = 50});
    EXPECT_EQ(flight.outcome(), Outcome::step_limit) << text(integrator);
    EXPECT_EQ(flight.cost().steps + flight.cost().rejected, 50) << text(integrator);
    EXPECT_GT(flight.duration(), 0) << text(integrator);
  }
}

TEST(Outcome, left_domain) {
  for (const Integrator integrator : {Integrator::rk4, Integrator::rk43, Integrator::tsit5, Integrator::dop853}) {
    const Flight flight = fly(bullet_308(), {.speed = 700, .elevation = -1}, {}, {.integrator = integrator},
                              {1e-9, 1e-9, 0.05}, {.ground = {}});
    EXPECT_EQ(flight.outcome(), Outcome::left_domain) << text(integrator);
    EXPECT_NEAR(flight.end().position.y, -5000, 1e-6);
  }
}

TEST(Outcome, non_finite) {
  // A huge push overflows; whatever the integrator, the flight ends where it last was sound.
  ProjectileDef p{.mass = 1e-300, .force = {1e300, 0, 0}};
  for (const Integrator integrator : kIntegrators)
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Fidelity f = vacuum(integrator);
      f.precision = precision;
      const Flight flight = fly(p, {.speed = 1}, constant_gravity(), f, {1e-5, 1e-5, 0.1}, {.ground = {}, .time = 10});
      EXPECT_EQ(flight.outcome(), Outcome::non_finite) << text(integrator) << ' ' << name(precision);
      const Sample end = flight.end();
      EXPECT_TRUE(std::isfinite(end.position.x + end.velocity.x)) << text(integrator);
    }
}

TEST(Outcome, steps_that_are_far_too_long_are_braked) {
  // Quadratic drag of such steps would blow up.
  ProjectileDef p{.drag = {.k2 = 10}};
  for (const Integrator integrator :
       {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun, Integrator::rk4}) {
    Fidelity f = vacuum(integrator);
    f.drag = DragModel::linear_quadratic;
    const Flight flight = fly(p, {.speed = 1000, .elevation = 0.5}, constant_gravity(), f, {.step = 1});
    EXPECT_EQ(flight.outcome(), Outcome::landed) << text(integrator);
  }
}

TEST(Outcome, stalled) {
  // A wall of wind after 100 s: no step short enough to enter it moves the clock.
  ProjectileDef p{.drag = {.k1 = 1}};
  Environment e = constant_gravity();
  e.gravity.acceleration = 0;
  e.wind = {.profile = {{0, {10, 0, 0}}, {1000, {1e15, 0, 0}}},
            .by = WindAxis::range,
            .interpolation = WindInterpolation::step};
  for (const Integrator integrator : kAdaptive)
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      Fidelity f = vacuum(integrator);
      f.drag = DragModel::linear_quadratic;
      f.wind = WindModel::profile;
      f.precision = precision;
      const Flight flight = fly(p, {.speed = 10}, e, f, {1e-6, 1e-6}, {.ground = {}, .time = 200});
      EXPECT_EQ(flight.outcome(), Outcome::stalled) << text(integrator) << ' ' << name(precision);
      EXPECT_NEAR(flight.end().position.x, 1000, 0.1) << text(integrator) << ' ' << name(precision);
      EXPECT_NEAR(flight.duration(), 100, 0.01) << text(integrator) << ' ' << name(precision);
    }
}

TEST(Outcome, stalled_at_a_drag_that_overflows) {
  // Each try is shorter than the last one, until none is left; the bends of the wind are looked for in all of them.
  ProjectileDef p{.mass = 0.01, .diameter = 1e140, .drag = {.table = DragTable::g7}};
  Environment e{.wind = {.profile = {{0, {1, 0, 0}}, {100, {5, 0, 0}}}}};
  for (const Integrator integrator : kAdaptive) {
    Fidelity f = Fidelity::simulation();
    f.integrator = integrator;
    f.wind = WindModel::profile;
    const Flight flight = fly(p, {.position = {0, 10, 0}, .speed = 1e80, .elevation = 0.1}, e, f);
    const bool is_over = flight.outcome() == Outcome::stalled || flight.outcome() == Outcome::non_finite;
    EXPECT_TRUE(is_over) << text(integrator) << ' ' << int(flight.outcome());
    EXPECT_EQ(flight.duration(), 0) << text(integrator);
  }
}

TEST(Outcome, refused) {
  EXPECT_EQ(fly({.mass = -1}, {}, {}).outcome(), Outcome::refused);
  EXPECT_TRUE(fly({.mass = -1}, {}, {}).error());
}

TEST(Outcome, nothing_that_never_lands_runs_for_ever) {
  const auto start = std::chrono::steady_clock::now();
  Fidelity f = vacuum();
  f.gravity = GravityModel::off;
  EXPECT_EQ(fly({}, {.speed = 1, .elevation = 1}, {}, f).outcome(), Outcome::time_limit) << "no gravity";
  f = vacuum();
  f.gravity = GravityModel::inverse_square;
  f.earth = EarthModel::sphere;
  EXPECT_EQ(fly({}, {.position = {0, 400e3, 0}, .speed = 7700}, {}, f).outcome(), Outcome::time_limit) << "an orbit";
  EXPECT_EQ(fly({}, {.speed = 20000, .elevation = 1.5}, {}, f).outcome(), Outcome::time_limit) << "escape";
  f = {};
  EXPECT_NE(fly(bullet_308(), {.speed = 20000, .elevation = 1.5}, {}, f).outcome(), Outcome::refused);
  const auto seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LT(seconds, 20);
}

TEST(Outcome, at_rest_in_still_air) {
  for (const Integrator integrator : kIntegrators) {
    Fidelity f{.integrator = integrator, .gravity = GravityModel::off};
    const Flight flight = fly({}, {.position = {0, 1, 0}}, {}, f, {.step = 0.01}, {.time = 1});
    EXPECT_EQ(flight.outcome(), Outcome::time_limit) << text(integrator);
    EXPECT_EQ(flight.end().position, (Vec3d{0, 1, 0}));
  }
}

TEST(Outcome, huge_steps_end) {
  for (const Integrator integrator : {Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::heun,
                                      Integrator::rk4, Integrator::classic})
    for (const double step : {1e6, 1e30, 1e300})
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        Fidelity f{.integrator = integrator, .precision = precision};
        const Flight flight = fly(bullet_308(), {.speed = 800, .elevation = 1}, {}, f, {.step = step});
        EXPECT_NE(flight.outcome(), Outcome::refused) << text(integrator) << step;
        EXPECT_LE(flight.cost().steps, 10000) << text(integrator) << step;
      }
}

}  // namespace physim::flight_outcome_test
