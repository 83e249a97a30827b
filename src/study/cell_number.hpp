// The cell that a number is counted in, see study/cells.hpp.
#pragma once

#include <cstdint>

#include "math/pack.hpp"

namespace physim {
inline constexpr int kCellDigits = 8;  // of t
inline constexpr double kFarthestCounted = 0x1p40;
}  // namespace physim

PHYSIM_ISA_BEGIN

/// The number of the cell that y = (x - centre) / scale lies in, as the bits of a signed integer.
template <class R>
PHYSIM_INLINE BitsOf<R> cell_number(const R& y) {
  using Bits = BitsOf<R>;
  constexpr int kDropped = 52 - kCellDigits;
  constexpr std::uint64_t kOne = std::uint64_t{0x3FF} << kCellDigits;  // what 1 has there
  PHYSIM_ASSERT(all(y == y));
  const R t = R(1.0) + min(abs(y), R(kFarthestCounted));
  const Bits below = Bits(0) - (to_bits(y + R(0.0)) >> 63);  // all ones where y < 0: then -1 - k, else k
  return ((to_bits(t) >> kDropped) - Bits(kOne)) ^ below;
}

PHYSIM_ISA_END
