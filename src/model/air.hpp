// Density, temperature and sound speed of the air.
//
// What it models: `constant` air; `exponential` air; `isa`: the US Standard Atmosphere 1976, seven layers of constant
//   temperature gradient up to 86 km, shifted so that it goes through given station conditions (model/air.cpp).
// When to use it: constant for flat fire within a few hundred metres of height; exponential for games with aircraft and
//   mountains; isa for everything that should be right.
// When it is wrong: real days differ from the standard lapse rate; humidity is measured at the station and its effect
//   is kept at all heights (levels of a sounding have what they measured: model/air_levels.hpp); above 86 km the last
//   layer continues isothermally (density there is below 1e-5 of sea level's); below -5 km a flight ends with
//   Outcome::left_domain.
// Symbols: Z geometric altitude, H geopotential altitude, r0 = 6356766 m; T temperature [K]; L lapse rate [K/m];
//   rho density [kg/m^3]; a sound speed [m/s]; index b: at the base of the layer.
// Equations: H = r0 Z / (r0 + Z);  T = T_b + L (H - H_b);
//   L != 0: rho = rho_b (T / T_b)^-(1 + g0 M / (R* L));  L = 0: rho = rho_b exp(-g0 M (H - H_b) / (R* T_b));
//   a = a_b sqrt(T / T_b);  viscosity mu = 1.458e-6 T^1.5 / (T + 110.4).
//   Below 11 km, where most shots fly, density and 1/a are polynomials in Z for these laws, made when the conditions
//   are prepared, or in each lane that has its own air (the standard's are fitted to 1e-14; model/low_air.hpp says
//   how close those of stations are): a third of the work, and no waiting for logarithm, exponential and divisions.
//   Above, both laws are written as one, rho = rho_b exp(power ln(T/T_b) + decay (H - H_b)), so that lanes in different
//   layers run the same instructions.
// Source: U.S. Standard Atmosphere, 1976 (NOAA-S/T 76-1562), eq. 18, 23, 33a, 33b, 42, 50, 51.
#pragma once

#include <type_traits>

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "model/body.hpp"
#include "model/earth.hpp"

PHYSIM_ISA_BEGIN

template <class R>
struct AirState {
  R density;          // [kg/m^3]
  R per_sound_speed;  // 1 / a [s/m]
};

/// The last layer that begins below all lanes; 0: there is none, or there are too few layers to look for it.
template <class R, class S>
PHYSIM_INLINE int layer_below_all(int layers, const S* bases, const R& h) {
  constexpr int kFew = 16;
  int low = 0;
  for (int high = layers; layers > kFew && high - low > 1;) {
    const int middle = (low + high) / 2;
    (all(h >= R(bases[middle])) ? low : high) = middle;
  }
  PHYSIM_ASSERT(low == 0 || low < layers);
  return low;
}

/// Any of some layers, by its law. Behind a call, as most shots stay below.
template <class R, class S, class N>
PHYSIM_NOINLINE void layered_air(int layers, const S* bases, const AirLayer<N>* layer, const R& z, AirState<R>& out) {
  PHYSIM_ASSERT(layers >= 1);
  const S r0 = static_cast<S>(kGeopotentialRadius);
  const R h = r0 * z / (r0 + z);
  const int first = layer_below_all(layers, bases, h);
  R base(bases[first]), lapse(layer[first].lapse), power(layer[first].power), decay(layer[first].decay);
  R density(layer[first].base_density), per_sound(layer[first].base_per_sound);
  for (int i = first + 1; i < layers; ++i) {
    const auto above = h >= R(bases[i]);
    if (!any(above)) break;
    base = select(above, R(bases[i]), base);
    lapse = select(above, R(layer[i].lapse), lapse);
    power = select(above, R(layer[i].power), power);
    decay = select(above, R(layer[i].decay), decay);
    density = select(above, R(layer[i].base_density), density);
    per_sound = select(above, R(layer[i].base_per_sound), per_sound);
  }
  const R rise = h - base;
  const R excess = lapse * rise;  // T / T_b - 1, between -0.3 and 0.3 in the standard's layers
  out = {density * exp_bounded(power * log1p_near_zero(excess) + decay * rise), per_sound / sqrt(S(1) + excess)};
}

/// Where a geometric altitude [m] lies in the lowest layer: -1 at its bottom, 1 at its top [-].
template <class R, class AnyAir>
PHYSIM_INLINE R place_in_low_air(const AnyAir& air, const R& z) {
  return (z - air.low_middle) * air.low_scale;
}
/// The lowest layer at a geometric altitude [m].
template <class R, class S, class N>
PHYSIM_INLINE AirState<R> low_air(const Air<S>& air, const AirNumbers<N>& numbers, const R& z) {
  constexpr bool kDouble = sizeof(S) == 8;
  PHYSIM_ASSERT(air.low_scale > S(0));
  const R u = place_in_low_air(air, z);
  return {polynomial < kDouble ? kDensityTerms : 8 > (u, numbers.low_density),
          polynomial < kDouble ? kPerSoundTerms : 10 > (u, numbers.low_per_sound)};
}

/// As low_air() of the air that all share, to the bit, for one number: both polynomials side by side in one register.
/// It has copies of all that it reads, so that the compiler knows that nothing else writes them.
class LowAirOfOne {
 public:
  PHYSIM_INLINE explicit LowAirOfOne(const Air<double>& air) : low_middle(air.low_middle), low_scale(air.low_scale) {
    static_assert(kDensityTerms <= kPerSoundTerms, "terms that density does not have are zero");
    for (int i = 0; i < kPerSoundTerms; ++i) {
      set_lane(c_[i], 0, i < kDensityTerms ? air.common.low_density[i] : 0.0);
      set_lane(c_[i], 1, air.common.low_per_sound[i]);
    }
  }
  [[nodiscard]] PHYSIM_INLINE AirState<double> operator()(double z) const {
    const Both both = polynomial(Both(place_in_low_air(*this, z)), c_);
    return {lane_of(both, 0), lane_of(both, 1)};
  }

  double low_middle, low_scale;  // as those of Air

 private:
  using Both = Pack<double, 2>;

  Both c_[kPerSoundTerms];
};

/// Standard atmosphere, or that of a profile of levels, at a geometric altitude [m].
template <class R, class S, class N>
PHYSIM_INLINE AirState<R> air_at_altitude(const Conditions<S>& c, const AirNumbers<N>& numbers, const R& z) {
  const AirState<R> low = low_air(c.air, numbers, z);
  const auto high = z > R(c.air.low_top);  // in a profile all are
  if (!any(high)) return low;
  const S* bases = c.air.base;
  const AirLayer<N>* layers = numbers.layer;
  if constexpr (std::is_same_v<N, S>)  // shots with air of their own have no profile
    if (c.has_air_profile) bases = c.air_bases, layers = c.air_layers;
  AirState<R> layered;
  layered_air(c.air.layers, bases, layers, z, layered);
  return {select(high, layered.density, low.density), select(high, layered.per_sound_speed, low.per_sound_speed)};
}

template <class R, class S, class N>
PHYSIM_INLINE AirState<R> air_state(const Conditions<S>& c, const AirNumbers<N>& air, const Vec3<R>& x) {
  switch (c.fidelity.air) {
    case AirModel::isa: return air_at_altitude<R>(c, air, altitude(c, x));
    case AirModel::exponential:
      return {air.density * exp_bounded(-(height(c, x) * c.air.per_scale_height)), R(air.per_sound_speed)};
    case AirModel::constant: return {R(air.density), R(air.per_sound_speed)};
    case AirModel::vacuum: break;
  }
  return {R(S(0)), R(air.per_sound_speed)};
}
/// Behind a call, as few have it.
template <class R, class S>
PHYSIM_NOINLINE void own_air_state(const Conditions<S>& c, const Body<R>& b, const Vec3<R>& x, AirState<R>& out) {
  out = air_state(c, b.air, x);
}
template <class R, class S>
PHYSIM_INLINE AirState<R> air_state(const Conditions<S>& c, const Body<R>& b, const Vec3<R>& x) {
  if (!c.has_own_air) return air_state(c, c.air.common, x);
  AirState<R> own;
  own_air_state(c, b, x, own);
  return own;
}

/// Temperature [K]. Sound speed knows it in the standard atmosphere; other air is as warm as at the origin.
template <class R, class S, class N>
PHYSIM_INLINE R temperature(const Conditions<S>& c, const AirNumbers<N>& air, const AirState<R>& state) {
  if (c.fidelity.air != AirModel::isa) return R(air.temperature);
  return air.kelvin_per_sound / (state.per_sound_speed * state.per_sound_speed);
}
template <class R, class S>
PHYSIM_INLINE R temperature(const Conditions<S>& c, const Body<R>& b, const AirState<R>& state) {
  return c.has_own_air ? temperature(c, b.air, state) : temperature(c, c.air.common, state);
}

/// Sutherland's dynamic viscosity [Pa s].
template <class R>
PHYSIM_INLINE R viscosity(const R& temperature) {
  using S = ScalarOf<R>;
  return S(1.458e-6) * (temperature * sqrt(temperature)) / (temperature + S(110.4));
}

PHYSIM_ISA_END
