// MotorDef: what pushes a rocket: thrust by a table over time, and the propellant that it burns.
#pragma once

#include <string>
#include <vector>

#include "physim/drag_point.hpp"

namespace physim {

/// Thrust at a time; straight lines between points, a step where two points have one time.
struct ThrustPoint {
  double time = 0;   ///< since ignition [s]
  double force = 0;  ///< [N]

  bool operator==(const ThrustPoint&) const = default;
};

/// Propellant left at a time; straight lines between points.
struct PropellantPoint {
  double time = 0;  ///< since ignition [s]
  double mass = 0;  ///< [kg]

  bool operator==(const PropellantPoint&) const = default;
};

/// A rocket motor. It burns once, from its ignition to the last point of its thrust.
struct MotorDef {
  std::string name{};                 ///< for tables [-]
  std::vector<ThrustPoint> thrust{};  ///< times rising from 0, at most 1000 points; empty: no motor [N]
  double propellant_mass = 0;         ///< burned in all; part of ProjectileDef::mass [kg]
  std::vector<PropellantPoint>
      propellant{};                     ///< left by time, propellant_mass to 0; empty: falls with the impulse [kg]
  double ignition_delay = 0;            ///< from launch to ignition [s]
  double drag_factor = 1;               ///< times the drag while it burns [-]
  std::vector<DragPoint> drag_curve{};  ///< Cd by Mach number while it burns; empty: that of the projectile [-]

  bool operator==(const MotorDef&) const = default;
};

/// How long it burns [s].
[[nodiscard]] double burn_time(const MotorDef& motor);
/// The integral of the thrust over the burn [N s].
[[nodiscard]] double total_impulse(const MotorDef& motor);
/// Total impulse over the weight of the propellant at standard gravity; 0 without propellant [s].
[[nodiscard]] double specific_impulse(const MotorDef& motor);
/// Thrust at a time since ignition [s]; nothing before and after the burn [N].
[[nodiscard]] double thrust_at(const MotorDef& motor, double time);
/// Propellant left at a time since ignition [s], [kg].
[[nodiscard]] double propellant_left(const MotorDef& motor, double time);

}  // namespace physim
