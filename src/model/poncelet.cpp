// Equations, symbols and Source: model/poncelet.hpp.
#include "model/poncelet.hpp"

#include <cmath>

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "math/pack.hpp"
#include "physim/math.hpp"

namespace physim {
namespace {

/// What the crater does; all 0 without a crater.
struct Crater {
  double slope;          // F / (c m): v^2 falls by slope x^2 [1/s^2]
  double speed_squared;  // v_1^2; below 0: it is not passed [m^2/s^2]
};

Crater crater_of(const Bore& b, double speed) {
  PHYSIM_ASSERT(b.mass > 0 && b.area > 0 && b.strength >= 0 && b.inertia >= 0 && b.crater >= 0);
  const double v_2 = speed * speed;
  if (b.crater == 0) return {0, v_2};
  const double carried = b.mass + b.area * b.inertia * b.crater;
  return {b.area * (b.strength + b.inertia * v_2) / (b.crater * carried),
          (b.mass * v_2 - b.area * b.strength * b.crater) / carried};
}

}  // namespace

double poncelet_depth(const Bore& b, double speed) {
  const Crater crater = crater_of(b, speed);
  if (crater.speed_squared < 0) return speed / std::sqrt(crater.slope);
  if (b.strength == 0) return kInfinity;
  if (b.inertia == 0) return b.crater + b.mass * crater.speed_squared / (2 * b.area * b.strength);
  return b.crater + b.mass / (2 * b.area * b.inertia) * log1p(b.inertia * crater.speed_squared / b.strength);
}

double poncelet_speed(const Bore& b, double speed, double depth) {
  PHYSIM_ASSERT(depth >= 0);
  const Crater crater = crater_of(b, speed);
  if (depth <= b.crater || crater.speed_squared < 0)
    return std::sqrt(max(speed * speed - crater.slope * depth * depth, 0.0));
  const double way = depth - b.crater;
  if (b.inertia == 0) return std::sqrt(max(crater.speed_squared - 2 * b.area * b.strength * way / b.mass, 0.0));
  const double lost = expm1(-2 * b.area * b.inertia * way / b.mass);  // -1 to 0
  return std::sqrt(max(crater.speed_squared + (crater.speed_squared + b.strength / b.inertia) * lost, 0.0));
}

double concrete_strength(double compressive_strength) {
  PHYSIM_ASSERT(compressive_strength > 0);
  return 82.6e6 * pow(compressive_strength * 1e-6, 1 - 0.544);
}

}  // namespace physim
