// Equations, symbols and Source: model/standard_atmosphere.hpp.
#include "model/standard_atmosphere.hpp"


#include "math/elementary.hpp"
#include "model/air.hpp"
#include "math/text.hpp"
#include "model/humid_air.hpp"

namespace physim {
namespace {

constexpr double kGravity = 9.80665;           // g0 [m/s^2]
constexpr double kGasConstant = 8314.32;       // R* [J/(kmol K)]
constexpr double kMolarMass = 28.9644;         // M [kg/kmol]
constexpr double kHeatRatio = 1.4;             // gamma [-]
constexpr double kSeaLevelPressure = 101325;   // [Pa]
constexpr double kHydrostatic = kGravity * kMolarMass / kGasConstant;  // g0 M / R* [K/m]

// Table 4 of the standard: base height [m] and lapse rate [K/m]. The eighth layer goes on isothermally above 86 km; its
// base is at 84852.046 m, which the table rounds to a metre.
constexpr double kTop = 86000;  // geometric [m]
constexpr double kBase[kAirLayers] = {
    0, 11000, 20000, 32000, 47000, 51000, 71000, kGeopotentialRadius * kTop / (kGeopotentialRadius + kTop)};
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

Station station_of(const Environment& environment) {
  const Atmosphere& given = environment.atmosphere;
  const Profile standard = profile_through(0, kSeaLevelPressure, 0, 1);
  if (!given.temperature && !given.pressure && !given.humidity) return {standard, 1};
  const double h = geopotential(given.station_altitude.value_or(environment.altitude));
  const double t = given.temperature.value_or(standard.temperature_at(h));
  const double p = given.pressure.value_or(standard.pressure_at(h));
  const double humidity = given.humidity.value_or(0);
  const double factor = moist_air_density(t, p, humidity) * kGasConstant * t / (p * kMolarMass);
  const double dry_sound = sqrt(kHeatRatio * kGasConstant * t / kMolarMass);
  return {profile_through(h, p, t - standard.temperature_at(h), factor),
          moist_air_sound_speed(t, p, humidity) / dry_sound};
}

double density_of(const Profile& profile, double pressure, double temperature) {
  return profile.density_factor * pressure * kMolarMass / (kGasConstant * temperature);
}

}  // namespace

Air<double> prepare_air(const Environment& environment, AirModel model) {
  const auto [profile, sound_factor] = station_of(environment);
  const auto sound = [&, factor = sound_factor](double t) {
    return factor * sqrt(kHeatRatio * kGasConstant * t / kMolarMass);
  };
  Air<double> air{};
  air.layers = kAirLayers;
  for (int i = 0; i < kAirLayers; ++i) {
    const double t = profile.temperature[i];
    const double hydrostatic = profile.density_factor * kHydrostatic;
    air.base[i] = kBase[i];
    air.lapse[i] = kLapse[i] / t;
    air.power[i] = kLapse[i] == 0 ? 0 : -hydrostatic / kLapse[i] - 1;
    air.decay[i] = kLapse[i] == 0 ? -hydrostatic / t : 0;
    air.base_density[i] = density_of(profile, profile.pressure[i], t);
    air.base_sound_speed[i] = sound(t);
    air.base_temperature[i] = t;
  }
  const double h = geopotential(environment.altitude);
  air.temperature = profile.temperature_at(h);
  air.density = density_of(profile, profile.pressure_at(h), air.temperature);
  air.sound_speed = sound(air.temperature);
  air.per_scale_height = 1 / environment.atmosphere.scale_height;
  if (model != AirModel::isa) {
    air.density = environment.atmosphere.density.value_or(air.density);
    air.sound_speed = environment.atmosphere.sound_speed.value_or(air.sound_speed);
  }
  if (model == AirModel::vacuum) air.density = 0;
  return air;
}

Result<AirSample> air_at(const Environment& environment, double altitude) {
  if (!(altitude >= -5000 && altitude <= 86000))
    return Error{"altitude " + short_text(altitude) + " m lies outside the standard atmosphere", "altitude",
                 "give a height from -5000 m to 86000 m"};
  const AirModel model = environment.atmosphere.model;
  const Air<double> air = prepare_air(environment, model);
  AirState<double> state{air.density, air.sound_speed, air.temperature};
  if (model == AirModel::isa) state = standard_air(air, altitude);
  if (model == AirModel::exponential) state.density *= exp(-(altitude - environment.altitude) * air.per_scale_height);
  const double factor = station_of(environment).profile.density_factor;
  const double pressure = state.density * kGasConstant * state.temperature / (kMolarMass * factor);
  return AirSample{state.temperature, pressure, state.density, state.sound_speed, viscosity(state.temperature)};
}

}  // namespace physim
