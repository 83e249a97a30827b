// Equations, symbols and Source: model/standard_atmosphere.hpp.
#include "model/standard_atmosphere.hpp"

#include <algorithm>
#include <vector>

#include "base/assert.hpp"
#include "math/chebyshev.hpp"
#include "math/elementary.hpp"
#include "model/air.hpp"
#include "model/humid_air.hpp"

namespace physim {
namespace {

constexpr double kGravity = 9.80665;                                   // g0 [m/s^2]
constexpr double kGasConstant = 8314.32;                               // R* [J/(kmol K)]
constexpr double kMolarMass = 28.9644;                                 // M [kg/kmol]
constexpr double kHeatRatio = 1.4;                                     // gamma [-]
constexpr double kSeaLevelPressure = 101325;                           // [Pa]
constexpr double kHydrostatic = kGravity * kMolarMass / kGasConstant;  // g0 M / R* [K/m]

// Table 4 of the standard: base height [m] and lapse rate [K/m]. The eighth layer goes on isothermally above 86 km; its
// base is at 84852.046 m, which the table rounds to a metre.
constexpr double kTop = 86000;  // geometric [m]
constexpr double kBase[kAirLayers] = {0,     11000, 20000, 32000,
                                      47000, 51000, 71000, kGeopotentialRadius* kTop / (kGeopotentialRadius + kTop)};
constexpr double kLapse[kAirLayers] = {-0.0065, 0, 0.001, 0.0028, 0, -0.0028, -0.002, 0};

double geopotential(double z) { return kGeopotentialRadius * z / (kGeopotentialRadius + z); }

int layer_of(double h) {
  int layer = 0;
  while (layer + 1 < kAirLayers && h >= kBase[layer + 1]) ++layer;
  return layer;
}

struct Profile {
  double temperature[kAirLayers];  // at the bases [K]
  double pressure[kAirLayers];     // at the bases [Pa]
  double density_factor;           // f

  [[nodiscard]] double temperature_at(double h) const {
    const int i = layer_of(h);
    return temperature[i] + kLapse[i] * (h - kBase[i]);
  }
  /// p(to) / p(from) along layer i.
  [[nodiscard]] double pressure_ratio(int i, double from, double to) const {
    const double t_from = temperature[i] + kLapse[i] * (from - kBase[i]);
    const double t_to = temperature[i] + kLapse[i] * (to - kBase[i]);
    if (kLapse[i] == 0) return exp(-density_factor * kHydrostatic * (to - from) / t_from);
    return pow(t_to / t_from, -density_factor * kHydrostatic / kLapse[i]);
  }
  [[nodiscard]] double density(double p, double t) const {
    return density_factor * p * kMolarMass / (kGasConstant * t);
  }
  [[nodiscard]] double pressure_at(double h) const {
    const int i = layer_of(h);
    return pressure[i] * pressure_ratio(i, kBase[i], h);
  }
};

/// The profile with the standard's temperatures plus `shift`, through pressure p at height h.
Profile profile_through(double h, double p, double shift, double density_factor) {
  Profile profile{};
  profile.density_factor = density_factor;
  profile.temperature[0] = 288.15 + shift;
  for (int i = 1; i < kAirLayers; ++i)
    profile.temperature[i] = profile.temperature[i - 1] + kLapse[i - 1] * (kBase[i] - kBase[i - 1]);
  PHYSIM_ASSERT(!(profile.density_factor <= 0));
  const int station = layer_of(h);
  profile.pressure[station] = p * profile.pressure_ratio(station, h, kBase[station]);
  for (int i = station + 1; i < kAirLayers; ++i)
    profile.pressure[i] = profile.pressure[i - 1] * profile.pressure_ratio(i - 1, kBase[i - 1], kBase[i]);
  for (int i = station; i-- > 0;)
    profile.pressure[i] = profile.pressure[i + 1] * profile.pressure_ratio(i, kBase[i + 1], kBase[i]);
  return profile;
}

struct Station {
  Profile profile;
  double sound_factor;  // sound speed over that of the standard's dry air
};

double dry_sound_speed(double t) { return sqrt(kHeatRatio * kGasConstant * t / kMolarMass); }

const Profile& standard_profile() {
  static const Profile profile = profile_through(0, kSeaLevelPressure, 0, 1);
  return profile;
}

bool is_standard(const Atmosphere& given) { return !given.temperature && !given.pressure && !given.humidity; }

double station_height(const Environment& environment) {
  return geopotential(environment.atmosphere.station_altitude.value_or(environment.altitude));
}

Station station_of(const Environment& environment) {
  const Atmosphere& given = environment.atmosphere;
  const Profile& standard = standard_profile();
  if (is_standard(given)) return {standard, 1};
  const double h = station_height(environment);
  const auto [t, p] = station_air(environment);
  const double humidity = given.humidity.value_or(0);
  const double factor = moist_air_density(t, p, humidity) * kGasConstant * t / (p * kMolarMass);
  return {profile_through(h, p, t - standard.temperature_at(h), factor),
          moist_air_sound_speed(t, p, humidity) / dry_sound_speed(t)};
}

/// Fits f over the lowest layer of the air.
template <int N>
void fit_low(const Air<double>& air, const auto& f, double (&out)[N]) {
  static const ChebyshevFit fit(N);
  std::vector<double> values;
  for (const double u : fit.points()) values.push_back(f(air.low_middle + u / air.low_scale));
  PHYSIM_ASSERT(values.size() == N && air.low_scale > 0);
  const auto powers = fit.powers(values);
  std::copy(powers.begin(), powers.end(), out);
}

/// The layers of an Air, and the polynomials of the lowest one.
Air<double> layers_of(const Station& station) {
  Air<double> air{};
  const Profile& profile = station.profile;
  const auto per_sound = [&](double t) { return 1 / (station.sound_factor * dry_sound_speed(t)); };
  air.layers = kAirLayers;
  for (int i = 0; i < kAirLayers; ++i) {
    const double t = profile.temperature[i];
    const double hydrostatic = profile.density_factor * kHydrostatic;
    air.base[i] = kBase[i];
    air.lapse[i] = kLapse[i] / t;
    air.power[i] = kLapse[i] == 0 ? 0 : -hydrostatic / kLapse[i] - 1;
    air.decay[i] = kLapse[i] == 0 ? -hydrostatic / t : 0;
    air.base_density[i] = profile.density(profile.pressure[i], t);
    air.base_per_sound[i] = per_sound(t);
  }
  air.low_top = kGeopotentialRadius * kBase[1] / (kGeopotentialRadius - kBase[1]);
  air.low_middle = 0.5 * (kLowestAltitude + air.low_top);
  air.low_scale = 2 / (air.low_top - kLowestAltitude);
  const auto density_at = [&](double z) {
    const double h = geopotential(z);
    const double t = profile.temperature[0] + kLapse[0] * h;
    return profile.density(profile.pressure[0] * profile.pressure_ratio(0, 0, h), t);
  };
  fit_low(air, density_at, air.low_density);
  fit_low(
      air, [&](double z) { return per_sound(profile.temperature[0] + kLapse[0] * geopotential(z)); },
      air.low_per_sound);
  return air;
}

/// Fitting takes some microseconds, and most air is standard.
Air<double> layers_of(const Station& station, const Atmosphere& given) {
  static const Air<double> standard = layers_of({standard_profile(), 1});
  return is_standard(given) ? standard : layers_of(station);
}

}  // namespace

StationAir station_air(const Environment& environment) {
  const Atmosphere& given = environment.atmosphere;
  const Profile& standard = standard_profile();
  const double h = station_height(environment);
  return {given.temperature.value_or(standard.temperature_at(h)), given.pressure.value_or(standard.pressure_at(h))};
}

Air<double> prepare_air(const Environment& environment, AirModel model) {
  const Station station = station_of(environment);
  const Profile& profile = station.profile;
  const double h = geopotential(environment.altitude);
  const Atmosphere& given = environment.atmosphere;
  Air<double> air = model == AirModel::isa ? layers_of(station, given) : Air<double>{};
  air.temperature = profile.temperature_at(h);
  air.density = profile.density(profile.pressure_at(h), air.temperature);
  air.per_sound_speed = 1 / (station.sound_factor * dry_sound_speed(air.temperature));
  air.kelvin_per_sound = air.temperature * air.per_sound_speed * air.per_sound_speed;
  air.per_scale_height = 1 / given.scale_height;
  switch (model) {
    case AirModel::isa: return air;
    case AirModel::vacuum: air.density = 0; break;
    case AirModel::constant:
    case AirModel::exponential: air.density = given.density.value_or(air.density); break;
  }
  if (given.sound_speed) air.per_sound_speed = 1 / *given.sound_speed;
  return air;
}

AirSample air_sample(const Environment& environment, double altitude) {
  PHYSIM_ASSERT(altitude >= kLowestAltitude && altitude <= kHighestAltitude);
  Conditions<double> c{};
  c.fidelity.air = environment.atmosphere.model;
  c.altitude = environment.altitude;
  c.air = prepare_air(environment, c.fidelity.air);
  const AirState<double> state = air_state(c, Vec3d{0, altitude - c.altitude, 0});
  const double kelvin = temperature(c, state);
  const double factor = station_of(environment).profile.density_factor;
  const double pressure = state.density * kGasConstant * kelvin / (kMolarMass * factor);
  return {kelvin, pressure, state.density, 1 / state.per_sound_speed, viscosity(kelvin)};
}

}  // namespace physim
