// Density and 1 / sound speed in the lowest layer of the air as polynomials in height, straight from their laws.
//
// What it models: a power of the temperature, as both are there, by its power series about the middle of the layer.
// When to use it: for air through a station (model/station.hpp), where each shot of a batch may have its own: a few
//   operations for each coefficient. The standard's own air is fitted once for all (math/chebyshev.hpp).
// When it is wrong: never by much. Largest relative error in the layer, of density and of 1 / sound speed: 1e-16 and
//   7e-16 where it is as warm as in the standard, 7e-15 and 1e-13 where it is 60 K colder, 9e-14 and 2e-12 at 88 K
//   (with rounding, some 1e-15 more). tests/model/low_air_test.cpp holds it to the laws.
// Symbols: Z geometric altitude, Z_m that of the layer's middle, s half the layer's depth [m]; u = (Z - Z_m) / s;
//   T temperature, T_m in the middle, T_0 at sea level [K]; L lapse rate [K/m]; r0 as in model/air.hpp; nu the power
//   [-].
// Equations: T / T_m = (1 - a u) / (1 + b u), b = s / (r0 + Z_m), a = -b (T_0 + L r0) / T_m. So y = (T / T_m)^nu has
//   (1 - a u) (1 + b u) y' = -nu (a + b) y, and its coefficients
//   (k + 1) c_k+1 = ((a - b) k - nu (a + b)) c_k + a b (k - 1) c_k-1, c_0 = 1.
//   Of more coefficients than wanted the last is taken away with c_k T_k(u) / 2^(k-1), T_k Chebyshev's polynomial,
//   which changes y by no more than c_k / 2^(k-1).
// Source: the equation of y from model/air.hpp's laws; C. Lanczos, Applied Analysis (1956), chap. VII (telescoping of
//   power series).
#pragma once

#include <array>

#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// Row k: coefficients of u^j in T_k(u) / 2^(k-1), of which that of u^k is 1: the next is u times it less a quarter of
/// the one before.
template <int kRows>
constexpr std::array<std::array<double, kRows>, kRows> monic_chebyshev() {
  std::array<std::array<double, kRows>, kRows> t{};
  t[0][0] = t[1][1] = t[2][2] = 1;
  t[2][0] = -0.5;
  for (std::size_t k = 3; k < kRows; ++k)
    for (std::size_t j = 0; j <= k; ++j) t[k][j] = (j > 0 ? t[k - 1][j - 1] : 0) - 0.25 * t[k - 2][j];
  return t;
}

/// How T / T_m changes with u.
template <class R>
struct LowLayer {
  R a, b;
};

/// `scale` times (T / T_m)^nu: a series of kTerms, drawn together to N.
template <int kTerms, class R, int N>
PHYSIM_INLINE void put_power_of(const LowLayer<R>& layer, const R& nu, const R& scale, R (&out)[N]) {
  static_assert(kTerms >= N && N > 2);
  constexpr auto kMonic = monic_chebyshev<kTerms>();
  const R rise = layer.a - layer.b, product = layer.a * layer.b, start = nu * (layer.a + layer.b);
  R c[kTerms];
  c[0] = scale;
  c[1] = -start * scale;
  for (int k = 1; k + 1 < kTerms; ++k)
    c[k + 1] = ((rise * R(double(k)) - start) * c[k] + product * R(double(k - 1)) * c[k - 1]) * R(1.0 / (k + 1));
  for (int k = kTerms - 1; k >= N; --k)
    for (int j = k - 2; j >= 0; j -= 2)
      c[j] -= c[k] * R(kMonic[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)]);
  for (int j = 0; j < N; ++j) out[j] = c[j];
}

template <int kTerms, class R, int N>
PHYSIM_INLINE void put_power(const LowLayer<R>& layer, const R& nu, const R& scale, R (&out)[N]) {
  put_power_of<kTerms>(layer, nu, scale, out);
}
/// A register at a time: a series of several does not fit the processor.
template <int kTerms, int kLanes, int N>
PHYSIM_INLINE void put_power(const LowLayer<Pack<double, kLanes>>& layer, const Pack<double, kLanes>& nu,
                             const Pack<double, kLanes>& scale, Pack<double, kLanes> (&out)[N]) {
  using All = Pack<double, kLanes>;
  using One = Pack<double, All::kPerRegister>;
  for (int i = 0; i < All::kRegisters; ++i) {
    const auto part = [i](const All& all) PHYSIM_INLINE_LAMBDA {
      One one;
      one.r[0] = all.r[i];
      return one;
    };
    One of[N];
    put_power_of<kTerms>(LowLayer<One>{part(layer.a), part(layer.b)}, part(nu), part(scale), of);
    for (int j = 0; j < N; ++j) out[j].r[i] = of[j].r[0];
  }
}

PHYSIM_ISA_END
