// The rules of engines in plain loops over arrays: what their formulas cost without the engines around them.
#include "engine_rules.hpp"
#include "world_peers.hpp"

namespace physim::bench {
namespace {

template <EngineRule kRule>
class RuleWorld final : public PeerWorld {
 public:
  RuleWorld(const PeerPhysics& physics, float rate, const std::vector<PeerProjectile>& projectiles)
      : gravity_(physics.gravity), rate_(rate) {
    for (int axis = 0; axis < 3; ++axis)
      for (const PeerProjectile& p : projectiles) {
        x_[axis].push_back(p.position[axis]);
        v_[axis].push_back(p.velocity[axis]);
      }
  }
  void step(float dt) override {
    const float h = dt / sub_steps(kRule);
    for (int sub = 0; sub < sub_steps(kRule); ++sub)
      for (int axis = 0; axis < 3; ++axis) go(x_[axis], v_[axis], axis == 1 ? -gravity_ : 0.0F, h);
  }
  void position(std::size_t index, float* into) const override {
    for (int axis = 0; axis < 3; ++axis) into[axis] = x_[axis][index];
  }

 private:
  void go(std::vector<float>& x, std::vector<float>& v, float a, float h) const {
    const float c = rate_;
    float* const at = x.data();
    float* const speed = v.data();
    const std::size_t count = x.size();
    for (std::size_t i = 0; i < count; ++i) {
      speed[i] = velocity_after<kRule>(speed[i], a, c, h);
      at[i] += speed[i] * h;
    }
  }

  float gravity_;
  float rate_;
  std::vector<float> x_[3], v_[3];
};

template <EngineRule kRule>
std::unique_ptr<PeerWorld> made(const PeerPhysics& physics, float rate, const std::vector<PeerProjectile>& list) {
  return std::make_unique<RuleWorld<kRule>>(physics, rate, list);
}

}  // namespace

std::unique_ptr<PeerWorld> rule_world(EngineRule rule, const PeerPhysics& physics, float rate,
                                      const std::vector<PeerProjectile>& projectiles) {
  switch (rule) {
    case EngineRule::unity: return made<EngineRule::unity>(physics, rate, projectiles);
    case EngineRule::unity_2d: return made<EngineRule::unity_2d>(physics, rate, projectiles);
    case EngineRule::jolt: return made<EngineRule::jolt>(physics, rate, projectiles);
    case EngineRule::godot: return made<EngineRule::godot>(physics, rate, projectiles);
    case EngineRule::box2d: return made<EngineRule::box2d>(physics, rate, projectiles);
  }
  return nullptr;
}

}  // namespace physim::bench
