#include "plot_extent.hpp"

#include <algorithm>
#include <cmath>

#include "output_number.hpp"

namespace physim::cli {

bool is_constant(Extent extent) {
  const double size = std::max(std::abs(extent.low), std::abs(extent.high));
  return extent.span() <= std::max(1e-9, 1e-9 * size);
}

Extent padded(Extent extent) {
  if (is_constant(extent)) {
    const double middle = std::abs(extent.low) < 1e-9 ? 0 : (extent.low + extent.high) / 2;
    const double room = middle == 0 ? 1 : std::abs(middle) / 2;
    return {middle - room, middle + room};
  }
  return {extent.low - 0.07 * extent.span(), extent.high + 0.07 * extent.span()};
}

std::string range_of(const char* axis, Extent extent) {
  return std::string("set ") + axis + "range [" + significant(extent.low, 9) + ":" + significant(extent.high, 9) +
         "]\n";
}

}  // namespace physim::cli
