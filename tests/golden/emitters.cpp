// Emitters in the golden hash: random ones of every row, among things and over the ground, that set each other off, on
// random rungs. For every kernel and several numbers of threads; saved and loaded on the way.
#include <bit>

#include "alike.hpp"
#include "base/hash.hpp"
#include "random_emitters.hpp"
#include "scenes.hpp"

namespace physim::test {
namespace {

Scene wall_and_plank(Random& r) {
  Scene scene;
  const auto box = scene.add_shape(BoxShape{{0.1, 6, 6}});
  if (!box) return scene;
  static_cast<void>(scene.add({.shape = *box, .transform = {.position = {8, 2, 0}}}));
  static_cast<void>(scene.add({.shape = *box, .motion = SteadyMotion{.velocity = r.vector(10)}}));
  return scene;
}

World world_with_emitters(Random& r, unsigned threads) {
  WorldDef def;
  def.environment = random_environment(r);
  def.ground.mode = static_cast<GroundMode>(r.below(4));
  def.apex_events = r.one_in(2);
  def.threading = {threads, 1};
  def.tolerance.relative = 1e-5;
  def.tolerance.absolute = 1e-5;
  auto made = World::create(def);
  if (!made) return {};
  World world = std::move(*made);
  static_cast<void>(world.set_scene(wall_and_plank(r)));
  for (int i = 0; i < 7; ++i) {
    ProjectileDef p = random_projectile(r);
    p.fidelity = random_fidelity(r);
    BodyDef body;
    body.collision = {.on_hit = static_cast<OnHit>(r.below(5)), .radius = r.one_in(2) ? 0.05 : 0};
    const auto kind = world.add_kind(p, body);
    if (!kind) continue;
    EmitterDef emitter = random_emitter(r, *kind, world.emitters());
    if (p.fidelity.motion == Motion::force && !r.one_in(3)) emitter.flight = random_flight(r);
    const ProjectileId led = i == 3 && !world.ids().empty() ? world.ids().front() : ProjectileId{};
    if (led) emitter.follows = led, emitter.motion = AtRest{};
    static_cast<void>(world.add_emitter(emitter));
    if (i == 0) static_cast<void>(world.spawn(*kind, {.position = {0, 3, 0}, .velocity = Vec3d{9, 5, 1}}));
  }
  if (r.one_in(2))
    static_cast<void>(
        world.add_force({.law = PointAttractor{r.vector(20), 50, 2}, .target = ForceTarget::everything()}));
  return world;
}

void add_number(Hash& hash, double x) {
  hash.add(x != x ? 0x7ff8000000000000u : std::bit_cast<std::uint64_t>(x));  // the bits of NaN are nobody's promise
}

/// What a renderer is shown.
void add_looks(Hash& hash, const World& world) {
  for (const EmitterId id : world.emitters()) {
    const std::size_t count = world.particles(id, {});
    std::vector<Vec3d> size(count), rotation(count);
    std::vector<std::uint32_t> colour(count);
    world.particles(id, {.size = size, .rotation = rotation, .colour = colour});
    for (std::size_t i = 0; i < count; ++i) {
      for (const Vec3d& v : {size[i], rotation[i]})
        for (const double x : {v.x, v.y, v.z}) add_number(hash, x);
      hash.add(std::uint64_t{colour[i]});
    }
    std::vector<Vec3d> trail(world.trails(id, {}).places);
    world.trails(id, {.position = trail});
    for (const Vec3d& v : trail)
      for (const double x : {v.x, v.y, v.z}) add_number(hash, x);
    hash.add(world.emitter_counts(id).born);
    hash.add(world.emitter_counts(id).refused);
  }
}

void run_world(Hash& hash, std::uint64_t seed, unsigned threads) {
  Random r(seed);
  World world = world_with_emitters(r, threads);
  const auto steps = [&](int count, double dt) {
    for (int i = 0; i < count; ++i) {
      static_cast<void>(world.step(dt));
      hash.add(world.hash());
      for (const Event& e : world.events()) {
        hash.add(static_cast<std::uint64_t>(e.kind));
        for (const double x : {e.time, e.position.x, e.position.y, e.velocity.z}) add_number(hash, x);
      }
    }
  };
  steps(20, 1.0 / 50);
  add_looks(hash, world);
  const auto saved = world.save();
  auto loaded = saved ? World::load(*saved) : saved.error();
  hash.add(static_cast<std::uint64_t>(loaded.ok()));
  if (!loaded) return;
  world = std::move(*loaded);
  for (const EmitterId id : world.emitters()) {
    static_cast<void>(world.move_emitter(id, {.position = r.vector(10)}));
    static_cast<void>(world.trigger_emitter(id));
    if (r.one_in(3)) static_cast<void>(world.jump_emitter(id, {.position = r.vector(10)}));
    if (r.one_in(3)) static_cast<void>(world.seek_emitter(id, r.in(0, 1.5)));
  }
  steps(20, 1.0 / 30);
  add_looks(hash, world);
}

std::uint64_t run_worlds(unsigned threads) {
  Hash hash;
  for (std::uint64_t seed = 500; seed < 524; ++seed) run_world(hash, seed, threads);
  return hash.value();
}

}  // namespace

bool add_emitters(std::uint64_t& hash) {
  hash = run_worlds(1);
  return gives_alike("worlds with emitters", hash, {1u, 3u}, run_worlds);
}

}  // namespace physim::test
