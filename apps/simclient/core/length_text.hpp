// Lengths as people say them.
#pragma once

#include <string>

#include "base/text.hpp"

namespace physim::client {

/// "0.023 mm", "1.1 cm", "31.2 m", "2.39 km": two digits below a metre, three above. Each bound is where its unit would
/// be rounded to a thousand or a hundred of it.
[[nodiscard]] inline std::string length_text(double metres) {
  if (metres < 0.00995) return formatted("%.2g mm", 1000 * metres);
  if (metres < 0.995) return formatted("%.2g cm", 100 * metres);
  if (metres < 999.5) return formatted("%.3g m", metres);
  return metres < 999.5e3 ? formatted("%.3g km", metres / 1000) : formatted("%.0f km", metres / 1000);
}

}  // namespace physim::client
