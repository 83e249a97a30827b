// Emitters and frames: who is born, when and how, and where they are, do not depend on how long steps are.
#include "world/emitter_support.hpp"

namespace physim::world_emitter_frames_test {

constexpr double kEnd = 2;

KeyedMotion loop_of_keys() {
  KeyedMotion motion{.curve = MotionCurve::smooth};
  for (int i = 0; i <= 40; ++i) {
    const double a = i * 0.9;
    motion.keys.push_back({i * 0.3,
                           {10 * std::cos(a), 1 + 0.5 * i, 10 * std::sin(a)},
                           {1, 0, 0.1 * i, 0},
                           {-30 * std::sin(a), 1, 30 * std::cos(a)}});
  }
  return motion;
}

using Make = EmitterDef (*)(World&);

EmitterDef fixed(World& world) { return spray(kind_of(world, spark()), 400, 0.7); }
EmitterDef on_path(World& world) {
  EmitterDef def = fixed(world);
  def.motion = loop_of_keys();
  def.inherit_velocity = 0.5;
  return def;
}
EmitterDef by_distance(World& world) {
  EmitterDef def = on_path(world);
  def.per_second = {0};
  def.per_metre = 7;
  return def;
}
EmitterDef of_everything(World& world) {
  EmitterDef def = on_path(world);
  def.cycle.duration = 0.37;
  def.cycle.delay = {0.05, 0.1};
  def.cycle.rate = 1.3;
  def.per_second = {50, 900, {{0, 1}, {0.5, 0.1}, {1, 1}}};
  def.bursts = {{.time = 0.11, .count = {3, 9}, .cycles = 4, .interval = 0.02, .probability = 0.7}};
  def.gun = {.rounds_per_minute = 3000, .burst_rounds = 5, .burst_pause = 0.1, .dispersion = 0.01};
  def.start.lifetime = {0.2, 1.1};
  def.start.gravity = {0.5, 1.5};
  return def;
}

TEST(EmitterFrames, births_are_the_same_to_the_bit) {
  constexpr double kLong = 10;
  for (const Make make : {fixed, on_path, by_distance, of_everything}) {
    std::vector<Event> first;
    for (const int rate : kFrameRates) {
      World world = make_world({.ground = {.mode = GroundMode::none}});
      added(world, make(world));
      std::vector<Event> events;
      step_to(world, kLong + 0.2, rate, &events);
      const std::vector<Event> born = told(events, EventKind::spawned, kLong);
      if (first.empty()) first = born;
      ASSERT_GT(born.size(), 500u);
      ASSERT_EQ(born.size(), first.size()) << rate;
      for (std::size_t i = 0; i < born.size(); ++i) {
        ASSERT_EQ(born[i].time, first[i].time) << rate << ", " << i;
        ASSERT_EQ(born[i].position, first[i].position) << rate << ", " << i;
        ASSERT_EQ(born[i].velocity, first[i].velocity) << rate << ", " << i;
      }
    }
  }
}

/// Where all are at a time that every frame rate reaches, against the closed form of each one's birth.
void expect_places(const ProjectileDef& projectile, double within) {
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = on_path(world);
    def.kind = kind_of(world, projectile);
    const EmitterId emitter = added(world, def);
    std::vector<Event> events;
    step_to(world, kEnd, rate, &events);
    const std::vector<Event> born = told(events, EventKind::spawned, kEnd);
    const auto all = alive(world, emitter);
    ASSERT_GT(all.size(), 200u);
    for (const auto& [number, state] : all) {
      const Event& b = born.at(number);
      const double t = world.time() - b.time;
      const Vec3d g{0, -world.def().environment.gravity.acceleration, 0};
      EXPECT_LT(length(state.position - (b.position + b.velocity * t + g * (t * t / 2))), within) << rate;
      EXPECT_LT(length(state.velocity - (b.velocity + g * t)), within * 10) << rate;
    }
  }
}

TEST(EmitterFrames, places_of_closed_forms_are_exact) { expect_places(spark(), 1e-11); }
TEST(EmitterFrames, places_of_adaptive_steps_are_within_their_tolerance) {
  expect_places(spark(Motion::force, Integrator::tsit5), 1e-8);
}

TEST(EmitterFrames, places_of_float_rows_are_within_their_precision) {
  ProjectileDef p = spark();
  p.fidelity.precision = Precision::float32;
  expect_places(p, 3e-5);
}

TEST(EmitterFrames, a_stepped_rung_has_its_own_error_of_first_order) {
  const auto worst = [](int rate) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = fixed(world);
    def.kind = kind_of(world, spark(Motion::force));
    const EmitterId emitter = added(world, def);
    std::vector<Event> events;
    step_to(world, 1, rate, &events);
    const std::vector<Event> born = told(events, EventKind::spawned, 1);
    double off = 0;
    for (const auto& [number, state] : alive(world, emitter)) {
      const Event& b = born.at(number);
      const double t = world.time() - b.time;
      off = std::max(off, length(state.position - (b.position + b.velocity * t + Vec3d{0, -9.80665 / 2 * t * t, 0})));
    }
    return off;
  };
  const double coarse = worst(32), fine = worst(64);
  EXPECT_GT(coarse, 0.02);
  EXPECT_NEAR(coarse / fine, 2, 0.1);
}

TEST(EmitterFrames, lives_end_at_their_moment_and_place) {
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = of_everything(world);
    added(world, def);
    std::vector<Event> events;
    step_to(world, kEnd, rate, &events);
    std::map<ProjectileId, Event> born;
    std::size_t ended = 0;
    for (const Event& e : events) {
      if (e.kind == EventKind::spawned) born[e.id] = e;
      if (e.kind != EventKind::expired) continue;
      const Event& b = born.at(e.id);
      const double t = e.time - b.time;
      EXPECT_EQ(e.reason, Reason::older);
      EXPECT_GE(t, 0.2 - 1e-12);
      EXPECT_LE(t, 1.1 + 1e-12);
      const Vec3d way = e.position - (b.position + b.velocity * t);
      EXPECT_LT(std::hypot(way.x, way.z), 1e-10);
      EXPECT_LE(way.y, -0.5 * 9.80665 / 2 * t * t + 1e-10);
      EXPECT_GE(way.y, -1.5 * 9.80665 / 2 * t * t - 1e-10);
      ++ended;
    }
    EXPECT_GT(ended, 300u) << rate;
  }
}

TEST(EmitterFrames, along_a_path_there_is_no_gap_and_no_clump) {
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def{.kind = kind_of(world, spark()),
                   .motion = SteadyMotion{.velocity = {300, 40, -5}},
                   .per_second = {0},
                   .per_metre = 4,
                   .start = {.speed = {0}},
                   .maximum = 10000};
    added(world, def);
    std::vector<Event> events;
    step_to(world, 1, rate, &events);
    const std::vector<Event> born = told(events, EventKind::spawned, 1);
    ASSERT_GT(born.size(), 1200u);
    for (std::size_t i = 0; i < born.size(); ++i)
      EXPECT_NEAR(length(born[i].position), 0.25 * static_cast<double>(i + 1), 1e-9) << rate;
  }
}

TEST(EmitterFrames, who_is_moved_by_calls_goes_straight_from_each_to_the_next) {
  std::vector<Event> first;
  for (const int rate : {8, 16, 64}) {  // each describes the corners of the others
    World world = make_world({.ground = {.mode = GroundMode::none}});
    EmitterDef def = fixed(world);
    def.inherit_velocity = 1;
    def.per_metre = 3;
    const EmitterId emitter = added(world, def);
    const auto place = [](double t) {
      const double corner = std::floor(t * 8) / 8, part = (t - corner) * 8;
      const auto at = [](double c) { return Vec3d{20 * c, c * c, 5 - 3 * c}; };
      return at(corner) + (at(corner + 0.125) - at(corner)) * part;
    };
    ASSERT_TRUE(world.move_emitter(emitter, {.position = place(0), .rotation = def.rotation}));
    std::vector<Event> events;
    ASSERT_TRUE(world.step(0.125));  // it goes to its first place
    for (int i = 1; i <= rate; ++i) {
      ASSERT_TRUE(world.move_emitter(emitter, {.position = place(double(i) / rate), .rotation = def.rotation}));
      ASSERT_TRUE(world.step(1.0 / rate));
      events.insert(events.end(), world.events().begin(), world.events().end());
    }
    const std::vector<Event> born = told(events, EventKind::spawned, 2);
    if (first.empty()) first = born;
    ASSERT_GT(born.size(), 400u);
    ASSERT_EQ(born.size(), first.size());
    for (std::size_t i = 0; i < born.size(); ++i) {
      EXPECT_NEAR(born[i].time, first[i].time, 1e-12);
      EXPECT_LT(length(born[i].position - first[i].position), 1e-11);
      EXPECT_LT(length(born[i].velocity - first[i].velocity), 1e-9);
    }
  }
}

TEST(EmitterFrames, metres_count_from_the_first_cycle_on_whoever_moves_it) {
  for (const int rate : {7, 50, 1000})
    for (const int way : {0, 1, 2}) {  // by calls, on a path, behind a projectile
      World world = make_world({.ground = {.mode = GroundMode::none}});
      EmitterDef def{.kind = kind_of(world, spark(), {.use_gravity = false}),
                     .cycle = {.delay = {0.6}},
                     .per_second = {0},
                     .per_metre = 10,
                     .start = {.speed = {0}}};
      if (way == 1) def.motion = SteadyMotion{.velocity = {3, 0, 0}};
      if (way == 2) def.follows = *world.spawn(def.kind, {.velocity = Vec3d{3, 0, 0}});
      const EmitterId id = added(world, def);
      for (int i = 1; i <= 2 * rate; ++i) {
        if (way == 0) {
          ASSERT_TRUE(world.move_emitter(id, {.position = {3.0 * i / rate, 0, 0}}));
        }
        ASSERT_TRUE(world.step(1.0 / rate));
      }
      const auto all = alive(world, id);
      EXPECT_NEAR(static_cast<double>(all.size()), 42, 1) << rate << ", " << way;  // the last is due at the very end
      for (const auto& [number, state] : all)
        EXPECT_NEAR(state.position.x, 1.8 + 0.1 * static_cast<double>(number + 1), 1e-9) << rate << ", " << way;
    }
}

TEST(EmitterFrames, who_follows_a_closed_form_is_where_it_is) {
  for (const int rate : kFrameRates) {
    World world = make_world({.ground = {.mode = GroundMode::none}});
    const BodyState start{{1, 2, 3}, {40, 30, -20}};
    const ProjectileId led = *world.spawn(spark(), {.position = start.position, .velocity = start.velocity});
    EmitterDef def = fixed(world);
    def.follows = led;
    def.from = {};
    def.start.speed = {0};
    def.inherit_velocity = 0.25;
    added(world, def);
    std::vector<Event> events;
    step_to(world, 1, rate, &events);
    const Vec3d g{0, -9.80665, 0};
    std::size_t count = 0;
    for (const Event& e : told(events, EventKind::spawned, 1)) {
      if (e.id == led) continue;
      EXPECT_LT(length(e.position - (start.position + start.velocity * e.time + g * (e.time * e.time / 2))), 1e-11);
      EXPECT_LT(length(e.velocity - (start.velocity + g * e.time) * 0.25), 1e-10);
      ++count;
    }
    EXPECT_EQ(count, 400u);
  }
}

}  // namespace physim::world_emitter_frames_test
