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

/// T_s [K].
double sound_temperature(const AirLevel& level) {
  using A = StandardAir;
  return level.sound_speed * level.sound_speed * (A::kMolarMass / (A::kHeatRatio * A::kGasConstant));
}

/// Sets what follows from temperature, pressure and humidity.
PHYSIM_COLD void finish(AirLevel& level) {
  using A = StandardAir;
  const double x_v = vapour_fraction(level.temperature, level.pressure, level.humidity);
  const double f = density_over_ideal(level.temperature, level.pressure, x_v), s = sound_over_dry(x_v);
  level.density = f * level.pressure * A::kMolarMass / (A::kGasConstant * level.temperature);
  level.sound_speed = s * AirProfile<double>::dry_sound_speed(level.temperature);
  level.hydrostatic = f * s * s * A::kHydrostatic;
}

/// Gives a level the pressure that follows from another one, which is finished, above or below.
PHYSIM_COLD void balance(const AirLevel& from, AirLevel& level) {
  level.pressure = from.pressure;
  for (int i = 0; i < 3; ++i) {  // f depends on the pressure a little
    finish(level);
    level.pressure = from.pressure * exp(-balanced_fall(from, level));
  }
  finish(level);
}

/// As a level is given: kUnknown where it has no pressure.
PHYSIM_COLD AirLevel level_of(const AirPoint& point) {
  return {.height = geopotential(point.altitude),
          .temperature = point.temperature,
          .pressure = point.pressure.value_or(kUnknown),
          .humidity = point.humidity.value_or(0)};
}

/// A dry level at another height, with the standard's temperature there moved by as much as at a given level.
PHYSIM_COLD AirLevel beyond(const AirLevel& level, double height) {
  const double shift = level.temperature - standard_air(level.height).temperature;
  return {.height = height, .temperature = standard_air(height).temperature + shift, .pressure = kUnknown};
}

/// Puts levels between those whose temperatures differ much.
PHYSIM_COLD std::vector<AirLevel> refined(const std::vector<AirLevel>& given) {
  std::vector<AirLevel> levels{given.front()};
  for (std::size_t i = 1; i < given.size(); ++i) {
    const AirLevel &low = given[i - 1], &high = given[i];
    const double change = std::abs(high.temperature - low.temperature);
    const double parts = std::ceil(change / (kMostChange * std::min(low.temperature, high.temperature)));
    for (double part = 1; part < parts; ++part) {
      const auto between = [&](double a, double b) { return a + (b - a) * (part / parts); };
      levels.push_back({.height = between(low.height, high.height),
                        .temperature = between(low.temperature, high.temperature),
                        .pressure = kUnknown,
                        .humidity = between(low.humidity, high.humidity)});
    }
    levels.push_back(high);
  }
  return levels;
}

}  // namespace

PHYSIM_COLD std::vector<AirLevel> air_levels(const Atmosphere& atmosphere) {
  std::vector<AirLevel> given;
  for (const AirPoint& point : atmosphere.profile) given.push_back(level_of(point));
  if (given.empty()) return given;
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

PHYSIM_COLD double balanced_fall(const AirLevel& low, const AirLevel& high) {
  const double t0 = sound_temperature(low), t1 = sound_temperature(high), rise = high.height - low.height;
  const double thickness = std::abs(t1 / t0 - 1) < kIsothermal ? rise / t0 : rise / (t1 - t0) * log(t1 / t0);
  return 0.5 * (low.hydrostatic + high.hydrostatic) * thickness;
}

PHYSIM_COLD AirLayer<double> layer_above(const std::vector<AirLevel>& levels, std::size_t i) {
  PHYSIM_ASSERT(i < levels.size());
  const AirLevel& low = levels[i];
  const double t = sound_temperature(low);
  AirLayer<double> layer{0, 0, -low.hydrostatic / t, low.density, 1 / low.sound_speed};
  if (i + 1 == levels.size()) return layer;
  const AirLevel& high = levels[i + 1];
  const double rise = high.height - low.height, excess = sound_temperature(high) / t - 1;
  layer.decay = log(high.density / low.density) / rise;
  if (std::abs(excess) < kIsothermal) return layer;
  layer.lapse = excess / rise;
  layer.power = -0.5 * (low.hydrostatic + high.hydrostatic) / (layer.lapse * t) - 1;
  layer.decay -= layer.power * log1p(excess) / rise;
  return layer;
}

PHYSIM_COLD AirLevel air_between(const std::vector<AirLevel>& levels, double height) {
  const auto above = std::ranges::upper_bound(levels.begin() + 1, levels.end(), height, {}, &AirLevel::height);
  const auto i = static_cast<std::size_t>(above - levels.begin()) - 1;
  const AirLayer<double> layer = layer_above(levels, i);
  const AirLevel& low = levels[i];
  AirLevel air = low;
  const double rise = height - low.height, excess = layer.lapse * rise;
  air.height = height;
  if (i + 1 < levels.size()) {
    const double part = rise / (levels[i + 1].height - low.height);
    air.temperature += (levels[i + 1].temperature - low.temperature) * part;
    air.humidity += (levels[i + 1].humidity - low.humidity) * part;
  }
  const double density = low.density * exp(layer.power * log1p(excess) + layer.decay * rise);
  for (int k = 0; k < 3; ++k) {  // the pressure of that density: f depends on it a little
    finish(air);
    air.pressure *= density / air.density;
  }
  air.density = density;
  air.sound_speed = low.sound_speed * std::sqrt(1 + excess);
  return air;
}

}  // namespace physim
