// Equations, symbols and Source: model/young.hpp.
#include "model/young.hpp"

#include <cmath>

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "math/pack.hpp"
#include "model/nose.hpp"

namespace physim {
namespace {

constexpr double kSlow = 0.0008, kSlowSquare = 2.15e-4, kFast = 0.000018, kFastFrom = 30.5;
constexpr double kFastBranch = 61;  // [m/s]

/// K.
double young_light(double mass, bool hard) {
  if (hard) return mass < 182 ? 0.46 * pow(mass, 0.15) : 1.0;
  return mass < 27 ? 0.27 * pow(mass, 0.4) : 1.0;
}

}  // namespace

double young_reach(double s_number, double nose_length, double mass, double area, bool hard) {
  PHYSIM_ASSERT(s_number > 0 && mass > 0 && area > 0);
  return s_number * young_nose_factor(nose_length) * young_light(mass, hard) * pow(mass / area, 0.7);
}

double young_depth(double reach, double speed) {
  PHYSIM_ASSERT(reach > 0 && speed >= 0);
  return speed < kFastBranch ? kSlow * reach * log1p(kSlowSquare * speed * speed) : kFast * reach * (speed - kFastFrom);
}

double young_speed(double reach, double depth) {
  PHYSIM_ASSERT(reach > 0 && depth >= 0);
  const double fast = kFastFrom + depth / (kFast * reach);
  if (fast >= kFastBranch) return fast;
  return min(std::sqrt(expm1(depth / (kSlow * reach)) / kSlowSquare), kFastBranch);
}

}  // namespace physim
