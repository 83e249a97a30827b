// What people write or take instead of a World, behind plain classes: their files are compiled with every instruction
// of this machine and fused multiply-add allowed, so nothing of the library may be instantiated in them.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engine_rules.hpp"

namespace physim::bench {

struct PeerProjectile {
  float position[3];  // [m]
  float velocity[3];  // [m/s]
};

/// Constant gravity, and drag linear and quadratic in speed.
struct PeerPhysics {
  float gravity;      // downwards [m/s^2]
  float mass;         // [kg]
  float radius;       // [m]
  float k1;           // [kg/s]
  float k2;           // [kg/m]
  float damping = 1;  // part of the velocity that is left after a second; of Bullet and Cyclone alone [-]
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

/// The rule of an engine, with a damping of `rate` [1/s].
[[nodiscard]] std::unique_ptr<PeerWorld> rule_world(EngineRule rule, const PeerPhysics& physics, float rate,
                                                    const std::vector<PeerProjectile>& projectiles);

/// Cyclone's own sources: a damping power where it is below 1, else generators of gravity and drag; null where the
/// build has none.
[[nodiscard]] std::unique_ptr<PeerWorld> cyclone_world(const PeerPhysics& physics,
                                                       const std::vector<PeerProjectile>& projectiles);
/// What commit they are of; null where the build has none.
[[nodiscard]] const char* cyclone_commit();

/// A spray of sparks: how many come, how long they live, how fast they start upwards within a cone.
struct PeerSpray {
  float per_second;  // [1/s]
  float shortest;    // life [s]
  float longest;     // [s]
  float slowest;     // [m/s]
  float fastest;     // [m/s]
  float half_angle;  // [rad]
};

/// Sparks that are born inside of frames, fly, and are gone at the end of their lives.
class PeerSparks {
 public:
  virtual ~PeerSparks() = default;
  /// Those at hand fly on or die; then new ones are born.
  virtual void step(float dt) = 0;
  /// So many now.
  virtual void emit(std::size_t count) = 0;
  /// Size and colour of each by its age.
  virtual void look() = 0;
  [[nodiscard]] virtual std::size_t size() const = 0;
};

/// A structure of arrays that one loop goes over, and a dead spark's place is taken by the last one.
[[nodiscard]] std::unique_ptr<PeerSparks> plain_loop(const PeerPhysics& physics, const PeerSpray& spray,
                                                     std::size_t room);

}  // namespace physim::bench
