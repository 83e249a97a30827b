#include "math/text.hpp"

#include <charconv>

namespace physim {

std::string short_text(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return {buffer, end};
}

}  // namespace physim
