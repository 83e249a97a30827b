// Miller's stability factor, Litz's spin drift and aerodynamic jump against figures worked by hand in the formulas' own
// units, and against six degrees of freedom.
#include "model/spin_drift.hpp"

#include "support.hpp"

namespace physim::model_spin_drift_test {

using test::near;

/// The example of D. Miller (2005): .308 bullet of 168 gr, 1.226 in long, twist 12 in, at 2800 ft/s, 59 degF, 29.92
/// inHg: Sg = 30 * 168 / ((12/.308)^2 .308^3 (3.9805) (1 + 3.9805^2)) = 1.7398.
ProjectileDef millers_bullet() {
  return {.mass = 168 * 6.479891e-5, .diameter = 0.308 * 0.0254, .length = 1.226 * 0.0254, .twist = 12 * 0.0254};
}

constexpr double kStandardPressure = 29.92 * 3386.389;

TEST(SpinDrift, millers_stability_factor) {
  const double l = 1.226 / 0.308, t = 12 / 0.308;
  const double by_hand = 30 * 168 / (t * t * 0.308 * 0.308 * 0.308 * l * (1 + l * l));
  EXPECT_NEAR(by_hand, 1.7, 0.1);
  EXPECT_TRUE(near(miller_stability(millers_bullet(), 2800 * 0.3048, 288.15, kStandardPressure), by_hand, 1e-4));
}

TEST(SpinDrift, stability_follows_speed_temperature_pressure_and_twist) {
  const auto sg = [](double v, double t, double p) { return miller_stability(millers_bullet(), v, t, p); };
  const double base = sg(2800 * 0.3048, 288.15, kStandardPressure);
  EXPECT_TRUE(near(sg(1400 * 0.3048, 288.15, kStandardPressure), base * std::cbrt(0.5), 1e-12));
  EXPECT_TRUE(near(sg(2800 * 0.3048, 288.15, kStandardPressure / 2), base * 2, 1e-12));
  EXPECT_TRUE(near(sg(2800 * 0.3048, 310.928, kStandardPressure), base * 560 / 519, 1e-3)) << "100 degF";
  ProjectileDef slow = millers_bullet();
  slow.twist *= -2;
  EXPECT_TRUE(near(miller_stability(slow, 2800 * 0.3048, 288.15, kStandardPressure), base / 4, 1e-12));
}

TEST(SpinDrift, litz_formula) {
  // Sg 1.7 and 1.5 s: 1.25 * 2.9 * 1.5^1.83 = 7.6129 in.
  const SpinDrift drift = litz_spin_drift(1.7, 0.3);
  EXPECT_TRUE(near(drift.drift(1.5), 1.25 * 2.9 * std::pow(1.5, 1.83) * 0.0254, 1e-14));
  EXPECT_TRUE(near(litz_spin_drift(1.7, -0.3).drift(1.5), -drift.drift(1.5), 1e-15));
  EXPECT_EQ(drift.drift(0), 0);
  EXPECT_EQ(drift.drift_rate(0), 0);
  EXPECT_TRUE(near(drift.drift_rate(1.5), (drift.drift(1.5001) - drift.drift(1.4999)) / 2e-4, 1e-7));
}

TEST(SpinDrift, moves_the_flown_path_to_the_side_of_the_twist_and_nothing_else) {
  const ProjectileDef p = test::bullet_308();
  Fidelity f = Fidelity::small_arms();
  const Launch launch{.speed = 800, .azimuth = 0.5};
  const Until until{.ground = {}, .time = 1.2};
  const Flight drifts = fly(p, launch, {}, f, {}, until);
  f.rotation = RotationModel::none;
  const Flight none = fly(p, launch, {}, f, {}, until);
  const double sg = miller_stability(p, 800, 288.15, 101325);
  const double expected = litz_spin_drift(sg, p.twist).drift(1.2);
  EXPECT_NEAR(drifts.end().windage, expected, 1e-9);
  EXPECT_NEAR(none.end().windage, 0, 1e-9);
  EXPECT_NEAR(drifts.end().drop, none.end().drop, 1e-12);
  EXPECT_NEAR(drifts.end().range, none.end().range, 1e-9);
  EXPECT_EQ(drifts.duration(), none.duration());
}

Fidelity jumping() {
  Fidelity f = Fidelity::small_arms();
  f.aerodynamic_jump = true;
  return f;
}
Environment with_wind(const Vec3d& velocity) { return {.wind = {.velocity = velocity}}; }
constexpr double kTenMilesPerHour = 4.4704;

/// How far the flown launch points above the bore [rad].
double jump_of(const ProjectileDef& p, const Vec3d& wind, double azimuth = 0, const Fidelity& f = jumping()) {
  const Flight flight = fly(p, {.speed = 800, .azimuth = azimuth}, with_wind(wind), f, {}, {.ground = {}, .time = 0.1});
  const Vec3d v = flight.at(0).velocity;
  EXPECT_NEAR(length(v), 800, 1e-9);
  return std::asin(v.y / length(v));
}

TEST(AerodynamicJump, litz_formula) {
  // Sg 1.7, 4 calibres, 10 mph: 10 (0.017 - 0.0096 + 0.032) = 0.394 minutes of arc.
  const double minute = 3.14159265358979323846 / 180 / 60;
  EXPECT_TRUE(near(litz_aerodynamic_jump(1.7, 4, 0.3, kTenMilesPerHour), 0.394 * minute, 1e-12));
  EXPECT_TRUE(near(litz_aerodynamic_jump(1.7, 4, -0.3, kTenMilesPerHour), -0.394 * minute, 1e-12));
  EXPECT_TRUE(near(litz_aerodynamic_jump(1.7, 4, 0.3, -kTenMilesPerHour), -0.394 * minute, 1e-12));
}

TEST(AerodynamicJump, turns_the_launch_up_where_the_wind_comes_from_the_right) {
  const ProjectileDef p = test::bullet_308();
  const double expected =
      litz_aerodynamic_jump(miller_stability(p, 800, 288.15, 101325), p.length / p.diameter, p.twist, kTenMilesPerHour);
  EXPECT_NEAR(jump_of(p, {0, 0, -kTenMilesPerHour}), expected, 1e-12);
  EXPECT_NEAR(jump_of(p, {0, 0, kTenMilesPerHour}), -expected, 1e-12);
  EXPECT_NEAR(jump_of(p, {kTenMilesPerHour, 0, 0}), 0, 1e-15);
  EXPECT_NEAR(jump_of(p, {kTenMilesPerHour, 0, 0}, 0.5 * 3.14159265358979323846), expected, 1e-12)
      << "fired to the right";
  ProjectileDef left = p;
  left.twist = -p.twist;
  EXPECT_NEAR(jump_of(left, {0, 0, -kTenMilesPerHour}), -expected, 1e-12);
  EXPECT_NEAR(jump_of(p, {0, 0, -kTenMilesPerHour}, 0, Fidelity::small_arms()), 0, 1e-15);
}

// McCoy's .308 of 168 gr at Mach 2.3, coefficients of that speed: crosswind lifts it about as much as Litz says.
TEST(AerodynamicJump, agrees_with_six_degrees_of_freedom) {
  ProjectileDef p = millers_bullet();
  p.drag.coefficient = 0.33;
  p.inertia.moments = Vec3d{0.000247, 0.001838, 0.001838} * (0.45359237 * 0.0254 * 0.0254);
  p.aero.lift = {{0, 0, 2.7}};
  p.aero.pitching = {{0, 0, 2.65}};
  p.aero.pitch_damping = {{0, 0, -7}};
  p.aero.roll_damping = {{0, 0, -0.01}};
  Fidelity f = Fidelity::simulation();
  f.earth = EarthModel::flat;
  const auto height = [&](double from_right, RotationModel rotation, bool jump) {
    f.rotation = rotation;
    f.aerodynamic_jump = jump;
    const Flight flight =
        fly(p, {.speed = 2600 * 0.3048}, with_wind({0, 0, -from_right}), f, {}, {.ground = {}, .range = 200});
    EXPECT_EQ(flight.fidelity_in_use().fidelity.rotation, rotation);
    return flight.end().position.y;
  };
  const auto lift = [&](RotationModel rotation, bool jump) {
    return 0.5 * (height(kTenMilesPerHour, rotation, jump) - height(-kTenMilesPerHour, rotation, jump));
  };
  const double by_physics = lift(RotationModel::rigid_body, false);
  const double by_litz = lift(RotationModel::spin_drift, true);
  EXPECT_GT(by_physics, 0.01);
  EXPECT_NEAR(by_litz, by_physics, 0.25 * by_physics);
  EXPECT_NEAR(lift(RotationModel::spin_drift, false), 0, 1e-9);
}

TEST(AerodynamicJump, batches_jump_as_single_flights) {
  const Environment e = with_wind({1, 0, -6});
  std::vector<Shot> shots;
  for (int i = 0; i < 5; ++i) shots.push_back({test::bullet_308(), {.speed = 700 + 30.0 * i, .azimuth = 0.1 * i}});
  const Until until{.ground = {}, .time = 0.5};
  const BatchResult batch = fly_batch(shots, e, jumping(), {}, until);
  for (std::size_t i = 0; i < shots.size(); ++i)
    EXPECT_EQ(batch.shots[i].position,
              fly(shots[i].projectile, shots[i].launch, e, jumping(), {}, until).end().position);
}

TEST(SpinDrift, bad_input_has_no_stability_factor) {
  ProjectileDef p = test::bullet_308();
  p.length = 0.03;
  p.twist = 0.3;
  ASSERT_TRUE(stability_factor(p, {.speed = 800}, {}));
  EXPECT_FALSE(stability_factor(p, {.speed = test::kNan}, {}));
  p.length = test::kNan;
  EXPECT_FALSE(stability_factor(p, {.speed = 800}, {}));
  p.length = 0.03;
  p.twist = test::kNan;
  EXPECT_FALSE(stability_factor(p, {.speed = 800}, {}));
}

}  // namespace physim::model_spin_drift_test
