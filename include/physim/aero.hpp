// AeroDef: the aerodynamic coefficients of a rigid body, in the conventions of exterior ballistics.
#pragma once

#include <vector>

#include "physim/vec3.hpp"

namespace physim {

/// One point of a coefficient. Between Mach numbers straight lines; held outside. Only Magnus coefficients may have
/// several angles at a Mach number: straight lines in the square of the angle first, then in Mach.
struct AeroPoint {
  double mach = 0;           ///< Mach number [-]
  double angle_squared = 0;  ///< square of the total angle of attack [rad^2]
  double value = 0;          ///< of the coefficient there [-]

  bool operator==(const AeroPoint&) const = default;
};

/// A coefficient: none: 0; one point: constant; else at rising Mach numbers, rising angles at each.
using AeroCoefficient = std::vector<AeroPoint>;

/// What rates are made dimensionless by.
enum class RateNorm {
  speed,        ///< p d / V: McCoy, and ballistics since
  twice_speed,  ///< p d / 2V: aircraft, and the NASA check-cases
};

/// Which motion of a body its damping is against.
enum class DampingFrame {
  air,       ///< against the air, which turns with the Earth
  inertial,  ///< against the fixed stars
};

/// Aerodynamics of a rigid body beside its drag at zero yaw, which is that of DragDef at every fidelity. s is the sine
/// of the total angle of attack, q the dynamic pressure, S the area, d the length, p the spin; rates as rate_norm says.
struct AeroDef {
  double area = 0;                       ///< S; 0: pi/4 diameter^2 [m^2]
  double length = 0;                     ///< d, of pitching and yawing moments and of Magnus; 0: the diameter [m]
  double span = 0;                       ///< of rolling and yaw damping; 0: the length [m]
  RateNorm rate_norm = RateNorm::speed;  ///< [-]
  DampingFrame damping_frame = DampingFrame::air;  ///< [-]
  AeroCoefficient drag_yaw{};                      ///< CDd2: drag q S CDd2 s^2 on top of that at zero yaw [-]
  AeroCoefficient lift{};                          ///< CLa0: lift q S (CLa0 + CLa2 s^2) s towards the nose [-]
  AeroCoefficient lift_cubic{};                    ///< CLa2 [-]
  AeroCoefficient pitching{};        ///< CMa0: moment q S d (CMa0 + CMa2 s^2) s, positive away from the path [-]
  AeroCoefficient pitching_cubic{};  ///< CMa2 [-]
  AeroCoefficient pitch_damping{};   ///< CMq + CMadot, negative where it damps [-]
  AeroCoefficient yaw_damping{};     ///< Cnr; none: as pitch_damping, of the length instead of the span [-]
  AeroCoefficient roll_damping{};    ///< Clp, negative where it damps [-]
  AeroCoefficient magnus_force{};    ///< CNpa: force q S CNpa (p d / V) s across the plane of yaw [-]
  AeroCoefficient magnus_moment{};   ///< CMpa: moment q S d CMpa (p d / V) s [-]

  bool operator==(const AeroDef&) const = default;
};

}  // namespace physim
