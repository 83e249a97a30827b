// Equations, symbols and Source: model/air_levels.hpp.
#include "model/air_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.hpp"
#include "model/standard_atmosphere.hpp"
#include "model/station.hpp"

namespace physim {
namespace {

constexpr double kMostChange = 0.25;  // of temperature within a layer, over that of its base: log1p_near_zero() [-]
constexpr double kIsothermal = 1e-9;  // relative change of temperature below which a layer is isothermal [-]
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();  // a pressure that a level does not have

/// Density, sound speed and what they follow from.
struct Humid {
  double density_factor;  // f
  double sound_factor;    // s
};
Humid humid(double temperature, double pressure, double humidity) {
  const double x_v = vapour_fraction(temperature, pressure, humidity);
  return {density_over_ideal(temperature, pressure, x_v), sound_over_dry(x_v)};
}
double sound_temperature(const AirLevel& level) {
  const double s = level.sound_speed / AirProfile<double>::dry_sound_speed(level.temperature);
  return level.temperature * s * s;
}

/// Sets what follows from temperature, pressure and humidity; returns k.
[[gnu::cold]] double finish(AirLevel& level) {
  using A = StandardAir;
  const Humid h = humid(level.temperature, level.pressure, level.humidity);
  level.density = h.density_factor * level.pressure * A::kMolarMass / (A::kGasConstant * level.temperature);
  level.sound_speed = h.sound_factor * AirProfile<double>::dry_sound_speed(level.temperature);
  return h.density_factor * h.sound_factor * h.sound_factor * A::kHydrostatic;
}

/// k of a level that is finished.
[[gnu::cold]] double hydrostatic_of(const AirLevel& level) {
  AirLevel same = level;
  return finish(same);
}

/// The integral of dH / T_s from one level to another [m/K].
[[gnu::cold]] double thickness(const AirLevel& from, const AirLevel& to) {
  const double t0 = sound_temperature(from), t1 = sound_temperature(to), rise = to.height - from.height;
  return std::abs(t1 / t0 - 1) < kIsothermal ? rise / t0 : rise / (t1 - t0) * log(t1 / t0);
}

/// Gives a level the pressure that follows from another one, which is finished, above or below.
[[gnu::cold]] void balance(const AirLevel& from, AirLevel& level) {
  double k = hydrostatic_of(from);
  level.pressure = from.pressure;
  for (int i = 0; i < 3; ++i) {  // f depends on the pressure a little
    const double own = finish(level);
    if (i > 0) k = 0.5 * (hydrostatic_of(from) + own);
    level.pressure = from.pressure * exp(-k * thickness(from, level));
  }
  finish(level);
}

/// As a level is given: kUnknown where it has no pressure.
[[gnu::cold]] AirLevel level_of(const AirPoint& point) {
  return {geopotential(point.altitude),
          point.temperature,
          point.pressure.value_or(kUnknown),
          point.humidity.value_or(0),
          0,
          0};
}

/// What the standard has at other heights, moved to meet a level; dry.
[[gnu::cold]] AirLevel beyond(const AirLevel& level, double height) {
  const double shift = level.temperature - standard_air(level.height).temperature;
  return {height, standard_air(height).temperature + shift, kUnknown, 0, 0, 0};
}

/// Puts levels between those whose temperatures differ much.
[[gnu::cold]] std::vector<AirLevel> refined(const std::vector<AirLevel>& given) {
  std::vector<AirLevel> levels{given.front()};
  for (std::size_t i = 1; i < given.size(); ++i) {
    const AirLevel &low = given[i - 1], &high = given[i];
    const double change = std::abs(high.temperature - low.temperature);
    const double parts = std::ceil(change / (kMostChange * std::min(low.temperature, high.temperature)));
    for (double part = 1; part < parts; ++part) {
      const auto between = [&](double a, double b) { return a + (b - a) * (part / parts); };
      levels.push_back({between(low.height, high.height), between(low.temperature, high.temperature), kUnknown,
                        between(low.humidity, high.humidity), 0, 0});
    }
    levels.push_back(high);
  }
  return levels;
}

}  // namespace

[[gnu::cold]] std::vector<AirLevel> air_levels(const Atmosphere& atmosphere) {
  PHYSIM_ASSERT(!atmosphere.profile.empty());
  std::vector<AirLevel> given;
  for (const AirPoint& point : atmosphere.profile) given.push_back(level_of(point));
  if (std::isnan(given.front().pressure)) given.front().pressure = standard_air(given.front().height).pressure;
  const AirLevel lowest = given.front(), last = given.back();
  std::vector<AirLevel> below;
  const auto begin_at = [&](double height) {
    below.push_back(beyond(lowest, height));
    below.back().humidity = lowest.humidity;
  };
  if (lowest.height > geopotential(kLowestAltitude)) begin_at(geopotential(kLowestAltitude));
  for (const double base : StandardAir::kBase)
    if (base < lowest.height) begin_at(base);
  given.insert(given.begin(), below.begin(), below.end());
  constexpr double kDries = 100;  // above the last level [m]
  if (last.humidity > 0) given.push_back(beyond(last, last.height + kDries));
  for (const double base : StandardAir::kBase)
    if (base > given.back().height) given.push_back(beyond(last, base));
  std::vector<AirLevel> levels = refined(given);
  // Up from the first level that the profile has, and down from it.
  const auto first = std::ranges::find(levels, lowest.height, &AirLevel::height) - levels.begin();
  finish(levels[static_cast<std::size_t>(first)]);
  for (auto i = static_cast<std::size_t>(first) + 1; i < levels.size(); ++i)
    std::isnan(levels[i].pressure) ? balance(levels[i - 1], levels[i]) : void(finish(levels[i]));
  for (auto i = static_cast<std::size_t>(first); i-- > 0;) balance(levels[i + 1], levels[i]);
  return levels;
}

[[gnu::cold]] std::vector<AirLayer<double>> air_layers(const std::vector<AirLevel>& levels) {
  std::vector<AirLayer<double>> layers;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const AirLevel& low = levels[i];
    const double t = sound_temperature(low);
    AirLayer<double> layer{0, 0, -hydrostatic_of(low) / t, low.density, 1 / low.sound_speed};
    if (i + 1 < levels.size()) {
      const AirLevel& high = levels[i + 1];
      const double rise = high.height - low.height, excess = sound_temperature(high) / t - 1;
      layer.decay = log(high.density / low.density) / rise;
      if (std::abs(excess) >= kIsothermal) {
        layer.lapse = excess / rise;
        layer.power = -0.5 * (hydrostatic_of(low) + hydrostatic_of(high)) / (layer.lapse * t) - 1;
        layer.decay -= layer.power * log1p(excess) / rise;
      }
    }
    layers.push_back(layer);
  }
  PHYSIM_ASSERT(layers.size() == levels.size());
  return layers;
}

[[gnu::cold]] double balanced_fall(const AirLevel& low, const AirLevel& high) {
  PHYSIM_ASSERT(high.height > low.height);
  return 0.5 * (hydrostatic_of(low) + hydrostatic_of(high)) * thickness(low, high);
}

[[gnu::cold]] AirLevel air_between(const std::vector<AirLevel>& levels, double height) {
  const std::vector<AirLayer<double>> layers = air_layers(levels);
  std::size_t i = 0;
  while (i + 1 < levels.size() && height >= levels[i + 1].height) ++i;
  const AirLayer<double>& layer = layers[i];
  const AirLevel& low = levels[i];
  AirLevel air = low;
  const double rise = height - low.height, excess = layer.lapse * rise;
  air.height = height;
  air.density = low.density * exp(layer.power * log1p(excess) + layer.decay * rise);
  air.sound_speed = low.sound_speed * std::sqrt(1 + excess);
  if (i + 1 < levels.size()) {
    const double part = rise / (levels[i + 1].height - low.height);
    air.temperature += (levels[i + 1].temperature - low.temperature) * part;
    air.humidity += (levels[i + 1].humidity - low.humidity) * part;
  }
  // The pressure of that density: f depends on it a little.
  for (int k = 0; k < 3; ++k)
    air.pressure = air.density * StandardAir::kGasConstant * air.temperature /
                   (StandardAir::kMolarMass * humid(air.temperature, air.pressure, air.humidity).density_factor);
  return air;
}

}  // namespace physim
