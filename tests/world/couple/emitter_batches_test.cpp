// Births that go through side by side are those that go one by one: a sub-emitter that waits for an age, which a birth
// might reach in its own step, makes them go one by one.
#include <bit>

#include "random_emitters.hpp"
#include "world/emitter_support.hpp"

namespace physim::world_emitter_batches_test {

constexpr double kFrame = 1.0 / 64;

/// Bits of all that a world tells.
class Told {
 public:
  void step(World& world, double dt, const std::vector<EmitterId>& emitters) {
    ASSERT_TRUE(world.step(dt));
    for (const Event& e : world.events()) {
      add({static_cast<double>(e.kind), static_cast<double>(e.reason), e.value, e.time});
      add(e.id), add(e.position), add(e.velocity);
    }
    for (const EmitterId emitter : emitters) add(world, emitter);
  }
  bool operator==(const Told&) const = default;
  [[nodiscard]] std::size_t size() const { return words_.size(); }

 private:
  void add(std::initializer_list<double> numbers) {
    for (const double x : numbers) words_.push_back(std::bit_cast<std::uint64_t>(x));
  }
  void add(const Vec3d& v) { add({v.x, v.y, v.z}); }
  void add(ProjectileId id) { words_.push_back(std::uint64_t{id.index} << 32 | id.generation); }
  void add(const World& world, EmitterId emitter) {
    const EmitterCounts c = world.emitter_counts(emitter);
    for (const std::uint64_t count : {c.born, c.refused, c.aged, c.landed, c.expired, c.replaced, c.taken, c.cut})
      words_.push_back(count);
    const std::size_t alive = world.particles(emitter, {});
    std::vector<Vec3d> position(alive), previous(alive), velocity(alive), size(alive);
    std::vector<std::uint32_t> colour(alive);
    std::vector<ProjectileId> id(alive);
    std::vector<double> age(alive);
    world.particles(emitter, {.id = id,
                              .position = position,
                              .previous = previous,
                              .velocity = velocity,
                              .size = size,
                              .colour = colour,
                              .age = age});
    for (std::size_t i = 0; i < alive; ++i) {
      add(id[i]), add(position[i]), add(previous[i]), add(velocity[i]), add(size[i]);
      add({age[i], static_cast<double>(colour[i])});
    }
  }

  std::vector<std::uint64_t> words_;
};

/// Waits for what never comes.
SubEmitter never(EmitterId emitter) { return {.on = SubEvent::age, .emitter = emitter, .age = 1e9}; }

Fidelity random_rung(test::Random& r) {
  Fidelity f = r.one_in(3) ? Fidelity::arcade() : Fidelity::game();
  if (f.motion == Motion::force) f.drag = static_cast<DragModel>(r.below(4)), f.air = AirModel::isa;
  f.precision = r.one_in(2) ? Precision::float32 : Precision::float64;
  if (r.one_in(8)) f.integrator = Integrator::rk4;  // that no kernel knows
  if (r.one_in(4) && f.motion == Motion::force) f.integrator = Integrator::explicit_euler;
  if (r.one_in(4) && f.motion == Motion::force) f.gravity = GravityModel::inverse_square;
  return f;
}
WorldDef random_world(test::Random& r) {
  const IeeeMode mode;
  WorldDef def;
  if (r.one_in(2)) def.ground = {.mode = GroundMode::none};
  if (r.one_in(3)) def.environment.wind.velocity = {4, 0, 1};
  if (r.one_in(3)) def.max_projectiles = 150;
  def.pools = {{.maximum = static_cast<std::uint32_t>(r.one_in(3) ? 90 : 100000),
                .when_full = r.one_in(2) ? WhenFull::refuse : WhenFull::replace_oldest}};
  return def;
}
EmitterDef random_spray(test::Random& r, KindId kind, Motion motion) {
  const IeeeMode mode;
  EmitterDef def = test::random_emitter(r, kind, {});
  def.seed = 5;
  def.cycle.plays = true;
  def.cycle.delay = {0};
  def.flight = {};
  if (motion == Motion::force && r.one_in(3)) def.flight = test::random_flight(r);
  if (motion == Motion::force && r.one_in(3)) def.flight = {.drag = test::random_number(r, 0, 3)};
  if (!r.one_in(4)) def.gun = {}, def.rain = {}, def.per_metre = 0, def.start.gravity = {1};
  def.per_second = test::random_number(r, 200, 4000);
  if (r.one_in(3)) def.start.lifetime = {0.002, 0.05};  // some do not outlive the step of their birth
  if (r.one_in(2)) def.maximum = 3000;
  def.subs.clear();
  if (r.one_in(2)) def.bursts = {{.time = 0.05, .count = {40, 90}, .cycles = 3, .interval = 0.031}};
  return def;
}

/// Two emitters and one that the second sets off where its particles end.
Told session(std::uint64_t seed, bool one_by_one) {
  test::Random r(seed);
  World world = make_world(random_world(r));
  ProjectileDef p = spark();
  p.drag = {.table = DragTable::g1, .ballistic_coefficient = 10, .damping = 0.7, .k1 = 1e-4, .k2 = 2e-5};
  p.fidelity = random_rung(r);
  const KindId kind = kind_of(world, p);
  const Motion motion = p.fidelity.motion;
  p.fidelity = random_rung(r);
  const KindId other = kind_of(world, p);
  EmitterDef idle = spray(kind, 0, 1);
  idle.cycle.plays = false;
  const EmitterId nobody = added(world, idle);

  std::vector<EmitterDef> defs = {random_spray(r, kind, motion), random_spray(r, other, p.fidelity.motion),
                                  random_spray(r, other, p.fidelity.motion)};
  defs[2].cycle.plays = false;
  defs[2].inherit_velocity = 0;
  std::vector<EmitterId> ids;
  for (const int i : {2, 0, 1}) {
    EmitterDef def = defs[static_cast<std::size_t>(i)];
    if (i == 1)
      def.subs = {{.on = SubEvent::death,
                   .emitter = ids[0],
                   .count = {5, 40},
                   .probability = 0.3,
                   .axis = static_cast<SubAxis>(r.below(3)),
                   .inherit_velocity = 0.5,
                   .inherit_colour = true,
                   .inherit_size = true}};
    if (one_by_one) def.subs.push_back(never(nobody));
    ids.push_back(added(world, def));
  }
  Told told;
  for (int i = 0; i < 24; ++i) told.step(world, i % 5 == 0 ? 0.5 * kFrame : kFrame, ids);
  return told;
}

TEST(EmitterBatches, random_sprays_are_born_as_one_by_one) {
  std::size_t size = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Told together = session(seed, false);
    ASSERT_TRUE(together == session(seed, true)) << "seed " << seed;
    size += together.size();
  }
  EXPECT_GT(size, 1'000'000u);
}

TEST(EmitterBatches, calls_between_steps_and_bursts_too) {
  const auto run = [](bool one_by_one) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    const KindId kind = kind_of(world, spark());
    EmitterDef def = spray(kind, 0, 0.5);
    def.from = {.shape = EmitShape::ring, .arc_mode = ArcMode::spread};
    def.maximum = 500;
    def.bursts = {{.time = 0.01, .count = {333}, .cycles = 2, .interval = 0.02}};
    if (one_by_one) def.subs = {never({})};
    const EmitterId id = added(world, def);
    Told told;
    for (int i = 0; i < 40; ++i) {
      EXPECT_TRUE(world.emit(id, i < 4 ? 77 : 5));
      told.step(world, kFrame, {id});
    }
    return std::pair(told, world.emitter_counts(id));
  };
  const auto together = run(false), alone = run(true);
  EXPECT_TRUE(together.first == alone.first);
  EXPECT_EQ(together.second, alone.second);
  EXPECT_GT(together.second.refused, 100u);
  EXPECT_GT(together.second.aged, 100u);
}

TEST(EmitterBatches, too_many_of_a_step_are_cut_at_the_same_place) {
  const auto run = [](bool one_by_one) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = spray(kind_of(world, spark()), 1e9, 1);
    def.maximum = 10;
    if (one_by_one) def.subs = {never({})};
    const EmitterId id = added(world, def);
    EXPECT_TRUE(world.step(kFrame));
    EXPECT_TRUE(world.step(kFrame));
    return world.emitter_counts(id);
  };
  const EmitterCounts counts = run(false);
  EXPECT_EQ(counts, run(true));
  EXPECT_EQ(counts.cut, 1u);
}

/// Emitters of many rungs, most of which fire at the same moments.
Told turns(std::uint64_t seed, bool one_by_one) {
  test::Random r(seed);
  World world = make_world(random_world(r));
  EmitterDef idle = spray(kind_of(world, spark()), 0, 1);
  idle.cycle.plays = false;
  const EmitterId nobody = added(world, idle);
  const double rate = r.in(500, 8000);
  std::vector<EmitterId> ids;
  for (std::size_t i = 0, count = 2 + r.below(40); i < count; ++i) {
    ProjectileDef p = spark();
    p.drag = {.damping = 0.7, .k1 = 1e-4, .k2 = 2e-5};
    p.fidelity = random_rung(r);
    EmitterDef def = spray(kind_of(world, p), r.one_in(5) ? r.in(10, 20000) : rate, 0);
    def.seed = seed + i;
    def.from = {.shape = static_cast<EmitShape>(r.below(8))};
    def.start.lifetime = {r.one_in(4) ? 0.001 : 0.03, 0.2};
    def.start.speed = {1, 30};
    def.maximum = r.one_in(4) ? 60 : 3000;
    def.when_full = r.one_in(2) ? WhenFull::refuse : WhenFull::replace_oldest;
    if (one_by_one) def.subs = {never(nobody)};
    ids.push_back(added(world, def));
  }
  Told told;
  for (int i = 0; i < 10; ++i) told.step(world, i % 3 == 0 ? 0.5 * kFrame : kFrame, ids);
  return told;
}

TEST(EmitterBatches, emitters_that_fire_in_turn_are_born_as_one_by_one) {
  std::size_t size = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Told together = turns(seed, false);
    ASSERT_TRUE(together == turns(seed, true)) << "seed " << seed;
    size += together.size();
  }
  EXPECT_GT(size, 1'000'000u);
}

}  // namespace physim::world_emitter_batches_test
