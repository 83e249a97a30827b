// Units: what settings measure, and literals such as 168_gr.
#pragma once

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// Quantities: what the numbers of settings measure.

/// The physical quantity of a setting; decides the units that are accepted at the door.
enum class Quantity {
  number,
  length,
  mass,
  time,
  speed,
  angle,
  acceleration,
  force,
  pressure,
  temperature,
  density,
  ballistic_coefficient,
  linear_drag,
  quadratic_drag,
  angular_rate,
  energy,
  frequency,
  stiffness,
  volume,
  attraction,
  moment_of_inertia,
  area,
  jerk,
};
inline constexpr Quantity kLastQuantity = Quantity::jerk;

}  // namespace physim

// ---------------------------------------------------------------------------------------------------------------------
// Unit literals: 168_gr, 800_mps, 2_deg, 0.243_lb_in2. Every literal is a double in SI units, computed by the compiler:
// neither flags nor the rounding mode of the processor change it.

namespace physim::units {

/// The literals of a unit, with and without a decimal point; `si`: one of it in SI.
#define PHYSIM_UNIT(unit, si)                                                                 \
  consteval double operator""_##unit(long double v) { return static_cast<double>(v) * (si); } \
  consteval double operator""_##unit(unsigned long long v) { return static_cast<double>(v) * (si); }
PHYSIM_UNIT(kg, 1.0)  // mass [kg]
PHYSIM_UNIT(g, 1e-3)
PHYSIM_UNIT(gr, 6.479891e-5)     // grain, exact: 64.79891 mg
PHYSIM_UNIT(lb, 0.45359237)      // pound, exact
PHYSIM_UNIT(oz, 0.028349523125)  // ounce, exact
PHYSIM_UNIT(m, 1.0)              // length [m]
PHYSIM_UNIT(mm, 1e-3)
PHYSIM_UNIT(cm, 1e-2)
PHYSIM_UNIT(km, 1e3)
PHYSIM_UNIT(in, 0.0254)
PHYSIM_UNIT(ft, 0.3048)
PHYSIM_UNIT(yd, 0.9144)
PHYSIM_UNIT(mi, 1609.344)
PHYSIM_UNIT(mps, 1.0)  // speed [m/s]
PHYSIM_UNIT(kmh, 1.0 / 3.6)
PHYSIM_UNIT(fps, 0.3048)
PHYSIM_UNIT(mph, 0.44704)
PHYSIM_UNIT(kn, 1852.0 / 3600.0)
PHYSIM_UNIT(rad, 1.0)  // angle [rad]
PHYSIM_UNIT(deg, 3.14159265358979323846 / 180.0)
PHYSIM_UNIT(mrad, 1e-3)
PHYSIM_UNIT(moa, 3.14159265358979323846 / 10800.0)  // minute of angle
PHYSIM_UNIT(s, 1.0)                                 // time [s]
PHYSIM_UNIT(ms, 1e-3)
PHYSIM_UNIT(min, 60.0)
PHYSIM_UNIT(Pa, 1.0)  // pressure [Pa]
PHYSIM_UNIT(hPa, 100.0)
PHYSIM_UNIT(kPa, 1000.0)
PHYSIM_UNIT(inHg, 3386.389)  // inch of mercury at 0 degC
PHYSIM_UNIT(K, 1.0)          // temperature [K]
PHYSIM_UNIT(kg_m2, 1.0)      // ballistic coefficient [kg/m^2]
PHYSIM_UNIT(lb_in2, 0.45359237 / (0.0254 * 0.0254))
PHYSIM_UNIT(kg_m3, 1.0)  // density [kg/m^3]
PHYSIM_UNIT(N, 1.0)      // force [N]
#undef PHYSIM_UNIT

// Temperatures with an offset.
consteval double operator""_degC(long double v) { return static_cast<double>(v) + 273.15; }
consteval double operator""_degC(unsigned long long v) { return static_cast<double>(v) + 273.15; }
consteval double operator""_degF(long double v) { return (static_cast<double>(v) + 459.67) * 5.0 / 9.0; }
consteval double operator""_degF(unsigned long long v) { return (static_cast<double>(v) + 459.67) * 5.0 / 9.0; }

}  // namespace physim::units
