// Emitters at their edges: where rounding, equal times, what comes between steps, and what is gone meet.
#include "world/emitter_support.hpp"

namespace physim::world_emitter_edges_test {

World empty_world() { return make_world({.ground = {.mode = GroundMode::none}}); }

TEST(EmitterEdges, births_by_distance_go_on_where_they_fall_on_frames) {
  for (const double rate : {30.0, 60.0, 120.0, 144.0}) {
    World world = empty_world();
    const KindId kind = kind_of(world, spark());
    while (world.time() < 1.1333) ASSERT_TRUE(world.step(1 / rate));
    EmitterDef def{.kind = kind,
                   .motion = SteadyMotion{.velocity = {60, 0, 0}},
                   .per_second = {0},
                   .per_metre = 6,
                   .maximum = 100000};
    const EmitterId id = added(world, def);
    const double from = world.time();
    while (world.time() < 12) ASSERT_TRUE(world.step(1 / rate));
    EXPECT_NEAR(double(world.emitter_counts(id).born), 360 * (world.time() - from), 1.001) << rate;
    const auto saved = must(world.save());
    EXPECT_TRUE(World::load(saved));
  }
}

TEST(EmitterEdges, two_that_wait_for_one_age_fire_once_each) {
  for (const bool prewarm : {false, true})
    for (const int rate : {5, 60}) {
      World world = empty_world();
      EmitterDef def = spray(kind_of(world, spark()), 0, 9);
      def.cycle.plays = false;
      const EmitterId smoke = added(world, def), flash = added(world, def);
      def = spray(def.kind, 10, 3);
      def.cycle = {.duration = 1, .looping = true, .prewarm = prewarm};
      def.subs = {{.on = SubEvent::age, .emitter = smoke, .age = 0.33},
                  {.on = SubEvent::age, .emitter = flash, .age = 0.33}};
      const EmitterId id = added(world, def);
      step_to(world, 1.05, rate);
      ASSERT_TRUE(world.stop_emitter(id));
      step_to(world, 2, rate);
      EXPECT_EQ(world.emitter_counts(smoke).born, world.emitter_counts(id).born);
      EXPECT_EQ(world.emitter_counts(flash).born, world.emitter_counts(id).born);
    }
}

TEST(EmitterEdges, who_follows_a_particle_ends_with_it) {
  for (const int rate : {4, 10, 60}) {
    World world = empty_world();
    EmitterDef def = spray(kind_of(world, spark()), 0, 0.27);
    def.cycle.plays = false;
    def.from = {};
    def.start.speed = {20};
    const EmitterId shell = added(world, def);
    ASSERT_EQ(*world.emit(shell, 1), 1u);
    const ProjectileId led = world.ids().front();
    EmitterDef trail = spray(def.kind, 50, 9);
    trail.from = {};
    trail.start.speed = {0};
    trail.follows = led;
    const EmitterId id = added(world, trail);
    std::vector<Event> events;
    step_to(world, 1, rate, &events);
    EXPECT_EQ(world.emitter_counts(id).born, 13u) << rate;  // 0.27 s, 50 a second
    EXPECT_FALSE(world.is_playing(id));
    for (const Event& e : told(events, EventKind::spawned, 1)) {
      if (e.id == led) continue;
      EXPECT_NEAR(e.position.y, 20 * e.time - 9.80665 / 2 * e.time * e.time, 1e-9) << rate;
    }
  }
}

TEST(EmitterEdges, how_many_a_sub_emitter_fires_does_not_depend_on_frames) {
  std::vector<std::uint64_t> first;
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}, .apex_events = true});
    EmitterDef def = spray(kind_of(world, spark()), 0, 9);
    def.cycle.plays = false;
    def.maximum = 1u << 20;
    const EmitterId a = added(world, def), b = added(world, def), c = added(world, def);
    def = spray(def.kind, 60, 1.3);
    def.subs = {{.on = SubEvent::apex, .emitter = a, .count = {0, 10}},
                {.on = SubEvent::age, .emitter = b, .count = {0, 10}, .age = 0.9},
                {.on = SubEvent::death, .emitter = c, .count = {0, 10}, .probability = 0.5}};
    added(world, def);
    std::vector<Event> events;
    step_to(world, 2.2, rate, &events);
    std::vector<std::uint64_t> counts;
    for (const double end : {1.5, 1.9, 2.1}) counts.push_back(told(events, EventKind::spawned, end).size());
    if (first.empty()) first = counts;
    EXPECT_EQ(counts, first) << rate;
  }
}

TEST(EmitterEdges, what_is_put_up_after_a_prewarm_is_met) {
  World world = empty_world();
  Scene scene;
  const ShapeId box = *scene.add_shape(BoxShape{{0.1, 50, 50}});
  ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = {900, 0, 0}}}));
  ASSERT_TRUE(world.set_scene(scene));
  EmitterDef def{.kind = kind_of(world, spark(), {.collision = {.on_hit = OnHit::stop}}),
                 .cycle = {.duration = 0.5, .prewarm = true},
                 .per_second = {20},
                 .start = {.lifetime = {20}, .speed = {10}}};
  const EmitterId id = added(world, def);
  ASSERT_TRUE(world.add_instance({.shape = box, .transform = {.position = {25, 0, 0}}}));
  ASSERT_TRUE(world.stop_emitter(id));
  step_to(world, 4, 60);
  EXPECT_EQ(world.emitter_counts(id).landed, 10u);
}

TEST(EmitterEdges, functions_asked_about_the_past_change_nothing) {
  World world = empty_world();
  int refused = 0;
  EmitterDef def{.kind = kind_of(world, spark(), {.collision = {.on_hit = OnHit::stop}})};
  Scene scene;
  ASSERT_TRUE(
      scene.set_engine({.query = [&](const EngineBatch&) { refused += world.spawn(def.kind, Launch{}) ? 0 : 1; }}));
  ASSERT_TRUE(world.set_scene(scene));
  def.cycle.prewarm = true;
  def.cycle.duration = 0.5;
  added(world, def);
  EXPECT_GT(refused, 0);
}

TEST(EmitterEdges, a_life_that_vanishes_in_rounding_ends_at_once) {
  World world = empty_world();
  step_to(world, 1, 64);
  EmitterDef def = spray(kind_of(world, spark()), 0, 1e-17);
  def.cycle.plays = false;
  const EmitterId id = added(world, def);
  ASSERT_EQ(*world.emit(id, 3), 3u);
  std::vector<Vec3d> size(3);
  EXPECT_EQ(world.particles(id, {.size = size}), 3u);
  ASSERT_TRUE(world.step(0.1));
  EXPECT_EQ(world.emitter_counts(id).aged, 3u);
}

TEST(EmitterEdges, memory_does_not_grow_where_the_oldest_would_make_room) {
  World world = empty_world();
  EmitterDef def = spray(kind_of(world, spark()), 20000, 0.01);
  def.when_full = WhenFull::replace_oldest;
  added(world, def);
  step_to(world, 0.5, 50);
  world.forget_events();
  const std::size_t before = world.memory();
  step_to(world, 3, 50);
  EXPECT_LT(world.memory(), before + before / 4);
}

TEST(EmitterEdges, a_long_past_costs_what_is_alive) {
  World world = empty_world();
  EmitterDef def = spray(kind_of(world, spark()), 20000, 0.05);
  def.cycle.duration = 60;
  def.cycle.prewarm = true;
  const EmitterId id = added(world, def);
  const EmitterCounts c = world.emitter_counts(id);
  EXPECT_TRUE(world.is_playing(id));
  EXPECT_EQ(c.born, 1'200'000u);
  EXPECT_EQ(c.cut, 0u);
  EXPECT_NEAR(c.alive, 1000, 1);
}

TEST(EmitterEdges, calls_between_steps_are_counted_each_for_itself) {
  World world = empty_world();
  EmitterDef def = spray(kind_of(world, spark()), 0, 9);
  def.cycle.plays = false;
  def.maximum = 1;
  const EmitterId marks = added(world, def);
  def.subs = {{.on = SubEvent::trigger, .emitter = marks, .count = {600'000}}};
  const EmitterId id = added(world, def);
  ASSERT_EQ(*world.emit(id, 1), 1u);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(world.trigger_emitter(id));
  EXPECT_EQ(world.emitter_counts(marks).born + world.emitter_counts(marks).refused, 1'800'000u);
  EXPECT_EQ(world.emitter_counts(marks).cut, 0u);
}

TEST(EmitterEdges, the_hash_knows_when_those_end_whose_emitter_is_gone) {
  World one = empty_world(), other = empty_world();
  for (World* world : {&one, &other}) {
    EmitterDef def = spray(kind_of(*world, spark()), 0, world == &one ? 0.5 : 5);
    def.cycle.plays = false;
    def.from = {};
    def.start.speed = {1};
    const EmitterId id = added(*world, def);
    ASSERT_EQ(*world->emit(id, 1), 1u);
    ASSERT_TRUE(world->remove_emitter(id));
  }
  EXPECT_NE(one.hash(), other.hash());
}

TEST(EmitterEdges, what_no_numbers_can_hold_is_refused) {
  World world = empty_world();
  EmitterDef def = spray(kind_of(world, spark()), 10, 1);
  const EmitterId id = added(world, def);
  EXPECT_FALSE(world.move_emitter(id, {.position = {1e200, 0, 0}}));
  def.gun = {.rounds_per_minute = 60, .barrels = {{}, {}}, .convergence = 1e-200};
  EXPECT_FALSE(world.add_emitter(def));
  def.gun = {};
  def.bursts = {{.cycles = 1, .interval = 1e-17}};
  EXPECT_TRUE(world.add_emitter(def));
  def.bursts = {{.cycles = 0, .interval = 1e-17}};
  EXPECT_FALSE(world.add_emitter(def));  // too many
  def.bursts = {};
  def.per_second = {1, 1, {{0, 0}, {1e-9, 1}, {2e-9, 0}}};
  EXPECT_FALSE(world.add_emitter(def));  // too few
}

TEST(EmitterEdges, laws_are_made_of_sound_numbers_only) {
  World world = empty_world();
  EmitterDef def = spray(kind_of(world, spark()), 10, 1);
  for (const double at : {0.0, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
    def.flight.drag = {1, {}, {{0.5, 1}, {at, 2}}};  // keys that do not rise
    const auto added = world.add_emitter(def);
    ASSERT_FALSE(added) << at;
    EXPECT_EQ(added.error().place, "emitter.flight.drag.curve[1].at") << at;
  }
}

}  // namespace physim::world_emitter_edges_test
