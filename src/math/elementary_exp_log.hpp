// exp, expm1, log, log1p and pow for float, double and packs of them. Errors and rules: see elementary.hpp.
#pragma once

#include <limits>

#include "math/pack.hpp"
#include "math/polynomial.hpp"

PHYSIM_ISA_BEGIN

// --------------------------------------------------------------------------------------------------- common parts
template <class R>
inline constexpr bool kIsDouble = sizeof(ScalarOf<R>) == 8;
template <class R>
inline constexpr int kMantissaBits = kIsDouble<R> ? 52 : 23;
template <class R>
inline constexpr int kExponentBias = kIsDouble<R> ? 1023 : 127;

/// A constant that differs between double and float.
template <class R>
PHYSIM_INLINE R constant(double for_double, double for_float) {
  return constant<R>(kIsDouble<R> ? for_double : for_float);
}
/// A polynomial with coefficients that differ between double and float.
template <class R, int N, int M>
PHYSIM_INLINE R polynomial(const R& x, const double (&for_double)[N], const double (&for_float)[M]) {
  if constexpr (kIsDouble<R>)
    return polynomial(x, for_double);
  else
    return polynomial(x, for_float);
}
/// Equal bits in every lane.
template <class R>
PHYSIM_INLINE BitsOf<R> bits_constant(std::uint64_t for_double, std::uint32_t for_float) {
  return BitsOf<R>(static_cast<BitsOf<ScalarOf<R>>>(kIsDouble<R> ? for_double : for_float));
}
template <class R>
PHYSIM_INLINE R infinity() {
  return R(std::numeric_limits<ScalarOf<R>>::infinity());
}
template <class R>
PHYSIM_INLINE R not_a_number() {
  return R(std::numeric_limits<ScalarOf<R>>::quiet_NaN());
}
/// As clamp, but NaN stays NaN.
template <class R>
PHYSIM_INLINE R clamp_keeping_nan(const R& x, const R& low, const R& high) {
  return min(high, max(low, x));
}

/// A number as the unevaluated sum of two: lo is at most half a unit in the last place of hi.
template <class R>
struct HiLo {
  R hi;
  R lo;
};
/// a + b exactly, if |a| >= |b| or a == 0 (Dekker 1971).
template <class R>
PHYSIM_INLINE HiLo<R> fast_two_sum(const R& a, const R& b) {
  const R sum = a + b;
  return {sum, b - (sum - a)};
}
/// a + b exactly (Knuth).
template <class R>
PHYSIM_INLINE HiLo<R> two_sum(const R& a, const R& b) {
  const R sum = a + b;
  const R b_seen = sum - a;
  return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}
/// The upper half of the digits of x, so that products of two such halves are exact.
template <class R>
PHYSIM_INLINE R upper_half(const R& x) {
  return from_bits<R>(to_bits(x) & bits_constant<R>(0xfffffffff8000000u, 0xfffff000u));
}
/// a * b to twice the digits (Dekker 1971, cutting the factors in halves by their bits).
template <class R>
PHYSIM_INLINE HiLo<R> two_product(const R& a, const R& b) {
  const R a_hi = upper_half(a), a_lo = a - a_hi;
  const R b_hi = upper_half(b), b_lo = b - b_hi;
  const R product = a * b;
  return {product, ((a_hi * b_hi - product) + (a_hi * b_lo + a_lo * b_hi)) + a_lo * b_lo};
}

// ln 2 = hi + lo, where hi has so few digits that n * hi is exact for every exponent n.
template <class R>
PHYSIM_INLINE R ln2_hi() {
  return constant<R>(0.6931471805598903, 0.693145751953125);
}
template <class R>
PHYSIM_INLINE R ln2_lo() {
  return constant<R>(5.497923018708371e-14, 1.428606765330187e-06);
}

// ------------------------------------------------------------------------------------------------------------ exp
// exp(r) = 1 + r + r^2 Q(r) on |r| <= ln(2)/2. Q minimises the largest relative error (Sollya's fpminimax, on the
// Taylor series in exact fractions): 2^-52.0 of Q in double, 2^-22.9 in float, so 2^-56 and 2^-27 of exp.
inline constexpr double kExpDouble[] = {0.5000000000000001,    0.16666666666666644,    0.04166666666662305,
                                        0.008333333333356332,  0.0013888888917575424,  0.00019841269784766718,
                                        2.480152084373104e-05, 2.7557354997489083e-06, 2.7620276052627005e-07,
                                        2.506847892822816e-08};
inline constexpr double kExpFloat[] = {0.5, 0.166665763, 0.0416667014, 0.00836326927, 0.00139115669};

/// x = n ln2 + hi - lo with |hi - lo| <= ln(2)/2 and hi exact.
template <class R>
struct ExpReduction {
  BitsOf<R> n_bits;  ///< the bits of rounding_magic + n
  R n;
  R hi;
  R lo;
};
template <class R>
PHYSIM_INLINE ExpReduction<R> reduce_exp(const R& x) {
  const R shifted = x * constant<R>(1.4426950408889634) + rounding_magic<R>();
  const R n = shifted - rounding_magic<R>();
  return {to_bits(shifted), n, x - n * ln2_hi<R>(), n * ln2_lo<R>()};
}
/// r^2 Q(r) = exp(r) - 1 - r.
template <class R>
PHYSIM_INLINE R exp_tail(const R& r) {
  return r * r * polynomial(r, kExpDouble, kExpFloat);
}
/// y 2^n in two steps, since 2^n itself may be too large or too small for a normal number.
template <class R>
PHYSIM_INLINE R scale_by_power_of_two(const R& y, const BitsOf<R>& n_bits) {
  using U = BitsOf<ScalarOf<R>>;
  const U to_biased = U(2 * kExponentBias<R>) - to_bits(rounding_magic<ScalarOf<R>>());
  const BitsOf<R> biased = n_bits + BitsOf<R>(to_biased);  // n + 2 bias, the sum of the two exponents
  const BitsOf<R> half = biased >> 1;
  const R factor_1 = from_bits<R>(half << kMantissaBits<R>);
  const R factor_2 = from_bits<R>((biased - half) << kMantissaBits<R>);
  return y * factor_1 * factor_2;
}

/// exp(x + dx) for |dx| << 1.
template <class R>
PHYSIM_INLINE R exp_of_sum(const R& x, const R& dx) {
  const R bounded = clamp_keeping_nan(x, constant<R>(-746, -104), constant<R>(710, 89));  // still 0 and infinity
  const ExpReduction<R> e = reduce_exp(bounded);
  const R lo = e.lo - dx;
  const HiLo<R> one_plus_hi = fast_two_sum(R(ScalarOf<R>(1)), e.hi);
  const R y = one_plus_hi.hi + (one_plus_hi.lo + (exp_tail(e.hi - lo) - lo));
  return scale_by_power_of_two(y, e.n_bits);
}

/// e^x. Results below the smallest normal number are rounded twice.
template <class R>
PHYSIM_INLINE R exp(const R& x) {
  return exp_of_sum(x, R(ScalarOf<R>(0)));
}

/// e^x for |x| < 700 to about two units in the last place, without the care that exp() takes at the ends of the number
/// range; beyond, |x| counts as 700 (float: 80). For kernels with arguments that physics bounds.
template <class R>
PHYSIM_INLINE R exp_bounded(const R& x) {
  const R limit = constant<R>(700, 80);
  const ExpReduction<R> e = reduce_exp(min(max(x, -limit), limit));
  const R r = e.hi - e.lo;
  const R y = R(ScalarOf<R>(1)) + (r + exp_tail(r));
  return from_bits<R>(to_bits(y) + (e.n_bits << kMantissaBits<R>));
}

/// e^x - 1, accurate near zero.
template <class R>
PHYSIM_INLINE R expm1(const R& x) {
  const R one = R(ScalarOf<R>(1));
  const R bounded = clamp_keeping_nan(x, constant<R>(-40, -20), constant<R>(710, 89));
  const ExpReduction<R> e = reduce_exp(bounded);
  // 2^n (exp(r) - 1 + 1 - 2^-n). Beyond n = 64, 2^-n is lost in 1 anyway.
  const BitsOf<R> minus_n = to_bits(rounding_magic<R>() - min(e.n, constant<R>(64)));
  const HiLo<R> one_minus = two_sum(one, -scale_by_power_of_two(one, minus_n));
  const HiLo<R> sum = fast_two_sum(one_minus.hi, e.hi);
  const R y = sum.hi + (sum.lo + (exp_tail(e.hi - e.lo) - (e.lo - one_minus.lo)));
  return copysign(scale_by_power_of_two(y, e.n_bits), x);
}

// ------------------------------------------------------------------------------------------------------------ log
// With s = f / (2 + f): log(1 + f) = log((1 + s) / (1 - s)) = 2 s + s z P(z), z = s^2 <= 0.0295, P(0) = 2/3.
// P by fpminimax as above: relative error 2^-51.0 (double), 2^-21.7 (float), so 2^-57.6 and 2^-28 of the logarithm.
inline constexpr double kLogDouble[] = {0.666666666666667,   0.39999999999899855, 0.285714286259241,
                                        0.22222211136730977, 0.18182889203205188, 0.15331715212428512,
                                        0.1461655458629714};
inline constexpr double kLogFloat[] = {0.666666865, 0.399885684, 0.295858443};

/// x = 2^k m with sqrt(1/2) <= m < sqrt(2), for 0 < x < infinity.
template <class R>
struct ExponentMantissa {
  R k;
  R m;
};
/// Splits a normal x into exponent and mantissa; `bias` is that of the exponent field.
template <class R>
PHYSIM_INLINE ExponentMantissa<R> split_normal(const R& x, const R& bias) {
  constexpr int kBits = kMantissaBits<R>;
  const R power = constant<R>(4503599627370496.0, 8388608.0);  // 2^kBits: where the last digit of the mantissa is 1
  // Moving sqrt(1/2) to 1 makes the exponent field change at sqrt(2) 2^k.
  const BitsOf<R> sqrt_half = bits_constant<R>(0x3fe6a09e667f3bcdu, 0x3f3504f3u);
  const BitsOf<R> moved = to_bits(x) + (to_bits(constant<R>(1)) - sqrt_half);
  const BitsOf<R> mantissa_mask = bits_constant<R>(0x000fffffffffffffu, 0x007fffffu);
  return {from_bits<R>((moved >> kBits) | to_bits(power)) - (power + bias),
          from_bits<R>((moved & mantissa_mask) + sqrt_half)};
}
template <class R>
PHYSIM_INLINE ExponentMantissa<R> split_exponent(const R& x) {
  const MaskOf<R> subnormal = x < R(std::numeric_limits<ScalarOf<R>>::min());
  const R normal = select(subnormal, x * constant<R>(18014398509481984.0, 33554432.0), x);  // 2^54, 2^25
  return split_normal(normal, select(subnormal, constant<R>(1023 + 54, 127 + 25), constant<R>(1023, 127)));
}
/// k ln2 + log(1 + f) + c for |c| << 1.
template <class R>
PHYSIM_INLINE R log_of_parts(const R& k, const R& f, const R& c) {
  const R s = f / (constant<R>(2) + f);
  const R z = s * s;
  const R p = polynomial(z, kLogDouble, kLogFloat);
  const R half_square = constant<R>(0.5) * f * f;
  // 2 s = f - f^2/2 + s f^2/2 leaves the exact f as the first term.
  const R tail = s * (half_square + z * p) - half_square;
  const HiLo<R> sum = fast_two_sum(k * ln2_hi<R>(), f);
  return sum.hi + (sum.lo + (tail + (k * ln2_lo<R>() + c)));
}
/// The logarithm's value where y = log(x) is no use: x infinite, zero, negative or NaN.
template <class R>
PHYSIM_INLINE R log_special_cases(const R& x, const R& y) {
  const R zero = R(ScalarOf<R>(0));
  const R below = select(x < zero, not_a_number<R>(), -infinity<R>());
  return select(x <= zero, below, select(x < infinity<R>(), y, x));
}

/// Natural logarithm.
template <class R>
PHYSIM_INLINE R log(const R& x) {
  const ExponentMantissa<R> e = split_exponent(x);
  return log_special_cases(x, log_of_parts(e.k, e.m - constant<R>(1), constant<R>(0)));
}

/// log(1 + x) for -0.3 < x < 0.42, where no power of two need be split off; to about two units in the last place.
/// Outside, it stays finite for x > -2 and loses accuracy.
template <class R>
PHYSIM_INLINE R log1p_near_zero(const R& x) {
  const R s = x / (constant<R>(2) + x);
  const R z = s * s;
  const R half_square = constant<R>(0.5) * x * x;
  return x - (half_square - s * (half_square + z * polynomial(z, kLogDouble, kLogFloat)));
}

/// log(1 + x), accurate near zero.
template <class R>
PHYSIM_INLINE R log1p(const R& x) {
  const R zero = R(ScalarOf<R>(0)), one = R(ScalarOf<R>(1));
  const HiLo<R> u = two_sum(one, x);
  const ExponentMantissa<R> e = split_exponent(u.hi);
  const MaskOf<R> no_power = e.k == zero;  // here x itself is the exact f
  const R y = log_of_parts(e.k, select(no_power, x, e.m - one), select(no_power, zero, u.lo / u.hi));
  const R tiny = constant<R>(1e-300, 1e-30);
  return select(abs(x) < tiny, x, log_special_cases(u.hi, y));
}

// ------------------------------------------------------------------------------------------------------------ pow
// log needs 11 more digits than its result in double, 7 in float, because y log(x) may be that large. So the first two
// terms of the series are added up in double the digits: log m = 2 s + 2/3 s^3 + s^5 Q(s^2). Q by fpminimax as above.
inline constexpr double kPowLogDouble[] = {0.4,
                                           0.2857142857142631,
                                           0.22222222222778976,
                                           0.18181818153464532,
                                           0.15384610086652456,
                                           0.1333413148640673,
                                           0.11721494613409297,
                                           0.11584861788513337};
inline constexpr double kPowLogFloat[] = {0.400000155, 0.285621732, 0.23049973};

/// log(x) with twice the digits, for 0 < x < infinity.
template <class R>
PHYSIM_INLINE HiLo<R> log_in_two_parts(const R& x) {
  const R two = constant<R>(2);
  const ExponentMantissa<R> e = split_exponent(x);
  const R f = e.m - constant<R>(1);
  // s = f / (2 + f)
  const HiLo<R> d = fast_two_sum(two, f);
  const R inverse = constant<R>(1) / d.hi;
  const R s_hi = f * inverse;
  const HiLo<R> sd = two_product(s_hi, d.hi);
  const R s_lo = (((f - sd.hi) - sd.lo) - s_hi * d.lo) * inverse;
  // t = 2/3 + z Q(z)
  HiLo<R> z = two_product(s_hi, s_hi);
  z.lo = z.lo + two * s_hi * s_lo;
  const R q = polynomial(z.hi, kPowLogDouble, kPowLogFloat);
  HiLo<R> t = fast_two_sum(constant<R>(0.6666666666666666, 0.6666666865348816), z.hi * q);
  t.lo = t.lo + constant<R>(3.700743415417188e-17, -1.9868214925130207e-08);
  // v = s z t
  HiLo<R> zt = two_product(z.hi, t.hi);
  zt.lo = zt.lo + (z.hi * t.lo + z.lo * t.hi);
  HiLo<R> v = two_product(s_hi, zt.hi);
  v.lo = v.lo + (s_hi * zt.lo + s_lo * zt.hi);
  // k ln2 + 2 s + v
  const HiLo<R> sum_1 = fast_two_sum(e.k * ln2_hi<R>(), two * s_hi);
  const HiLo<R> sum_2 = fast_two_sum(sum_1.hi, v.hi);
  return fast_two_sum(sum_2.hi, sum_1.lo + sum_2.lo + (e.k * ln2_lo<R>() + two * s_lo + v.lo));
}
template <class R>
PHYSIM_INLINE MaskOf<R> is_integer(const R& x) {                 // x >= 0
  const R all_are = constant<R>(4503599627370496.0, 8388608.0);  // from here on; adding it rounds to integers
  return (x >= all_are) | ((x + all_are) - all_are == x);
}
/// `power` = |x|^y put right where x is zero, infinite, negative or NaN.
template <class R>
PHYSIM_INLINE R pow_special_cases(const R& x, const R& y, const R& power) {
  const R zero = R(ScalarOf<R>(0));
  const R magnitude = abs(x);
  const MaskOf<R> edge = (magnitude == zero) | (magnitude == infinity<R>());
  const R inverse = select(magnitude == zero, infinity<R>(), zero);
  R result = select(edge, select(y > zero, magnitude, inverse), power);
  const MaskOf<R> integer = is_integer(abs(y)), even = is_integer(constant<R>(0.5) * abs(y));
  result = select(integer & !even, copysign(result, x), result);
  result = select((x < zero) & !integer & !edge, not_a_number<R>(), result);
  return select(y == y, select(x == x, result, x), y);
}

/// x^y. A negative x needs an integer y, else the result is NaN. x^0 and 1^y are 1 for every x and y, as in C.
template <class R>
PHYSIM_INLINE R pow(const R& x, const R& y) {
  const R zero = R(ScalarOf<R>(0)), one = R(ScalarOf<R>(1));
  // No y beyond +-2^65 changes the result: y log(x) is far out of range already.
  const R limit = constant<R>(36893488147419103232.0, 1099511627776.0);
  const R bounded = clamp_keeping_nan(y, -limit, limit);
  const HiLo<R> log_x = log_in_two_parts(abs(x));
  const HiLo<R> product = two_product(bounded, log_x.hi);
  const R dx = select(abs(product.hi) < constant<R>(1000), product.lo + bounded * log_x.lo, zero);
  R result = exp_of_sum(product.hi, dx);  // |x|^y
  if (!all((x > zero) & (x < infinity<R>()))) result = pow_special_cases(x, y, result);
  return select((x == one) | (y == zero), one, result);
}

PHYSIM_ISA_END
