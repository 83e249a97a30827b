// Cyclone, from a checkout of its sources where `./dev bench --cyclone FOLDER` names one: its world of particles, with
// gravity as their acceleration and a damping power, or with its force generators of gravity and drag.
#include "world_peers.hpp"

#if PHYSIM_BENCH_CYCLONE
#include <cyclone/cyclone.h>

namespace physim::bench {
namespace {

class CycloneWorld final : public PeerWorld {
 public:
  CycloneWorld(const PeerPhysics& physics, const std::vector<PeerProjectile>& projectiles)
      : gravity_(cyclone::Vector3(0, -physics.gravity, 0)),
        drag_(physics.k1, physics.k2),
        particles_(projectiles.size()) {
    const bool is_damped = physics.damping < 1;
    for (std::size_t i = 0; i < projectiles.size(); ++i) {
      const PeerProjectile& p = projectiles[i];
      cyclone::Particle& particle = particles_[i];
      particle.setMass(physics.mass);
      particle.setDamping(physics.damping);
      particle.setPosition(p.position[0], p.position[1], p.position[2]);
      particle.setVelocity(p.velocity[0], p.velocity[1], p.velocity[2]);
      particle.setAcceleration(0, is_damped ? -physics.gravity : 0, 0);
      particle.clearAccumulator();
      world_.getParticles().push_back(&particle);
      if (is_damped) continue;
      world_.getForceRegistry().add(&particle, &gravity_);
      world_.getForceRegistry().add(&particle, &drag_);
    }
  }
  void step(float dt) override {
    world_.startFrame();
    world_.runPhysics(dt);
  }
  void position(std::size_t index, float* into) const override {
    const cyclone::Vector3 x = particles_[index].getPosition();
    into[0] = static_cast<float>(x.x), into[1] = static_cast<float>(x.y), into[2] = static_cast<float>(x.z);
  }

 private:
  cyclone::ParticleWorld world_{1};
  cyclone::ParticleGravity gravity_;
  cyclone::ParticleDrag drag_;
  std::vector<cyclone::Particle> particles_;
};

}  // namespace

std::unique_ptr<PeerWorld> cyclone_world(const PeerPhysics& physics, const std::vector<PeerProjectile>& projectiles) {
  return std::make_unique<CycloneWorld>(physics, projectiles);
}
const char* cyclone_commit() { return PHYSIM_CYCLONE_COMMIT; }

}  // namespace physim::bench
#else

namespace physim::bench {

std::unique_ptr<PeerWorld> cyclone_world(const PeerPhysics&, const std::vector<PeerProjectile>&) { return nullptr; }
const char* cyclone_commit() { return nullptr; }

}  // namespace physim::bench
#endif
