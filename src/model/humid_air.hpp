// Density and sound speed of moist air.
//
// What it models: density by the CIPM-2007 formula with 400 ppm CO2; sound speed of a mixture of ideal gases.
// When to use it: to turn a weather station's readings into air for a range card.
// When it is wrong: CIPM-2007 is an interlaboratory formula for 600-1100 hPa and 15-27 degC; outside it stays within
//   about 0.1 % from -20 to 45 degC. Sound speed leaves out real-gas effects (below 0.1 %).
// Symbols: T temperature [K], t in degC; p pressure [Pa]; h relative humidity [-]; p_sv saturation vapour pressure
//   [Pa]; f enhancement factor [-]; x_v mole fraction of water vapour [-]; Z compressibility [-]; M_a, M_v molar masses
//   of dry air and water [kg/mol]; R molar gas constant [J/(mol K)]; gamma ratio of specific heats [-].
// Equations: rho = p M_a / (Z R T) (1 - x_v (1 - M_v / M_a));  x_v = h f p_sv / p;  a = sqrt(gamma R T / M),
//   gamma = c_p / (c_p - R), c_p / R = 3.5 (1 - x_v) + 4.04 x_v.
// Source: A. Picard, R. S. Davis, M. Glaeser, K. Fujii, "Revised formula for the density of moist air (CIPM-2007)",
//   Metrologia 45 (2008) 149-155, eq. 1 and appendices A1, A2; vapour c_p: ideal-gas value of steam at 20 degC.
#pragma once

#include "physim/air.hpp"

namespace physim {

/// Mole fraction of water vapour [-].
[[nodiscard]] double vapour_fraction(double temperature, double pressure, double humidity);

}  // namespace physim
