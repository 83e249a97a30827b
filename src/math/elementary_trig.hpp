// sin, cos, tan, asin, acos, atan and atan2 for float, double and packs of them. Errors and rules: see elementary.hpp.
#pragma once

#include "math/elementary_exp_log.hpp"

PHYSIM_ISA_BEGIN

// -------------------------------------------------------------------------------------------------- sin, cos, tan
// sin r = r - r z S(z) and cos r = 1 - z/2 + z^2 C(z), z = r^2, on |r| <= pi/4. S and C minimise the largest relative
// error (Sollya's fpminimax on the Taylor series in exact fractions): S 2^-52.7 and 2^-22.7, C 2^-54 and 2^-24.
inline constexpr double kSinDouble[] = {0.16666666666666666,     -0.008333333333331293, 0.00019841269837059247,
                                        -2.7557316210349706e-06, 2.505114883520916e-08, -1.5919106452814597e-10};
inline constexpr double kSinFloat[] = {0.166666642, -0.00833271537, 0.000195834931};
inline constexpr double kCosDouble[] = {0.041666666666666664,   -0.0013888888888887055, 2.4801587298450413e-05,
                                        -2.755731715355149e-07, 2.0876126924260117e-09, -1.1381482491915975e-11};
inline constexpr double kCosFloat[] = {0.0416666642, -0.00138882711, 2.45437113e-05};

// pi/2 as a sum (Cody and Waite 1980). n times each part but the last is exact up to n = 2^19 in double, 2^13 in float;
// no part is negative, so that the sign of a zero survives.
inline constexpr double kHalfPiDouble[] = {1.5707963267341256, 6.07710049817245e-11, 8.333742889482319e-20,
                                           2.9038559739793605e-28};
inline constexpr double kHalfPiFloat[] = {1.5703125, 0.00048351287841796875, 3.1385570764541626e-07,
                                          6.070877134334296e-11, 6.223371969669989e-14};

template <class R>
struct SinCos {
  R sin;
  R cos;
};

/// x = n pi/2 + r.hi - r.lo with |r.hi| <= pi/4 (a little more in float, where n may be off by a rounding).
template <class R>
struct QuarterTurns {
  BitsOf<R> n_bits;
  HiLo<R> r;
};
template <class R, int N>
PHYSIM_INLINE QuarterTurns<R> reduce_angle(const R& x, const double (&half_pi)[N]) {
  const R shifted = x * constant<R>(0.6366197723675814) + rounding_magic<R>();
  const R n = shifted - rounding_magic<R>();
  R hi = x - n * constant<R>(half_pi[0]);
  R lo = constant<R>(0);
  for (int i = 1; i < N; ++i) {
    const R part = n * constant<R>(half_pi[i]);
    const R next = hi - part;
    lo = lo + (part - (hi - next));
    hi = next;
  }
  // Far out of range n is not exact any more: keep the angle where the polynomials make sense.
  const R limit = constant<R>(0.8), lo_limit = constant<R>(1e-15, 5e-7);
  return {to_bits(shifted), {clamp_keeping_nan(hi, -limit, limit), clamp(lo, -lo_limit, lo_limit)}};
}

/// Sine and cosine together.
template <class R>
PHYSIM_INLINE SinCos<R> sincos(const R& x) {
  const R one = R(ScalarOf<R>(1));
  QuarterTurns<R> turns;
  if constexpr (kIsDouble<R>) {
    turns = reduce_angle(x, kHalfPiDouble);
  } else {
    turns = reduce_angle(x, kHalfPiFloat);
  }
  const R r = turns.r.hi, dr = turns.r.lo;
  const R z = r * r;
  const R s = polynomial(z, kSinDouble, kSinFloat);
  const R c = polynomial(z, kCosDouble, kCosFloat);
  const R half_z = constant<R>(0.5) * z;
  const R sin_r = r - (r * z * s + (dr - dr * half_z));
  const HiLo<R> one_minus = fast_two_sum(one, -half_z);
  const R cos_r = one_minus.hi + (one_minus.lo + (z * z * c + r * dr));
  // Odd quarter turns exchange sine and cosine; bit 1 of n (of n + 1 for the cosine) is the sign.
  constexpr int kTop = 8 * sizeof(ScalarOf<R>) - 1;
  const BitsOf<R> n = turns.n_bits, bit_0 = bits_constant<R>(1, 1), bit_1 = bits_constant<R>(2, 2);
  const MaskOf<R> odd = from_bits<R>((n & bit_0) << (kTop - 1)) != constant<R>(0);  // the bits of 2.0 or of 0.0
  const R sin_x = select(odd, cos_r, sin_r);
  const R cos_x = select(odd, sin_r, cos_r);
  return {from_bits<R>(to_bits(sin_x) ^ ((n & bit_1) << (kTop - 1))),
          from_bits<R>(to_bits(cos_x) ^ (((n + bit_0) & bit_1) << (kTop - 1)))};
}
PHYSIM_INLINE auto sin(const auto& x) { return sincos(x).sin; }
PHYSIM_INLINE auto cos(const auto& x) { return sincos(x).cos; }
template <class R>
PHYSIM_INLINE R tan(const R& x) {
  const SinCos<R> sc = sincos(x);
  return sc.sin / sc.cos;
}

// ----------------------------------------------------------------------------------------------------- asin, acos
// asin s = s + s z P(z), z = s^2, on s <= 1/2. Above: asin x = pi/2 - 2 asin(sqrt((1 - x) / 2)).
// P by fpminimax as above: relative error 2^-53 in double, 2^-24 in float.
inline constexpr double kAsinDouble[] = {
    0.16666666666666669,  0.0749999999999808,    0.04464285714685996,  0.030381944106161178, 0.02237217407864782,
    0.017352368457446345, 0.01397154725294532,   0.011476111080393217, 0.01034172298405099,  0.005380070769908013,
    0.01760279080505581,  -0.015155240082311219, 0.028957712174443616};
inline constexpr double kAsinFloat[] = {0.166666657,  0.075001508,  0.044586271,
                                        0.0312244613, 0.0166421179, 0.0344425924};

// pi/4 = hi + lo; hi times 2, 3 and 4 is exact.
template <class R>
PHYSIM_INLINE R quarter_pi_hi() {
  return constant<R>(0.7853981633974483, 0.7853982448577881);
}
template <class R>
PHYSIM_INLINE R quarter_pi_lo() {
  return constant<R>(3.061616997868383e-17, -8.146034247147327e-08);
}
/// eighths pi/4 + a + b, for b << a <= eighths pi/4 or eighths == 0.
template <class R>
PHYSIM_INLINE R angle_sum(const R& eighths, const R& a, const R& b) {
  const HiLo<R> sum = fast_two_sum(eighths * quarter_pi_hi<R>(), a);
  return sum.hi + (sum.lo + (eighths * quarter_pi_lo<R>() + b));
}

/// |x| on the half where the series converges fast: s, and s z P(z).
template <class R>
struct AsinParts {
  MaskOf<R> above;  ///< |x| > 1/2: asin |x| = pi/2 - 2 (s + tail)
  R s;
  R tail;
};
template <class R>
PHYSIM_INLINE AsinParts<R> asin_parts(const R& x) {
  const R half = constant<R>(0.5), one = constant<R>(1);
  const R magnitude = abs(x);
  const MaskOf<R> above = magnitude > half;
  const R z = select(above, (one - magnitude) * half, magnitude * magnitude);
  const R s = select(above, sqrt(z), magnitude);
  return {above, s, s * (z * polynomial(z, kAsinDouble, kAsinFloat))};
}
/// Arc sine; NaN for |x| > 1.
template <class R>
PHYSIM_INLINE R asin(const R& x) {
  const R zero = constant<R>(0), two = constant<R>(2);
  const AsinParts<R> a = asin_parts(x);
  const R factor = select(a.above, -two, constant<R>(1));
  return copysign(angle_sum(select(a.above, two, zero), factor * a.s, factor * a.tail), x);
}
/// Arc cosine; NaN for |x| > 1.
template <class R>
PHYSIM_INLINE R acos(const R& x) {
  const R zero = constant<R>(0), one = constant<R>(1), two = constant<R>(2);
  const AsinParts<R> a = asin_parts(x);
  const MaskOf<R> negative = x < zero;
  const R eighths = select(a.above, select(negative, constant<R>(4), zero), two);
  const R toward = select(negative, -one, one);
  const R factor = select(a.above, two * toward, -toward);
  return angle_sum(eighths, factor * a.s, factor * a.tail);
}

// ---------------------------------------------------------------------------------------------------- atan, atan2
// atan q = q + q z P(z), z = q^2, on |q| <= 1/2. P by fpminimax as above: relative error 2^-52 and 2^-25.
inline constexpr double kAtanDouble[] = {-0.33333333333333326, 0.1999999999999171,   -0.14285714284130682,
                                         0.11111110991832114,  -0.09090904427278915, 0.07692199545200196,
                                         -0.06665065809495971, 0.05866594634649277,  -0.0515798962897406,
                                         0.04284996883951026,  -0.02897748998048892, 0.01117038095858062};
inline constexpr double kAtanFloat[] = {-0.333333343, 0.199999884,  -0.142823234,
                                        0.110298678,  -0.083272323, 0.0435885191};

/// The angle of (x, y) from the x axis, in [-pi, pi], with the sign of y, also for zeros and infinities.
template <class R>
PHYSIM_INLINE R atan2(const R& y, const R& x) {
  const R zero = constant<R>(0), one = constant<R>(1), half = constant<R>(0.5);
  const R a = abs(y), b = abs(x);
  const MaskOf<R> steep = a > b;
  R low = select(steep, b, a), high = select(steep, a, b);
  // Two infinite components count as 45 degrees, two zero ones as 0; huge ones are halved, so that low + high stays
  // finite.
  const MaskOf<R> infinite = high == infinity<R>();
  low = select(infinite, select(low == infinity<R>(), one, low * zero), low);
  high = select(infinite | (high == zero), one, high);
  const R scale = select(high > constant<R>(1e300, 1e30), half, one);
  low = low * scale;
  high = high * scale;
  // First eighth of a turn. Above 1/2: atan(low/high) = pi/4 - atan((high - low) / (high + low)); high - low is exact.
  const MaskOf<R> above = low + low > high;
  const R q = select(above, low - high, low) / select(above, low + high, high);
  const R z = q * q;
  const R p = polynomial(z, kAtanDouble, kAtanFloat);
  // The other eighths: 90 degrees minus the angle if steep, 180 degrees minus the angle if x < 0.
  const MaskOf<R> backward = copysign(one, x) < zero;
  R eighths = select(above, one, zero);
  R sign = select(steep, -one, one);
  eighths = select(steep, constant<R>(2) - eighths, eighths);
  eighths = select(backward, constant<R>(4) - eighths, eighths);
  sign = select(backward, -sign, sign);
  return copysign(angle_sum(eighths, sign * q, sign * (q * (z * p))), y);
}
/// Arc tangent.
template <class R>
PHYSIM_INLINE R atan(const R& x) {
  return atan2(x, R(ScalarOf<R>(1)));
}

PHYSIM_ISA_END
