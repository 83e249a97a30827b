// The air of an environment at one place, for tools and tests.
#pragma once

#include "physim/environment.hpp"
#include "physim/result.hpp"

namespace physim {

/// The state of the air at one height.
struct AirSample {
  double temperature = 0;  ///< [K]
  double pressure = 0;     ///< [Pa]
  double density = 0;      ///< [kg/m^3]
  double sound_speed = 0;  ///< [m/s]
  double viscosity = 0;    ///< dynamic [Pa s]
};

/// The air at a geometric altitude above sea level [m], from -5 km to 86 km.
[[nodiscard]] Result<AirSample> air_at(const Environment& environment, double altitude);

/// Density of moist air [kg/m^3] by CIPM-2007 at a temperature [K], pressure [Pa] and relative humidity 0..1 [-].
[[nodiscard]] double moist_air_density(double temperature, double pressure, double humidity);
/// Speed of sound in moist air [m/s].
[[nodiscard]] double moist_air_sound_speed(double temperature, double pressure, double humidity);

}  // namespace physim
