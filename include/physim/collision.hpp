// CollisionDef: how a projectile meets the things of a scene, in a world and in a flight.
#pragma once

#include <cstdint>

namespace physim {

/// What a projectile does where it meets a thing of the scene. Each hit is told, too.
enum class OnHit : std::uint8_t {
  pass,    ///< flies on
  stop,    ///< its flight ends; in a world: LifeStatus::landed, and it leaves the world
  stick,   ///< it stays where it struck, at rest; in a world LifeStatus::landed, until it is despawned or moved
  bounce,  ///< it bounces by its restitution and friction times those of the material, slides, rolls to rest and sleeps
  impact,  ///< as its material says (physim/impact.hpp): it ricochets, goes through, stays in it, or bounces as above
  ask,     ///< as World::set_hit_function() answers for this hit; in worlds alone
};

/// How a projectile meets the things of a scene.
struct CollisionDef {
  OnHit on_hit = OnHit::stop;         ///< what it does then [-]
  double radius = 0;                  ///< it meets them as a ball of so much, 1e-12 to 1e6; 0: as a point, which
                                      ///< nothing spins [m]
  double inertia = 0.4;               ///< of the ball, over mass and radius squared: 2/5 solid, 2/3 hollow [-]
  std::uint32_t layers = 0xffffffff;  ///< bits: things of these layers; 0: none [-]
  std::uint32_t others = 0;           ///< bits: in worlds, projectiles of these BodyDef::layers, which want its own; 0:
                                      ///< none [-]

  bool operator==(const CollisionDef&) const = default;
};

/// How a flight meets the things of a scene, see Until::scene. Its numbers are those of a BodyDef.
struct ContactDef {
  CollisionDef collision{};          ///< [-]
  double restitution = 0.5;          ///< speed kept by a bounce, times that of the material, 0..1 [-]
  double friction = 0.5;             ///< Coulomb's, of bounces and sliding, times that of the material [-]
  double rolling_resistance = 0.05;  ///< weight that resists rolling; 0: a point slides, against friction [-]
  double scene_time = 0;             ///< of the scene at launch: what moves is then where it is at that time [s]
  std::uint64_t seed = 0;            ///< of what materials leave to chance (Material::spread) [-]

  bool operator==(const ContactDef&) const = default;
};

}  // namespace physim
