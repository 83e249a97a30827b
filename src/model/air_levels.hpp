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

/// A level with all that is known of it.
struct AirLevel {
  double height;       // geopotential [m]
  double temperature;  // [K]
  double pressure;     // [Pa]
  double humidity;     // relative [-]
  double density;      // [kg/m^3]
  double sound_speed;  // [m/s]
};

/// The levels of a profile that has some, with those of the standard below and above; more of them where temperature
/// changes by over a quarter between two.
[[nodiscard]] std::vector<AirLevel> air_levels(const Atmosphere& atmosphere);
/// The layer above each of some levels, above the last one with its temperature.
[[nodiscard]] std::vector<AirLayer<double>> air_layers(const std::vector<AirLevel>& levels);
/// The fall of the logarithm of pressure from a level up to the next one in hydrostatic equilibrium [-].
[[nodiscard]] double balanced_fall(const AirLevel& low, const AirLevel& high);
/// The air at a geopotential height, by these layers [m].
[[nodiscard]] AirLevel air_between(const std::vector<AirLevel>& levels, double height);

}  // namespace physim
