// What people write or take instead of a World, behind plain classes: their files are compiled with every instruction
// of this machine and fused multiply-add allowed, so nothing of the library may be instantiated in them.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace physim::bench {

struct PeerProjectile {
  float position[3];  // [m]
  float velocity[3];  // [m/s]
};

/// Constant gravity, and drag linear and quadratic in speed.
struct PeerPhysics {
  float gravity;  // downwards [m/s^2]
  float mass;     // [kg]
  float radius;   // [m]
  float k1;       // [kg/s]
  float k2;       // [kg/m]
};

/// Many projectiles in free flight.
class PeerWorld {
 public:
  virtual ~PeerWorld() = default;
  virtual void step(float dt) = 0;
  /// Of one projectile [m].
  virtual void position(std::size_t index, float* into) const = 0;
};

/// The loop of the first PhySim, after Millington's Cyclone: a particle on the heap for each projectile, virtual force
/// generators, and a registry of pointers to both that is asked in every frame.
[[nodiscard]] std::unique_ptr<PeerWorld> original_loop(const PeerPhysics& physics,
                                                       const std::vector<PeerProjectile>& projectiles);

/// Bullet 3: a small sphere for each projectile; with or without its detection of collisions.
[[nodiscard]] std::unique_ptr<PeerWorld> bullet_world(const PeerPhysics& physics,
                                                      const std::vector<PeerProjectile>& projectiles, bool detection);

}  // namespace physim::bench
