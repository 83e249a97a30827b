#include "base/text.hpp"

#include <charconv>

namespace physim {

std::string short_text(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return {buffer, end};
}

std::string rounded_text(double x) {
  char buffer[32];
  const bool whole = x >= 99.5 && x < 99999.5;  // 120, not 1.2e+02
  const auto end = whole ? std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, 0).ptr
                         : std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 2).ptr;
  return {buffer, end};
}

std::string length_text(double x) {
  struct Unit {
    double size;
    const char* name;
  };
  constexpr Unit kUnits[] = {{1e3, " km"}, {1, " m"}, {1e-2, " cm"}, {1e-3, " mm"}, {1e-6, " um"}, {1e-9, " nm"}};
  for (const Unit& unit : kUnits)
    if (x >= 0.995 * unit.size && x < 1e300) return rounded_text(x / unit.size) + unit.name;
  return rounded_text(x) + " m";
}

}  // namespace physim
