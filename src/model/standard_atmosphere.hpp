// Prepares the air of an environment for computing: the layers of the US Standard Atmosphere 1976 through a station.
//
// What it models: the standard temperature profile moved by T_station - T_standard(H_station) at all heights, pressure
//   in hydrostatic equilibrium through the station's pressure, and the density of the station's moist air by CIPM-2007.
// When it is wrong: the standard lapse rate need not be the day's; see model/air.hpp.
// Symbols: as in model/air.hpp; f = rho_station R* T / (p M), density over that of the standard's dry ideal gas [-].
// Equations: p = p_b (T / T_b)^-(f g0 M / (R* L)) or p_b exp(-f g0 M (H - H_b) / (R* T_b)); rho = f p M / (R* T).
//   Without station data f = 1 and this is the standard atmosphere itself.
// Source: U.S. Standard Atmosphere, 1976 (NOAA-S/T 76-1562), table 4 and eq. 33a, 33b, 42, 50.
#pragma once

#include "model/conditions.hpp"
#include "physim/air.hpp"

namespace physim {

/// Geometric altitudes between which the standard is defined [m].
inline constexpr double kLowestAltitude = -5000;
inline constexpr double kHighestAltitude = 86000;

/// What a station measures, or the standard's air at its height.
struct StationAir {
  double temperature;  ///< [K]
  double pressure;     ///< [Pa]
};
[[nodiscard]] StationAir station_air(const Environment& environment);

/// The air at an altitude that the standard defines [m].
[[nodiscard]] AirSample air_sample(const Environment& environment, double altitude);

/// The air of an environment; `model` is the granted rung.
[[nodiscard]] Air<double> prepare_air(const Environment& environment, AirModel model);

}  // namespace physim
