// A rocket and a motor whose flights have closed forms, for tests of motors and rails.
#pragma once

#include "support.hpp"

namespace physim::test {

inline constexpr double kG = 9.80665;
inline constexpr double kFar = 1e9;  // a rail that does not end

/// 10 kg, of which 4 kg burn in 5 s at 300 N: an exhaust velocity of 375 m/s.
inline constexpr double kMass = 10, kPropellant = 4, kThrust = 300, kBurn = 5;
inline constexpr double kFlow = kPropellant / kBurn, kExhaust = kThrust / kFlow;

inline ProjectileDef rocket() {
  return {.mass = kMass, .motor = {.thrust = {{0, kThrust}, {kBurn, kThrust}}, .propellant_mass = kPropellant}};
}

/// 20 N s in 1.9 s, in the shape of a model rocket's motor; its points are multiples of no usual step.
inline MotorDef peaked_motor() {
  return {
      .thrust = {{0, 0}, {0.0317, 0.95}, {0.2371, 28.1}, {0.3113, 14.3}, {0.7173, 9.7}, {1.5791, 10.1}, {1.8937, 0}},
      .propellant_mass = 0.0108};
}

inline double tsiolkovsky_speed(double t) { return kExhaust * std::log(kMass / (kMass - kFlow * t)); }
inline double tsiolkovsky_way(double t) {
  const double m = kMass - kFlow * t;
  return kExhaust * (t - m / kFlow * std::log(kMass / m));
}

inline Fidelity weightless(Integrator integrator) {
  Fidelity f = vacuum(integrator);
  f.gravity = GravityModel::off;
  return f;
}

}  // namespace physim::test
