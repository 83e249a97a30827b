#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdarg>
#include <cstdio>

#include "base/assert.hpp"

namespace physim {
namespace {

std::string text_of(double x, auto... format) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x, format...);
  PHYSIM_ASSERT(error == std::errc());
  return {buffer, end};
}

}  // namespace

std::string short_text(double x) { return text_of(x, std::chars_format::general, 6); }

std::string rounded_text(double x) {
  const bool whole = x >= 99.5 && x < 99999.5;  // 120, not 1.2e+02
  return whole ? text_of(x, std::chars_format::fixed, 0) : text_of(x, std::chars_format::general, 2);
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

std::string within_sentence(const Error& error) {
  const std::string text = error.place.empty() ? error.message : error.place + ": " + error.message;
  return error.hint.empty() ? text : text + "; " + error.hint;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  PHYSIM_ASSERT(!from.empty());
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) text.replace(at, from.size(), to);
}

std::string formatted(const char* pattern, ...) {
  va_list arguments, again;
  va_start(arguments, pattern);
  va_copy(again, arguments);
  std::string text(static_cast<std::size_t>(std::max(0, std::vsnprintf(nullptr, 0, pattern, arguments))), '\0');
  std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(arguments);
  va_end(again);
  return text;
}

}  // namespace physim
