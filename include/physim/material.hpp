// Material: what a surface is made of, and what it does to what hits it.
#pragma once

#include <string>
#include <variant>

namespace physim {

/// How a surface throws off what meets it flat (docs/models/ricochet.md). By itself: it throws nothing off.
struct RicochetDef {
  double critical_angle = 0;  ///< from the surface; what comes in flatter is thrown off; 0 to below pi/2 [rad]
  double restitution = 0;     ///< part of the speed along the normal that is left, 0 to 1 [-]
  double friction = 0;        ///< impulse along the surface over that along the normal [-]
  bool liquid = false;        ///< angle and loss are those of spheres off a liquid of Material::density; the three
                              ///< numbers above are not looked at [-]

  bool operator==(const RicochetDef&) const = default;
};

// How deep a projectile goes, and with which speed it comes out behind.

/// Nothing goes in.
struct ImpenetrableDef {
  bool operator==(const ImpenetrableDef&) const = default;
};
/// A resistance that does not change with depth: wood, concrete, soil, liquids (docs/models/poncelet.md).
struct PonceletDef {
  double strength = 0;  ///< resistance to what moves slowly; 0: a liquid, which stops nothing [Pa]
  double inertia = 0;   ///< resistance by the speed is inertia N density v^2, N by the nose; solids 1, liquids 1/2 [-]
  double crater = 0;    ///< depth over which the resistance grows from 0, in diameters; concrete 2 [-]

  bool operator==(const PonceletDef&) const = default;
};
/// Soil, rock and concrete hit by heavy penetrators (docs/models/young.md).
struct YoungDef {
  double s_number = 0;  ///< penetrability: concrete about 1, soils more; above 0 [-]
  bool hard = false;    ///< rock or concrete: the correction for light penetrators is theirs, not that of soil [-]

  bool operator==(const YoungDef&) const = default;
};
/// Steel armour against solid shot (docs/models/de_marre.md).
struct DeMarreDef {
  double quality = 1;  ///< limit speed over that of nickel steel; above 0 [-]
  double plug = 0;     ///< part of a plug of Material::density, as wide as the shot, that it drives out, 0 to 1 [-]

  bool operator==(const DeMarreDef&) const = default;
};
/// Metal plates against long rods (docs/models/lambert_jonas.md); needs Material::density.
struct LambertDef {
  double coefficient = 4000;  ///< rolled homogeneous armour 4000, aluminium 1750 [m/s g^1/2 cm^-3/2]

  bool operator==(const LambertDef&) const = default;
};
/// A plate whose ballistic limit was measured: v_r = a (v^p - limit^p)^(1/p) (docs/models/recht_ipson.md).
struct BallisticLimitDef {
  double speed = 0;  ///< the limit, straight on; above 0 [m/s]
  double a = 1;      ///< part of the speed that is left at high speed, 0 to 1 [-]
  double p = 2;      ///< 1 to 100; 2: a constant energy is lost [-]

  bool operator==(const BallisticLimitDef&) const = default;
};
using PenetrationDef = std::variant<ImpenetrableDef, PonceletDef, YoungDef, DeMarreDef, LambertDef, BallisticLimitDef>;

/// How what comes out behind, or ricochets, is turned at random (docs/models/exit_spread.md). By itself: not at all.
struct SpreadDef {
  double deflection = 0;  ///< standard deviation of its direction, in each of two planes, below pi/2 [rad]
  double yaw = 0;         ///< that of the angle between its axis and its direction, below pi/2 [rad]

  bool operator==(const SpreadDef&) const = default;
};

/// What a surface is made of. What is left out is not known, and then does not happen.
struct Material {
  std::string name{};            ///< for tables [-]
  double restitution = 0.5;      ///< part of the speed along the normal that is left after a bounce, 0 to 1 [-]
  double friction = 0.5;         ///< Coulomb's, of what slides on it [-]
  double grip_restitution = 0;   ///< part of the slip that comes back after a ball gripped, 0 to 1 [-]
  double density = 0;            ///< 0: not known [kg/m^3]
  RicochetDef ricochet{};        ///< [-]
  PenetrationDef penetration{};  ///< [-]
  SpreadDef spread{};            ///< [-]

  bool operator==(const Material&) const = default;
};

/// Materials whose numbers were published; restitution and friction are those of any material. Sources:
/// docs/models/README.md#materials.
namespace materials {

/// Balls skip off it, and lose speed in it.
[[nodiscard]] Material water();
/// Concrete of a compressive strength [Pa], 13 to 100 MPa.
[[nodiscard]] Material concrete(double compressive_strength);
/// Softwood, as it met the cannon balls of Metz.
[[nodiscard]] Material fir();
/// Oak, as it met the cannon balls of Metz.
[[nodiscard]] Material oak();
/// Nickel steel armour against solid shot.
[[nodiscard]] Material nickel_steel();
/// Rolled homogeneous armour against long rods.
[[nodiscard]] Material rolled_armour();
/// Aluminium against long rods.
[[nodiscard]] Material aluminium();

}  // namespace materials
}  // namespace physim
