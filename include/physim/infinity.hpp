// kInfinity: the default of every limit that is none.
#pragma once

#include <bit>
#include <cstdint>

namespace physim {

/// Positive infinity, by its bits: where a program is compiled with -ffast-math, compilers warn of infinities that are
/// written as such.
inline constexpr double kInfinity = std::bit_cast<double>(std::uint64_t{0x7ff0000000000000});

}  // namespace physim
