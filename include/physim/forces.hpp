// Forces: generators that push projectiles of a world until they are removed or their time is over.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "physim/infinity.hpp"
#include "physim/world_def.hpp"

namespace physim {

/// F = force.
struct ConstantForce {
  Vec3d force{};  ///< [N]
};
/// F = m a: the same acceleration for every mass.
struct ConstantAcceleration {
  Vec3d acceleration{};  ///< [m/s^2]
};
/// F = m g in any direction: a gravity generator beside or instead of the world's own.
struct GravityForce {
  Vec3d gravity{0, -9.80665, 0};  ///< [m/s^2]
};
/// F = -(k1 + k2 |u|) u, with u the velocity relative to `wind`.
struct LinearQuadraticDragForce {
  double k1 = 0;  ///< [kg/s]
  double k2 = 0;  ///< [kg/m]
  Vec3d wind{};   ///< [m/s]
};
/// Hooke's spring between the projectile and a fixed point, with damping along the spring.
struct AnchoredSpring {
  Vec3d anchor{};          ///< [m]
  double stiffness = 1;    ///< [N/m]
  double rest_length = 0;  ///< [m]
  double damping = 0;      ///< of the rate at which its length changes [kg/s]
};
/// Hooke's spring between the projectile and another one, which feels the opposite force where it can move.
struct Spring {
  ProjectileId other{};    ///< [-]
  double stiffness = 1;    ///< [N/m]
  double rest_length = 0;  ///< [m]
  double damping = 0;      ///< [kg/s]
};
/// A spring that only pulls: nothing below its rest length. Between the projectile and `other`, or `anchor` where there
/// is no other.
struct Bungee {
  ProjectileId other{};    ///< null: anchored [-]
  Vec3d anchor{};          ///< [m]
  double stiffness = 1;    ///< [N/m]
  double rest_length = 0;  ///< [m]
  double damping = 0;      ///< [kg/s]
};
/// Archimedes' lift of a liquid with a level surface, and its resistance. The projectile goes under between depth above
/// and depth below the surface.
struct Buoyancy {
  double surface = 0;        ///< height of the liquid [m]
  double volume = 0;         ///< of the projectile; 0: the sphere of its diameter [m^3]
  double depth = 0;          ///< half the height of an upright cylinder or box; 0: a sphere of its diameter [m]
  double density = 1000;     ///< of the liquid [kg/m^3]
  double damping = 0;        ///< of the velocity in the liquid, times the part under it [kg/s]
  double gravity = 9.80665;  ///< that weighs the liquid; 0: no lift [m/s^2]
};
/// Attraction to a point (repulsion where the strength is negative): F = m strength r / (r^2 + softening^2)^(3/2).
struct PointAttractor {
  Vec3d centre{};        ///< [m]
  double strength = 1;   ///< G M of the attracting mass [m^3/s^2]
  double softening = 0;  ///< keeps the force finite near the centre [m]
};
/// A box of moving air: inside, it takes the place of the air around, with the drag equation and the projectile's own
/// area and Cd (by the Mach number in air of 15 degrees Celsius). Corners may be infinite.
struct WindZone {
  Vec3d velocity{};        ///< of the air [m/s]
  Vec3d low{};             ///< corner of the box [m]
  Vec3d high{};            ///< opposite corner [m]
  double density = 1.225;  ///< of its air [kg/m^3]
};
/// A blast: an outward force that falls linearly from the centre to the radius, over the time it lasts.
struct Explosion {
  Vec3d centre{};     ///< [m]
  double force = 0;   ///< at the centre [N]
  double radius = 1;  ///< [m]
};
/// Thrust along the velocity (nothing at rest), or along a fixed direction, from a table of thrust over time.
struct Thrust {
  struct Point {
    double time = 0;   ///< since the generator was added, or from each launch for kinds [s]
    double force = 0;  ///< [N]
  };
  std::vector<Point> curve{};  ///< straight lines between rising times; nothing before and after [N]
  Vec3d direction{};           ///< in W, of any length; zero: along the velocity [-]
};

/// What a force function sees and fills: all projectiles that it acts on, side by side.
struct ForceBatch {
  double time = 0;                     ///< of the world [s]
  std::span<const ProjectileId> id{};  ///< [-]
  std::span<const Vec3d> position{};   ///< [m]
  std::span<const Vec3d> velocity{};   ///< [m/s]
  std::span<const double> mass{};      ///< [kg]
  std::span<Vec3d> force{};            ///< to be added to [N]
};
/// The user's own force. Called once per stage for all projectiles of a batch that it acts on, from one thread. It must
/// be a function of what it sees. It may read its world, as that was when the step began, but not change it (see
/// World), and must not throw: of a call that does, nothing is felt.
struct CustomForce {
  std::function<void(const ForceBatch&)> function{};  ///< [-]
};

using ForceLaw =
    std::variant<ConstantForce, ConstantAcceleration, GravityForce, LinearQuadraticDragForce, AnchoredSpring, Spring,
                 Bungee, Buoyancy, PointAttractor, WindZone, Explosion, Thrust, CustomForce>;

/// What a generator acts on: projectiles one by one, or everything of a kind, or of some layers.
struct ForceTarget {
  std::vector<ProjectileId> ids{};  ///< these [-]
  KindId kind{};                    ///< all of this kind, now and later [-]
  std::uint32_t layers = 0;         ///< all with one of these layer bits, now and later [-]

  static ForceTarget everything() { return {{}, {}, 0xffffffffu}; }
};

struct ForceDef {
  ForceLaw law{};               ///< [-]
  ForceTarget target{};         ///< [-]
  double delay = 0;             ///< before it starts [s]
  double duration = kInfinity;  ///< then it removes itself [s]
};

}  // namespace physim
