// Figures of a flight that expectations ask for, against the closed form in vacuum.

#include <cmath>

#include "must.hpp"
#include "scenario/scenario.hpp"

namespace physim::scenario_measure_test {

constexpr double kGravity = 9.80665, kSpeed = 100;
const double kSide = kSpeed * std::sqrt(0.5);  // both components of 45 degrees

Flight lob() {
  Fidelity fidelity = Fidelity::arcade();
  fidelity.precision = Precision::float64;
  return fly({.mass = 2}, {.speed = kSpeed, .elevation = std::atan(1.0)}, {}, fidelity);
}

double figure(const std::string& quantity, ExpectAt at, double at_value = 0) {
  return must(measure(lob(), {.at = at, .at_value = at_value, .quantity = quantity}));
}

TEST(Measure, LooksAtTheApex) {
  EXPECT_NEAR(figure("y", ExpectAt::apex), kSide * kSide / (2 * kGravity), 1e-6);
  EXPECT_NEAR(figure("time", ExpectAt::apex), kSide / kGravity, 1e-6);
  EXPECT_NEAR(figure("vy", ExpectAt::apex), 0, 1e-6);
  EXPECT_NEAR(figure("speed", ExpectAt::apex), kSide, 1e-6);
}

TEST(Measure, LooksAtTheEnd) {
  EXPECT_NEAR(figure("x", ExpectAt::end), 2 * kSide * kSide / kGravity, 1e-6);
  EXPECT_NEAR(figure("range", ExpectAt::end), 2 * kSide * kSide / kGravity, 1e-6);
  EXPECT_NEAR(figure("vy", ExpectAt::end), -kSide, 1e-6);
  EXPECT_NEAR(figure("z", ExpectAt::end), 0, 1e-9);
  EXPECT_NEAR(figure("energy", ExpectAt::end), kSpeed * kSpeed, 1e-4);
  EXPECT_NEAR(figure("elevation", ExpectAt::end), std::atan(1.0), 1e-15);
}

TEST(Measure, LooksAtTimesRangesAndHeights) {
  EXPECT_NEAR(figure("x", ExpectAt::time, 2), 2 * kSide, 1e-9);
  EXPECT_NEAR(figure("vx", ExpectAt::time, 2), kSide, 1e-9);
  EXPECT_NEAR(figure("time", ExpectAt::range, 100), 100 / kSide, 1e-9);
  EXPECT_NEAR(figure("drop", ExpectAt::range, 100), 100 - 0.5 * kGravity * 1e4 / (kSide * kSide), 1e-6);
  EXPECT_NEAR(figure("y", ExpectAt::height, 50), 50, 1e-6);
  EXPECT_GT(figure("vy", ExpectAt::height, 50), 0) << "the first crossing";
}

std::string error_of(const Flight& flight, const Expectation& expectation) {
  const Result<double> value = measure(flight, expectation);
  return value.ok() ? "no error" : value.error().text();
}

TEST(Measure, SaysWhyThereIsNothing) {
  EXPECT_EQ(error_of(lob(), {.quantity = "sped", .place = "f.toml:3:1"}),
            "f.toml:3:1: error: unknown quantity \"sped\"; did you mean \"speed\"?");
  EXPECT_NE(
      error_of(lob(), {.at = ExpectAt::time, .at_value = 1000, .quantity = "x"}).find("the flight ends after 14."),
      std::string::npos);
  EXPECT_NE(error_of(lob(), {.at = ExpectAt::range, .at_value = 1e6, .quantity = "drop"}), "no error");
  Fidelity fidelity = Fidelity::arcade();
  const Flight drop = fly({}, {.position = {0, 10, 0}}, {}, fidelity);
  EXPECT_EQ(error_of(drop, {.at = ExpectAt::apex, .quantity = "y"}), "error: the flight has no apex");
  const Flight refused = fly({.mass = -1}, {}, {}, fidelity);
  EXPECT_NE(error_of(refused, {.quantity = "x"}), "no error");
}

/// Linear drag of rate k: v' = g - k v, so that the jerk is -k a.
TEST(Measure, LooksAtTheJerk) {
  const double k = 0.5;
  Fidelity fidelity = Fidelity::reference();
  fidelity.gravity = GravityModel::constant;
  fidelity.drag = DragModel::linear_quadratic;
  fidelity.wind = WindModel::off;
  fidelity.earth = EarthModel::flat;
  fidelity.rotation = RotationModel::none;
  const Flight flight = fly({.mass = 2, .drag = {.k1 = 2 * k}}, {.velocity = Vec3d{30, 20, 5}}, {}, fidelity);
  for (const std::string axis : {"x", "y", "z"}) {
    const auto at_one_second = [&](const std::string& what) {
      return *measure(flight, {.at = ExpectAt::time, .at_value = 1, .quantity = what + axis});
    };
    EXPECT_NEAR(at_one_second("j"), -k * at_one_second("a"), 1e-6) << axis;
  }
  EXPECT_NEAR(figure("jy", ExpectAt::time, 2), 0, 1e-9);
}

}  // namespace physim::scenario_measure_test
