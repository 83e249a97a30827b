// Worlds whose scene is an engine's: against the same scene as their own, and against closed forms.
#include <set>
#include <thread>

#include "engine_support.hpp"
#include "random_shots.hpp"
#include "scene_support.hpp"

namespace physim::world_engine_scene_test {

using test::answered_by;
using test::answers_of;
using test::Random;
using test_scene::in_the_open;
using test_scene::kG;
using test_scene::put;
using test_scene::room;

/// A hundred of them from a place, every way.
std::vector<ProjectileId> spray(World& world, const BodyDef& body, double speed, Precision precision) {
  Random r(3);
  ProjectileDef p = stone();
  p.fidelity.precision = precision;
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 100; ++i) {
    Launch launch{.position = {0.1, 0.2, 0.3}, .velocity = r.vector(speed)};
    ids.push_back(*world.spawn(p, launch, body));
  }
  return ids;
}

/// Both worlds tell of the same hits, and are in the same places.
void expect_alike(World& own, World& asking, const std::vector<ProjectileId>& ids, int steps, double within) {
  std::size_t hits = 0;
  for (int i = 0; i < steps; ++i) {
    own.step(1.0 / 64);
    asking.step(1.0 / 64);
    ASSERT_EQ(own.events().size(), asking.events().size()) << i;
    for (std::size_t k = 0; k < own.events().size(); ++k) {
      const Event &a = own.events()[k], &b = asking.events()[k];
      ASSERT_EQ(a.kind, b.kind) << i;
      ASSERT_EQ(a.id, b.id) << i;
      ASSERT_EQ(a.instance.index, b.instance.index) << i;
      ASSERT_NEAR(a.time, b.time, within);
      ASSERT_LT(length(a.position - b.position), within);
      ASSERT_LT(length(a.normal - b.normal), within);
      ASSERT_NEAR(a.value, b.value, within);
      hits += a.kind == EventKind::hit ? 1 : 0;
    }
  }
  EXPECT_GT(hits, ids.size() / 2);
  for (const ProjectileId id : ids) {
    ASSERT_EQ(own[id].is_alive(), asking[id].is_alive());
    if (own[id].is_alive()) {
      EXPECT_LT(length(own[id].position() - asking[id].position()), within);
    }
  }
}

TEST(EngineScene, what_bounces_meets_what_it_would_meet_in_a_scene_of_its_own) {
  const Scene scene = room({5, 3, 4}, {.restitution = 0.8, .friction = 0.3});
  for (const Precision precision : {Precision::float64, Precision::float32})
    for (const double radius : {0.0, 0.11}) {
      World own = make_world(in_the_open(), scene), asking = make_world(in_the_open());
      ASSERT_TRUE(asking.set_scene(answered_by(scene, 1)));
      BodyDef body{.restitution = 1, .collision = {.on_hit = OnHit::bounce, .radius = radius}};
      const auto ids = spray(own, body, 20, precision);
      EXPECT_EQ(spray(asking, body, 20, precision), ids);
      expect_alike(own, asking, ids, 60, 1e-4);
      EXPECT_EQ(asking.scene()->engine_counters().refused, 0u);
    }
}

TEST(EngineScene, what_goes_through_is_as_thick_as_it_would_be) {
  Scene scene;
  const MaterialId fir = *scene.add_material(materials::fir());
  const MaterialId concrete = *scene.add_material(materials::concrete(30e6));
  const ShapeId plank = *scene.add_shape(BoxShape{{0.009, 2, 2}}), wall = *scene.add_shape(BoxShape{{0.15, 3, 3}});
  for (int i = 0; i < 4; ++i) put(scene, BoxShape{{0.009, 2, 2}}, {10 + 1.5 * i, 0, 0}, fir);
  ASSERT_TRUE(scene.add({plank, {{17, 0, 0}, {0.9, 0, 0, 0.4}, 1}, fir}));
  ASSERT_TRUE(scene.add({wall, {.position = {20, 0, 0}}, concrete}));
  for (const double radius : {0.0, 0.003}) {
    World own = make_world(in_the_open(), scene), asking = make_world(in_the_open());
    ASSERT_TRUE(asking.set_scene(answered_by(scene, 2)));
    BodyDef body{.collision = {.on_hit = OnHit::impact, .radius = radius}};
    std::vector<ProjectileId> ids;
    for (int i = 0; i < 20; ++i) {
      Launch launch{.position = {0, -0.5 + 0.05 * i, 0.02 * i}, .speed = 300.0 + 20 * i, .elevation = 0.002 * i};
      ids.push_back(*own.spawn(bullet(), launch, body));
      EXPECT_EQ(*asking.spawn(bullet(), launch, body), ids.back());
    }
    expect_alike(own, asking, ids, 40, 1e-4);
  }
}

TEST(EngineScene, who_passes_is_told_of_every_way_in_and_out) {
  const Scene scene = room({3, 3, 3}, {});
  World own = make_world(in_the_open(), scene), asking = make_world(in_the_open());
  ASSERT_TRUE(asking.set_scene(answered_by(scene, 1)));
  BodyDef body{.collision = {.on_hit = OnHit::pass}};
  const ProjectileId id = *own.spawn(stone(), {.speed = 30}, body);
  EXPECT_EQ(*asking.spawn(stone(), {.speed = 30}, body), id);
  const auto right = run_for(own, 1), told = run_for(asking, 1);
  ASSERT_EQ(told.size(), right.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(told[i].kind, right[i].kind);
    EXPECT_NEAR(told[i].time, right[i].time, 1e-7);
  }
}

TEST(EngineScene, a_step_asks_once_about_all_that_fly_free_from_the_thread_that_steps) {
  std::set<std::thread::id> threads;
  std::vector<std::size_t> sizes;
  Scene scene;
  const auto nothing_there = [&](const EngineBatch& batch) {
    threads.insert(std::this_thread::get_id());
    sizes.push_back(batch.segments.size());
    for (const SceneSegment& s : batch.segments) EXPECT_EQ(s.radius, 0) << "a ray";
  };
  ASSERT_TRUE(scene.set_engine({nothing_there}));
  World world = make_world(in_the_open(4), scene);
  BodyDef body;
  spray(world, body, 50, Precision::float64);
  spray(world, body, 50, Precision::float32);
  body.collision.layers = 6;
  spray(world, body, 50, Precision::float64);
  body.collision.layers = 0;
  spray(world, body, 50, Precision::float64);
  for (int i = 0; i < 3; ++i) world.step(1.0 / 64);
  EXPECT_EQ(sizes, (std::vector<std::size_t>{100, 200, 100, 200, 100, 200})) << "a call for each set of layers";
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

/// A floor at y = 0, which an engine in single precision knows to 1e-5 m, and through which falls whoever is below.
EngineQuery worn_floor() {
  return [](const EngineBatch& batch) {
    for (std::size_t i = 0; i < batch.segments.size(); ++i) {
      const SceneSegment& s = batch.segments[i];
      const double noise = 1e-5 * std::sin(1e6 * s.from.x + 1e7 * s.to.y);
      const double from = s.from.y - s.radius + noise, to = s.to.y - s.radius + noise;
      if (!(from >= 0 && to < 0)) continue;
      batch.hits[i].part = from / (from - to);
      batch.hits[i].normal = {0, 1, 0};
      batch.hits[i].instance.index = 7;
    }
  };
}

TEST(EngineScene, a_skin_keeps_what_bounces_and_rolls_above_a_floor_that_rounds) {
  constexpr double kSkin = 1e-3;
  for (const double dt : {1.0 / 30, 1.0 / 64, 1.0 / 240})
    for (const double radius : {0.0, 0.05}) {
      Scene scene;
      ASSERT_TRUE(scene.set_engine({worn_floor(), kSkin}));
      World world = make_world(in_the_open(), scene);
      BodyDef body{.rolling_resistance = 0.3, .collision = {.on_hit = OnHit::bounce, .radius = radius}};
      std::vector<ProjectileId> ids;
      for (int i = 0; i < 30; ++i) {
        Launch launch{.position = {0, 0.2 + 0.1 * i, 0}, .speed = 0.5 * i, .elevation = -0.03 * i};
        ids.push_back(*world.spawn(stone(), launch, body));
      }
      for (double t = 0; t < 20; t += dt) {
        world.step(dt);
        for (const ProjectileId id : ids)
          ASSERT_GT(world[id].position().y, radius + 0.1 * kSkin) << dt << " s, " << radius << " m, at " << t;
      }
      for (const ProjectileId id : ids) {
        EXPECT_TRUE(world[id].is_asleep()) << dt << " s, " << radius << " m";
        EXPECT_NEAR(world[id].position().y, radius + kSkin, 0.2 * kSkin);
      }
      EXPECT_EQ(world.scene()->engine_counters().refused, 0u);
    }
}

TEST(EngineScene, the_first_touch_is_where_a_closed_form_has_it) {
  Scene scene;
  ASSERT_TRUE(scene.set_engine({worn_floor(), 1e-3}));
  World world = make_world(in_the_open(), scene);
  const BodyDef body{.collision = {.on_hit = OnHit::stop, .radius = 0.1}};
  ProjectileDef p = stone();
  p.fidelity.integrator = Integrator::rk4;
  ASSERT_TRUE(world.spawn(p, {.position = {0, 5, 0}}, body));
  const auto events = run_for(world, 2);
  const auto hit = std::ranges::find(events, EventKind::hit, &Event::kind);
  ASSERT_NE(hit, events.end());
  EXPECT_NEAR(hit->time, std::sqrt(2 * (5 - 0.101) / kG), 3e-5);
  EXPECT_EQ(hit->instance, (InstanceId{7, kEngineGeneration}));
}

TEST(EngineScene, bad_answers_meet_nothing_and_nothing_throws) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const SceneHit good{.part = 0.5, .normal = {-1, 0, 0}, .instance = {1, 0}};
  SceneHit nan = good, far = good, flat = good;
  nan.part = kNone, far.part = 3, flat.normal = {};
  for (const SceneHit& answer : {nan, far, flat}) {
    Scene scene;
    ASSERT_TRUE(scene.set_engine({[&](const EngineBatch& b) { std::ranges::fill(b.hits, answer); }}));
    World world = make_world(in_the_open(), scene), alone = make_world(in_the_open());
    const auto ids = spray(world, {}, 30, Precision::float64);
    spray(alone, {}, 30, Precision::float64);
    EXPECT_TRUE(run_for(world, 1).size() == run_for(alone, 1).size());
    for (const ProjectileId id : ids) EXPECT_EQ(world[id].position(), alone[id].position());
    EXPECT_EQ(world.scene()->engine_counters().refused, 6400u) << "each of a hundred, 64 times";
  }
  Scene scene;
  ASSERT_TRUE(scene.set_engine({[](const EngineBatch&) { throw std::runtime_error("no"); }}));
  World world = make_world(in_the_open(), scene);
  spray(world, {}, 30, Precision::float64);
  world.step(1.0 / 64);
  EXPECT_EQ(world.size(), 100u);
  EXPECT_EQ(scene.engine_counters().refused, 100u) << "copies count together";
}

TEST(EngineScene, from_inside_a_question_the_world_is_read_and_not_changed) {
  World world = make_world(in_the_open());
  ProjectileId id;
  int asked = 0;
  Scene scene;
  const auto curious = [&](const EngineBatch&) {
    ++asked;
    EXPECT_TRUE(world[id].is_alive());
    EXPECT_FALSE(world[id].despawn());
    EXPECT_FALSE(world.step(0.1));
    EXPECT_FALSE(world.remove_scene());
    EXPECT_FALSE(world.scene()->first_hit({{0, 0, 0}, {1, 0, 0}}));
  };
  ASSERT_TRUE(scene.set_engine({curious}));
  ASSERT_TRUE(world.set_scene(scene));
  id = *world.spawn(stone(), {.speed = 10});
  world.step(0.1);
  EXPECT_EQ(asked, 1);
  EXPECT_NE(world.predict(id, 1.0).outcome(), Outcome::refused);
  EXPECT_GT(asked, 1);
  EXPECT_EQ(world.size(), 1u);
}

TEST(EngineScene, saves_and_recordings_want_the_function_again) {
  const Scene scene = room({5, 3, 4}, {.restitution = 0.8, .friction = 0.3});
  const EngineQuery query = answers_of(std::make_shared<const Scene>(scene));
  World world = make_world(in_the_open());
  std::vector<std::byte> recording;
  ASSERT_TRUE(world.record(record_into(recording)));
  ASSERT_TRUE(world.set_scene(answered_by(scene, 1)));
  spray(world, {.collision = {.on_hit = OnHit::bounce}}, 20, Precision::float64);
  for (int i = 0; i < 50; ++i) world.single_step();
  const Snapshot moment = world.snapshot();
  const std::vector<std::byte> save = *world.save();
  EXPECT_EQ(World::load(save).error().place, "engine_queries");
  auto loaded = must(World::load(save, {.engine_queries = {query}}));
  EXPECT_EQ(loaded.hash(), world.hash());
  for (int i = 0; i < 50; ++i) world.single_step(), loaded.single_step();
  EXPECT_EQ(loaded.hash(), world.hash());
  const std::uint64_t then = world.hash();
  ASSERT_TRUE(world.restore(moment));
  for (int i = 0; i < 50; ++i) world.single_step();
  EXPECT_EQ(world.hash(), then);
  ASSERT_TRUE(world.set_scene(answered_by(scene, 1))) << "a second scene";
  world.single_step();
  ASSERT_TRUE(world.stop_recording());
  EXPECT_EQ(replay(recording, {.engine_queries = {query}}).error().place, "engine_queries");
  const auto report = must(replay(recording, {.engine_queries = {query, query}}));
  EXPECT_FALSE(report.difference);
  EXPECT_TRUE(report.complete);
}

TEST(EngineScene, flights_and_predictions_meet_it_too) {
  const Scene scene = room({5, 3, 4}, {.restitution = 0.8, .friction = 0.3});
  const Scene asking = answered_by(scene, 1);
  for (const Fidelity& fidelity : {test_scene::rung(Integrator::rk4), test_scene::closed()}) {
    ProjectileDef p = stone();
    p.fidelity = fidelity;
    const Launch launch{.position = {0.1, 0.2, 0.3}, .speed = 9, .elevation = 0.7};
    Until until = test_scene::meeting(scene, OnHit::bounce, 0.1),
          other = test_scene::meeting(asking, OnHit::bounce, 0.1);
    until.time = other.time = 1.5;
    const Flight own = fly(p, launch, test_scene::vacuum_of(kG), fidelity, {}, until);
    const Flight foreign = fly(p, launch, test_scene::vacuum_of(kG), fidelity, {}, other);
    EXPECT_EQ(foreign.outcome(), own.outcome());
    EXPECT_EQ(foreign.events().size(), own.events().size());
    EXPECT_GE(own.events().size(), 4u);
    for (double t = 0; t < own.duration(); t += 0.05)
      ASSERT_LT(length(foreign.at(t).position - own.at(t).position), 1e-3) << t;
  }
  World world = make_world(in_the_open(), asking);
  const ProjectileId id = *world.spawn(stone(), {.speed = 15}, {.collision = {.on_hit = OnHit::bounce, .radius = 0.1}});
  const Flight ahead = world.predict(id, Until{.ground = std::nullopt, .time = 2}, 1.0 / 64);
  for (int i = 1; i <= 100; ++i) {
    world.step(1.0 / 64);
    ASSERT_EQ(world[id].position(), ahead.at(i / 64.0).position) << i;
  }
}

}  // namespace physim::world_engine_scene_test
