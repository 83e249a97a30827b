// Weather: what of an environment differs from shot to shot of a batch.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "physim/environment.hpp"

namespace physim {

/// The weather of each shot, as columns of one length, the number of shots. Those left empty are as Environment says.
/// Shot i flies as fly() lets it fly in at(i, common): its air is that of its own station, and a zero range is found in
/// its own air (give an elevation where the zero is that of another day).
///
/// In float32 places within a step are looked for in double, with air and wind that are rounded to float here and not
/// in fly(): crossings of a Mach number, and the corners at which adaptive integrators end steps: knots of a linear
/// curve (Interpolation::linear), DragDef::bands, tables of AeroDef. Steps that end elsewhere make other errors, so
/// such flights differ from those of fly() by as much as their tolerance lets them; where the rounding changes no
/// number, as of a wind of 2.5 m/s, by nothing. All others, and all in float64, are equal bit for bit.
struct Weather {
  // Wind that is the same everywhere, in the place of all that Environment::wind has; see there for the signs.
  std::span<const double> wind_x{};  ///< empty, though another is given: that of Wind::velocity [m/s]
  std::span<const double> wind_y{};  ///< upwards [m/s]
  std::span<const double> wind_z{};  ///< [m/s]
  // As the members of Atmosphere of these names.
  std::span<const double> temperature{};  ///< at the station [K]
  std::span<const double> pressure{};     ///< at the station [Pa]
  std::span<const double> humidity{};     ///< at the station [-]
  std::span<const double> density{};      ///< at the origin, above 0; for constant and exponential air [kg/m^3]

  [[nodiscard]] bool has_wind() const { return !wind_x.empty() || !wind_y.empty() || !wind_z.empty(); }
  [[nodiscard]] bool has_station() const { return !temperature.empty() || !pressure.empty() || !humidity.empty(); }
  [[nodiscard]] bool has_air() const { return has_station() || !density.empty(); }
  [[nodiscard]] bool empty() const { return !has_wind() && !has_air(); }
  /// Length of the longest column; the others have none or as many.
  [[nodiscard]] std::size_t size() const {
    return std::max({wind_x.size(), wind_y.size(), wind_z.size(), temperature.size(), pressure.size(), humidity.size(),
                     density.size()});
  }
  /// The environment of shot i < size().
  [[nodiscard]] Environment at(std::size_t i, const Environment& common) const {
    Environment own = common;
    put(i, own);
    return own;
  }
  /// Writes the weather of shot i < size() over that of an environment.
  void put(std::size_t i, Environment& own) const {
    if (has_wind()) {
      own.wind.profile.clear();
      own.wind.field = {};
    }
    if (!wind_x.empty()) own.wind.velocity.x = wind_x[i];
    if (!wind_y.empty()) own.wind.velocity.y = wind_y[i];
    if (!wind_z.empty()) own.wind.velocity.z = wind_z[i];
    if (!temperature.empty()) own.atmosphere.temperature = temperature[i];
    if (!pressure.empty()) own.atmosphere.pressure = pressure[i];
    if (!humidity.empty()) own.atmosphere.humidity = humidity[i];
    if (!density.empty()) own.atmosphere.density = density[i];
  }
};

}  // namespace physim
