// Worlds whose projectiles meet things: against closed forms, against the ground, and from every side.
#include <array>

#include "random_shots.hpp"
#include "scene_support.hpp"

namespace physim::world_scene_world_test {

using test::Random;
using test_scene::kG;
using test_scene::room;
using test_scene::unfolded;
using test_scene::Unfolded;

WorldDef no_ground() {
  return {.environment = {.atmosphere = {.model = AirModel::vacuum}}, .ground = {.mode = GroundMode::none}};
}

struct Precise {
  Precision precision;
  double within;
};

TEST(SceneWorld, elastic_bounces_in_a_room_follow_the_closed_form) {
  const Vec3d half{5, 3, 4};
  const Scene scene = room(half, {.restitution = 1, .friction = 0});
  for (const auto& [precision, within] : {Precise{Precision::float64, 1e-9}, Precise{Precision::float32, 1e-5}})
    for (const double speed : {10.0, 100.0, 300.0})
      for (const double radius : {0.0, 0.11}) {
        WorldDef def = no_ground();
        World world = make_world(def, scene);
        ProjectileDef p = stone();
        p.fidelity.precision = precision;
        BodyDef body{.gravity_scale = 0,
                     .can_sleep = false,
                     .restitution = 1,
                     .friction = 0,
                     .collision = {.on_hit = OnHit::bounce, .radius = radius}};
        Launch launch{.position = {0.5, -0.25, 0.125}};
        const Vec3d v0 = Vec3d{0.6, 0.48, 0.64} * speed;
        launch.velocity = v0;
        const ProjectileId id = *world.spawn(p, launch, body);
        const auto events = run_for(world, 120 / speed, 1.0 / 60);
        const double time = world.time();
        const double flown = speed * time;
        const Vec3d there = launch.position + v0 * time;
        const Unfolded x = unfolded(there.x, half.x - radius), y = unfolded(there.y, half.y - radius),
                       z = unfolded(there.z, half.z - radius);
        const Vec3d place = world[id].position(), velocity = world[id].velocity();
        EXPECT_LT(length(place - Vec3d{x.x, y.x, z.x}), within * flown) << speed << " m/s, radius " << radius;
        const Vec3d right{x.sign * v0.x, y.sign * v0.y, z.sign * v0.z};
        EXPECT_LT(length(velocity - right), within * speed);
        EXPECT_GT(
            std::count_if(events.begin(), events.end(), [](const Event& e) { return e.kind == EventKind::bounced; }),
            10);
      }
}

TEST(SceneWorld, a_ball_on_a_plane_bounces_as_on_the_ground) {
  Scene scene;
  const MaterialId hard = *scene.add_material({.restitution = 1, .friction = 1});
  add_thing(scene, PlaneShape{}, {.material = hard});
  for (const Integrator integrator : {Integrator::rk4, Integrator::semi_implicit_euler, Integrator::tsit5}) {
    World on_ground = make_world({.ground = {.mode = GroundMode::bounce}});
    World on_plane = make_world(no_ground(), scene);
    ProjectileDef p = stone();
    p.fidelity.integrator = integrator;
    BodyDef body{.restitution = 0.7, .friction = 0.2, .collision = {.on_hit = OnHit::bounce}};
    const Launch launch{.position = {0, 2, 0}, .speed = 5};
    const ProjectileId one = *on_ground.spawn(p, launch, body), other = *on_plane.spawn(p, launch, body);
    for (int i = 0; i < 64 * 20; ++i) {
      on_ground.step(1.0 / 64);
      on_plane.step(1.0 / 64);
      ASSERT_EQ(events_of(on_ground, EventKind::bounced).size(), events_of(on_plane, EventKind::bounced).size());
      ASSERT_LT(length(on_ground[one].position() - on_plane[other].position()), 1e-6) << i;
    }
    EXPECT_TRUE(on_ground[one].is_asleep());
    EXPECT_TRUE(on_plane[other].is_asleep());
  }
}

/// What ends a flight on the ground ends it at a plane there.
TEST(SceneWorld, every_preset_meets_a_plane_where_it_would_land) {
  Scene scene;
  add_thing(scene, PlaneShape{});
  for (const Fidelity& fidelity : {Fidelity::classic(), Fidelity::game(), Fidelity::constant_air(),
                                   Fidelity::small_arms(), Fidelity::artillery()}) {
    WorldDef def;
    World landing = make_world(def);
    def.ground.mode = GroundMode::none;
    World meeting = make_world(def, scene);
    ProjectileDef p = bullet();
    p.fidelity = fidelity;
    const Launch launch{.position = {0, 1.5, 0}, .speed = 300, .elevation = 0.002};
    ASSERT_TRUE(landing.spawn(p, launch));
    ASSERT_TRUE(meeting.spawn(p, launch));
    std::vector<Event> landed, hit;
    for (int i = 0; i < 120; ++i) {
      landing.step(1.0 / 60), meeting.step(1.0 / 60);
      for (const Event& e : events_of(landing, EventKind::landed)) landed.push_back(e);
      for (const Event& e : events_of(meeting, EventKind::hit)) hit.push_back(e);
    }
    ASSERT_EQ(landed.size(), 1u);
    ASSERT_EQ(hit.size(), 1u);
    const double within = fidelity.precision == Precision::float32 ? 2e-5 : 1e-8;
    EXPECT_NEAR(hit[0].time, landed[0].time, within);
    EXPECT_LT(length(hit[0].position - landed[0].position), 400 * within);
    EXPECT_EQ(hit[0].normal, (Vec3d{0, 1, 0}));
    EXPECT_EQ(meeting.size(), 0u);
  }
}

TEST(SceneWorld, what_meets_nothing_flies_as_without_a_scene) {
  Scene scene;
  const ShapeId shape = *scene.add_shape(BoxShape{{1, 1, 1}});
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(scene.add({.shape = shape, .transform = {.position = {20.0 * i, -5, 4}}}));
  for (const Fidelity& fidelity : {Fidelity::classic(), Fidelity::game(), Fidelity::constant_air(),
                                   Fidelity::small_arms(), Fidelity::artillery()}) {
    WorldDef def = no_ground();
    def.environment.atmosphere.model = AirModel::isa;
    World with = make_world(def, scene), without = make_world(def);
    ProjectileDef p = bullet();
    p.fidelity = fidelity;
    std::vector<ProjectileId> ids;
    Random r(5);
    for (int i = 0; i < 100; ++i) {
      const Launch launch{.position = {0, r.in(2, 40), r.in(-3, 3)}, .speed = r.in(50, 300)};
      ids.push_back(*with.spawn(p, launch));
      ASSERT_EQ(*without.spawn(p, launch), ids.back());
    }
    for (int i = 0; i < 30; ++i) with.step(1.0 / 60), without.step(1.0 / 60);
    for (const ProjectileId id : ids) {
      if (!with[id].is_alive()) continue;
      EXPECT_EQ(with[id].position(), without[id].position());
      EXPECT_EQ(with[id].velocity(), without[id].velocity());
    }
    EXPECT_GT(with.size(), 20u);
  }
}

TEST(SceneWorld, projectiles_do_what_their_kind_says) {
  Scene scene;
  const MaterialId steel = *scene.add_material({.name = "steel"});
  const InstanceId wall =
      add_thing(scene, BoxShape{{0.01, 5, 5}}, {.transform = {.position = {10, 0, 0}}, .material = steel, .layers = 2});
  World world = make_world(no_ground(), scene);
  const auto fire = [&](const CollisionDef& collision) {
    return *world.spawn(stone(), {.speed = 100}, {.collision = collision});
  };
  const ProjectileId stops = fire({.on_hit = OnHit::stop}), sticks = fire({.on_hit = OnHit::stick}),
                     bounces = fire({.on_hit = OnHit::bounce}), other_layers = fire({.layers = 5});
  const auto events = run_for(world, 0.5);
  EXPECT_EQ(world[stops].status(), LifeStatus::landed);
  EXPECT_FALSE(world[stops].is_alive());
  EXPECT_EQ(world[sticks].status(), LifeStatus::landed);
  ASSERT_TRUE(world[sticks].is_alive());
  EXPECT_NEAR(world[sticks].position().x, 9.99, 1e-9);
  EXPECT_LT(world[bounces].velocity().x, 0);
  EXPECT_GT(world[other_layers].position().x, 49);
  std::size_t hits = 0;
  for (const Event& e : events) {
    if (e.kind != EventKind::hit) continue;
    ++hits;
    EXPECT_EQ(e.instance, wall);
    EXPECT_EQ(e.material, steel);
    EXPECT_NEAR(e.time, 0.0999, 1e-9);
    EXPECT_EQ(e.normal, (Vec3d{-1, 0, 0}));
    EXPECT_NEAR(e.velocity.x, 100, 1e-9);
  }
  EXPECT_EQ(hits, 3u);
}

/// A stone that is thrown through a box and a sensor behind it.
TEST(SceneWorld, what_is_passed_is_told_with_the_time_of_the_closed_form) {
  Scene scene;
  const ShapeId box = *scene.add_shape(BoxShape{{1, 50, 50}});
  const InstanceId solid = *scene.add({.shape = box, .transform = {.position = {5, 0, 0}}});
  const InstanceId sensor = *scene.add({.shape = box, .transform = {.position = {15, 0, 0}}, .sensor = true});
  for (const OnHit on_hit : {OnHit::pass, OnHit::stop}) {
    World world = make_world(no_ground(), scene);
    BodyDef body{.collision = {.on_hit = on_hit}};
    const double beyond = on_hit == OnHit::pass ? 0 : 7;  // starts behind the box that would stop it
    ProjectileDef p = stone();
    p.fidelity.integrator = Integrator::rk4;
    ASSERT_TRUE(world.spawn(p, {.position = {beyond, 0, 0}, .speed = 30}, body));
    struct Passage {
      EventKind kind;
      InstanceId instance;
      double x;
    };
    std::vector<Passage> expected = {{EventKind::sensed, sensor, 14}, {EventKind::left, sensor, 16}};
    if (on_hit == OnHit::pass)
      expected.insert(expected.begin(), {{EventKind::entered, solid, 4}, {EventKind::left, solid, 6}});
    std::vector<Event> passed;
    for (const Event& e : run_for(world, 1, 1.0 / 30))
      if (e.kind != EventKind::spawned) passed.push_back(e);
    ASSERT_EQ(passed.size(), expected.size());
    for (std::size_t i = 0; i < passed.size(); ++i) {
      EXPECT_EQ(passed[i].kind, expected[i].kind);
      EXPECT_EQ(passed[i].instance, expected[i].instance);
      const double time = (expected[i].x - beyond) / 30;
      EXPECT_NEAR(passed[i].time, time, 1e-6);
      EXPECT_NEAR(passed[i].position.y, -0.5 * kG * time * time, 1e-5);
    }
    EXPECT_EQ(world.size(), 1u);
  }
}

/// As many shots aimed at a thing as beside it: each is told, or flies on.
TEST(SceneWorld, nothing_tunnels_and_nothing_is_hit_that_was_missed) {
  struct Sheet {
    const char* name;
    ShapeDef shape;
  };
  MeshShape mesh;  // four triangles that meet in the middle
  mesh.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 0, 0}};
  mesh.triangles = {{0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
  HeightFieldShape field{.columns = 9, .rows = 9, .spacing_x = 0.25, .spacing_z = 0.25};
  field.heights.assign(81, 0);
  Fidelity closed = Fidelity::game();
  closed.motion = Motion::closed_form;
  closed.drag = DragModel::off;
  Random r(11);
  for (const Sheet& sheet : {Sheet{"mesh", mesh}, Sheet{"field", field}, Sheet{"box", BoxShape{{1, 0.0005, 1}}}})
    for (const Fidelity& fidelity : {closed, Fidelity::game(), Fidelity::constant_air(), Fidelity::small_arms()})
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        Scene scene;
        const bool is_field = std::holds_alternative<HeightFieldShape>(sheet.shape);
        const Vec3d middle = is_field ? Vec3d{-1, 0, -1} : Vec3d{};
        add_thing(scene, sheet.shape, {.transform = {.position = middle}});
        WorldDef def = no_ground();
        def.environment.atmosphere.model = AirModel::isa;
        World world = make_world(def, scene);
        ProjectileDef p = bullet();
        p.fidelity = fidelity;
        p.fidelity.precision = precision;
        std::vector<ProjectileId> at, beside;
        for (int i = 0; i < 40; ++i) {
          const double speeds[] = {5, 10, 30, 100, 300, 900, 8000};
          const double speed = speeds[i % 7];
          const double radii[] = {0, 0.01, 0.5};
          BodyDef body{.gravity_scale = 0, .collision = {.radius = radii[i % 3]}};
          const bool hits = i % 2 == 0;
          const Vec3d aim = hits ? Vec3d{r.one_in(5) ? 0 : r.in(-0.99, 0.99), 0, r.one_in(5) ? 0 : r.in(-0.99, 0.99)}
                                 : Vec3d{r.in(2.2, 3) + body.collision.radius, 0, r.in(-0.5, 0.5)};
          const double side = r.one_in(2) ? 1 : -1;
          const double far = r.in(0.6, 3);
          Launch launch{.position = aim + Vec3d{0, side * far, 0}, .velocity = Vec3d{0, -side * speed, 0}};
          (hits ? at : beside).push_back(*world.spawn(p, launch, body));
        }
        run_for(world, 0.8, r.in(1.0 / 240, 1.0 / 30));
        for (const ProjectileId id : at)
          EXPECT_EQ(world[id].status(), LifeStatus::landed) << sheet.name << " " << world[id].position().y;
        for (const ProjectileId id : beside) EXPECT_NE(world[id].status(), LifeStatus::landed) << sheet.name;
      }
}

// So far away numbers of float32 are 0.98 mm apart: steps of 1.6 times that are rounded to twice it, every time.
TEST(SceneWorld, rounding_that_adds_up_from_step_to_step_carries_nothing_through) {
  constexpr double kFar = 1e4, kStep = 1.0 / 64;
  const double spacing = 8192.0 * std::numeric_limits<float>::epsilon();
  for (const Fidelity& fidelity : {Fidelity::game(), Fidelity::constant_air()})
    for (const double spacings : {1.55, 1.6, 1.75, 2.6}) {
      Scene scene;
      ASSERT_TRUE(
          scene.add({.shape = *scene.add_shape(BoxShape{{0.0005, 1, 1}}), .transform = {.position = {kFar, 0, 0}}}));
      World world = make_world(no_ground(), scene);
      ProjectileDef p = bullet();
      p.fidelity = fidelity;
      p.fidelity.precision = Precision::float32;
      std::vector<ProjectileId> all;
      for (int steps = 10; steps < 60; ++steps) {
        const Launch launch{.position = {kFar - 2 * steps * spacing, 0, 0},
                            .velocity = Vec3d{spacings * spacing / kStep, 0, 0}};
        all.push_back(*world.spawn(p, launch, {.gravity_scale = 0}));
      }
      run_for(world, 2, kStep);
      for (const ProjectileId id : all) EXPECT_EQ(world[id].status(), LifeStatus::landed) << spacings;
    }
}

TEST(SceneWorld, a_block_slides_down_a_slope_as_friction_lets_it) {
  constexpr double kSlope = 30 * test::kDegree;
  for (const double resistance : {0.0, 0.2}) {
    Scene scene;
    const MaterialId ice = *scene.add_material({.restitution = 0, .friction = 0});
    // The plane turned about z: it falls along +x.
    add_thing(scene, PlaneShape{},
              {.transform = {.rotation = {std::cos(kSlope / 2), 0, 0, -std::sin(kSlope / 2)}}, .material = ice});
    World world = make_world(no_ground(), scene);
    BodyDef body{
        .can_sleep = false, .restitution = 0, .rolling_resistance = resistance, .collision = {.on_hit = OnHit::bounce}};
    const ProjectileId id = *world.spawn(stone(), {.position = {0, 1e-6, 0}}, body);
    run_for(world, 2, 1.0 / 60);
    const double a = kG * (std::sin(kSlope) - resistance * std::cos(kSlope));
    const double time = world.time();
    EXPECT_NEAR(length(world[id].position()), 0.5 * a * time * time, 0.02 * a);
    EXPECT_NEAR(length(world[id].velocity()), a * time, 0.02 * a);
    const Vec3d normal{std::sin(kSlope), std::cos(kSlope), 0};
    EXPECT_NEAR(dot(world[id].position(), normal), 0, 1e-6);
  }
}

TEST(SceneWorld, a_wall_that_goes_wakes_what_leans_on_it) {
  Scene scene;
  const InstanceId table = add_thing(scene, BoxShape{{1, 0.1, 1}});
  World world = make_world(no_ground(), scene);
  BodyDef body{.restitution = 0.2, .collision = {.on_hit = OnHit::bounce, .radius = 0.05}};
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 0.5, 0}}, body);
  run_for(world, 4);
  ASSERT_TRUE(world[id].is_asleep());
  EXPECT_NEAR(world[id].position().y, 0.15, 1e-6);
  const Snapshot resting = world.snapshot();
  const std::uint64_t hash = world.hash();
  ASSERT_TRUE(world.remove_instance(table));
  EXPECT_FALSE(world[id].is_asleep());
  run_for(world, 1);
  EXPECT_LT(world[id].position().y, -4);
  EXPECT_EQ(world.scene()->size(), 0u);
  ASSERT_TRUE(world.restore(resting));
  EXPECT_EQ(world.hash(), hash);
  EXPECT_EQ(world.scene()->size(), 1u);
  run_for(world, 1);
  EXPECT_NEAR(world[id].position().y, 0.15, 1e-6);
}

TEST(SceneWorld, a_start_inside_of_something_is_told) {
  Scene scene;
  add_thing(scene, BoxShape{{1, 1, 1}});
  World world = make_world(no_ground(), scene);
  BodyDef body{.collision = {.on_hit = OnHit::bounce}};
  const ProjectileId id = *world.spawn(stone(), {.position = {0.5, 0, 0}, .speed = 50}, body);
  world.step(1.0 / 60);
  const auto hits = events_of(world, EventKind::hit);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].reason, Reason::inside);
  EXPECT_EQ(world[id].position().x, 0.5);
  EXPECT_EQ(world[id].status(), LifeStatus::landed);
}

TEST(SceneWorld, what_leaves_all_numbers_beside_a_thing_is_retired) {
  // A push that no number holds, after some steps.
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    WorldDef def{.ground = {.mode = GroundMode::none}};
    World world = make_world(def, room({50, 50, 50}, {.restitution = 1, .friction = 0}));
    ProjectileDef p = stone();
    p.fidelity = Fidelity::game();
    p.fidelity.precision = precision;
    p.fidelity.drag = DragModel::off;
    p.mass = 1e-3;
    const auto kind = must(world.add_kind(p, {.collision = {.on_hit = OnHit::bounce, .radius = 0.1}}));
    const auto id = must(world.spawn(kind, {.velocity = Vec3d{3, 0, 0}}));
    const auto pushes = [](const ForceBatch& b) {
      for (std::size_t i = 0; i < b.force.size(); ++i) b.force[i] = {b.time > 0.5 ? 1e308 : 0, 0, 0};
    };
    ASSERT_TRUE(world.add_force({.law = CustomForce{pushes}, .target = ForceTarget::everything()}));
    for (int step = 0; step < 200 && world[id].is_alive(); ++step) world.step(1.0 / 60);
    EXPECT_FALSE(world[id].is_alive());
  }
}

TEST(SceneWorld, threads_and_kernels_change_nothing) {
  std::vector<std::uint64_t> hashes;
  for (const unsigned threads : {1u, 2u, 7u}) {
    WorldDef def = no_ground();
    def.threading = {.threads = threads, .rows_per_thread = 64};
    World world = make_world(def, room({5, 3, 4}, {.restitution = 0.9, .friction = 0.3}));
    Random r(3);
    for (int i = 0; i < 300; ++i) {
      ProjectileDef p = bullet();
      p.fidelity = r.one_in(2) ? Fidelity::game() : Fidelity::small_arms();
      BodyDef body{.collision = {.on_hit = OnHit::bounce, .radius = r.one_in(2) ? 0.1 : 0.0}};
      Launch launch{.position = {r.in(-4, 4), r.in(-2, 2), r.in(-3, 3)},
                    .speed = r.in(1, 300),
                    .elevation = r.in(-1.5, 1.5),
                    .azimuth = r.in(-3, 3)};
      ASSERT_TRUE(world.spawn(p, launch, body));
    }
    run_for(world, 1, 1.0 / 60);
    hashes.push_back(world.hash());
    for (const ProjectileId id : world.ids()) {
      const Vec3d x = world[id].position();
      EXPECT_TRUE(std::abs(x.x) < 5 && std::abs(x.y) < 3 && std::abs(x.z) < 4) << x.x << " " << x.y << " " << x.z;
    }
  }
  EXPECT_EQ(hashes[0], hashes[1]);
  EXPECT_EQ(hashes[0], hashes[2]);
}

}  // namespace physim::world_scene_world_test
