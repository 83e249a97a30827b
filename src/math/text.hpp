// Numbers as people read them in messages.
#pragma once

#include <string>

namespace physim {

/// The shortest text that reads back as x: "1000", "0.001", "nan".
[[nodiscard]] std::string short_text(double x);

}  // namespace physim
