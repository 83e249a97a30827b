#include "report/plot_extent.hpp"

#include "report/number.hpp"
#include "report/picture.hpp"

namespace physim::report {

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

std::string to_scale(Extent& across, Extent& up, double width, double height, double part_below, AxisNames names) {
  const double metres_per_pixel = std::max(across.span() / width, up.span() / height);
  const double part_across = across.span() / (metres_per_pixel * width);
  const double part_up = up.span() / (metres_per_pixel * height);
  if (!(part_across > 0.25 && part_up > 0.25))
    return std::string(", ") + (part_up < part_across ? names.up : names.across) + " stretched " +
           readable(std::max(part_across / part_up, part_up / part_across), 2) + " times";
  const auto widened = [&](const Extent& extent, double size) {
    const double room = metres_per_pixel * size - extent.span();
    return Extent{extent.low - part_below * room, extent.high + (1 - part_below) * room};
  };
  across = widened(across, width);
  up = widened(up, height);
  return ", to scale";
}

std::string panel_title(const std::string& text) {
  return "set label " + literal(text) + " at graph 0,1 left offset 0,0.75 font ',14' textcolor rgb " + literal(kInk) +
         "\n";
}

}  // namespace physim::report
