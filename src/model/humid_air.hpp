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

#include <type_traits>

#include "math/elementary.hpp"

namespace physim {

inline constexpr double kMolarGasConstant = 8.314472;     // the value of CIPM-2007 [J/(mol K)]
inline constexpr double kDryMolarMass = 28.96546e-3;      // M_a with 400 ppm CO2 [kg/mol]
inline constexpr double kWaterMolarMass = 18.01528e-3;    // M_v [kg/mol]
inline constexpr double kStandardGasConstant = 8.31432;   // of US Standard Atmosphere 1976 [J/(mol K)]
inline constexpr double kStandardMolarMass = 28.9644e-3;  // [kg/mol]
inline constexpr double kStandardHeatRatio = 1.4;         // gamma of dry air [-]

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Mole fraction of water vapour [-].
template <class R>
PHYSIM_INLINE R vapour_fraction(const R& temperature, const std::type_identity_t<R>& pressure,
                                const std::type_identity_t<R>& humidity) {
  if (!any(humidity != R(0.0))) return R(0.0);  // what follows would give as much
  const R t = temperature - R(273.15);
  const R saturation = exp(R(1.2378847e-5) * temperature * temperature - R(1.9121316e-2) * temperature +
                           R(33.93711047) - R(6.3431645e3) / temperature);
  const R enhancement = R(1.00062) + R(3.14e-8) * pressure + R(5.6e-7) * t * t;
  return humidity * enhancement * saturation / pressure;
}

/// Z.
template <class R>
PHYSIM_INLINE R compressibility(const R& temperature, const R& pressure, const R& x_v) {
  const R t = temperature - R(273.15);
  const R first = R(1.58123e-6) + t * (R(-2.9331e-8) + t * R(1.1043e-10)) + (R(5.707e-6) - R(2.051e-8) * t) * x_v +
                  (R(1.9898e-4) - R(2.376e-6) * t) * x_v * x_v;
  const R ratio = pressure / temperature;
  return R(1.0) - ratio * first + ratio * ratio * (R(1.83e-11) - R(0.765e-8) * x_v * x_v);
}

/// Density over that of the standard's dry ideal gas of the same temperature and pressure [-].
template <class R>
PHYSIM_INLINE R density_over_ideal(const R& temperature, const R& pressure, const R& x_v) {
  constexpr double kDry = kDryMolarMass * kStandardGasConstant / (kMolarGasConstant * kStandardMolarMass);
  return R(kDry) * (R(1.0) - x_v * R(1 - kWaterMolarMass / kDryMolarMass)) /
         compressibility(temperature, pressure, x_v);
}

/// Sound speed over that of the standard's dry air of the same temperature [-].
template <class R>
PHYSIM_INLINE R sound_over_dry(const R& x_v) {
  if (!any(x_v != R(0.0))) return R(1.0);                  // what follows would give as much
  const R heat = R(3.5) * (R(1.0) - x_v) + R(4.04) * x_v;  // c_p / R
  const R mass = (R(1.0) - x_v) + R(kWaterMolarMass / kStandardMolarMass) * x_v;
  return sqrt(heat / (heat - R(1.0)) / R(kStandardHeatRatio) / mass);
}

/// [kg/m^3]
template <class R>
PHYSIM_INLINE R moist_density(const R& temperature, const R& pressure, const R& humidity) {
  const R x_v = vapour_fraction(temperature, pressure, humidity);
  return density_over_ideal(temperature, pressure, x_v) * pressure * R(kStandardMolarMass) /
         (R(kStandardGasConstant) * temperature);
}

/// [m/s]
template <class R>
PHYSIM_INLINE R moist_sound_speed(const R& temperature, const R& pressure, const R& humidity) {
  const R dry = sqrt(R(kStandardHeatRatio * kStandardGasConstant) * temperature / R(kStandardMolarMass));
  return sound_over_dry(vapour_fraction(temperature, pressure, humidity)) * dry;
}

PHYSIM_ISA_END
