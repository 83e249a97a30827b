// Measured tables of drag and thrust have many corners, and winds do: they cost few steps that are taken twice.
#include "support.hpp"

namespace physim::solve_rocket_steps_test {

/// A rocket of 20 kg as those that flew are described: a drag table of 80 points and a thrust curve of 30, each a
/// hundredth off a smooth curve to and fro, as measurements are.
ProjectileDef measured_rocket() {
  ProjectileDef p{.mass = 20, .diameter = 0.15};
  const auto off = [](int i) { return i % 2 == 0 ? 1.01 : 0.99; };
  p.drag.table = DragTable::custom;
  for (int i = 0; i < 80; ++i) {
    const double mach = 0.025 * i, wave = std::exp(-std::pow((mach - 1.05) / 0.15, 2));
    p.drag.curve.push_back({mach, (0.4 + 0.3 * wave) * off(i)});
  }
  p.motor.propellant_mass = 2.4;
  for (int i = 1; i < 29; ++i) p.motor.thrust.push_back({3.0 * i / 29, 1400 * off(i)});
  p.motor.thrust.insert(p.motor.thrust.begin(), {0, 0});
  p.motor.thrust.push_back({3, 0});
  p.inertia.moments = {0.06, 12, 12};
  p.aero.lift = {{0, 0, 9}};
  p.aero.pitching = {{0, 0, -18}};
  p.aero.pitch_damping = {{0, 0, -400}};
  p.aero.roll_damping = {{0, 0, -5}};
  p.fidelity = Fidelity::simulation();
  p.fidelity.interpolation = Interpolation::linear;
  return p;
}

Flight flown() {
  Environment environment;
  for (int i = 0; i < 28; ++i) environment.wind.profile.push_back({100.0 * i, {-0.2 * i, 0, i % 2 == 0 ? 1.0 : 1.5}});
  const ProjectileDef p = measured_rocket();
  return fly(p, {.speed = 0, .elevation = 1.48, .rail_length = 5}, environment, p.fidelity, {},
             {.time = 200, .events = {{.kind = EventKind::apex, .terminal = true}}});
}

TEST(RocketSteps, a_body_by_measured_tables_rejects_a_tenth_of_its_steps_at_most) {
  const Flight flight = flown();
  ASSERT_FALSE(flight.error()) << flight.error()->text();
  EXPECT_EQ(flight.fidelity_in_use().fidelity.rotation, RotationModel::rigid_body);
  EXPECT_GT(flight.end().position.y, 1000) << "it flies through all corners";
  const FlightCost& cost = flight.cost();
  EXPECT_LT(10 * cost.rejected, cost.steps + cost.rejected) << cost.rejected << " of " << cost.steps;
}

}  // namespace physim::solve_rocket_steps_test
