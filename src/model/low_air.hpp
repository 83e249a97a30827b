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

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

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

/// `scale` times (T / T_m)^nu, on demand: a series of kSeries terms, drawn together to N coefficients.
template <int kSeries, class R, int N>
struct Power {
  static constexpr int kTerms = kSeries;
  static_assert(kTerms >= N && N > 2);
  const R& nu;
  const R& scale;
  R (&out)[N];
};
template <int kTerms, class R, int N>
PHYSIM_INLINE Power<kTerms, R, N> power(const R& nu, const R& scale, R (&out)[N]) {
  return {nu, scale, out};
}

template <int kTerms, class R>
struct PowerSeries {
  R start;  // nu (a + b)
  R c[kTerms];

  PHYSIM_INLINE PowerSeries(const LowLayer<R>& layer, const R& nu, const R& scale) : start(nu * (layer.a + layer.b)) {
    c[0] = scale;
    c[1] = -start * scale;
  }
  /// The coefficient of u^(k+1), if there is one; `rise` is a - b, `product` a b.
  template <int k>
  PHYSIM_INLINE void go_on(const R& rise, const R& product) {
    if constexpr (k + 1 < kTerms)
      c[k + 1] = ((rise * R(double(k)) - start) * c[k] + product * R(double(k - 1)) * c[k - 1]) * R(1.0 / (k + 1));
  }
  PHYSIM_INLINE void draw_together(int n) {
    constexpr auto kMonic = monic_chebyshev<kTerms>();
    for (int k = kTerms - 1; k >= n; --k)
      for (int j = k - 2; j >= 0; j -= 2)
        c[j] -= c[k] * R(kMonic[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)]);
  }
};

/// Numbers by their registers: series of several registers do not fit the processor.
template <class R>
struct RegisterOf {
  using One = R;
  static constexpr int kCount = 1;
  PHYSIM_INLINE static const R& get(const R& x, int) { return x; }
  PHYSIM_INLINE static void put(const R& one, int, R& x) { x = one; }
};
template <int kMany>
struct RegisterOf<Pack<double, kMany>> {
  using All = Pack<double, kMany>;
  using One = Pack<double, All::kPerRegister>;
  static constexpr int kCount = All::kRegisters;
  PHYSIM_INLINE static One get(const All& x, int i) {
    One one;
    one.r[0] = x.r[i];
    return one;
  }
  PHYSIM_INLINE static void put(const One& one, int i, All& x) { x.r[i] = one.r[0]; }
};

/// Powers in one layer, side by side, since each coefficient waits for the one before.
template <class R, class... Asked>
PHYSIM_INLINE void put_powers(const LowLayer<R>& layer, const Asked&... asked) {
  using Register = RegisterOf<R>;
  using One = typename Register::One;
  constexpr int kLongest = std::max({Asked::kTerms...});
  for (int i = 0; i < Register::kCount; ++i) {
    const LowLayer<One> one{Register::get(layer.a, i), Register::get(layer.b, i)};
    const One rise = one.a - one.b, product = one.a * one.b;
    const auto put = [&](const auto& series, auto& out) PHYSIM_INLINE_LAMBDA {
      for (std::size_t j = 0; j < std::size(out); ++j) Register::put(series.c[j], i, out[j]);
    };
    const auto fill = [&](auto... series) PHYSIM_INLINE_LAMBDA {
      [&]<int... before>(std::integer_sequence<int, before...>) PHYSIM_INLINE_LAMBDA {
        const auto next = [&]<int k>(std::integral_constant<int, k>)
                              PHYSIM_INLINE_LAMBDA { (series.template go_on<k>(rise, product), ...); };
        (next(std::integral_constant<int, before + 1>{}), ...);
      }
      (std::make_integer_sequence<int, kLongest - 2>{});
      (series.draw_together(static_cast<int>(std::size(asked.out))), ...);
      (put(series, asked.out), ...);
    };
    fill(PowerSeries<Asked::kTerms, One>(one, Register::get(asked.nu, i), Register::get(asked.scale, i))...);
  }
}

PHYSIM_ISA_END
