// Scenes in the golden hash: random projectiles among things of every shape and material, some of which move, on random
// rungs; they meet each other, too. For every kernel and several numbers of threads.
#include "scenes.hpp"

#include <bit>

#include "alike.hpp"
#include "base/hash.hpp"
#include "random_shots.hpp"

namespace physim::test {
namespace {

ShapeDef random_shape(Random& r) {
  switch (r.below(7)) {
    case 0: return SphereShape{r.in(0.5, 4)};
    case 1: return CapsuleShape{r.in(0.3, 2), r.in(0.2, 4)};
    case 2: return CylinderShape{r.in(0.3, 2), r.in(0.01, 4)};
    case 3: {
      ConvexHullShape hull;
      for (int i = 0; i < 12; ++i) hull.points.push_back(r.vector(3));
      return hull;
    }
    case 4: {
      HeightFieldShape field{.columns = 6, .rows = 7, .spacing_x = 1.5, .spacing_z = 2};
      for (int i = 0; i < 42; ++i) field.heights.push_back(r.in(-1, 1));
      return field;
    }
    case 5: {
      MeshShape mesh;
      for (int i = 0; i < 9; ++i) mesh.vertices.push_back(r.vector(4));
      for (std::uint32_t i = 0; i < 7; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
      return mesh;
    }
    default: return BoxShape{{r.in(0.005, 3), r.in(0.5, 3), r.in(0.5, 3)}};
  }
}

Material random_material(Random& r) {
  Material made_of{.restitution = r.unit(), .friction = r.unit()};
  switch (r.below(7)) {
    case 0: made_of = materials::water(); break;
    case 1: made_of = materials::concrete(30e6); break;
    case 2: made_of = materials::oak(); break;
    case 3: made_of = materials::rolled_armour(); break;
    case 4: made_of = materials::aluminium(); break;
    default: made_of.grip_restitution = r.unit(); break;
  }
  if (r.one_in(3)) made_of.spread = {0.05, 0.1};
  return made_of;
}

SceneMotion random_motion(Random& r) {
  switch (r.below(5)) {
    case 0: return SteadyMotion{.velocity = r.vector(20), .angular_velocity = r.vector(3)};
    case 1: {
      KeyedMotion keyed{.keys = {}, .curve = r.one_in(2) ? MotionCurve::smooth : MotionCurve::straight};
      for (int i = 0; i < 4; ++i)
        keyed.keys.push_back({0.25 * i, r.vector(8), {r.in(-1, 1), r.in(-1, 1), r.in(-1, 1), 1}, r.vector(5)});
      return keyed;
    }
    default: return AtRest{};
  }
}

Scene random_scene(Random& r) {
  Scene scene;
  for (int i = 0; i < 14; ++i) {
    const auto shape = scene.add_shape(random_shape(r));
    const auto material = scene.add_material(random_material(r));
    InstanceDef thing{.transform = {r.vector(12), {r.in(-1, 1), r.in(-1, 1), r.in(-1, 1), 1}, r.in(0.5, 2)},
                      .sensor = r.one_in(8),
                      .motion = random_motion(r)};
    if (!shape || !material) continue;
    thing.shape = *shape;
    thing.material = *material;
    static_cast<void>(scene.add(thing));
  }
  return scene;
}

CollisionDef random_collision(Random& r) {
  CollisionDef c{.on_hit = static_cast<OnHit>(r.below(5)), .radius = r.one_in(2) ? r.in(0.01, 0.3) : 0};
  if (r.one_in(2)) c.others = 1;
  return c;
}

Launch launch_among_things(Random& r) {
  Launch launch;
  launch.position = r.vector(12);
  launch.velocity = r.vector(r.one_in(3) ? 600 : 40);
  return launch;
}

void add(Hash& hash, double x) {
  hash.add(x != x ? 0x7ff8000000000000u : std::bit_cast<std::uint64_t>(x));
}  // the bits of NaN are nobody's promise
void add(Hash& hash, const Event& e) {
  hash.add(static_cast<std::uint64_t>(e.kind) * 64 + static_cast<std::uint64_t>(e.reason));
  for (const double x : {e.time, e.value, e.energy}) add(hash, x);
  for (const Vec3d& v : {e.position, e.velocity, e.normal})
    for (const double x : {v.x, v.y, v.z}) add(hash, x);
}

World world_among_things(Random& r, unsigned threads) {
  WorldDef def;
  def.environment = random_environment(r);
  def.ground.mode = static_cast<GroundMode>(r.below(4));
  def.threading = {threads, 1};
  def.tolerance.relative = 1e-5;
  def.tolerance.absolute = 1e-5;
  auto made = World::create(def);
  if (!made) return {};
  if (!made->set_scene(random_scene(r))) return {};
  for (const Shot& shot : random_shots(r, 30)) {
    ProjectileDef p = shot.projectile;
    p.fidelity = random_fidelity(r);
    BodyDef body;
    body.collision = random_collision(r);
    body.restitution = r.unit();
    body.friction = r.unit();
    if (r.one_in(6)) body.frozen = Axes::z;
    static_cast<void>(made->spawn(p, launch_among_things(r), body));
  }
  return std::move(*made);
}

void run_world(Hash& hash, std::uint64_t seed, unsigned threads) {
  Random r(seed);
  World world = world_among_things(r, threads);
  const auto steps = [&](int count) {
    for (int i = 0; i < count; ++i) {
      world.step(1.0 / 50);
      hash.add(world.hash());
      for (const Event& e : world.events()) add(hash, e);
    }
  };
  steps(12);
  const auto saved = world.save();
  steps(3);
  auto loaded = saved ? World::load(*saved) : saved.error();
  hash.add(static_cast<std::uint64_t>(loaded.ok()));
  if (!loaded) return;
  world = std::move(*loaded);
  steps(8);
}

std::uint64_t run_worlds(unsigned threads) {
  Hash hash;
  for (std::uint64_t seed = 300; seed < 320; ++seed) run_world(hash, seed, threads);
  return hash.value();
}

void add_flights(Hash& hash) {
  for (std::uint64_t seed = 400; seed < 440; ++seed) {
    Random r(seed);
    const Scene scene = random_scene(r);
    const Environment environment = random_environment(r);
    Until until{.ground = std::nullopt, .time = 0.5};
    until.scene = &scene;
    for (const Shot& shot : random_shots(r, 4)) {
      until.contact = {.collision = random_collision(r), .restitution = r.unit(), .friction = r.unit()};
      until.contact.collision.others = 0;
      const Fidelity fidelity = random_fidelity(r);  // one after the other: arguments have no order
      const Launch launch = launch_among_things(r);
      const Flight flight = fly(shot.projectile, launch, environment, fidelity, {1e-6, 1e-6, 0.02}, until);
      hash.add(static_cast<std::uint64_t>(flight.outcome()));
      for (const Event& e : flight.events()) add(hash, e);
      const Sample end = flight.at(flight.duration());
      for (const double x : {end.position.x, end.position.y, end.position.z, end.speed}) add(hash, x);
    }
  }
}

}  // namespace

bool add_scenes(std::uint64_t& hash) {
  hash = run_worlds(1);
  const bool same = gives_alike("worlds with scenes", hash, {1u, 3u}, run_worlds);
  Hash flights;
  flights.add(hash);
  add_flights(flights);
  hash = flights.value();
  return same;
}

}  // namespace physim::test
