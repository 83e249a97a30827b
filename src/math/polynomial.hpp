// Polynomials by Estrin's scheme: c0 + c1 x + (c2 + c3 x) x^2 + (c4 + c5 x + (c6 + c7 x) x^2) x^4 ...
//
// Horner's scheme waits for each step before the next; Estrin's halves can be computed side by side. The order of the
// operations depends on the number of coefficients alone, so every machine gets the same bits.
#pragma once

#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// The smallest j with 2^(j+1) >= n: where a polynomial of n coefficients is cut is at 2^j of them.
constexpr int estrin_level(int n) { return n <= 2 ? 0 : 1 + estrin_level((n + 1) / 2); }

/// The part with the coefficients [kFrom, kFrom + kCount), divided by x^kFrom. `powers` holds x, x^2, x^4, x^8, ...
template <int kFrom, int kCount, class R, class C, int N>
PHYSIM_INLINE R polynomial_part(const R* powers, const C (&c)[N]) {
  if constexpr (kCount == 1 && std::is_same_v<C, R>) {
    return c[kFrom];
  } else if constexpr (kCount == 1) {
    return R(static_cast<ScalarOf<R>>(c[kFrom]));
  } else {
    constexpr int kLevel = estrin_level(kCount);
    constexpr int kHalf = 1 << kLevel;
    const R low = polynomial_part<kFrom, kHalf, R>(powers, c);
    const R high = polynomial_part<kFrom + kHalf, kCount - kHalf, R>(powers, c);
    return low + high * powers[kLevel];
  }
}

/// c[0] + c[1] x + ... + c[kTerms-1] x^(kTerms-1); all of c by default. Lanes may have their own.
template <int kTermsGiven = 0, class R, class C, int N>
PHYSIM_INLINE R polynomial(const R& x, const C (&c)[N]) {
  constexpr int kTerms = kTermsGiven == 0 ? N : kTermsGiven;
  static_assert(kTerms <= 32 && kTerms <= N);
  R powers[5];
  powers[0] = x;
  if constexpr (kTerms > 2) powers[1] = x * x;
  if constexpr (kTerms > 4) powers[2] = powers[1] * powers[1];
  if constexpr (kTerms > 8) powers[3] = powers[2] * powers[2];
  if constexpr (kTerms > 16) powers[4] = powers[3] * powers[3];
  return polynomial_part<0, kTerms, R>(powers, c);
}

PHYSIM_ISA_END
