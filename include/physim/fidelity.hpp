// Fidelity: which model each effect uses. Raising it never changes the data of a projectile or its environment.
#pragma once

#include <string>
#include <string_view>
#include <vector>
#include "physim/math.hpp"

namespace physim {

/// The form of the equations of motion.
enum class Motion {
  closed_form,  ///< exact formulas: vacuum, or drag linear in velocity
  velocity,     ///< constants act directly on the velocity: constant gravity and damping, no forces
  force,        ///< the resultant of all forces, divided by mass
};

/// The time integration of the equations of motion.
enum class Integrator {
  classic,              ///< the original PhySim frame loop: position, then velocity, then damping
  explicit_euler,       ///< order 1
  semi_implicit_euler,  ///< order 1, symplectic; what most game engines do
  heun,                 ///< order 2
  rk4,                  ///< order 4, fixed step
  rk43,                 ///< order 4, adaptive (Sofroniou and Spaletta 2004)
  tsit5,                ///< order 5, adaptive (Tsitouras 2011), dense output of order 4
  dop853,               ///< order 8, adaptive (Dormand and Prince 8(5,3)), dense output of order 7
  automatic,  ///< as adaptive in single flights, which choose their steps; semi_implicit_euler in worlds: their
              ///< frames are given, and in flights with Tolerance::step
  adaptive,   ///< rk43 for points; tsit5 for bodies that turn, whose evaluations are dear
};

enum class GravityModel {
  off,
  constant,        ///< the same everywhere
  inverse_square,  ///< Newton's law: falls with the square of the distance from the Earth's centre
  j2,              ///< a point mass and the Earth's flattening, J2
  wgs84,           ///< normal gravity of the ellipsoid WGS-84, exact at every height
};

enum class DragModel {
  off,
  damping,           ///< velocity through the air decays to the part `damping` per second: a = ln(damping) v
  linear_quadratic,  ///< F = -(k1 + k2 |v|) v
  equation,          ///< F = -1/2 rho |v| v Cd A, with Cd constant, by Reynolds number or by Mach number
};

enum class AirModel {
  vacuum,
  constant,     ///< the air at the origin, everywhere
  exponential,  ///< density falls by e per scale height; sound speed constant
  isa,          ///< US Standard Atmosphere 1976, shifted to the station's temperature, pressure and humidity
};

enum class WindModel {
  off,
  constant,
  profile,  ///< by height or by range
};

enum class EarthModel {
  flat,             ///< not rotating
  flat_coriolis,    ///< flat, with the Coriolis acceleration -2 Omega x v
  sphere,           ///< round, not rotating; heights are above the sphere and gravity points to its centre
  sphere_rotating,  ///< the same, turning: W, the air and the wind turn with it
  ellipsoid,        ///< WGS-84, turning: heights are above the ellipsoid
};

enum class RotationModel {
  none,
  spin_drift,           ///< Litz's empirical spin drift with Miller's stability factor; added to the flown path
  magnus,               ///< lift and drag of balls that spin
  modified_point_mass,  ///< spinning shells in their yaw of repose; only the spin is flown with the point (STANAG 4355)
  rigid_body,           ///< six degrees of freedom: the attitude is flown too
  automatic_point,      ///< the truest above that the projectile's data allow, but no rigid body
  automatic,            ///< the truest that the projectile's data allow
};

/// The formulation of the attitude of a rigid body.
enum class BodyForm {
  automatic,   ///< `axis` for bodies that are symmetric about their x axis and have rifling, `quaternion` else
  quaternion,  ///< quaternion and body rates: any body; steps must resolve its spin
  axis,        ///< symmetry axis and angular momentum: steps need not resolve the spin, only the axis' motion
};

/// The interpolation between the points of a drag curve.
enum class Interpolation {
  linear,  ///< straight lines; adaptive integrators stop at every point of the curve
  pchip,   ///< monotone cubic (Fritsch and Butland): smooth slope, no overshoot
  cubic,   ///< natural cubic spline: smooth curvature, best for high-order integrators
};

enum class Precision { float32, float64 };

PHYSIM_UNORDERED(Motion)
PHYSIM_UNORDERED(Integrator)
PHYSIM_UNORDERED(GravityModel)
PHYSIM_UNORDERED(DragModel)
PHYSIM_UNORDERED(AirModel)
PHYSIM_UNORDERED(WindModel)
PHYSIM_UNORDERED(EarthModel)
PHYSIM_UNORDERED(RotationModel)
PHYSIM_UNORDERED(BodyForm)
PHYSIM_UNORDERED(Interpolation)
PHYSIM_UNORDERED(Precision)

/// The rung of the ladder that each effect stands on; as it begins, small_arms().
struct Fidelity {
  Motion motion = Motion::force;                            ///< equations of motion [-]
  Integrator integrator = Integrator::adaptive;             ///< time stepping [-]
  GravityModel gravity = GravityModel::constant;            ///< gravity [-]
  DragModel drag = DragModel::equation;                     ///< drag [-]
  AirModel air = AirModel::isa;                             ///< air density and sound speed [-]
  WindModel wind = WindModel::profile;                      ///< wind [-]
  EarthModel earth = EarthModel::flat;                      ///< shape and rotation of the Earth [-]
  RotationModel rotation = RotationModel::automatic_point;  ///< effects of the projectile's spin [-]
  BodyForm body_form = BodyForm::automatic;                 ///< of RotationModel::rigid_body [-]
  Precision precision = Precision::float64;                 ///< number type of the computation [-]
  Interpolation interpolation = Interpolation::pchip;       ///< of drag curves [-]
  double tolerance = 1e-8;  ///< of adaptive integrators, relative, if Tolerance::relative is not given; 1e-15 at least,
                            ///< in float32 2e-6; 0: 1e-9, in float32 2e-6 [-]
  bool planar = false;      ///< confine the flight to the vertical plane of fire [-]
  bool aerodynamic_jump = false;  ///< with RotationModel::spin_drift: Litz's deflection by crosswind at the muzzle [-]
  bool original_one_shot_forces = false;  ///< classic only: applied forces act for one frame and never stop [-]

  bool operator==(const Fidelity&) const = default;

  static Fidelity arcade();        ///< closed form, vacuum, float32
  static Fidelity game();          ///< k1 k2 drag and lift by spin in constant air and wind, float32
  static Fidelity constant_air();  ///< drag equation, lift by spin or a shell's drift, in constant air and wind
  static Fidelity small_arms();    ///< the same in the standard atmosphere and any wind
  static Fidelity artillery();     ///< as small arms, with Newton's gravity and Coriolis
  static Fidelity simulation();    ///< every effect over a flat Earth, bodies in six degrees of freedom
  static Fidelity reference();     ///< simulation by the integrator of order 8, as exact as doubles allow
  static Fidelity classic();       ///< the original PhySim loop, float32

  [[deprecated("its name is constant_air()")]] static Fidelity sport_ball() { return constant_air(); }
};

/// The rotation is part of what is flown: a flight knows where the projectile points and how fast it turns.
PHYSIM_INLINE constexpr bool turns(const Fidelity& f) {
  switch (f.rotation) {
    case RotationModel::none:
    case RotationModel::spin_drift:
    case RotationModel::magnus:
    case RotationModel::automatic_point:
    case RotationModel::automatic: return false;  // as asked; what is granted is one of the others
    case RotationModel::modified_point_mass:
    case RotationModel::rigid_body: return true;
  }
  return false;
}

/// Description of a rung of the ladder.
struct RungInfo {
  std::string_view name{};  ///< as its enumerator is spelled [-]
  std::string_view doc{};   ///< one line [-]
  int level = 0;            ///< its place among the rungs of its effect, from cheap to true [-]
};

/// One answer of fidelity_in_use(): what was asked for, what was granted, and why they differ.
struct FidelityNote {
  std::string effect{};   ///< field of Fidelity, "drag", or the setting it is about, "until.ground" [-]
  std::string asked{};    ///< "equation" [-]
  std::string granted{};  ///< "off" [-]
  std::string reason{};   ///< one sentence [-]
};

/// The fidelity that a flight really used.
struct FidelityInUse {
  Fidelity fidelity{};                ///< as granted [-]
  std::vector<FidelityNote> notes{};  ///< one for each field that differs from what was asked [-]
};

}  // namespace physim
