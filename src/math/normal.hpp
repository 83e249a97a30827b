// The normal distribution: its cumulative function and the inverse of that, the same bits on every machine.
//
// Symbols: z a number of a normal distribution with mean 0 and deviation 1, p = Phi(z) the probability of less.
// Phi: rational approximations on |z| < 0.675, below sqrt(32) and above, exp(-z^2/2) taken out of the latter two with
//   z^2 in two parts, so that its digits survive. Worst relative error found (z in -37..8): 1.1e-15.
// Its inverse: rational approximations in q = p - 1/2 for |q| <= 0.425, beyond in sqrt(-log(p)). Worst relative error
//   found (p from 1e-300 to 1 - 1e-16): 1.2e-15. tests/math/normal_test.cpp asserts these, rounded up a little.
// Source: W. J. Cody, "Rational Chebyshev Approximations for the Error Function", Math. Comp. 23 (1969) 631, as
//   algorithm 715 has them for the normal distribution (ACM TOMS 19 (1993) 22); M. J. Wichura, "Algorithm AS 241: The
//   Percentage Points of the Normal Distribution", Appl. Statist. 37 (1988) 477, PPND16.
#pragma once

#include <cmath>

#include "math/normal_quantile.hpp"

namespace physim {
namespace normal_detail {

inline constexpr double kCentre[] = {18154.981253343561249, 1067.6894854603709582, 161.02823106855587881,
                                     2.2352520354606839287, 0.065682337918207449113};
inline constexpr double kCentreUnder[] = {45507.789335026729956, 10260.932208618978205, 976.09855173777669322,
                                          47.20258190468824187, 1.0};
inline constexpr double kSide[] = {9842.7148383839780218, 11602.651437647350124,  6848.1904505362823326,
                                   2494.5375852903726711, 597.27027639480026226,  93.506656132177855979,
                                   8.8831497943883759412, 0.39894151208813466764, 1.0765576773720192317e-8};
inline constexpr double kSideUnder[] = {19685.429676859990727, 38912.003286093271411, 34900.952721145977266,
                                        18615.571640885098091, 6485.558298266760755,  1519.377599407554805,
                                        235.38790178262499861, 22.266688044328115691, 1.0};
inline constexpr double kTail[] = {2.9112874951168792e-5, 0.001421619193227893466, 0.022235277870649807,
                                   0.1274011611602473639, 0.21589853405795699,     0.02307344176494017303};
inline constexpr double kTailUnder[] = {7.29751555083966205e-5, 0.00378239633202758244, 0.0659881378689285515,
                                        0.468238212480865118,   1.28426009614491121,    1.0};

/// exp(-z^2 / 2) with the digits of z^2: z in sixteenths, and the rest.
inline double bell(double z) {
  const double coarse = std::trunc(z * 16) / 16;
  return exp(-coarse * coarse * 0.5) * exp(-(z - coarse) * (z + coarse) * 0.5);
}

/// The probability of more than z > 0.67.
inline double upper_tail(double z) {
  if (z <= 5.656854249492380195) return bell(z) * horner(z, kSide) / horner(z, kSideUnder);
  const double per_square = 1 / (z * z);
  const double less = per_square * horner(per_square, kTail) / horner(per_square, kTailUnder);
  return z > 39 ? 0 : bell(z) * (0.39894228040143267794 - less) / z;
}

}  // namespace normal_detail

/// Phi(z): the probability of a normal number below z [-]; of NaN a NaN.
inline double normal_cdf(double z) {
  using namespace normal_detail;
  if (std::abs(z) <= 0.67448975) return 0.5 + z * horner(z * z, kCentre) / horner(z * z, kCentreUnder);
  if (z < 0) return upper_tail(-z);
  return z > 0 ? 1 - upper_tail(z) : z;
}

}  // namespace physim
