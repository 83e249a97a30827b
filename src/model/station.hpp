// The layers of the US Standard Atmosphere 1976 through what a station measures, for one station or for lanes of them.
//
// What it models: the standard temperature profile moved by T_station - T_standard(H_station) at all heights, pressure
//   in hydrostatic equilibrium through the station's pressure, and the density of the station's moist air by CIPM-2007.
// When to use it: wherever air is prepared (model/standard_atmosphere.hpp); in lanes where each shot has its own.
// When it is wrong: the standard lapse rate need not be the day's; see model/air.hpp.
// Symbols: as in model/air.hpp; f = rho_station R* T / (p M), density over that of the standard's dry ideal gas [-].
// Equations: p = p_b (T / T_b)^-(f g0 M / (R* L)) or p_b exp(-f g0 M (H - H_b) / (R* T_b)); rho = f p M / (R* T).
//   Without station data f = 1 and this is the standard atmosphere itself.
// Source: U.S. Standard Atmosphere, 1976 (NOAA-S/T 76-1562), table 4 and eq. 33a, 33b, 42, 50.
#pragma once

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "model/conditions.hpp"
#include "model/humid_air.hpp"
#include "model/low_air.hpp"

namespace physim {

/// Geometric altitudes between which the standard is defined [m].
inline constexpr double kLowestAltitude = -5000;
inline constexpr double kHighestAltitude = 86000;

[[nodiscard]] inline double geopotential(double z) { return kGeopotentialRadius * z / (kGeopotentialRadius + z); }

/// What stations of one place measure, or the standard's air there without measurements.
template <class R>
struct Readings {
  R temperature;  // [K]
  R pressure;     // [Pa]
  R humidity;     // relative [-]
};

/// Where stations stand, and what air is wanted of them.
struct StationPlace {
  AirModel model;
  double height;    // geopotential [m]
  double standard;  // the standard's temperature there [K]
  double origin;    // geopotential height of the origin [m]
  bool low_alone;   // nothing but the polynomials of the lowest layer
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// The standard's constants.
struct StandardAir {
  static constexpr double kGravity = 9.80665;                                   // g0 [m/s^2]
  static constexpr double kGasConstant = 8314.32;                               // R* [J/(kmol K)]
  static constexpr double kMolarMass = 28.9644;                                 // M [kg/kmol]
  static constexpr double kHeatRatio = kStandardHeatRatio;                      // gamma [-]
  static constexpr double kSeaLevelPressure = 101325;                           // [Pa]
  static constexpr double kSeaLevelTemperature = 288.15;                        // [K]
  static constexpr double kHydrostatic = kGravity * kMolarMass / kGasConstant;  // g0 M / R* [K/m]

  // Table 4 of the standard: base height [m] and lapse rate [K/m]. The eighth layer continues isothermally above 86 km;
  // its base is at 84852.046 m, which the table rounds to a metre.
  static constexpr double kBase[kAirLayers] = {
      0,     11000, 20000, 32000,
      47000, 51000, 71000, kGeopotentialRadius* kHighestAltitude / (kGeopotentialRadius + kHighestAltitude)};
  static constexpr double kLapse[kAirLayers] = {-0.0065, 0, 0.001, 0.0028, 0, -0.0028, -0.002, 0};

  /// Up to where the lowest layer reaches, geometric [m].
  static constexpr double kLowTop = kGeopotentialRadius * kBase[1] / (kGeopotentialRadius - kBase[1]);
  static constexpr double kLowMiddle = 0.5 * (kLowestAltitude + kLowTop);  // [m]
  static constexpr double kLowScale = 2 / (kLowTop - kLowestAltitude);     // [1/m]

  static int layer_of(double h) {
    int layer = 0;
    while (layer + 1 < kAirLayers && h >= kBase[layer + 1]) ++layer;
    return layer;
  }
};

/// Temperature and pressure by height.
template <class R>
struct AirProfile : StandardAir {
  using Number = R;

  R temperature[kAirLayers];  // at the bases [K]
  R pressure[kAirLayers];     // at the bases [Pa]
  R density_factor;           // f
  R sound_factor;             // sound speed over that of the standard's dry air

  PHYSIM_INLINE R temperature_at(double h) const {
    const int i = layer_of(h);
    return temperature[i] + R(kLapse[i] * (h - kBase[i]));
  }
  /// p(to) / p(from) along layer i, to some 1e-15. Behind a call: it is long.
  [[nodiscard, gnu::noinline]] R pressure_ratio(int i, double from, double to) const {
    if (from == to) return R(1.0);  // what follows would give as much
    const R t_from = temperature[i] + R(kLapse[i] * (from - kBase[i]));
    const R hydrostatic = -density_factor * R(kHydrostatic);
    if (kLapse[i] == 0) return exp_bounded(hydrostatic * R(to - from) / t_from);
    const R t_to = temperature[i] + R(kLapse[i] * (to - kBase[i]));
    return exp_bounded(hydrostatic * R(1 / kLapse[i]) * log(t_to / t_from));
  }
  /// The power in density ~ (T / T_b)^power of layer i; 0 where the layer is isothermal.
  PHYSIM_INLINE R power(int i) const {
    return kLapse[i] == 0 ? R(0.0) : -(density_factor * R(kHydrostatic)) / R(kLapse[i]) - R(1.0);
  }
  PHYSIM_INLINE R density(const R& p, const R& t) const {
    return density_factor * p * R(kMolarMass) / (R(kGasConstant) * t);
  }
  PHYSIM_INLINE R per_sound(const R& t) const { return R(1.0) / (sound_factor * dry_sound_speed(t)); }
  PHYSIM_INLINE static R dry_sound_speed(const R& t) { return sqrt(R(kHeatRatio * kGasConstant) * t / R(kMolarMass)); }
};

template <class Profile, class R = typename Profile::Number>
PHYSIM_INLINE R pressure_at(const Profile& profile, double h) {
  const int i = StandardAir::layer_of(h);
  return profile.pressure[i] * profile.pressure_ratio(i, StandardAir::kBase[i], h);
}

/// The profile with the standard's temperatures plus `shift`, through pressure p at height h: temperatures of all
/// layers, pressures of the lowest `layers`, and of those down from the height.
template <class Profile, class R = typename Profile::Number>
void profile_through(double h, const R& p, const std::type_identity_t<R>& shift, Profile& profile,
                     int layers = kAirLayers) {
  using A = StandardAir;
  profile.temperature[0] = R(A::kSeaLevelTemperature) + shift;
  for (int i = 1; i < kAirLayers; ++i)
    profile.temperature[i] = profile.temperature[i - 1] + R(A::kLapse[i - 1] * (A::kBase[i] - A::kBase[i - 1]));
  const int station = A::layer_of(h);
  profile.pressure[station] = p * profile.pressure_ratio(station, h, A::kBase[station]);
  for (int i = station + 1; i < layers; ++i)
    profile.pressure[i] = profile.pressure[i - 1] * profile.pressure_ratio(i - 1, A::kBase[i - 1], A::kBase[i]);
  for (int i = station; i-- > 0;)
    profile.pressure[i] = profile.pressure[i + 1] * profile.pressure_ratio(i, A::kBase[i + 1], A::kBase[i]);
}

/// The profile through a station at geopotential height h [m], where the standard has `standard` [K].
template <class R>
void profile_of_station(double h, double standard, const Readings<R>& station, AirProfile<R>& profile,
                        int layers = kAirLayers) {
  const auto& [t, p, humidity] = station;
  const R x_v = vapour_fraction(t, p, humidity);
  profile.density_factor = density_over_ideal(t, p, x_v);
  profile.sound_factor = sound_over_dry(x_v);
  profile_through(h, p, t - R(standard), profile, layers);
}

/// All layers by their laws.
template <class R>
void put_layers(const AirProfile<R>& profile, AirNumbers<R>& air) {
  using A = StandardAir;
  const R hydrostatic = profile.density_factor * R(A::kHydrostatic);
  for (int i = 0; i < kAirLayers; ++i) {
    const R t = profile.temperature[i];
    AirLayer<R>& layer = air.layer[i];
    layer.lapse = R(A::kLapse[i]) / t;
    layer.power = profile.power(i);
    layer.decay = A::kLapse[i] == 0 ? -hydrostatic / t : R(0.0);
    layer.base_density = profile.density(profile.pressure[i], t);
    layer.base_per_sound = profile.per_sound(t);
  }
}

/// The polynomials of the lowest layer.
template <class R>
void put_low(const AirProfile<R>& profile, AirNumbers<R>& air) {
  using A = StandardAir;
  constexpr double kHalf = 1 / (A::kLowScale * (kGeopotentialRadius + A::kLowMiddle));
  const double middle = geopotential(A::kLowMiddle);
  const R sea_level = profile.temperature[0];
  const R t = sea_level + R(A::kLapse[0] * middle);
  const R density = profile.density(profile.pressure[0] * profile.pressure_ratio(0, 0, middle), t);
  const LowLayer<R> layer{R(-kHalf) * (sea_level + R(A::kLapse[0] * kGeopotentialRadius)) / t, R(kHalf)};
  const R nu = profile.power(0), root(-0.5), per_sound = profile.per_sound(t);
  put_powers(layer, power<kDensityTerms + 2>(nu, density, air.low_density),
             power<kPerSoundTerms + 4>(root, per_sound, air.low_per_sound));
}

/// The air at the origin, at geopotential height h [m], but for its density.
template <class R>
PHYSIM_INLINE void put_origin(const AirProfile<R>& profile, double h, AirNumbers<R>& air) {
  air.temperature = profile.temperature_at(h);
  air.per_sound_speed = profile.per_sound(air.temperature);
  air.kelvin_per_sound = air.temperature * air.per_sound_speed * air.per_sound_speed;
}

/// The air through stations of one place. Air in layers needs no density at the origin, and other air no layers.
/// Nothing beside the polynomials of the lowest layer is set where they are wanted alone.
template <class R>
void put_air(const StationPlace& place, const Readings<R>& station, AirNumbers<R>& air) {
  AirProfile<R> profile;
  profile_of_station(place.height, place.standard, station, profile, place.low_alone ? 1 : kAirLayers);
  if (place.low_alone) return put_low(profile, air);
  put_origin(profile, place.origin, air);
  air.density = R(0.0);
  if (place.model == AirModel::isa) {
    put_layers(profile, air);
    put_low(profile, air);
  } else if (place.model != AirModel::vacuum) {
    air.density = profile.density(pressure_at(profile, place.origin), air.temperature);
  }
}

PHYSIM_ISA_END
