// Powers of two and their logarithms to two or three digits, for where more would be wasted: a step's length by its
// error. A third of the work of exp() and log().
#pragma once

#include "math/elementary.hpp"

PHYSIM_ISA_BEGIN

/// log2(x) of a normal positive x within 0.01. With x = 2^k m, the parabola through the logarithm at both ends of
/// sqrt(1/2) <= m < sqrt(2) and at m = 1 takes the place of log2(m).
template <class R>
PHYSIM_INLINE R log2_roughly(const R& x) {
  const ExponentMantissa<R> e = split_normal(x, constant<R>(1023, 127));
  const R f = e.m - constant<R>(1);
  return e.k + f * (constant<R>(1.5) - constant<R>(0.70710678118654752) * f);
}

/// 2^x for |x| < 120 within one percent, by Taylor's series up to the square of what is left of a whole exponent.
template <class R>
PHYSIM_INLINE R exp2_roughly(const R& x) {
  const R shifted = x + rounding_magic<R>();
  const R f = x - (shifted - rounding_magic<R>());
  const R y = constant<R>(1) + f * (constant<R>(0.69314718055994531) + constant<R>(0.24022650695910071) * f);
  return from_bits<R>(to_bits(y) + (to_bits(shifted) << kMantissaBits<R>));
}

PHYSIM_ISA_END
