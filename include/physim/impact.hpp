// impact(): what happens to a projectile that meets a material.
#pragma once

#include <cstdint>

#include "physim/material.hpp"
#include "physim/result.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// A projectile as it meets a surface.
struct Impact {
  double mass = 0;           ///< 0 to 1e100; 1e-15 to 1e15 if the material lets things in, or is a liquid that throws
                             ///< them off [kg]
  double diameter = 0;       ///< 1e-15 to 1e15, or 0: a point, which nothing spins; 1e-9 to 1e6 for such materials [m]
  double length = 0;         ///< of a rod, for LambertDef, 0 to 1e15; 0: its diameter [m]
  double nose_length = 0.5;  ///< in diameters: 0 flat, 1/2 a hemisphere, more an ogive [-]
  double inertia = 0.4;      ///< moment of inertia over mass and radius squared: 2/5 a solid ball, 2/3 a hollow one [-]
  Vec3d velocity{};          ///< in W, at most 1e9 [m/s]
  Vec3d spin{};              ///< angular velocity in W, at most 1e15 [rad/s]
  Vec3d normal{0, 1, 0};     ///< of the surface, of length 1, on the side that the projectile comes from [-]
  Vec3d surface_velocity{};  ///< of the surface where it is met [m/s]
  double thickness = 0;      ///< of the material along the way; 0: not known, and without end [m]
  std::uint64_t seed = 0;    ///< of all spreads [-]
  std::uint32_t projectile = 0;  ///< its number [-]
  std::uint32_t hit = 0;         ///< the how many-th of its hits this is [-]
};

enum class ImpactKind {
  none,        ///< it does not move towards the surface
  bounced,     ///< thrown back by restitution
  ricocheted,  ///< thrown off, as it came in flat
  penetrated,  ///< came out behind
  stopped,     ///< stuck in the material
};

/// What became of it.
struct ImpactResult {
  ImpactKind kind = ImpactKind::none;  ///< [-]
  Vec3d velocity{};                    ///< where it is now: at the surface, behind the material, or in it [m/s]
  Vec3d spin{};                        ///< [rad/s]
  Vec3d nose{};          ///< of length 1: where its nose points now; {} where it was not turned by a yaw [-]
  double depth = 0;      ///< how far it came along its way; the thickness where it came out [m]
  double obliquity = 0;  ///< between its way and the normal; 0 straight on [rad]
  double energy = 0;     ///< kinetic energy that it lost, as seen from the surface [J]
};

/// Refuses a material that no number can be computed with, or that gains energy; names the number.
[[nodiscard]] Status check_material(const Material& material);

/// What happens, decided in this order:
/// 1. a projectile that does not move towards the surface goes on: `none`;
/// 2. one that comes in flatter than the critical angle `ricocheted`;
/// 3. one that the material lets through its thickness `penetrated`;
/// 4. one that comes to rest in it, at least half its diameter deep, `stopped`;
/// 5. what is left `bounced`, by restitution, friction and spin.
/// The way through the material is straight and takes no time here. The same input gives the same bits everywhere; the
/// spread depends on seed, projectile and hit alone. An error names the number that is wrong.
[[nodiscard]] Result<ImpactResult> impact(const Impact& hit, const Material& material);

}  // namespace physim
