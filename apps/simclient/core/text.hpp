// Text with numbers in it.
#pragma once

#include <cstdio>
#include <string>

namespace physim::client {

/// As printf() would write it, up to 159 characters.
template <class... Values>
[[nodiscard]] std::string text(const char* format, Values... values) {
  char out[160];
  std::snprintf(out, sizeof out, format, values...);
  return out;
}

}  // namespace physim::client
