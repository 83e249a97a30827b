// Equations, symbols and Source: model/station.hpp.
#include "model/standard_atmosphere.hpp"

#include <algorithm>
#include <vector>

#include "base/assert.hpp"
#include "math/chebyshev.hpp"
#include "model/air.hpp"
#include "model/air_levels.hpp"
#include "model/station.hpp"

namespace physim {
namespace {

/// The standard's own, computed once: to the last digits.
struct StandardProfile : AirProfile<double> {
  [[nodiscard]] double pressure_ratio(int i, double from, double to) const {
    const double t_from = temperature[i] + kLapse[i] * (from - kBase[i]);
    const double t_to = temperature[i] + kLapse[i] * (to - kBase[i]);
    if (kLapse[i] == 0) return exp(-density_factor * kHydrostatic * (to - from) / t_from);
    return pow(t_to / t_from, -density_factor * kHydrostatic / kLapse[i]);
  }
};

const StandardProfile& standard_profile() {
  static const StandardProfile profile = [] {
    StandardProfile standard{};
    standard.density_factor = standard.sound_factor = 1;
    profile_through(0, StandardAir::kSeaLevelPressure, 0.0, standard);
    return standard;
  }();
  return profile;
}

bool is_standard(const Atmosphere& given) { return !given.temperature && !given.pressure && !given.humidity; }

double station_height(const Environment& environment) {
  return geopotential(environment.atmosphere.station_altitude.value_or(environment.altitude));
}

/// Density over that of the standard's dry ideal gas.
double density_factor(const Environment& environment) {
  if (is_standard(environment.atmosphere)) return 1;
  const double h = station_height(environment);
  AirProfile<double> profile{};
  profile_of_station(h, standard_profile().temperature_at(h), station_air(environment), profile);
  return profile.density_factor;
}

/// Coefficients of a polynomial for f over the lowest layer.
template <int N>
void fit_low(const auto& f, double (&out)[N]) {
  const ChebyshevFit fit(N);
  double values[N];
  for (std::size_t i = 0; i < N; ++i) values[i] = f(StandardAir::kLowMiddle + fit.points()[i] / StandardAir::kLowScale);
  for (std::size_t j = 0; j < N; ++j) {
    out[j] = 0;
    for (std::size_t i = 0; i < N; ++i) out[j] += fit.matrix()[j * N + i] * values[i];
  }
}

/// Fitting takes some microseconds, and most air is standard.
const AirNumbers<double>& standard_layers() {
  static const AirNumbers<double> standard = [] {
    AirNumbers<double> numbers{};
    const StandardProfile& profile = standard_profile();
    put_layers(profile, numbers);
    fit_low(
        [&](double z) {
          return profile.density(pressure_at(profile, geopotential(z)), profile.temperature_at(geopotential(z)));
        },
        numbers.low_density);
    fit_low([&](double z) { return profile.per_sound(profile.temperature_at(geopotential(z))); },
            numbers.low_per_sound);
    return numbers;
  }();
  return standard;
}

/// What of the air is the same in any weather.
void put_frame(AirModel model, double scale_height, Air<double>& air) {
  air.per_scale_height = 1 / scale_height;
  if (model != AirModel::isa) return;
  air.low_middle = StandardAir::kLowMiddle;
  air.low_scale = StandardAir::kLowScale;
  air.low_top = StandardAir::kLowTop;
  air.layers = kAirLayers;
  std::ranges::copy(StandardAir::kBase, air.base);
}

}  // namespace

Readings<double> standard_air(double height) {
  const AirProfile<double>& standard = standard_profile();
  return {standard.temperature_at(height), pressure_at(standard, height), 0};
}

Readings<double> station_air(const Environment& environment) {
  const Atmosphere& given = environment.atmosphere;
  const Readings<double> standard = standard_air(station_height(environment));
  return {given.temperature.value_or(standard.temperature), given.pressure.value_or(standard.pressure),
          given.humidity.value_or(0)};
}

StationPlace station_place(const Environment& environment, AirModel model) {
  const double h = station_height(environment);
  return {model, h, standard_profile().temperature_at(h), geopotential(environment.altitude), false};
}

namespace {

/// The air between levels at the origin.
PHYSIM_COLD void put_origin(const std::vector<AirLevel>& levels, double height, AirNumbers<double>& air) {
  const AirLevel there = air_between(levels, height);
  air.temperature = there.temperature;
  air.density = there.density;
  air.per_sound_speed = 1 / there.sound_speed;
  air.kelvin_per_sound = there.temperature * air.per_sound_speed * air.per_sound_speed;
}

/// Into numbers that are all zero. The levels are those of the environment's profile.
void put_air_numbers(const Environment& environment, AirModel model, const std::vector<AirLevel>& levels,
                     AirNumbers<double>& air) {
  const Atmosphere& given = environment.atmosphere;
  if (!levels.empty()) {
    put_origin(levels, geopotential(environment.altitude), air);
  } else if (is_standard(given)) {
    const StandardProfile& profile = standard_profile();
    const double h = geopotential(environment.altitude);
    if (model == AirModel::isa) air = standard_layers();
    put_origin(profile, h, air);
    // Air in layers needs no density at the origin.
    if (model != AirModel::isa) air.density = profile.density(pressure_at(profile, h), air.temperature);
  } else {
    put_air(station_place(environment, model), station_air(environment), air);
  }
  switch (model) {
    case AirModel::isa: return;
    case AirModel::vacuum: air.density = 0; break;
    case AirModel::constant:
    case AirModel::exponential: air.density = given.density.value_or(air.density); break;
  }
  if (given.sound_speed) air.per_sound_speed = 1 / *given.sound_speed;
}

}  // namespace

AirNumbers<double> prepare_air_numbers(const Environment& environment, AirModel model) {
  AirNumbers<double> air{};
  put_air_numbers(environment, model, air_levels(environment.atmosphere), air);
  return air;
}

void put_air(const Environment& environment, AirModel model, const std::vector<AirLevel>& levels, Air<double>& air) {
  put_frame(model, environment.atmosphere.scale_height, air);
  put_air_numbers(environment, model, levels, air.common);
  if (levels.empty() || model != AirModel::isa) return;
  PHYSIM_ASSERT(levels.size() >= 2);
  air.low_top = -kInfinity;
  air.layers = static_cast<int>(levels.size());
  std::ranges::fill(air.base, levels[1].height);
  air.base[0] = levels[0].height;
}

AirSample air_sample(const Environment& environment, double altitude) {
  PHYSIM_ASSERT(altitude >= kLowestAltitude && altitude <= kHighestAltitude);
  const std::vector<AirLevel> levels = air_levels(environment.atmosphere);
  if (environment.atmosphere.model == AirModel::isa && !levels.empty()) {
    const AirLevel air = air_between(levels, geopotential(altitude));
    return {air.temperature, air.pressure, air.density, air.sound_speed, viscosity(air.temperature)};
  }
  Conditions<double> c{};
  c.fidelity.air = environment.atmosphere.model;
  c.altitude = environment.altitude;
  put_air(environment, c.fidelity.air, levels, c.air);
  const AirState<double> state = air_state(c, c.air.common, Vec3d{0, altitude - c.altitude, 0});
  const double kelvin = temperature(c, c.air.common, state);
  const double factor = density_factor(environment);
  const double pressure = state.density * StandardAir::kGasConstant * kelvin / (StandardAir::kMolarMass * factor);
  return {kelvin, pressure, state.density, 1 / state.per_sound_speed, viscosity(kelvin)};
}

}  // namespace physim
