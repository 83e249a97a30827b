// The highest point of a way of which the states at both ends are known: of what joints hold, or what slides.
//
// Symbols: w0, w1 rates of climb at its ends [m/s], h its time [s], theta a part of it.
// Equation: theta = w0 / (w0 - w1), the place on the cubic of x0, v0, x1, v1, the velocity v0 + theta (v1 - v0): exact
//   where the acceleration is constant.
// Source: J. Stoer, R. Bulirsch, Introduction to Numerical Analysis (2002), 2.1.5 (Hermite's interpolation).
// When wrong: by terms in h^2 elsewhere.
#pragma once

#include <optional>

#include "model/earth.hpp"

namespace physim {

struct Apex {
  double passed;  // since the way began [s]
  State<double> at;
};

/// Nothing unless the way climbs where it begins, and not where it ends.
[[nodiscard]] inline std::optional<Apex> apex_between(const Conditions<double>& c, const State<double>& from,
                                                      const State<double>& to, double h) {
  const double before = climb_rate(c, from), after = climb_rate(c, to);
  if (!(before > 0 && after <= 0)) return std::nullopt;
  const double t = before / (before - after), u = 1 - t;
  const Vec3d place = from.x + (to.x - from.x) * (t * t * (3 - 2 * t)) + (from.v * u - to.v * t) * (h * t * u);
  return Apex{h * t, {place, from.v + (to.v - from.v) * t}};
}

}  // namespace physim
