// The least of a function of one number.
#pragma once

#include "base/assert.hpp"

namespace physim {

/// Where between a and b the function f is least, by golden sections: right where f falls and then rises. The place is
/// known to 1e-6 of the interval; near a smooth minimum the values resolve nothing finer.
double least_between(const auto& f, double a, double b) {
  PHYSIM_ASSERT(a <= b);
  constexpr double kPart = 0.3819660112501051;  // 2 - golden ratio
  double x = a + kPart * (b - a), y = b - kPart * (b - a);
  double fx = f(x), fy = f(y);
  for (int i = 0; i < 28; ++i) {
    if (fx < fy) {
      b = y, y = x, fy = fx;
      x = a + kPart * (b - a), fx = f(x);
    } else {
      a = x, x = y, fx = fy;
      y = b - kPart * (b - a), fy = f(y);
    }
  }
  return fx < fy ? x : y;
}

}  // namespace physim
