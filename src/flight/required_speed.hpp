// The time of flight at which the launch velocity that a target takes has the magnitude that there is.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "math/minimum.hpp"
#include "math/root.hpp"
#include "math/vec3.hpp"
#include "physim/solve.hpp"

namespace physim {

/// A time of flight and the launch velocity that it takes.
struct Need {
  double time = 0;
  Vec3d velocity;
  bool in_reach = false;  // with the speed there is
  bool later = false;     // at the end of what is known: a longer flight may show more
};

/// The time at which the required speed falls to the speed there is (low) or rises above it for good (high).
/// `required` gives the velocity for a time; `times` start at 0, where it is infinite.
inline Need find_need(std::span<const double> times, const auto& required, double speed, Arc arc) {
  PHYSIM_ASSERT(times.size() >= 2 && times.front() == 0 && speed > 0);
  const auto excess = [&](double t) {
    const double value = length(required(t)) / speed - 1;
    return value < 1e300 ? value : 1e300;  // a path that went beyond all bounds says nothing
  };
  const auto at = [&](double t, bool in_reach, bool later) { return Need{t, required(t), in_reach, later}; };
  const auto root = [&](double a, double fa, double b, double fb) {
    return at(find_root(excess, a, fa, b, fb, 1e-12 * b), true, false);
  };
  std::vector<double> values(times.size(), 1e300);
  for (std::size_t i = 1; i < times.size(); ++i) values[i] = excess(times[i]);
  const auto below = [](double value) { return value <= 0; };
  const std::size_t last = times.size() - 1;
  const auto before = [&](std::size_t i) {  // the crossing before a time in reach
    double from = i == 1 ? 1e-3 * times[1] : times[i - 1];
    double at_from = i == 1 ? excess(from) : values[i - 1];
    for (int k = 0; k < 8 && at_from <= 0; ++k) from *= 1e-3, at_from = excess(from);
    return at_from > 0 ? root(from, at_from, times[i], values[i]) : at(from, true, false);
  };
  if (arc == Arc::low) {
    const auto first = std::find_if(values.begin(), values.end(), below);
    if (first != values.end()) return before(static_cast<std::size_t>(first - values.begin()));
  } else {
    const auto final = std::find_if(values.rbegin(), values.rend(), below);
    if (final == values.rbegin()) return at(times[last], true, true);
    if (final != values.rend()) {
      const auto i = static_cast<std::size_t>(values.rend() - final) - 1;
      return root(times[i], values[i], times[i + 1], values[i + 1]);
    }
  }
  const auto i = static_cast<std::size_t>(std::min_element(values.begin() + 1, values.end()) - values.begin());
  const double from = i == 1 ? 1e-3 * times[1] : times[i - 1];
  const double to = times[std::min(i + 1, last)];
  const double t = least_between(excess, from, to);
  const double least = excess(t);
  if (least > 0) return at(t, false, i == last);
  return arc == Arc::low ? root(from, excess(from), t, least) : root(t, least, to, excess(to));
}

}  // namespace physim
