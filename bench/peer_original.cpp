// The original's world of particles, as its author would write it today: I. Millington, Game Physics Engine Development
// (2010), ch. 3 and 5, single precision. What its frame got wrong is right here: forces are asked for anew in every
// frame, and velocity goes before position, as in the game preset. A damping power, taken in every frame there, is left
// out.
#include <cmath>

#include "world_peers.hpp"

namespace physim::bench {
namespace {

struct Vector3 {
  float x = 0;
  float y = 0;
  float z = 0;

  Vector3 operator*(float s) const { return {x * s, y * s, z * s}; }
  void operator+=(const Vector3& v) { x += v.x, y += v.y, z += v.z; }
  void add_scaled(const Vector3& v, float s) { x += v.x * s, y += v.y * s, z += v.z * s; }
  [[nodiscard]] float magnitude() const { return std::sqrt(x * x + y * y + z * z); }
};

class Particle {
 public:
  Particle(const PeerProjectile& p, float mass)
      : position_{p.position[0], p.position[1], p.position[2]},
        velocity_{p.velocity[0], p.velocity[1], p.velocity[2]},
        inverse_mass_(1 / mass) {}

  void integrate(float dt) {
    if (inverse_mass_ <= 0) return;
    Vector3 acceleration = acceleration_;
    acceleration.add_scaled(force_, inverse_mass_);
    velocity_.add_scaled(acceleration, dt);
    position_.add_scaled(velocity_, dt);
    force_ = {};
  }
  void add_force(const Vector3& force) { force_ += force; }
  [[nodiscard]] const Vector3& position() const { return position_; }
  [[nodiscard]] const Vector3& velocity() const { return velocity_; }
  [[nodiscard]] float mass() const { return 1 / inverse_mass_; }

 private:
  Vector3 position_;
  Vector3 velocity_;
  Vector3 acceleration_;
  Vector3 force_;
  float inverse_mass_;
};

class ForceGenerator {
 public:
  virtual ~ForceGenerator() = default;
  virtual void update_force(Particle& particle, float dt) = 0;
};

class Gravity final : public ForceGenerator {
 public:
  explicit Gravity(float g) : gravity_{0, -g, 0} {}
  void update_force(Particle& particle, float) override { particle.add_force(gravity_ * particle.mass()); }

 private:
  Vector3 gravity_;
};

class Drag final : public ForceGenerator {
 public:
  Drag(float k1, float k2) : k1_(k1), k2_(k2) {}
  void update_force(Particle& particle, float) override {
    const Vector3& v = particle.velocity();
    particle.add_force(v * -(k1_ + k2_ * v.magnitude()));
  }

 private:
  float k1_;
  float k2_;
};

class OriginalLoop final : public PeerWorld {
 public:
  OriginalLoop(const PeerPhysics& physics, const std::vector<PeerProjectile>& projectiles)
      : gravity_(std::make_unique<Gravity>(physics.gravity)), drag_(std::make_unique<Drag>(physics.k1, physics.k2)) {
    for (const PeerProjectile& p : projectiles) {
      particles_.push_back(std::make_unique<Particle>(p, physics.mass));
      registry_.push_back({particles_.back().get(), gravity_.get()});
      registry_.push_back({particles_.back().get(), drag_.get()});
    }
  }
  void step(float dt) override {
    for (const Registration& r : registry_) r.generator->update_force(*r.particle, dt);
    for (const auto& particle : particles_) particle->integrate(dt);
  }
  void position(std::size_t index, float* into) const override {
    const Vector3& x = particles_[index]->position();
    into[0] = x.x, into[1] = x.y, into[2] = x.z;
  }

 private:
  struct Registration {
    Particle* particle;
    ForceGenerator* generator;
  };
  std::unique_ptr<ForceGenerator> gravity_;
  std::unique_ptr<ForceGenerator> drag_;
  std::vector<std::unique_ptr<Particle>> particles_;
  std::vector<Registration> registry_;
};

}  // namespace

std::unique_ptr<PeerWorld> original_loop(const PeerPhysics& physics, const std::vector<PeerProjectile>& projectiles) {
  return std::make_unique<OriginalLoop>(physics, projectiles);
}

}  // namespace physim::bench
