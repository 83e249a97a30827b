// Powers of two and their logarithms, linear between whole exponents: for where more would be wasted and is waited for,
// as a step's length by its error. The bits of a number, read as a number with a fixed point, are its exponent and a
// line between powers of two.
//
// Source: J. N. Mitchell, "Computer multiplication and division using binary logarithms", IRE Trans. Electron. Comput.
// EC-11 (1962) 512-517.
#pragma once

#include "math/elementary.hpp"

PHYSIM_ISA_BEGIN

/// Bits of sign and exponent. Numbers from point_at() to twice that have as many digits in front of the point.
template <class R>
inline constexpr int kBitsInFront = 8 * sizeof(ScalarOf<R>) - kMantissaBits<R>;
template <class R>
PHYSIM_INLINE R point_at() {
  return constant<R>(4096, 512);
}
/// What an exponent of zero is stored as, behind point_at().
template <class R>
PHYSIM_INLINE R stored_zero() {
  return constant<R>(4096 + 1023, 512 + 127);
}

/// log2(x) of a normal positive x, no more than 0.0862 below it; exact where x is a power of two.
template <class R>
PHYSIM_INLINE R log2_roughly(const R& x) {
  return from_bits<R>((to_bits(x) >> kBitsInFront<R>) | to_bits(point_at<R>())) - stored_zero<R>();
}

/// 2^x for |x| < 120, no more than 6.2 % above it; exact where x is whole. The inverse of log2_roughly().
template <class R>
PHYSIM_INLINE R exp2_roughly(const R& x) {
  return from_bits<R>(to_bits(x + stored_zero<R>()) << kBitsInFront<R>);
}

PHYSIM_ISA_END
