#include "report/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/assert.hpp"

namespace physim::report {
namespace {

// Room for 309 digits before the point and all decimals that are ever asked for.
constexpr int kRoom = 400;

template <class... Format>
std::string to_text(double value, Format... format) {
  if (std::isnan(value)) return "nan";
  char text[kRoom];
  const auto [end, error] = std::to_chars(text, text + kRoom, value, format...);
  PHYSIM_ASSERT(error == std::errc());
  return {text, end};
}

}  // namespace

std::string shortest(double value) { return to_text(value); }

std::string plain(double value) { return to_text(value, std::chars_format::fixed); }

std::string fixed(double value, int decimals) {
  PHYSIM_ASSERT(decimals >= 0);
  std::string text = to_text(value, std::chars_format::fixed, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string significant(double value, int digits) {
  PHYSIM_ASSERT(digits > 0);
  return to_text(value, std::chars_format::general, digits);
}

std::string as_typed(double value) { return significant(value, 12); }

std::string readable(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return fixed(value, 0);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  constexpr int kMostDecimals = 6;
  return magnitude < -kMostDecimals ? "0" : fixed(value, std::clamp(digits - 1 - magnitude, 0, kMostDecimals));
}

std::string sized(double value, int digits) {
  const double size = std::abs(value);
  return size != 0 && (size < 1e-4 || size >= 1e9) ? significant(value, digits) : readable(value, digits);
}

double rounded(double value, int digits) {
  const std::string text = significant(value, digits);
  double number = value;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

std::string hex(std::uint64_t value) {
  char text[19];
  std::snprintf(text, sizeof text, "0x%016llx", static_cast<unsigned long long>(value));
  return text;
}

}  // namespace physim::report
