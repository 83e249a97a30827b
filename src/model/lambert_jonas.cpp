// Equations, symbols and Source: model/lambert_jonas.hpp.
#include "model/lambert_jonas.hpp"

#include <cmath>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"
#include "math/root.hpp"

namespace physim {
namespace {

/// f(z) = z + exp(-z) - 1, by its series where that would cancel.
double lambert_f(double z) { return z > 1e-4 ? z + expm1(-z) : z * z * (0.5 - z * (1 / 6.0 - z / 24)); }

/// v_l over the square root of f(z).
double lambert_scale(double coefficient, const LongRod& rod) {
  PHYSIM_ASSERT(coefficient > 0 && rod.mass > 0 && rod.diameter > 0 && rod.length > 0);
  const double d = rod.diameter;
  return coefficient * pow(rod.length / d, 0.15) * std::sqrt(1e3 * d * d * d / rod.mass);  // cm^3 / g
}

}  // namespace

double lambert_z(double way, double diameter, double cosine) {
  PHYSIM_ASSERT(way >= 0 && diameter > 0 && cosine > 0 && cosine < 1 + 1e-9);
  return way / diameter * pow(cosine, 0.25);
}

double lambert_limit(double coefficient, const LongRod& rod, double z) {
  PHYSIM_ASSERT(z >= 0);
  return lambert_scale(coefficient, rod) * std::sqrt(lambert_f(z));
}

double lambert_passed(double coefficient, const LongRod& rod, double speed) {
  PHYSIM_ASSERT(speed >= 0);
  const double ratio = speed / lambert_scale(coefficient, rod), wanted = ratio * ratio;
  const auto excess = [wanted](double z) { return lambert_f(z) - wanted; };
  const double high = wanted + 2 * ratio;  // f(z) is above z - 1 + exp(-z), and above z^2 / 4 up to z = 1
  return find_root(excess, 0.0, excess(0), high, excess(high), 0);
}

LambertResidual lambert_residual(const LongRod& rod, double density, double z) {
  PHYSIM_ASSERT(density >= 0 && z >= 0);
  const double plug = density * (kPi / 4) * rod.diameter * rod.diameter * rod.diameter * z;
  return {rod.mass / (rod.mass + plug / 3), 2 + z / 3};
}

}  // namespace physim
