// A motor that pauses flies like a rocket that coasts, and its impulse is that of both pulses.
#include "support.hpp"

namespace physim::flight_motor_pause_test {

using namespace test;

constexpr double kPi = 3.14159265358979323846;
constexpr double kPauses = 0.2, kGoesOn = 1.7;

ProjectileDef two_pulses() {
  return {
      .mass = 2,
      .diameter = 0.1,
      .drag = {.coefficient = 0.4},
      .motor = {.thrust = {{0, 100}, {kPauses, 100}, {kPauses, 0}, {kGoesOn, 0}, {kGoesOn, 50}, {1.9, 50}, {1.9, 0}},
                .propellant_mass = 0.3}};
}
Environment without_gravity() {
  return {.gravity = {.model = GravityModel::off}, .atmosphere = {.model = AirModel::constant, .density = 1.2}};
}
Flight shot(const ProjectileDef& p, Integrator integrator, DragModel drag) {
  Fidelity f = vacuum(integrator);
  f.drag = drag;
  f.air = AirModel::constant;
  return fly(p, {.speed = 10, .elevation = 0}, without_gravity(), f, {1e-11, 1e-11, 1e-2}, {.ground = {}, .time = 3});
}

TEST(MotorPause, in_vacuum_the_speed_is_that_of_tsiolkovsky) {
  const ProjectileDef p = two_pulses();
  const double exhaust = total_impulse(p.motor) / p.motor.propellant_mass;
  for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5, Integrator::dop853}) {
    const Flight flight = shot(p, integrator, DragModel::off);
    const double before = 10 + exhaust * std::log(2 / (2 - 0.3 * 20 / 30));
    EXPECT_NEAR(flight.at(1).velocity.x, before, 1e-7) << text(integrator);
    EXPECT_NEAR(flight.at(3).velocity.x, 10 + exhaust * std::log(2 / 1.7), 1e-7) << text(integrator);
  }
}

/// Drag that a burning motor takes away is there again while it pauses: v = v0 / (1 + k v0 t).
TEST(MotorPause, it_has_the_drag_of_a_coasting_rocket) {
  ProjectileDef p = two_pulses();
  p.motor.drag_factor = 0;
  const double mass = 2 - 0.3 * 20 / 30, k = 0.5 * 1.2 * 0.4 * kPi * 0.01 / 4 / mass;
  for (const Integrator integrator : {Integrator::rk4, Integrator::tsit5, Integrator::dop853}) {
    const Flight flight = shot(p, integrator, DragModel::equation);
    const double from = flight.at(kPauses).velocity.x;
    EXPECT_NEAR(from, 10 + 100 * std::log(2 / mass), 1e-6) << text(integrator);
    for (const double t : {0.5, 1.0, kGoesOn})
      EXPECT_NEAR(flight.at(t).velocity.x, from / (1 + k * from * (t - kPauses)), 1e-7) << text(integrator);
  }
}

}  // namespace physim::flight_motor_pause_test
