// Range: the values that a number may have, or the lengths that a list may have.
#pragma once

#include <string>
#include <string_view>

#include "physim/math.hpp"

namespace physim {

/// The values a number may have, or the lengths a list may have. Infinity only if the range includes it.
struct Range {
  double low = -kInfinity;
  double high = kInfinity;
  bool low_open = false;     // low itself is out of range
  bool infinite = false;     // infinity is in range
  std::string_view words{};  // instead of the text made from the numbers

  /// False for NaN.
  [[nodiscard]] constexpr bool contains(double value) const {
    const bool is_above = low_open || (low == -kInfinity && !infinite) ? value > low : value >= low;
    const bool is_below = high == kInfinity && !infinite ? value < high : value <= high;
    return is_above & is_below;
  }
  [[nodiscard]] std::string text() const;  // "> 0", "0 .. 1", ""
};

namespace setting_rows {

constexpr Range above(double low) { return {.low = low, .low_open = true}; }
constexpr Range at_least(double low) { return {.low = low}; }
constexpr Range at_most(double high) { return {.low = 0, .high = high}; }
constexpr Range between(double low, double high) { return {.low = low, .high = high}; }
constexpr Range or_infinite(Range range) {
  range.infinite = true;
  return range;
}
inline constexpr double kRightAngleUp = 1.5707963267948968;  // the next number above a right angle [rad]
inline constexpr Range kHalfTurn = {.low = -kRightAngleUp, .high = kRightAngleUp, .words = "-90 deg .. 90 deg"};
inline constexpr Range kTurn = {.low = -6.283185307179586, .high = 6.283185307179586, .words = "-360 deg .. 360 deg"};
inline constexpr Range kBits = {.low = 0, .high = 4294967295.0};
inline constexpr Range kFraction = {.low = 0, .high = 1};
inline constexpr Range kAboveZeroToOne = {.low = 0, .high = 1, .low_open = true};

}  // namespace setting_rows
}  // namespace physim
