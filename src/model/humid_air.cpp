// Equations, symbols and Source: model/humid_air.hpp.
#include "model/humid_air.hpp"

#include "base/ieee_mode.hpp"
#include "math/elementary.hpp"

namespace physim {
namespace {

constexpr double kMolarGasConstant = 8.314472;     // the value of CIPM-2007 [J/(mol K)]
constexpr double kDryMolarMass = 28.96546e-3;      // M_a with 400 ppm CO2 [kg/mol]
constexpr double kWaterMolarMass = 18.01528e-3;    // M_v [kg/mol]
constexpr double kStandardGasConstant = 8.31432;   // of US Standard Atmosphere 1976 [J/(mol K)]
constexpr double kStandardMolarMass = 28.9644e-3;  // [kg/mol]

double compressibility(double kelvin, double pressure, double x_v) {
  const double t = kelvin - 273.15;
  const double first = 1.58123e-6 + t * (-2.9331e-8 + t * 1.1043e-10) + (5.707e-6 - 2.051e-8 * t) * x_v +
                       (1.9898e-4 - 2.376e-6 * t) * x_v * x_v;
  const double ratio = pressure / kelvin;
  return 1 - ratio * first + ratio * ratio * (1.83e-11 - 0.765e-8 * x_v * x_v);
}

}  // namespace

double vapour_fraction(double temperature, double pressure, double humidity) {
  const double t = temperature - 273.15;
  const double saturation = exp(1.2378847e-5 * temperature * temperature - 1.9121316e-2 * temperature + 33.93711047 -
                                6.3431645e3 / temperature);
  const double enhancement = 1.00062 + 3.14e-8 * pressure + 5.6e-7 * t * t;
  return humidity * enhancement * saturation / pressure;
}

double moist_air_density(double temperature, double pressure, double humidity) {
  const IeeeMode mode;
  const double x_v = vapour_fraction(temperature, pressure, humidity);
  const double z = compressibility(temperature, pressure, x_v);
  return pressure * kDryMolarMass / (z * kMolarGasConstant * temperature) *
         (1 - x_v * (1 - kWaterMolarMass / kDryMolarMass));
}

double moist_air_sound_speed(double temperature, double pressure, double humidity) {
  const IeeeMode mode;
  const double x_v = vapour_fraction(temperature, pressure, humidity);
  const double heat = 3.5 * (1 - x_v) + 4.04 * x_v;  // c_p / R
  const double molar_mass = kStandardMolarMass * (1 - x_v) + kWaterMolarMass * x_v;
  return sqrt(heat / (heat - 1) * kStandardGasConstant * temperature / molar_mass);
}

}  // namespace physim
