// Equations, symbols and Source: model/humid_air.hpp.
#include "model/humid_air.hpp"

#include "base/ieee_mode.hpp"
#include "physim/environment.hpp"

namespace physim {

double moist_air_density(double temperature, double pressure, double humidity) {
  const IeeeMode mode;
  return moist_density(temperature, pressure, humidity);
}

double moist_air_sound_speed(double temperature, double pressure, double humidity) {
  const IeeeMode mode;
  return moist_sound_speed(temperature, pressure, humidity);
}

}  // namespace physim
