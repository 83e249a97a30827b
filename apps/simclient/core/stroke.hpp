// Strokes: lines on the screen through many points, with no more pieces than can be seen.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "math/angles.hpp"
#include "simclient/core/camera.hpp"

namespace physim::client {

/// How far a stroke may be beside a point that it leaves out [pixels].
inline constexpr double kStrokeError = 0.3;

/// The numbers of points that a stroke needs, first and last included. `place(i)`: where point i is seen; nothing: it
/// is not, and kept.
template <class Place>
[[nodiscard]] std::vector<std::size_t> points_of_stroke(std::size_t count, const Place& place) {
  std::vector<std::size_t> kept;
  std::optional<Pixel> from;          // the last one that was kept
  double way = 0, low = 0, high = 0;  // the directions in which a line passes all that were left out since
  double reached = -1;                // how far away the last of these is
  const auto keep = [&](std::size_t i) {
    if (kept.empty() || kept.back() != i) kept.push_back(i);
    from = place(i);
    reached = -1;
  };
  /// True if a line to a point passes all that were left out; narrows the directions then.
  const auto takes = [&](const Pixel& to) {
    const double x = to.x - from->x, y = to.y - from->y, away = std::hypot(x, y);
    if (away <= kStrokeError) return reached <= kStrokeError;
    const double room = std::asin(std::min(kStrokeError / away, 1.0));
    if (reached <= kStrokeError) {  // the first that gives a direction
      way = std::atan2(y, x), low = -room, high = room, reached = away;
      return true;
    }
    const double turn = std::remainder(std::atan2(y, x) - way, 2 * kPi);
    if (turn < low || turn > high || away < reached - kStrokeError) return false;
    low = std::max(low, turn - room), high = std::min(high, turn + room), reached = std::max(reached, away);
    return true;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Pixel> at = place(i);
    if (i > 0 && at && from && takes(*at)) continue;
    if (i > 0 && (kept.empty() || kept.back() + 1 != i)) {
      keep(i - 1);
      if (at && from && takes(*at)) continue;
    }
    keep(i);
  }
  if (count > 0 && kept.back() != count - 1) kept.push_back(count - 1);
  return kept;
}

}  // namespace physim::client
