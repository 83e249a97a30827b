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

#include <algorithm>
#include <cmath>
#include <span>

#include "base/assert.hpp"
#include "math/elementary.hpp"

namespace physim {
namespace normal_detail {

inline constexpr double kMiddle[] = {3.3871328727963666080e0,  1.3314166789178437745e+2, 1.9715909503065514427e+3,
                                     1.3731693765509461125e+4, 4.5921953931549871457e+4, 6.7265770927008700853e+4,
                                     3.3430575583588128105e+4, 2.5090809287301226727e+3};
inline constexpr double kMiddleUnder[] = {1.0,
                                          4.2313330701600911252e+1,
                                          6.8718700749205790830e+2,
                                          5.3941960214247511077e+3,
                                          2.1213794301586595867e+4,
                                          3.9307895800092710610e+4,
                                          2.8729085735721942674e+4,
                                          5.2264952788528545610e+3};
inline constexpr double kNear[] = {1.42343711074968357734e0,  4.63033784615654529590e0, 5.76949722146069140550e0,
                                   3.64784832476320460504e0,  1.27045825245236838258e0, 2.41780725177450611770e-1,
                                   2.27238449892691845833e-2, 7.74545014278341407640e-4};
inline constexpr double kNearUnder[] = {1.0,
                                        2.05319162663775882187e0,
                                        1.67638483018380384940e0,
                                        6.89767334985100004550e-1,
                                        1.48103976427480074590e-1,
                                        1.51986665636164571966e-2,
                                        5.47593808499534494600e-4,
                                        1.05075007164441684324e-9};
inline constexpr double kFar[] = {6.65790464350110377720e0,  5.46378491116411436990e0,  1.78482653991729133580e0,
                                  2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                  2.71155556874348757815e-5, 2.01033439929228813265e-7};
inline constexpr double kFarUnder[] = {1.0,
                                       5.99832206555887937690e-1,
                                       1.36929880922735805310e-1,
                                       1.48753612908506148525e-2,
                                       7.86869131145613259100e-4,
                                       1.84631831751005468180e-5,
                                       1.42151175831644588870e-7,
                                       2.04426310338993978564e-15};

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

template <int N>
PHYSIM_INLINE double horner(double x, const double (&c)[N]) {
  double sum = c[N - 1];
  for (int i = N - 2; i >= 0; --i) sum = sum * x + c[i];
  return sum;
}

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

/// z of a probability 0 < p < 1 given by `tail`, the smaller of p and 1 - p, below 0.075; without its sign.
inline double normal_quantile_of_tail(double tail) {
  using namespace normal_detail;
  PHYSIM_ASSERT(tail > 0 && tail <= 0.5);
  const double r = std::sqrt(-log(tail));
  return r <= 5 ? horner(r - 1.6, kNear) / horner(r - 1.6, kNearUnder) : horner(r - 5, kFar) / horner(r - 5, kFarUnder);
}

/// The middle of the inverse, where |q| <= 0.425; elsewhere a number that means nothing.
PHYSIM_INLINE double normal_quantile_of_middle(double q) {
  const double r = 0.180625 - q * q;
  return q * normal_detail::horner(r, normal_detail::kMiddle) / normal_detail::horner(r, normal_detail::kMiddleUnder);
}

/// z with Phi(z) = p, 0 < p < 1 [-].
inline double normal_quantile(double p) {
  PHYSIM_ASSERT(p > 0 && p < 1);
  const double q = p - 0.5;
  if (std::abs(q) <= 0.425) return normal_quantile_of_middle(q);
  const double z = normal_quantile_of_tail(q < 0 ? p : 1 - p);
  return q < 0 ? -z : z;
}

/// Puts z into the place of each p: the bits of normal_quantile(), with the middle computed for several at a time.
inline void normal_quantiles(std::span<double> numbers) {
  constexpr std::size_t kBlock = 64;
  double p[kBlock];
  for (std::size_t start = 0; start < numbers.size(); start += kBlock) {
    const std::span<double> some = numbers.subspan(start, std::min(kBlock, numbers.size() - start));
    std::copy(some.begin(), some.end(), p);
    for (double& z : some) z = normal_quantile_of_middle(z - 0.5);
    for (std::size_t i = 0; i < some.size(); ++i)
      if (std::abs(p[i] - 0.5) > 0.425) some[i] = normal_quantile(p[i]);
  }
}

}  // namespace physim
