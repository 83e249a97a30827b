// Projectile: what it is (mass, drag, lift, motor, aerodynamic coefficients), and how it is launched.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physim/fidelity.hpp"
#include "physim/math.hpp"

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// DragPoint: one point of a drag curve.

/// One point of a drag curve.
struct DragPoint {
  double mach = 0;         ///< Mach number [-]
  double coefficient = 0;  ///< drag coefficient Cd [-]

  bool operator==(const DragPoint&) const = default;
};

// ---------------------------------------------------------------------------------------------------------------------
// AeroDef: the aerodynamic coefficients of a rigid body, in the conventions of exterior ballistics.

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

/// The normalisation of rates to dimensionless numbers.
enum class RateNorm {
  speed,        ///< p d / V: McCoy, and ballistics since
  twice_speed,  ///< p d / 2V: aircraft, and the NASA check-cases
};

/// The reference frame of the motion that damping opposes.
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

// ---------------------------------------------------------------------------------------------------------------------
// MagnusDef: lift and drag of a ball that spins, by formula or by a table.

/// The second key of a table of coefficients.
enum class SpinMeasure {
  rate,       ///< spin across the path [rad/s]
  parameter,  ///< spin parameter S: speed of the surface over speed through the air [-]
};

/// Drag and lift coefficient at a speed and a spin.
struct MagnusPoint {
  double speed = 0;  ///< through the air [m/s]
  double spin = 0;   ///< as MagnusDef::measure says [rad/s or -]
  double drag = 0;   ///< drag coefficient Cd [-]
  double lift = 0;   ///< lift coefficient Cl [-]

  bool operator==(const MagnusPoint&) const = default;
};

/// Lift and drag of a spinning ball. Without a table: Cl = lift S / (lift_base + lift_saturation S), and the Cd of
/// DragDef plus drag_per_spin times the spin; S = r |omega x u| / u^2. With one: both by the table.
struct MagnusDef {
  double lift = 0;                          ///< 0 without a table: no lift [-]
  double lift_base = 1;                     ///< > 0 [-]
  double lift_saturation = 0;               ///< [-]
  double drag_per_spin = 0;                 ///< added to Cd for each rad/s of spin [s]
  std::vector<MagnusPoint> table{};         ///< every speed with every spin, in any order; straight lines between [-]
  SpinMeasure measure = SpinMeasure::rate;  ///< of the table [-]
  double decay_time = kInfinity;            ///< in which the spin falls to 1/e [s]

  bool operator==(const MagnusDef&) const = default;
};

// ---------------------------------------------------------------------------------------------------------------------
// MotorDef: what pushes a rocket: thrust by a table over time, and the propellant that it burns.

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

/// The burn time [s].
[[nodiscard]] double burn_time(const MotorDef& motor);
/// The integral of the thrust over the burn [N s].
[[nodiscard]] double total_impulse(const MotorDef& motor);
/// Total impulse over the weight of the propellant at standard gravity; 0 without propellant [s].
[[nodiscard]] double specific_impulse(const MotorDef& motor);
/// Thrust at a time since ignition [s]; nothing before and after the burn [N].
[[nodiscard]] double thrust_at(const MotorDef& motor, double time);
/// Propellant left at a time since ignition [s], [kg].
[[nodiscard]] double propellant_left(const MotorDef& motor, double time);

// ---------------------------------------------------------------------------------------------------------------------
// ProjectileDef: what a projectile is. Launch: where, how fast and in which direction it starts.

/// The source of the drag coefficient of the drag equation.
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

/// The properties of a projectile. Every field has one meaning at every fidelity; low fidelities ignore part of it.
/// Worlds change those marked (live) for a projectile in flight (Projectile::set_projectile()).
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
  double zero_range = 0;          ///< > 0: the bore hits the line of sight at this range on the level [m]
  bool zero_in_calm_air = false;  ///< the zero was shot without wind [-]
  double dial = 0;                ///< of the elevation turret: raises the bore above the zero, -pi/2..pi/2 [rad]
};

/// The reference frame of launch angles.
enum class AttitudeFrame {
  bore,   ///< the direction of launch: x along it, z level to the right
  world,  ///< the world frame W
};
/// The reference frame of launch rates.
enum class RateFrame {
  world,     ///< W, which turns with the Earth: as seen from the ground
  inertial,  ///< the fixed stars; the same where W does not turn
};

/// The attitude and angular rates of a rigid body at launch.
struct LaunchAttitude {
  AttitudeFrame frame = AttitudeFrame::bore;  ///< reference of the angles [-]
  double yaw = 0;                             ///< of the nose, to the right, first [rad]
  double pitch = 0;                           ///< of the nose, up, second [rad]
  double roll = 0;                            ///< right side down, third [rad]
  RateFrame rate_frame = RateFrame::world;    ///< reference of the rates [-]
  Vec3d rates{};                              ///< about body axes (x forward, y up, z right), on top of rifling [rad/s]
};

/// The spin of a ball at launch.
struct LaunchSpin {
  double backspin = 0;  ///< lifts it; negative: topspin [rad/s]
  double sidespin = 0;  ///< turns its path to the right [rad/s]
  double gyrospin = 0;  ///< about its path, clockwise seen from behind; its axis stays, see magnus.md [rad/s]

  bool operator==(const LaunchSpin&) const = default;
};

/// The launch of a projectile: its place, speed and direction.
struct Launch {
  Vec3d position{};                 ///< of the muzzle in the world frame W: x downrange, y up, z right [m]
  double speed = 0;                 ///< [m/s]
  double elevation = 0;             ///< of the bore above the horizon, before cant; 0 with a zero range [rad]
  double azimuth = 0;               ///< of the plane of fire, from x towards z (to the right) [rad]
  std::optional<Vec3d> velocity{};  ///< instead of speed, elevation and azimuth [m/s]
  double rail_length = 0;           ///< it moves only forwards along the bore over this way; 0: no rail [m]
  Sight sight{};                    ///< line of sight [-]
  LaunchAttitude attitude{};        ///< of rigid bodies [-]
  LaunchSpin spin{};                ///< of balls [-]
};

// ---------------------------------------------------------------------------------------------------------------------
// Drag coefficients by Mach number, for tools and tests.

/// The published points of a standard drag function; empty for constant, sphere and custom.
[[nodiscard]] std::span<const DragPoint> drag_points(DragTable table);
/// The drag coefficient [-] that a projectile's drag data give at a Mach number [-] (tables, custom curve, constant).
/// NaN where they give no curve: no points, or points that do not rise.
[[nodiscard]] double drag_coefficient(const DragDef& drag, Interpolation interpolation, double mach);
/// The drag coefficient of a smooth sphere [-] at a Reynolds number [-] (Morrison 2013).
[[nodiscard]] double sphere_drag_coefficient(double reynolds);

}  // namespace physim
