// Miller's stability factor and Litz's spin drift against figures worked by hand in the formulas' own units.
#include "model/spin_drift.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace physim {
namespace {

using test::near;

/// The example of D. Miller (2005): .308 bullet of 168 gr, 1.226 in long, twist 12 in, at 2800 ft/s, 59 degF, 29.92
/// inHg: Sg = 30 * 168 / ((12/.308)^2 .308^3 (3.9805) (1 + 3.9805^2)) = 1.7398.
ProjectileDef millers_bullet() {
  ProjectileDef p;
  p.mass = 168 * 6.479891e-5;
  p.diameter = 0.308 * 0.0254;
  p.length = 1.226 * 0.0254;
  p.twist = 12 * 0.0254;
  return p;
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

}  // namespace
}  // namespace physim
