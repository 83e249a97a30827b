// Equations, symbols and Source: model/ricochet.hpp.
#include "model/ricochet.hpp"

#include <cmath>

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "math/root.hpp"

namespace physim {
namespace {

constexpr double kWholeLift = 16.0 / 15;  // G(2)

double lift_work(double z) { return z * z * z * (4.0 / 3 + z * (z / 5 - 1)); }  // G

/// (G(a) - G(b)) / (a - b), which keeps its digits where a and b are near.
double lift_work_slope(double a, double b) {
  const double product = a * b, squares = a * a + b * b;
  return 4.0 / 3 * (squares + product) - (a + b) * squares +
         (squares * squares - product * product + product * squares) / 5;
}

/// I, by its series in the sine where that would cancel.
double drag_of_cap(double z) {
  const double cosine = 1 - z, square = z * (2 - z), sine = std::sqrt(square);
  if (z < 0.005) return square * square * sine * (0.2 + square * (1 / 14.0 + square / 24));
  const double sine_2 = 2 * sine * cosine, cosine_2 = 1 - 2 * sine * sine;
  return 0.375 * atan2(sine, cosine) - 0.25 * sine_2 + 0.0625 * sine_2 * cosine_2;
}

/// J. With z = z_m (1 - w^2) the integrand is smooth: sixteen points leave an error of 1e-5 of it.
double drag_integral(double x) {
  constexpr int kPoints = 16;
  const auto excess = [x](double z) { return lift_work(z) - x * kWholeLift; };
  const double deepest = find_root(excess, 0.0, excess(0), 2.0, excess(2), 1e-15);
  PHYSIM_ASSERT(deepest >= 0 && deepest <= 2);
  if (deepest == 0) return 0;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double w = (i + 0.5) / kPoints, z = deepest * (1 - w * w);
    sum += drag_of_cap(z) * std::sqrt(deepest * kWholeLift / lift_work_slope(deepest, z));
  }
  return 2 * sum / kPoints;
}

}  // namespace

double liquid_critical_angle(double specific_gravity) {
  PHYSIM_ASSERT(specific_gravity > 0);
  return std::sqrt(0.1 / specific_gravity);
}

double liquid_speed_kept(double specific_gravity, double angle) {
  const double part = angle / liquid_critical_angle(specific_gravity);
  PHYSIM_ASSERT(part >= 0 && part < 1);
  constexpr double kDrag = 1.0065842420897408;  // sqrt(10) / pi
  return part > 0 ? exp(-kDrag / std::sqrt(specific_gravity) * drag_integral(part * part)) : 1;
}

}  // namespace physim
