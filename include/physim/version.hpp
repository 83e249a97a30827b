// The version of the library.
#pragma once

namespace physim {

inline constexpr const char* kVersion = "0.2.0";

}  // namespace physim
