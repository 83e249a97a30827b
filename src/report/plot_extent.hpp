// What parts of its axes a panel of a picture shows.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

namespace physim::report {

struct Extent {
  double low = INFINITY, high = -INFINITY;  // of nothing
  void add(double value) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  /// From 0 to 0 where nothing was added.
  [[nodiscard]] Extent or_zero() const { return low <= high ? *this : Extent{0, 0}; }
  [[nodiscard]] double span() const { return high - low; }
};

/// A value that does not change but for rounding errors.
[[nodiscard]] bool is_constant(Extent extent);
/// Room around the data; a constant is shown in the middle of a range of its own size.
[[nodiscard]] Extent padded(Extent extent);
/// "set xrange [low:high]"
[[nodiscard]] std::string range_of(const char* axis, Extent extent);

/// What the axes of a panel are called in the singular or plural: "vertical axis".
struct AxisNames {
  const char *across, *up;
};
/// Makes a metre as long across as upwards in a panel of so many pixels, where both axes keep a visible part of it;
/// `part_below` of the room that is left lies below the data. Else they stay stretched. Gives what the title says of
/// it.
[[nodiscard]] std::string to_scale(Extent& across, Extent& up, double width, double height, double part_below,
                                   AxisNames names);

/// What a panel shows, above its vertical axis, where it takes no width.
[[nodiscard]] std::string panel_title(const std::string& text);

}  // namespace physim::report
