// Worlds in the golden hash: random projectiles on random rungs, with ground, forces, sleep, moves and snapshots, for
// every kernel and several numbers of threads.
#include "world.hpp"

#include "alike.hpp"
#include "random_shots.hpp"

namespace physim::test {
namespace {

WorldDef random_world(Random& r, unsigned threads) {
  WorldDef def;
  def.environment = random_environment(r);
  def.ground.mode = static_cast<GroundMode>(r.below(4));
  def.apex_events = r.one_in(2);
  def.tolerance.relative = 1e-5;
  def.tolerance.absolute = 1e-5;
  def.threading = {threads, 1};
  if (r.one_in(2)) def.detail.rungs = {{Fidelity::constant_air(), 60}, {Fidelity::game()}};
  return def;
}

void add_forces(World& world, Random& r, const std::vector<ProjectileId>& ids) {
  ForceDef f;
  f.target.ids = {ids[1], ids[4], ids[7]};
  f.law = LinearQuadraticDragForce{.k1 = 0.01, .k2 = 0.001, .wind = r.vector(10)};
  f.duration = 0.4;
  world.add_force(f);
  world[ids[2]].add_force(AnchoredSpring{r.vector(10), 3, 2, 0.1});
  world[ids[3]].add_force(Spring{.other = ids[5], .stiffness = 2, .rest_length = 1, .damping = 0.05});
  f.target = ForceTarget::everything();
  f.law = PointAttractor{r.vector(20), 100, 2};
  f.delay = 0.3;
  world.add_force(f);
}

std::uint64_t run_world(std::uint64_t seed, unsigned threads) {
  Random r(seed);
  auto made = World::create(random_world(r, threads));
  if (!made) return 0;
  World world = std::move(made.value());
  std::vector<ProjectileId> ids;
  for (const Shot& shot : random_shots(r, 24)) {
    ProjectileDef p = shot.projectile;
    p.fidelity = random_fidelity(r);
    Launch launch = shot.launch;
    launch.sight = {};
    BodyDef body;
    body.gravity_scale = r.one_in(4) ? r.in(0, 2) : 1;
    body.restitution = r.unit();
    if (r.one_in(6)) body.frozen = Axes::z;
    if (r.one_in(3)) body.despawn.farther = r.in(50, 500);
    ids.push_back(*world.spawn(p, launch, body, r.one_in(5) ? 0.2 : 0));
  }
  if (r.one_in(2)) add_forces(world, r, ids);
  std::uint64_t hash = 0;
  const auto step = [&] {
    world.step(1.0 / 50);
    hash = hash * 0x9e3779b97f4a7c15u + world.hash() + world.events().size();
  };
  for (int i = 0; i < 15; ++i) step();
  const Snapshot now = world.snapshot();
  for (int i = 0; i < 3; ++i) world.step(0.013);
  world.restore(now);
  world[ids[0]].set_fidelity(Fidelity::game());
  world[ids[6]].despawn();
  for (int i = 0; i < 15; ++i) step();
  return hash;
}

std::uint64_t run_worlds(unsigned threads) {
  std::uint64_t hash = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) hash = hash * 0x100000001b3u ^ run_world(seed, threads);
  return hash;
}

}  // namespace

bool add_worlds(std::uint64_t& hash) {
  hash = run_worlds(1);
  const bool same = gives_alike("worlds", hash, {1u, 2u, 7u}, run_worlds);
  return same;
}

}  // namespace physim::test
