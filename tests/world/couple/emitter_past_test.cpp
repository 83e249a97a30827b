// Emitters of worlds that are prewarmed: what they let out before the world's time.
#include "world/emitter_support.hpp"

namespace physim::world_emitter_past_test {

TEST(EmitterPast, one_that_is_prewarmed_is_as_if_it_had_waited) {
  for (const ProjectileDef& projectile :
       {spark(), spark(Motion::force, Integrator::tsit5), spark(Motion::force, Integrator::semi_implicit_euler)}) {
    const bool is_stepped = projectile.fidelity.integrator == Integrator::semi_implicit_euler &&
                            projectile.fidelity.motion == Motion::force;
    const auto def_of = [&](World& world, bool prewarm) {
      EmitterDef def = spray(kind_of(world, projectile), 200, 0.8);
      def.cycle.duration = 1.5;
      def.cycle.prewarm = prewarm;
      def.start.lifetime = {0.3, 1.4};
      def.maximum = 150;
      return def;
    };
    World waited = make_world({.ground = {.mode = GroundMode::bounce, .height = -1}});
    const EmitterId a = added(waited, def_of(waited, false));
    step_to(waited, 1.5, 60);
    World warmed = make_world({.ground = {.mode = GroundMode::bounce, .height = -1}});
    const EmitterId b = added(warmed, def_of(warmed, true));
    EXPECT_EQ(warmed.time(), 0);
    EXPECT_EQ(warmed.emitter_counts(b).born, waited.emitter_counts(a).born);
    EXPECT_EQ(warmed.emitter_counts(b).refused, waited.emitter_counts(a).refused);
    for (int later = 0; later < 2; ++later) {
      const auto then = alive(waited, a), now = alive(warmed, b);
      ASSERT_EQ(then.size(), now.size());
      ASSERT_GT(now.size(), 100u);
      for (const auto& [number, state] : now) {
        ASSERT_TRUE(then.contains(number));
        EXPECT_LT(length(then.at(number).position - state.position), is_stepped ? 0.15 : 1e-7) << number;
      }
      step_to(waited, 2, 60);
      step_to(warmed, 0.5, 60);
    }
  }
}

TEST(EmitterPast, one_that_follows_stands_still_in_its_past) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  const KindId kind = kind_of(world, spark(), {.use_gravity = false});
  const auto led = must(world.spawn(kind, {.position = {3, 2, 1}, .velocity = Vec3d{10, 0, 0}}));
  EmitterDef def{.kind = kind,
                 .cycle = {.duration = 1, .prewarm = true},
                 .follows = led,
                 .inherit_velocity = 1,
                 .per_second = {5},
                 .start = {.speed = {0}}};
  const auto all = alive(world, added(world, def));
  ASSERT_EQ(all.size(), 5u);
  for (const auto& [number, state] : all) {
    EXPECT_NEAR(state.velocity.x, 10, 1e-12) << number;
    EXPECT_NEAR(state.position.x, 3 + 10 * (1 - 0.2 * static_cast<double>(number + 1)), 1e-12) << number;
  }
}

TEST(EmitterPast, the_past_of_a_prewarmed_one_sets_off_too) {
  const auto show = [](World& world, bool prewarm) {
    EmitterDef def = spray(kind_of(world, spark()), 0, 5);
    def.cycle.plays = false;
    const EmitterId marks = added(world, def);
    def = spray(def.kind, 40, 0.5071);
    def.cycle = {.duration = 2, .prewarm = prewarm};
    def.subs = {{.on = SubEvent::death, .emitter = marks, .count = {3}},
                {.on = SubEvent::age, .emitter = marks, .age = 0.2137},
                {.on = SubEvent::birth, .emitter = marks}};
    added(world, def);
    return marks;
  };
  World waited = make_world({.ground = {.mode = GroundMode::none}});
  World warmed = make_world({.ground = {.mode = GroundMode::none}});
  const EmitterId a = show(waited, false), b = show(warmed, true);
  step_to(waited, 2, 50);
  const auto then = alive(waited, a), now = alive(warmed, b);
  EXPECT_EQ(now.size(), 80u + 3 * 59 + 71);
  ASSERT_EQ(then.size(), now.size());
  for (const auto& [number, state] : now) EXPECT_LT(length(then.at(number).position - state.position), 1e-10) << number;
}

/// Particles without an end that would fly for years: by steps, or from bounce to bounce.
TEST(EmitterPast, one_that_takes_too_many_steps_is_cut) {
  constexpr double kYears = 1e9;
  struct Case {
    Motion motion;
    GroundMode ground;
    WhenFull when_full;
    double time;  // [s]
  };
  for (const Case& c : {Case{Motion::force, GroundMode::none, WhenFull::refuse, kYears},
                        Case{Motion::closed_form, GroundMode::bounce, WhenFull::replace_oldest, kYears},
                        Case{Motion::closed_form, GroundMode::none, WhenFull::replace_oldest, 1000}}) {
    World world = make_world({.ground = {.mode = c.ground, .height = -1}});
    EmitterDef def =
        spray(kind_of(world, spark(c.motion), {.can_sleep = false, .restitution = 1, .friction = 0}), 10, kInfinity);
    def.maximum = 40;
    def.when_full = c.when_full;
    const EmitterId emitter = added(world, def);
    ASSERT_TRUE(world.seek_emitter(emitter, c.time));
    const EmitterCounts n = world.emitter_counts(emitter);
    EXPECT_EQ(n.born, n.aged + n.landed + n.expired + n.replaced + n.taken + n.alive);
    const bool is_cut = c.time == kYears;
    EXPECT_EQ(n.cut > 0, is_cut);
    EXPECT_EQ(n.taken, is_cut ? 1u : 0u) << "the one at hand";
    EXPECT_EQ(world.is_playing(emitter), !is_cut);
    if (!is_cut) {
      EXPECT_EQ(n.alive, 40u);
    }
    ASSERT_TRUE(world.seek_emitter(emitter, 3)) << "it may be asked again";
    EXPECT_EQ(world.emitter_counts(emitter).alive, 30u);
    EXPECT_TRUE(world.is_playing(emitter));
    EXPECT_TRUE(world.step(1.0 / 60));
  }
}

}  // namespace physim::world_emitter_past_test
