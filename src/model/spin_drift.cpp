// Equations, symbols and Source: model/spin_drift.hpp.
#include "model/spin_drift.hpp"

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"

namespace physim {
namespace {

constexpr double kInch = 0.0254;
constexpr double kGrain = 6.479891e-5;
constexpr double kFoot = 0.3048;
constexpr double kInchOfMercury = 3386.389;
constexpr double kPower = 1.83;
constexpr double kMilePerHour = 0.44704;
constexpr double kMinuteOfArc = kPi / (180 * 60);

}  // namespace

double SpinDrift::drift(double time) const { return time > 0 ? coefficient * pow(time, kPower) : 0; }

double SpinDrift::drift_rate(double time) const { return time > 0 ? coefficient * kPower * pow(time, kPower - 1) : 0; }

double miller_stability(const ProjectileDef& p, double speed, double temperature, double pressure) {
  PHYSIM_ASSERT(p.twist != 0 && p.length > 0);
  const double d = p.diameter / kInch;
  const double l = p.length / p.diameter;
  const double t = abs(p.twist) / p.diameter;
  const double fahrenheit = temperature * 1.8 - 459.67;
  const double base = 30 * (p.mass / kGrain) / (t * t * d * d * d * l * (1 + l * l));
  return base * pow(speed / kFoot / 2800, 1.0 / 3) * ((fahrenheit + 460) / 519) * (29.92 / (pressure / kInchOfMercury));
}

SpinDrift litz_spin_drift(double stability, double twist) {
  const double side = twist < 0 ? -1 : 1;
  return {side * 1.25 * (stability + 1.2) * kInch};
}

double litz_aerodynamic_jump(double stability, double calibres, double twist, double from_right) {
  const double side = twist < 0 ? -1 : 1;
  return side * (from_right / kMilePerHour) * (0.01 * stability - 0.0024 * calibres + 0.032) * kMinuteOfArc;
}

}  // namespace physim
