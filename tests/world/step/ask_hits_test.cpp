// Hits that ask: against kinds that do the same by themselves, bit by bit, and against closed forms.
#include <map>
#include <thread>

#include "engine_support.hpp"
#include "world/ask_support.hpp"

namespace physim::world_ask_hits_test {

using namespace test_ask;
using test::Random;

/// A room with a moving wall, planks and a sensor.
Scene crowded_room() {
  Scene scene = room({5, 3, 4}, {.restitution = 0.8, .friction = 0.3, .grip_restitution = 0.4});
  Material fir = materials::fir();
  fir.spread.deflection = 0.05;
  const MaterialId wood = *scene.add_material(fir);
  for (int i = 0; i < 3; ++i) put(scene, BoxShape{{0.01, 2, 3}}, {1.0 + 0.6 * i, -1, 0}, wood);
  add_thing(scene, BoxShape{{0.2, 1, 1}},
            {.transform = {.position = {-3, -2, 0}},
             .material = wood,
             .motion = SteadyMotion{.velocity = {0.5, 0.2, 0}, .angular_velocity = {0, 1, 0}}});
  EXPECT_TRUE(
      scene.add({.shape = *scene.add_shape(SphereShape{1}), .transform = {.position = {0, 0, 2}}, .sensor = true}));
  return scene;
}

struct Rung {
  std::string name;
  Fidelity fidelity;
};
std::vector<Rung> rungs() {
  Fidelity closed = test_scene::closed(), adaptive = test_scene::rung(Integrator::tsit5);
  Fidelity in_float = Fidelity::game(), spinning = Fidelity::simulation();
  in_float.precision = Precision::float32;
  spinning.rotation = RotationModel::rigid_body;
  spinning.integrator = Integrator::rk4;
  return {{"closed form", closed}, {"adaptive", adaptive},   {"game", Fidelity::game()},
          {"float32", in_float},   {"rigid body", spinning}, {"classic", Fidelity::classic()}};
}

/// Sixty of them from a place, every way.
void spray(World& world, const Fidelity& fidelity, const BodyDef& body, double speed) {
  Random r(5);
  for (int i = 0; i < 60; ++i) {
    ProjectileDef p = bullet();
    p.twist = 0.3;
    p.fidelity = fidelity;
    const auto id = world.spawn(p, {.position = {0.1, 0.2, 0.3}, .velocity = r.vector(speed)}, body);
    ASSERT_TRUE(id) << id.error().text();
  }
}

void expect_as_the_kind(const Scene& scene, const Rung& rung, OnHit on_hit, double radius, bool forced) {
  SCOPED_TRACE(rung.name + ", " + std::string(name(on_hit)) + ", radius " + std::to_string(radius));
  World own = make_world(in_the_open()), asking = make_world(in_the_open());
  ASSERT_TRUE(own.set_scene(scene) && asking.set_scene(scene));
  ASSERT_TRUE(asking.set_hit_function(always({.then = on_hit})));
  BodyDef body{.restitution = 0.9, .collision = {.on_hit = on_hit, .radius = radius}};
  spray(own, rung.fidelity, body, on_hit == OnHit::impact ? 300 : 40);
  body.collision.on_hit = OnHit::ask;
  spray(asking, rung.fidelity, body, on_hit == OnHit::impact ? 300 : 40);
  if (forced) {
    ASSERT_TRUE(own.add_force({.law = ConstantAcceleration{{0.3, 0, 0.1}}, .target = {.layers = 1}}));
    ASSERT_TRUE(asking.add_force({.law = ConstantAcceleration{{0.3, 0, 0.1}}, .target = {.layers = 1}}));
  }
  std::size_t hits = 0;
  for (int i = 0; i < 40 && !testing::Test::HasFatalFailure(); ++i) {
    own.step(1.0 / 60), asking.step(1.0 / 60);
    expect_same(own, asking, hits);
  }
  EXPECT_GE(hits, 60u);
  EXPECT_GE(asking.hit_counts().questions, hits);
  EXPECT_EQ(asking.hit_counts().refused, 0u) << asking.refused_answer();
}

TEST(AskHits, an_answer_does_what_a_kind_does_to_the_bit) {
  const Scene scene = crowded_room();
  for (const Rung& rung : rungs())
    for (const OnHit on_hit : {OnHit::stop, OnHit::stick, OnHit::bounce, OnHit::impact})
      expect_as_the_kind(scene, rung, on_hit, rung.name == "game" ? 0.05 : 0, false);
  for (const OnHit on_hit : {OnHit::bounce, OnHit::impact}) expect_as_the_kind(scene, rungs()[1], on_hit, 0.05, false);
}

TEST(AskHits, so_do_rows_that_generators_push) {
  Fidelity pushed = test_scene::rung(Integrator::rk4);
  pushed.motion = Motion::force;
  for (const OnHit on_hit : {OnHit::stick, OnHit::bounce, OnHit::impact})
    expect_as_the_kind(crowded_room(), {"pushed", pushed}, on_hit, 0.03, true);
}

TEST(AskHits, so_do_they_where_an_engine_answers) {
  const Scene scene = room({5, 3, 4}, {.restitution = 0.8, .friction = 0.3});
  expect_as_the_kind(test::answered_by(scene, 1), rungs()[1], OnHit::bounce, 0.05, false);
}

/// Who meets others or is let out by an emitter asks by itself, inside of the step.
TEST(AskHits, so_do_balls_that_meet_each_other_and_particles) {
  World worlds[2] = {make_world(in_the_open()), make_world(in_the_open())};
  for (int i = 0; i < 2; ++i) {
    World& world = worlds[i];
    ASSERT_TRUE(world.set_scene(crowded_room()));
    ASSERT_TRUE(world.set_hit_function(always({.then = OnHit::bounce})));
    BodyDef body{.restitution = 0.9,
                 .collision = {.on_hit = i == 0 ? OnHit::bounce : OnHit::ask, .radius = 0.1, .others = 1}};
    ProjectileDef p = stone();
    p.mass = 0.1;
    Random r(11);
    for (int k = 0; k < 40; ++k) ASSERT_TRUE(world.spawn(p, {.position = r.vector(2), .velocity = r.vector(30)}, body));
    EmitterDef def;
    body.collision.others = 0;
    def.kind = *world.add_kind(p, body);
    def.seed = 3;
    def.per_second = {200};
    def.maximum = 400;
    def.start.lifetime = {0.3, 0.7};
    def.start.speed = {20, 60};
    def.from = {.shape = EmitShape::sphere, .radius = 0.2};
    ASSERT_TRUE(world.add_emitter(def));
  }
  std::size_t hits = 0, met = 0;
  for (int i = 0; i < 90 && !HasFatalFailure(); ++i) {
    for (World& world : worlds) world.step(1.0 / 60);
    expect_same(worlds[0], worlds[1], hits);
    for (const Event& event : worlds[0].events()) met += event.other ? 1 : 0;
  }
  EXPECT_GT(hits, 500u);
  EXPECT_GT(met, 20u);
  EXPECT_EQ(worlds[1].hit_counts().refused, 0u);
  EXPECT_EQ(worlds[0].hit_counts().questions, 0u);
}

/// All that is known to be met goes into one call, and what follows from the answers into the next one.
TEST(AskHits, a_step_asks_in_rounds_in_order_of_time) {
  Scene scene;
  const MaterialId elastic = *scene.add_material({.restitution = 1, .friction = 0});
  for (const double side : {1.5, -1.5}) put(scene, BoxShape{{0.5, 50, 50}}, {side, 0, 0}, elastic);
  WorldDef def = in_the_open();
  def.environment.gravity.model = GravityModel::off;
  World world = make_world(def, scene);
  std::vector<std::vector<HitQuestion>> calls;
  ASSERT_TRUE(world.set_hit_function([&](const HitBatch& batch) {
    calls.emplace_back(batch.questions.begin(), batch.questions.end());
    for (HitAnswer& answer : batch.answers) {
      EXPECT_EQ(answer, HitAnswer{});
      answer.then = OnHit::bounce;
    }
  }));
  BodyDef body{.restitution = 1, .collision = {.on_hit = OnHit::ask}};
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 4; ++i) {
    ProjectileDef p = stone();
    p.mass = 2;
    p.fidelity = i % 2 == 0 ? test_scene::closed() : test_scene::rung(Integrator::rk4);
    ids.push_back(*world.spawn(p, {.position = {0, double(i), 0}, .velocity = Vec3d{(4 - i) * 30.0, 0, 0}}, body));
  }
  ASSERT_TRUE(world.step(0.1));
  // From the middle of a room 2 m wide, 12 m and less.
  ASSERT_GE(calls.size(), 6u);
  EXPECT_EQ(calls[0].size(), 4u);
  std::map<std::uint32_t, int> hits;
  for (const auto& call : calls) {
    EXPECT_TRUE(std::ranges::is_sorted(call, {}, &HitQuestion::time));
    for (const HitQuestion& q : call) {
      const int i = static_cast<int>(q.projectile.index - ids[0].index), n = hits[q.projectile.index]++;
      const double speed = (4 - i) * 30.0;
      if (n == 0) {
        EXPECT_NEAR(q.time, 1 / speed, 1e-12);
        EXPECT_NEAR(q.energy, speed * speed, 1e-6);
      }
      EXPECT_NEAR(std::abs(q.position.x), 1, 1e-9);
      EXPECT_EQ(q.normal.x, n % 2 == 0 ? -1 : 1);
      EXPECT_NEAR(q.obliquity, 0, 1e-12);
      EXPECT_NEAR(q.thickness, 1, 1e-9);
      EXPECT_FALSE(q.inside);
      EXPECT_EQ(q.kind, world[q.projectile].kind());
    }
  }
  EXPECT_EQ(world.hit_counts().calls, calls.size());
  const auto told = events_of(world, EventKind::hit);
  EXPECT_EQ(world.hit_counts().questions, told.size());
}

TEST(AskHits, threads_change_no_bit_and_no_question) {
  std::uint64_t hash[2] = {};
  std::vector<HitQuestion> asked[2];
  const unsigned threads[2] = {1, 3};
  for (int i = 0; i < 2; ++i) {
    World world = make_world(in_the_open(threads[i]), crowded_room());
    const std::thread::id stepping = std::this_thread::get_id();
    ASSERT_TRUE(world.set_hit_function([&, i](const HitBatch& batch) {
      EXPECT_EQ(std::this_thread::get_id(), stepping);
      asked[i].insert(asked[i].end(), batch.questions.begin(), batch.questions.end());
      answer_by_place(batch);
    }));
    Random r(7);
    for (int k = 0; k < 9000; ++k) {
      ProjectileDef p = bullet();
      p.fidelity = rungs()[static_cast<std::size_t>(k % 4)].fidelity;
      const BodyDef body{.collision = {.on_hit = k % 3 == 0 ? OnHit::bounce : OnHit::ask, .radius = k % 2 * 0.02}};
      ASSERT_TRUE(world.spawn(p, {.position = r.vector(0.5), .velocity = r.vector(90)}, body));
    }
    for (int k = 0; k < 12; ++k) world.step(1.0 / 60);
    EXPECT_EQ(world.hit_counts().refused, 0u);
    hash[i] = world.hash();
  }
  EXPECT_EQ(hash[0], hash[1]);
  EXPECT_GT(asked[0].size(), 5000u);
  EXPECT_TRUE(asked[0] == asked[1]);
}

// ------------------------------------------------------------------------------------------- velocities of one's own
/// Out of the back of a plank at once, with what is left, and on through the rest of the step.
TEST(AskHits, a_velocity_of_ones_own_goes_through) {
  for (const double radius : {0.0, 0.03}) {
    Scene scene;
    const InstanceId plank = put(scene, BoxShape{{0.05, 2, 2}}, {10, 0, 0});
    WorldDef def = in_the_open();
    def.environment.gravity.model = GravityModel::off;
    World world = make_world(def, scene);
    HitQuestion asked;
    ASSERT_TRUE(world.set_hit_function([&](const HitBatch& batch) {
      asked = batch.questions[0];
      batch.answers[0] = {OnHit::pass, asked.velocity * (1 - 2 * asked.thickness)};
    }));
    ProjectileDef p = stone();
    p.mass = 0.5;
    const BodyDef body{.collision = {.on_hit = OnHit::ask, .radius = radius}};
    const ProjectileId id = *world.spawn(p, {.velocity = Vec3d{80, 60, 0}}, body);
    world[id].set_position({10 - 0.05 - 4 - radius, -3, 0});
    ASSERT_TRUE(world.step(0.1));
    // 4 m to the plank at 80 m/s; 0.1 m thick, 0.125 m along its way.
    EXPECT_EQ(world.hit_counts().questions, 1u);
    EXPECT_EQ(asked.instance, plank);
    EXPECT_NEAR(asked.thickness, 0.125, 1e-7);
    EXPECT_NEAR(asked.obliquity, std::acos(0.8), 1e-12);
    EXPECT_NEAR(asked.time, 0.05, 1e-9);
    const auto through = events_of(world, EventKind::penetrated);
    ASSERT_EQ(through.size(), 1u);
    EXPECT_NEAR(through[0].value, 0.125, 1e-7);
    EXPECT_NEAR(through[0].energy, 0.5 * 0.5 * (1e4 - 75.0 * 75.0), 1e-2);
    EXPECT_NEAR(through[0].position.x, 10.05 + radius, 1e-8);
    EXPECT_NEAR(world[id].position().x, 10.05 + radius + 60 * 0.05, 1e-6);
    EXPECT_NEAR(world[id].velocity().x, 60, 1e-5);
    EXPECT_NEAR(world[id].velocity().y, 45, 1e-5);
  }
}

/// A clinch: it bounces off as somebody says, off a wall that moves, and flies on.
TEST(AskHits, a_velocity_of_ones_own_bounces) {
  Scene scene;
  add_thing(scene, BoxShape{{0.5, 50, 50}},
            {.transform = {.position = {10.5, 0, 0}}, .motion = SteadyMotion{.velocity = {-10, 0, 0}}});
  World world = make_world(in_the_open(), scene);
  ASSERT_TRUE(world.set_hit_function([&](const HitBatch& batch) {
    EXPECT_EQ(batch.questions[0].surface_velocity, (Vec3d{-10, 0, 0}));
    batch.answers[0] = {OnHit::bounce, Vec3d{-40, 20, 5}};
  }));
  ProjectileDef p = stone();
  p.fidelity = test_scene::closed();
  const ProjectileId id = *world.spawn(p, {.velocity = Vec3d{40, 0, 0}}, {.collision = {.on_hit = OnHit::ask}});
  ASSERT_TRUE(world.step(0.5));
  // They meet after 0.2 s at 8 m.
  const Vec3d at{8, -0.5 * test_scene::kG * 0.04, 0};
  const Vec3d then = at + Vec3d{-40, 20, 5} * 0.3 + Vec3d{0, -0.5 * test_scene::kG * 0.09, 0};
  EXPECT_TRUE(test::near(world[id].position(), then, 0, 1e-7));
  const auto told = events_of(world, EventKind::bounced);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].velocity, (Vec3d{-40, 20, 5}));
  EXPECT_EQ(world.hit_counts().refused, 0u) << world.refused_answer();
}

/// What is told to go along the surface, or hardly off it, slides there.
TEST(AskHits, a_velocity_along_the_surface_slides) {
  Scene scene;
  put(scene, BoxShape{{50, 1, 50}}, {0, -1, 0}, *scene.add_material({.restitution = 0.5, .friction = 0}));
  World world = make_world(in_the_open(), scene);
  ASSERT_TRUE(world.set_hit_function([&](const HitBatch& batch) {
    Vec3d along = batch.questions[0].velocity;
    along.y = 0;
    batch.answers[0] = {OnHit::bounce, along};
  }));
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 1, 0}, .velocity = Vec3d{6, 0, 2}},
                                       {.friction = 0, .rolling_resistance = 0, .collision = {.on_hit = OnHit::ask}});
  for (int i = 0; i < 60; ++i) ASSERT_TRUE(world.step(1.0 / 60));
  EXPECT_NEAR(world[id].position().y, 0, 1e-7);
  EXPECT_NEAR(world[id].position().x, 6, 0.1);
  EXPECT_EQ(world[id].velocity().x, 6);
  EXPECT_EQ(world.hit_counts().refused, 0u) << world.refused_answer();
  EXPECT_LT(world.hit_counts().questions, 300u);
}

/// As a bullet of ours goes through ours: through five planks in one step, each of which takes a tenth.
TEST(AskHits, what_passes_meets_what_stands_behind) {
  Scene scene;
  for (int i = 0; i < 5; ++i) put(scene, BoxShape{{0.05, 2, 2}}, {10.0 + 0.1 * i, 0, 0});  // they touch
  World world = make_world(in_the_open(), scene);
  int calls = 0;
  ASSERT_TRUE(world.set_hit_function([&](const HitBatch& batch) {
    ++calls;
    batch.answers[0] = {OnHit::pass, batch.questions[0].velocity * 0.9};
  }));
  for (const double radius : {0.0, 0.02}) {
    const ProjectileId id = *world.spawn(stone(), {.speed = 1000},
                                         {.gravity_scale = 0, .collision = {.on_hit = OnHit::ask, .radius = radius}});
    calls = 0;
    ASSERT_TRUE(world.step(0.02));
    EXPECT_EQ(calls, 5);
    EXPECT_NEAR(world[id].velocity().x, 1000 * std::pow(0.9, 5), 1e-6);
  }
}

/// Between two walls a millimetre apart there is no end of hits in a step; each costs the step from its start again.
TEST(AskHits, who_has_too_many_in_a_step_sticks) {
  World world = make_world(in_the_open());
  Scene scene;
  const ShapeId box = *scene.add_shape(BoxShape{{1, 1, 1}});
  const MaterialId steel = *scene.add_material({.restitution = 1, .friction = 0});
  for (const double side : {-1.0, 1.0})
    ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = {side * 1.0005, 0, 0}}, .material = steel}));
  ASSERT_TRUE(world.set_scene(scene) && world.set_hit_function(always({.then = OnHit::bounce})));
  const BodyDef body{.gravity_scale = 0, .restitution = 1, .collision = {.on_hit = OnHit::ask}};
  const ProjectileId id = *world.spawn(stone(), {.velocity = Vec3d{100, 0, 0}}, body);
  ASSERT_TRUE(world.step(1.0 / 60));
  EXPECT_EQ(world.hit_counts().questions, 256U);
  EXPECT_EQ(world[id].status(), LifeStatus::landed);
  EXPECT_EQ(world[id].velocity(), Vec3d{});
}

}  // namespace physim::world_ask_hits_test
