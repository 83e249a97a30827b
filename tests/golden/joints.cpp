// Joints in the golden hash: random nets of rods, cables and springs, over a ground that bounces and among things. For
// every kernel and several numbers of threads; saved and loaded on the way.
#include <bit>

#include "alike.hpp"
#include "base/hash.hpp"
#include "random_emitters.hpp"
#include "scenes.hpp"

namespace physim::test {
namespace {

World world_with_nets(Random& r, unsigned threads) {
  const IeeeMode mode;
  WorldDef def;
  def.ground = {r.one_in(2) ? GroundMode::bounce : GroundMode::none, -3, 0.7, 0.5};
  def.threading = {threads, 1};
  auto made = World::create(def);
  if (!made) return {};
  World world = std::move(*made);
  Scene scene;
  if (const auto box = scene.add_shape(BoxShape{{0.1, 5, 5}})) {
    static_cast<void>(scene.add({.shape = *box, .transform = {.position = {4, 0, 0}}}));
    static_cast<void>(scene.add({.shape = *box, .motion = SteadyMotion{.velocity = r.vector(2)}}));
  }
  if (r.one_in(2)) static_cast<void>(world.set_scene(scene));
  std::vector<ProjectileId> all;
  for (int i = 0; i < 24; ++i) {
    ProjectileDef p{.mass = 0.2 + r.below(5), .diameter = 0.1};
    p.fidelity = *fidelity_preset(fidelity_presets()[static_cast<std::size_t>(r.below(4))]);
    p.fidelity.precision = r.one_in(3) ? Precision::float32 : Precision::float64;
    BodyDef body{.restitution = 0.6, .collision = {.on_hit = OnHit::bounce, .radius = 0.1 * r.below(2), .others = 1}};
    body.kinematic = r.one_in(12);
    const auto id = world.spawn(p, {.position = r.vector(2), .velocity = r.vector(5)}, body);
    if (id) all.push_back(*id);
  }
  const auto some = [&] { return all[static_cast<std::size_t>(r.below(static_cast<int>(all.size())))]; };
  for (int i = 0; i < 30; ++i) {
    Joint joint{.kind = static_cast<JointKind>(r.below(3)), .a = some(), .b = r.one_in(5) ? ProjectileId{} : some()};
    if (r.one_in(3)) joint.length = 0.5 + r.below(4);
    if (joint.kind == JointKind::cable) joint.restitution = 0.25 * r.below(5);
    joint.stiffness = 10.0 * r.below(100);
    joint.damping = 0.5 * r.below(3);
    static_cast<void>(world.add_joint(joint));
  }
  return world;
}

void run_nets(Hash& hash, std::uint64_t seed, unsigned threads) {
  Random r(seed);
  World world = world_with_nets(r, threads);
  const auto steps = [&](int count, double dt) {
    for (int i = 0; i < count; ++i) {
      static_cast<void>(world.step(dt));
      hash.add(world.hash());
      hash.add(std::uint64_t{world.joint_counts().rounds});
      for (const JointEvent& e : world.joint_events()) hash.add(std::bit_cast<std::uint64_t>(e.speed));
    }
  };
  steps(20, 1.0 / 60);
  const auto saved = world.save();
  auto loaded = saved ? World::load(*saved) : saved.error();
  hash.add(static_cast<std::uint64_t>(loaded.ok()));
  if (!loaded) return;
  world = std::move(*loaded);
  const std::vector<JointId> joints = world.joints();
  for (std::size_t i = 0; i < joints.size(); i += 5) static_cast<void>(world.remove_joint(joints[i]));
  steps(20, 1.0 / 100);
  for (const JointId id : world.joints()) hash.add(std::bit_cast<std::uint64_t>(world.joint_state(id).tension));
}

std::uint64_t run_worlds_with_joints(unsigned threads) {
  Hash hash;
  for (std::uint64_t seed = 700; seed < 724; ++seed) run_nets(hash, seed, threads);
  return hash.value();
}

}  // namespace

bool add_joints(std::uint64_t& hash) {
  hash = run_worlds_with_joints(1);
  return gives_alike("worlds with joints", hash, {1u, 3u}, run_worlds_with_joints);
}

}  // namespace physim::test
