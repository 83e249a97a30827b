// What rows know to be clear of things at rest, while others move, come, start and stop: no answer changes.
#include "world/clear_support.hpp"
#include "world/core/newcomers.hpp"

namespace physim::world_scene_clear_movers_test {

using namespace test_clear;

Quatd some_turn(Random& r) { return normalized(Quatd{r.in(-1, 1), r.in(-1, 1), r.in(-1, 1), r.in(-1, 1) + 2}); }

/// Somewhere on the way of somebody, soon; or where somebody will not be.
Vec3d some_place(const Pair& pair, Random& r) {
  const ProjectileId id = pair.ids[std::size_t(r.below(int(pair.ids.size())))];
  if (r.one_in(3) || !pair.clear[id].is_alive()) {
    const double x = r.in(0, kSide), z = r.in(0, kSide);
    return {x, height(x, z) + r.in(0, 5), z};
  }
  return pair.clear[id].position() + pair.clear[id].velocity() * r.in(0.01, 0.2);
}

/// From key to key, with rests between some of them: it starts and stops.
SceneMotion some_keys(const Pair& pair, Random& r) {
  KeyedMotion motion{.curve = r.one_in(2) ? MotionCurve::smooth : MotionCurve::straight};
  double time = pair.clear.time() + r.in(-0.1, 0.2);
  for (int i = 0, count = 2 + r.below(5); i < count; ++i) {
    const bool stays = i > 0 && r.one_in(3);
    const Vec3d place = stays ? motion.keys.back().position : some_place(pair, r);
    motion.keys.push_back({time, place, some_turn(r), stays ? Vec3d{} : r.vector(10)});
    time += r.in(0.02, 0.5);
  }
  return motion;
}

/// A mover by its path: slow or very fast, straight, along keys, turning on its place, or from behind.
InstanceDef some_mover(const Pair& pair, Random& r, const Shapes& shapes) {
  InstanceDef mover{.shape = std::array{shapes.box, shapes.ball, shapes.post}[std::size_t(r.below(3))]};
  const double now = pair.clear.time();
  const ProjectileId id = pair.ids[std::size_t(r.below(int(pair.ids.size())))];
  mover.transform = {.position = some_place(pair, r), .rotation = some_turn(r), .scale = r.in(0.3, 2)};
  const double soon = r.in(0.01, 0.3);
  switch (r.below(5)) {
    case 0: mover.motion = SteadyMotion{.start = now + soon, .velocity = r.vector(20)}; break;
    case 1: mover.motion = SteadyMotion{.start = now + soon, .velocity = r.vector(1500)}; break;
    case 2: mover.motion = SteadyMotion{.start = now, .velocity = r.vector(2), .angular_velocity = r.vector(60)}; break;
    case 3: mover.motion = some_keys(pair, r); break;
    default:
      if (!pair.clear[id].is_alive()) break;
      const Vec3d velocity = pair.clear[id].velocity();
      mover.transform.position = pair.clear[id].position() - velocity * r.in(0.05, 0.2);
      mover.motion = SteadyMotion{.start = now, .velocity = velocity * r.in(1.5, 4), .angular_velocity = r.vector(1)};
  }
  return mover;
}

/// A thing that the caller takes along before each step: put elsewhere, or moved there during the step.
struct Cart {
  InstanceId thing;
  Vec3d place, velocity;
  bool glides;
};

void drive(Pair& pair, Random& r, std::vector<Cart>& carts, double dt) {
  for (Cart& cart : carts) {
    if (r.one_in(40)) cart.place = some_place(pair, r), cart.velocity = r.vector(15);
    if (r.one_in(30)) continue;  // it stands for a step
    const Vec3d from = cart.place;
    cart.place += cart.velocity * dt;
    if (cart.glides) {
      const double now = pair.clear.time();
      const KeyedMotion motion{.keys = {{now, from, {}, {}}, {now + dt, cart.place, {}, {}}}};
      pair.both([&](World& w) { return w.set_instance_motion(cart.thing, motion); });
    } else {
      pair.both([&](World& w) { return w.move_instance(cart.thing, {.position = cart.place}); });
    }
  }
}

/// Some mover comes, another one begins to move, moves otherwise, rests or goes.
void stir(Pair& pair, Random& r, const Shapes& shapes) {
  const std::size_t some = pair.things.empty() ? 0 : std::size_t(r.below(int(pair.things.size())));
  const InstanceDef mover = some_mover(pair, r, shapes);
  switch (pair.things.size() < 5 ? 0 : r.below(5)) {
    case 0:
      if (const auto made = pair.both([&](World& w) { return w.add_instance(mover); })) pair.things.push_back(*made);
      break;
    case 1: pair.both([&](World& w) { return w.set_instance_motion(pair.things[some], mover.motion); }); break;
    case 2: pair.both([&](World& w) { return w.set_instance_motion(pair.things[some], AtRest{}); }); break;
    case 3: pair.both([&](World& w) { return w.move_instance(pair.things[some], mover.transform); }); break;
    default:
      pair.both([&](World& w) { return w.remove_instance(pair.things[some]); });
      pair.things.erase(pair.things.begin() + std::ptrdiff_t(some));
  }
}

std::vector<Cart> some_carts(Pair& pair, Random& r, const Shapes& shapes, int count) {
  std::vector<Cart> carts;
  for (int i = 0; i < count; ++i) {
    const Vec3d place = some_place(pair, r);
    const InstanceDef def{.shape = r.one_in(2) ? shapes.box : shapes.ball, .transform = {.position = place}};
    if (const auto made = pair.both([&](World& w) { return w.add_instance(def); }))
      carts.push_back({*made, place, r.vector(15), r.one_in(2)});
  }
  return carts;
}

/// Hits on what came after the land and all that stands on it.
std::size_t hits_of_others(const World& world, std::size_t land) {
  const auto hits = events_of(world, EventKind::hit);
  return std::size_t(std::ranges::count_if(hits, [&](const Event& e) { return e.instance.index > land; }));
}

TEST(SceneClear, what_moves_is_met_by_those_who_know_what_rests) {
  std::size_t hits = 0;
  for (std::uint64_t seed = 101; seed <= 124; ++seed) {
    SCOPED_TRACE(seed);
    Trial trial(seed);
    auto& [r, shapes, scene, pair] = trial;
    if (r.one_in(2))
      pair.both([](World& w) {
        return w.add_force({.law = ConstantAcceleration{{1, 0, 2}}, .target = {.layers = 2}});
      });
    launch_some(pair, r, 50);
    std::vector<Cart> carts = some_carts(pair, r, shapes, std::array{0, 3, 30}[std::size_t(r.below(3))]);
    const double dt = std::array{1.0 / 30, 1.0 / 60, 1.0 / 240}[std::size_t(r.below(3))];
    const int calm = r.below(6);
    for (int i = 0, count = std::array{0, 2, 40}[std::size_t(r.below(3))]; i < count; ++i) stir(pair, r, shapes);
    for (int step = 0; step < 90; ++step) {
      drive(pair, r, carts, dt);
      if (r.one_in(2 + calm)) stir(pair, r, shapes);
      if (r.one_in(4)) push(pair, r);
      if (step == 40) launch_some(pair, r, 20);
      pair.clear.step(dt), pair.asking.step(dt);
      expect_the_same(pair, step);
      if (testing::Test::HasFatalFailure()) return;
      hits += hits_of_others(pair.clear, scene.size() + 1);
    }
  }
  EXPECT_GT(hits, 300u);
}

TEST(SceneClear, what_moves_is_met_after_moments_saves_and_frames) {
  for (std::uint64_t seed = 201; seed <= 208; ++seed) {
    SCOPED_TRACE(seed);
    Trial trial(seed);
    auto& [r, shapes, scene, pair] = trial;
    launch_some(pair, r, 40);
    std::vector<Cart> carts = some_carts(pair, r, shapes, 4);
    for (int i = 0; i < 6; ++i) stir(pair, r, shapes);
    Snapshot clear, asking;
    std::vector<InstanceId> things;
    for (int step = 0; step < 80; ++step) {
      const double frame = r.in(0.004, 0.04);
      drive(pair, r, carts, frame);
      if (r.one_in(3)) stir(pair, r, shapes);
      if (step == 20) clear = pair.clear.snapshot(), asking = pair.asking.snapshot(), things = pair.things;
      if (step == 45) {  // of two worlds one begins where the other one was
        ASSERT_TRUE(pair.clear.restore(clear) && pair.asking.restore(asking));
        pair.things = things;
      }
      if (step == 60) {
        pair.clear = reloaded(pair.clear);
      }
      EXPECT_EQ(pair.clear.advance(frame), pair.asking.advance(frame));
      expect_the_same(pair, step);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(SceneClear, many_newcomers_are_known_after_a_while) {
  for (std::uint64_t seed = 301; seed <= 304; ++seed) {
    SCOPED_TRACE(seed);
    Trial trial(seed);
    auto& [r, shapes, scene, pair] = trial;
    launch_some(pair, r, 10);
    const int many = seed % 2 == 0 ? int(Newcomers::kMost) + 50 : 20;
    for (int step = 0; step < 2 * int(Newcomers::kQuiet); ++step) {
      if (step == 5) some_carts(pair, r, shapes, many);
      if (step % 40 == 0) launch_some(pair, r, 5);
      pair.clear.step(1.0 / 120), pair.asking.step(1.0 / 120);
      expect_the_same(pair, step);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

/// A world in which one ball hangs far above a plane, or drifts slowly, and knows it.
struct Hanging {
  World world;
  ProjectileId id;
  ShapeId ball;  // of a metre

  Hanging(const Vec3d& velocity, double radius, Precision precision) {
    WorldDef def{.environment = {.atmosphere = {.model = AirModel::vacuum}}, .ground = {.mode = GroundMode::none}};
    world = make_world(def);
    Scene scene;
    put(scene, PlaneShape{}, {0, -40, 0});
    ball = *scene.add_shape(SphereShape{1});
    EXPECT_TRUE(world.set_scene(scene));
    ProjectileDef p = stone();
    p.fidelity.precision = precision;
    BodyDef body{.gravity_scale = 0, .can_sleep = false, .collision = {.on_hit = OnHit::stop, .radius = radius}};
    id = *world.spawn(p, {.position = {0, 0, 0}, .velocity = velocity}, body);
  }

  /// When something is met in so many steps; 0: never.
  double met(int steps, double dt) {
    for (int i = 0; i < steps; ++i) {
      world.step(dt);
      for (const Event& e : events_of(world, EventKind::hit)) return e.time;
    }
    return 0;
  }
};

TEST(SceneClear, a_mover_meets_whoever_knows_that_all_at_rest_is_far) {
  const double dt = 1.0 / 60;
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const double radius : {0.0, 0.5, 6.0})
      for (const double speed : {0.5, 30.0, 3000.0})
        for (const double drift : {0.0, 0.25})
          for (const Vec3d& way : {Vec3d{1, 0, 0}, Vec3d{0, -1, 0}, Vec3d{0.6, 0, -0.8}}) {
            Hanging one({drift, 0, 0}, radius, precision);
            EXPECT_EQ(one.met(100, dt), 0);  // it has looked around
            const double now = one.world.time(), after = 1.5 + 0.4 * dt;
            const Vec3d there = one.world[one.id].position() + Vec3d{drift, 0, 0} * after;
            const Vec3d begin = there - way * ((1 + radius) + speed * after);
            // It comes at `speed` and drifts along.
            const SteadyMotion motion{.start = now, .velocity = way * speed + Vec3d{drift, 0, 0}};
            const InstanceDef mover{
                .shape = one.ball, .transform = {.position = begin - Vec3d{drift, 0, 0} * after}, .motion = motion};
            ASSERT_TRUE(one.world.add_instance(mover));
            EXPECT_NEAR(one.met(200, dt), now + after, 1e-4 + 1e-5 / speed) << speed << " " << radius;
          }
}

TEST(SceneClear, what_the_caller_takes_along_meets_whoever_knows_that_all_at_rest_is_far) {
  const double dt = 1.0 / 60, speed = 5, drift = 1;
  for (const bool glides : {true, false})
    for (const double radius : {0.0, 0.5, 6.0}) {
      Hanging one({-drift, 0, 0}, radius, Precision::float32);
      const double from = -(1 + radius) - 10;
      const InstanceId thing = *one.world.add_instance({.shape = one.ball, .transform = {.position = {from, 0, 0}}});
      EXPECT_EQ(one.met(20, dt), 0);
      const double begin = one.world.time(), gap = 10 - drift * begin;
      double met = 0;
      for (int step = 0; step < 200 && met == 0; ++step) {
        const double now = one.world.time();
        const auto place = [&](double time) { return Vec3d{from + speed * (time - begin), 0, 0}; };
        if (glides)
          ASSERT_TRUE(one.world.set_instance_motion(
              thing, KeyedMotion{.keys = {{now, place(now), {}, {}}, {now + dt, place(now + dt), {}, {}}}}));
        else
          ASSERT_TRUE(one.world.move_instance(thing, {.position = place(now)}));
        met = one.met(1, dt);
      }
      EXPECT_NEAR(met, begin + gap / (speed + drift), glides ? 1e-4 : dt) << glides << " " << radius;
    }
}

TEST(SceneClear, who_knows_for_long_what_is_clear_meets_a_newcomer_that_has_stood_for_long) {
  const double dt = 1.0 / 60, drift = 0.01;
  Hanging one({drift, 0, 0}, 0, Precision::float64);
  EXPECT_EQ(one.met(20, dt), 0);
  const double now = one.world.time(), gap = 0.08;  // as far as it knows
  ASSERT_GT(gap / drift, 1.5 * dt * double(Newcomers::kQuiet));
  const Vec3d place{drift * now + gap + 1, 0, 0};
  ASSERT_TRUE(one.world.add_instance({.shape = one.ball, .transform = {.position = place}}));
  EXPECT_NEAR(one.met(600, dt), now + gap / drift, 1e-4);
}

TEST(SceneClear, a_mover_beside_the_chord_of_a_long_step_is_met) {
  const double dt = 0.5;
  Hanging one({}, 0, Precision::float64);
  ASSERT_TRUE(one.world[one.id].set_gravity_scale(1));
  ASSERT_TRUE(one.world[one.id].set_velocity({0, 9.9, 0}));
  EXPECT_EQ(one.met(1, dt), 0);
  const double low = one.world[one.id].position().y;
  // It rises by 0.05 m in the step that comes, and by 0.37 m within it.
  ASSERT_TRUE(one.world.add_instance({.shape = one.ball,
                                      .transform = {.position = {0, low + 0.3, 0}, .scale = 0.03},
                                      .motion = SteadyMotion{.start = dt, .velocity = {1e-3, 0, 0}}}));
  EXPECT_GT(one.met(1, dt), dt);
}

bool holds(const collide::Bounds& outer, const collide::Bounds& inner) {
  collide::Bounds both = outer;
  both.take(inner);
  return both.low == outer.low && both.high == outer.high;
}

TEST(SceneClear, few_boxes_hold_all_of_many) {
  Random r(7);
  for (const int count : {0, 1, 2, 5, 16, 17, 300}) {
    std::vector<collide::Bounds> boxes;
    for (int i = 0; i < count; ++i) {
      const Vec3d middle = r.one_in(5) ? Vec3d{} : r.vector(100);
      const Vec3d half{r.in(0, 2), r.in(0, 2), r.in(0, 2)};
      boxes.push_back({middle - half, middle + half});
    }
    const BoxGroups few(boxes);
    EXPECT_LE(few.groups().size(), 16u);
    EXPECT_EQ(few.groups().empty(), count == 0);
    for (const collide::Bounds& box : boxes)
      EXPECT_TRUE(std::ranges::any_of(few.groups(), [&](const auto& group) { return holds(group.about, box); }));
    for (int i = 0; i < 200; ++i) {
      const Vec3d middle = r.vector(110);
      const collide::Bounds asked{middle - Vec3d{3, 3, 3}, middle + Vec3d{3, 3, 3}};
      EXPECT_EQ(few.meets(asked), std::ranges::any_of(boxes, [&](const auto& box) { return box.meets(asked); }));
    }
  }
}

TEST(SceneClear, boxes_far_from_each_other_are_not_put_together) {
  std::vector<collide::Bounds> boxes;
  for (int i = 0; i < 1600; ++i) {
    const Vec3d low{i % 16 * 1000.0 + i / 16, 0, 0};
    boxes.push_back({low, low + Vec3d{1, 1, 1}});
  }
  const BoxGroups few(boxes);
  for (const auto& group : few.groups()) EXPECT_LT(group.about.high.x - group.about.low.x, 120);
}

}  // namespace physim::world_scene_clear_movers_test
