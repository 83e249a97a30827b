// The inverse of the normal distribution's cumulative function, for one number or a pack of them: see math/normal.hpp.
//
// Symbols, errors and Source: as there.
#pragma once

#include "math/elementary.hpp"

PHYSIM_ISA_BEGIN

namespace quantile_detail {
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

}  // namespace quantile_detail

/// By Horner's scheme: Source gives errors of these polynomials with it.
template <class R, int N>
PHYSIM_INLINE R horner(const R& x, const double (&c)[N]) {
  R sum(c[N - 1]);
  for (int i = N - 2; i >= 0; --i) sum = sum * x + R(c[i]);
  return sum;
}
inline constexpr double kTailFromMiddle = 0.425;
/// Whether p lies where the middle's approximation does not hold.
template <class R>
PHYSIM_INLINE MaskOf<R> is_in_tail(const R& p) {
  return abs(p - R(0.5)) > R(kTailFromMiddle);
}
/// z in the middle; elsewhere a number that means nothing.
template <class R>
PHYSIM_INLINE R normal_quantile_of_middle(const R& p) {
  using namespace quantile_detail;
  const R q = p - R(0.5), r = R(0.180625) - q * q;
  return q * horner(r, kMiddle) / horner(r, kMiddleUnder);
}
/// z in the tails; elsewhere a number that means nothing.
template <class R>
PHYSIM_INLINE R normal_quantile_of_tail(const R& p) {
  using namespace quantile_detail;
  const auto is_low = p - R(0.5) < R(0.0);
  const R r = sqrt(-log(select(is_low, p, R(1.0) - p)));
  const auto is_far = r > R(5.0);
  R z = horner(r - R(1.6), kNear) / horner(r - R(1.6), kNearUnder);
  if (any(is_far)) z = select(is_far, horner(r - R(5.0), kFar) / horner(r - R(5.0), kFarUnder), z);
  return select(is_low, -z, z);
}

/// z with Phi(z) = p, 0 < p < 1 [-].
template <class R>
PHYSIM_INLINE R normal_quantile(const R& p) {
  PHYSIM_ASSERT(all((p > R(0.0)) & (p < R(1.0))));
  const auto is_tail = is_in_tail(p);
  const R middle = normal_quantile_of_middle(p);
  return any(is_tail) ? select(is_tail, normal_quantile_of_tail(p), middle) : middle;
}

PHYSIM_ISA_END
