// ProjectileDef: what a projectile is. Launch: where, how fast and in which direction it starts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physim/aero.hpp"
#include "physim/drag_point.hpp"
#include "physim/fidelity.hpp"
#include "physim/infinity.hpp"
#include "physim/magnus.hpp"
#include "physim/motor.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// Where the drag coefficient of the drag equation comes from.
enum class DragTable {
  constant,  ///< DragDef::coefficient at every speed
  g1,        ///< the standard drag functions, Cd by Mach number
  g2,
  g5,
  g6,
  g7,
  g8,
  gi,
  gs,
  ra4,
  sphere,  ///< smooth sphere, Cd by Reynolds number (Morrison 2013)
  custom,  ///< DragDef::curve
};

/// The ballistic coefficient from a speed upwards.
struct BallisticBand {
  double above = 0;                  ///< air speed from which the band holds [m/s]
  double ballistic_coefficient = 0;  ///< BC = m / (i d^2) [kg/m^2]

  bool operator==(const BallisticBand&) const = default;
};

/// Data of all drag models; each rung reads its own part.
struct DragDef {
  DragTable table = DragTable::constant;  ///< source of Cd [-]
  double coefficient = 0.5;               ///< Cd of DragTable::constant [-]
  std::vector<DragPoint> curve{};         ///< of DragTable::custom; Mach strictly rising, held constant outside [-]
  double ballistic_coefficient = 0;       ///< BC = m / (i d^2); 0: from mass, diameter and form_factor [kg/m^2]
  std::vector<BallisticBand> bands{};     ///< BC by speed instead of one value, at most 8 [kg/m^2]
  double form_factor = 1;                 ///< i: Cd of the projectile over Cd of the table [-]
  double damping = 1;                     ///< part of the velocity kept after one second, 0 < d <= 1 [-]
  double k1 = 0;                          ///< linear drag: F = -(k1 + k2 |v|) v [kg/s]
  double k2 = 0;                          ///< quadratic drag; 0 with k1 = 0: from the drag equation at launch [kg/m]

  bool operator==(const DragDef&) const = default;
};

/// Moments of inertia about the centre of mass, along body axes: x forward, y up, z right. All 0: not known, and no
/// rigid body. A product is that of the tensor with its sign: Ixy = -integral of x y dm.
struct Inertia {
  Vec3d moments{};   ///< Ixx, Iyy, Izz [kg m^2]
  Vec3d products{};  ///< Ixy, Ixz, Iyz [kg m^2]

  bool operator==(const Inertia&) const = default;
};

/// What a projectile is. Every field has one meaning at every fidelity; low fidelities ignore part of it. Worlds change
/// those marked (live) for a projectile in flight (Projectile::set_projectile()).
struct ProjectileDef {
  std::string name{};                 ///< for tables and plots [-]
  double mass = 1;                    ///< (live) at launch, the propellant of a motor included [kg]
  double diameter = 0.1;              ///< (live) reference diameter: the reference area is pi d^2 / 4 [m]
  double length = 0;                  ///< for the stability factor; 0: not known [m]
  double twist = 0;                   ///< rifling, length of one turn, positive right-handed; 0: no spin [m]
  DragDef drag{};                     ///< (live) data of the drag models [-]
  MagnusDef magnus{};                 ///< of balls that spin [-]
  Inertia inertia{};                  ///< of rigid bodies [-]
  AeroDef aero{};                     ///< of rigid bodies, beside drag at zero yaw [-]
  double gravity_scale = 1;           ///< times gravity at every door; 0: none, below 0: it rises [-]
  Vec3d force{};                      ///< a constant force on the projectile, such as thrust [N]
  double force_duration = kInfinity;  ///< the force acts from launch for this long [s]
  MotorDef motor{};                   ///< pushes it along; empty thrust: none [-]
  Fidelity fidelity{};                ///< used where a call gives none [-]

  bool operator==(const ProjectileDef&) const = default;
};

/// The line of sight of the launcher. Range, drop and windage are measured along, above and right of it.
struct Sight {
  double height = 0;              ///< of the sight above the bore at the muzzle [m]
  double look_angle = 0;          ///< of the line of sight above the horizon [rad]
  double cant = 0;                ///< roll of launcher and sight, clockwise seen from behind [rad]
  double zero_range = 0;          ///< > 0: the bore is elevated to hit the line of sight at this range [m]
  bool zero_in_calm_air = false;  ///< the zero was shot without wind [-]
};

/// What launch angles are measured from.
enum class AttitudeFrame {
  bore,   ///< the direction of launch: x along it, z level to the right
  world,  ///< the world frame W
};
/// Which frame launch rates are seen from.
enum class RateFrame {
  world,     ///< W, which turns with the Earth: as seen from the ground
  inertial,  ///< the fixed stars; the same where W does not turn
};

/// How a rigid body points and turns at launch.
struct LaunchAttitude {
  AttitudeFrame frame = AttitudeFrame::bore;  ///< what the angles are measured from [-]
  double yaw = 0;                             ///< of the nose, to the right, first [rad]
  double pitch = 0;                           ///< of the nose, up, second [rad]
  double roll = 0;                            ///< right side down, third [rad]
  RateFrame rate_frame = RateFrame::world;    ///< which frame the rates are seen from [-]
  Vec3d rates{};                              ///< about body axes (x forward, y up, z right), on top of rifling [rad/s]
};

/// The spin of a ball at launch.
struct LaunchSpin {
  double backspin = 0;  ///< lifts it; negative: topspin [rad/s]
  double sidespin = 0;  ///< turns its path to the right [rad/s]
  double gyrospin = 0;  ///< about its path, clockwise seen from behind; lifts nothing [rad/s]

  bool operator==(const LaunchSpin&) const = default;
};

/// Where, how fast and in which direction a projectile starts.
struct Launch {
  Vec3d position{};                 ///< of the muzzle in the world frame W: x downrange, y up, z right [m]
  double speed = 0;                 ///< [m/s]
  double elevation = 0;             ///< of the bore above the horizon, before cant; 0 with a zero range [rad]
  double azimuth = 0;               ///< of the plane of fire, from x towards z (to the right) [rad]
  std::optional<Vec3d> velocity{};  ///< instead of speed, elevation and azimuth [m/s]
  double rail_length = 0;           ///< it moves only forwards along the bore until it has come so far; 0: no rail [m]
  Sight sight{};                    ///< line of sight [-]
  LaunchAttitude attitude{};        ///< of rigid bodies [-]
  LaunchSpin spin{};                ///< of balls [-]
};

}  // namespace physim
