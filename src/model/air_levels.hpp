// The air of a sounding: temperature, pressure and humidity by levels.
//
// What it models: between two levels temperature changes linearly with geopotential height, and density follows the
//   hydrostatic law of that temperature, with a factor exp(c H) that meets the density of both levels: measured
//   pressures need not be in hydrostatic equilibrium. The pressure of a level that has none follows from the level
//   below. Below the first level and above the last one temperature changes as the standard's does, in hydrostatic
//   equilibrium; below it is as humid as the first level, and dry from 100 m above the last one.
// When to use it: wherever a radiosonde or a forecast gives the day's air; inversions and cold tropopauses are in it.
// When it is wrong: the day's air changes with time and place; what lies between levels is not known.
// Symbols: H geopotential height [m]; T temperature [K]; s sound speed over that of dry air [-]; T_s = T s^2 the
//   temperature of dry air of that sound speed [K]; p pressure [Pa]; rho density [kg/m^3]; f density over that of the
//   standard's dry ideal gas [-]; L = dT_s/dH [K/m]; g0, M, R* those of the standard; index b: at the lower level.
// Equations: T_s = T_sb + L (H - H_b);  k = f s^2 g0 M / R*, the mean of both levels;
//   rho = rho_b (T_s / T_sb)^(-1 - k / L) exp(c (H - H_b)), c from rho at the upper level;
//   p = p_b (T_s / T_sb)^(-k / L) where a level has no pressure; a = a_b sqrt(T_s / T_sb).
// Source: U.S. Standard Atmosphere, 1976 (NOAA-S/T 76-1562), eq. 33a and 33b for a layer; CIPM-2007 for f
//   (model/humid_air.hpp). WMO-No. 8 (2018), ch. 12: radiosondes give such levels.
#pragma once

#include <vector>

#include "model/conditions.hpp"
#include "physim/environment.hpp"

namespace physim {

/// A level with what follows from its temperature, pressure and humidity.
struct AirLevel {
  double height = 0;       // geopotential [m]
  double temperature = 0;  // [K]
  double pressure = 0;     // [Pa]
  double humidity = 0;     // relative [-]
  double density = 0;      // [kg/m^3]
  double sound_speed = 0;  // [m/s]
  double hydrostatic = 0;  // k [K/m]
};

/// The levels of a profile, with those of the standard below and above, and more where temperature changes by over a
/// quarter between two; none without a profile.
[[nodiscard]] std::vector<AirLevel> air_levels(const Atmosphere& atmosphere);
/// The layer above the i-th level; above the last one air has its temperature.
[[nodiscard]] AirLayer<double> layer_above(const std::vector<AirLevel>& levels, std::size_t i);
/// The fall of the logarithm of pressure from one level to another in hydrostatic equilibrium [-].
[[nodiscard]] double balanced_fall(const AirLevel& low, const AirLevel& high);
/// The air at a geopotential height, by these layers [m].
[[nodiscard]] AirLevel air_between(const std::vector<AirLevel>& levels, double height);

}  // namespace physim
