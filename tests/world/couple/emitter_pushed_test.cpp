// Rows that an emitter pushes on rungs that kernels know at compile time fly as on the way of all rungs, bit for bit.
#include "world/emitter_support.hpp"

namespace physim::world_emitter_pushed_test {

struct Place {
  Vec3d position, previous, velocity;
  bool operator==(const Place&) const = default;
};
struct Told {
  std::vector<Place> places;
  std::vector<std::tuple<EventKind, double, Vec3d, Vec3d>> events;
  bool operator==(const Told&) const = default;
};

/// What is asked of a session.
struct Asked {
  DragModel drag = DragModel::off;
  Precision precision = Precision::float32;
  Vec3d wind{};
  Ground ground{.mode = GroundMode::none};
  DespawnRules despawn{};
  bool apexes = false, scene = false, own_force = false;
  bool drag_alone = false;  // by age is all that acts on flights
};

EmitterDef sparks(KindId kind, int law, bool drag_alone) {
  EmitterDef def = spray(kind, law == 0 ? 400 : 700, 0.2);
  def.start.lifetime = {0.05, 1.5};
  def.position = {0, 1.5, 0};
  if (law == 0)
    def.flight.drag = {1, 4, {{0, 1}, {1, 0}}};
  else if (drag_alone)
    def.flight.drag = {3, 0.5};
  else
    def.flight.gravity = {0.2}, def.flight.force_x = {0.001, 0.003}, def.flight.limit = {5}, def.flight.noise = {2};
  return def;
}

/// Sparks of two emitters that come and go; a force on others sends all rows the way of all rungs.
Told session(const Asked& asked, bool general, std::uint64_t seed = 1) {
  WorldDef def{.ground = asked.ground, .apex_events = asked.apexes};
  def.environment.wind.velocity = asked.wind;
  World world = make_world(def);
  ProjectileDef p = spark(Motion::force);
  p.drag = {.table = DragTable::g1, .ballistic_coefficient = 10, .damping = 0.7, .k1 = 1e-4, .k2 = 2e-5};
  p.fidelity = Fidelity::game();
  p.fidelity.drag = asked.drag;
  p.fidelity.air = AirModel::isa;
  p.fidelity.wind = WindModel::constant;
  p.fidelity.precision = asked.precision;
  if (asked.own_force) p.force = {0.002, 0, 0}, p.force_duration = 0.1;
  BodyDef body{.restitution = 0.5, .despawn = asked.despawn};
  if (asked.scene) {
    Scene scene;
    const ShapeId box = scene.add_shape(BoxShape{{2, 0.2, 2}}).value();
    EXPECT_TRUE(scene.add({.shape = box, .transform = {.position = {0, 5, 0}}}));
    EXPECT_TRUE(world.set_scene(scene));
    body.collision.on_hit = OnHit::bounce;
  }
  const KindId kind = kind_of(world, p, body);
  if (general) {
    const KindId other = kind_of(world, stone());
    EXPECT_TRUE(world.add_force({.law = ConstantForce{{1, 0, 0}}, .target = {.kind = other}}));
  }
  const EmitterId ids[] = {added(world, sparks(kind, 0, asked.drag_alone)),
                           added(world, sparks(kind, 1, asked.drag_alone))};
  Told told;
  std::uint32_t random = static_cast<std::uint32_t>(seed);
  for (int i = 0; i < 90; ++i) {
    random = random * 1664525u + 1013904223u;
    EXPECT_TRUE(world.step(i % 3 == 0 ? 1.0 / 60 : 0.002 + 0.02 * (random >> 8) / 16777216.0));
    for (const Event& e : world.events()) told.events.emplace_back(e.kind, e.time, e.position, e.velocity);
    const auto alive = world.ids();
    for (std::size_t k = 0; k < alive.size() && random % 5 == 0; k += 1 + random % 37) world[alive[k]].despawn();
    if (random % 7 == 0) world.emit(ids[random % 2], 50);
  }
  for (const ProjectileId id : world.ids())
    told.places.push_back({world[id].position(), world[id].previous_position(), world[id].velocity()});
  return told;
}
void expect_same(const Asked& asked, std::size_t least_events) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Told known = session(asked, false, seed), general = session(asked, true, seed);
    EXPECT_GT(known.places.size(), 100u);
    EXPECT_GE(known.events.size(), least_events);
    EXPECT_TRUE(known == general) << static_cast<int>(asked.drag) << ' ' << seed;
  }
}

constexpr DragModel kDrags[] = {DragModel::off, DragModel::damping, DragModel::linear_quadratic, DragModel::equation};
constexpr Precision kPrecisions[] = {Precision::float32, Precision::float64};

TEST(EmitterPushed, every_known_rung_gives_the_bits_of_all_rungs) {
  for (const DragModel drag : kDrags)
    for (const Precision precision : kPrecisions)
      for (const Vec3d& wind : {Vec3d{}, Vec3d{7, 1, -2}})
        for (const bool alone : {false, true})
          expect_same({.drag = drag, .precision = precision, .wind = wind, .drag_alone = alone}, 100);
}

TEST(EmitterPushed, what_happens_to_some_happens_as_on_all_rungs) {
  for (const Precision precision : kPrecisions) {
    const auto with = [precision](const auto& change, std::size_t least_events) {
      for (const bool alone : {false, true}) {
        Asked asked{.drag = DragModel::linear_quadratic, .precision = precision, .drag_alone = alone};
        change(asked);
        expect_same(asked, least_events);
      }
    };
    with([](Asked& a) { a.ground.mode = GroundMode::bounce; }, 300);
    with([](Asked& a) { a.ground.mode = GroundMode::land; }, 300);
    with([](Asked& a) { a.apexes = true; }, 300);
    with([](Asked& a) { a.despawn.farther = 3; }, 300);
    with(
        [](Asked& a) {
          a.despawn.outside_box = true, a.despawn.box_low = {-1, -2, -1}, a.despawn.box_high = {1, 3, 1};
        },
        300);
    with([](Asked& a) { a.despawn.slower = 2; }, 300);
    with([](Asked& a) { a.scene = true; }, 300);
    with([](Asked& a) { a.own_force = true; }, 100);
  }
}

TEST(EmitterPushed, threads_change_no_bit) {
  for (const Precision precision : kPrecisions) {
    const auto flown = [precision](unsigned threads) {
      WorldDef def{.ground = {.mode = GroundMode::bounce}, .max_projectiles = 12000};
      def.threading = {.threads = threads, .rows_per_thread = 1};
      World world = make_world(def);
      ProjectileDef p = spark(Motion::force);
      p.fidelity = Fidelity::game();
      p.fidelity.precision = precision;
      const EmitterId id = added(world, sparks(kind_of(world, p), 1, false));
      world.emit(id, 10000);  // three chunks of rows
      for (int i = 0; i < 30; ++i) EXPECT_TRUE(world.step(1.0 / 60));
      return world.hash();
    };
    EXPECT_EQ(flown(1), flown(3));
  }
}

}  // namespace physim::world_emitter_pushed_test
