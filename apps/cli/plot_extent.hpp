// What part of an axis a panel of a picture shows.
#pragma once

#include <string>

namespace physim::cli {

struct Extent {
  double low = 0, high = 0;
  [[nodiscard]] double span() const { return high - low; }
};

/// A value that does not change but for rounding errors.
[[nodiscard]] bool is_constant(Extent extent);
/// Room around the data; a constant is shown in the middle of a range of its own size.
[[nodiscard]] Extent padded(Extent extent);
/// "set xrange [low:high]"
[[nodiscard]] std::string range_of(const char* axis, Extent extent);

}  // namespace physim::cli
