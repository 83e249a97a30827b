// Worlds with scenes through every door of time: snapshots, saves, recordings, and changes in between.
#include "world/world_support.hpp"

namespace physim::world_scene_moments_test {

/// Balls that bounce in a trough, beside a plank that moves to and fro.
World trough() {
  Scene scene;
  const MaterialId hard = *scene.add_material({.restitution = 0.8, .friction = 0.3});
  const MaterialId wood = *scene.add_material(materials::oak());
  const ShapeId plane = *scene.add_shape(PlaneShape{});
  for (const double side : {-1.0, 1.0})
    EXPECT_TRUE(scene.add(
        {.shape = plane, .transform = {.rotation = {1, 0, 0, side * 0.3}}, .material = hard, .name = "side"}));
  add_thing(scene, BoxShape{{0.1, 1, 3}},
            {.transform = {.position = {8, 2, 0}},
             .material = wood,
             .name = "plank",
             .motion = KeyedMotion{{{.time = 0, .position = {8, 2, 0}},
                                    {.time = 1, .position = {2, 2, 0}},
                                    {.time = 2, .position = {8, 2, 0}}}}});
  return make_world({.ground = {.mode = GroundMode::none}}, scene);
}

void throw_in(World& world, int number) {
  for (int i = 0; i < number; ++i) {
    ProjectileDef p = bullet();
    p.fidelity = i % 3 == 0 ? Fidelity::small_arms() : i % 3 == 1 ? Fidelity::game() : Fidelity::arcade();
    BodyDef body{.collision = {.on_hit = i % 4 == 0 ? OnHit::impact : OnHit::bounce, .radius = i % 2 * 0.1}};
    ASSERT_TRUE(world.spawn(p, {.position = {0.3 * i - 3, 4 + 0.1 * i, 0.2 * i}, .speed = 3.0 * i}, body));
  }
}

TEST(SceneMoments, a_save_goes_on_as_the_world_does) {
  World world = trough();
  throw_in(world, 24);
  run_for(world, 0.7, 1.0 / 60);
  const auto save = must(world.save());
  World loaded = must(World::load(save));
  EXPECT_EQ(loaded.hash(), world.hash());
  EXPECT_EQ(loaded.save().value(), save);
  for (int i = 0; i < 90; ++i) {
    world.step(1.0 / 60), loaded.step(1.0 / 60);
    ASSERT_EQ(loaded.hash(), world.hash()) << i;
    ASSERT_EQ(loaded.events().size(), world.events().size());
  }
  const InstanceId added = *world.add_instance({.shape = *world.add_shape(SphereShape{2})});
  ASSERT_EQ(*loaded.add_instance({.shape = *loaded.add_shape(SphereShape{2})}), added);
  EXPECT_EQ(loaded.hash(), world.hash());
}

/// What one projectile meets at one time is told in one order, wherever its row lies.
TEST(SceneMoments, what_is_met_at_once_is_told_in_one_order) {
  Scene scene;
  const ShapeId box = *scene.add_shape(BoxShape{{0.5, 50, 50}});
  for (int i = 0; i < 4; ++i)
    ASSERT_TRUE(scene.add({.shape = box, .transform = {.position = {5.5, 0, 0}}, .sensor = true}));
  World world = make_world({}, scene);
  BodyDef body{.gravity_scale = 0};
  std::vector<ProjectileId> ids;
  for (int i = 0; i < 80; ++i) ids.push_back(*world.spawn(stone(), {.position = {0, 1, 0.1 * i}, .speed = 100}, body));
  for (std::size_t i = 0; i < 40; ++i) EXPECT_TRUE(world[ids[i * 37 % 40]].despawn());
  world.step(1.0 / 60);
  World loaded = reloaded(world);
  std::size_t told = 0;
  for (int i = 0; i < 3; ++i) {
    world.step(1.0 / 60), loaded.step(1.0 / 60);
    ASSERT_EQ(world.events().size(), loaded.events().size());
    for (std::size_t e = 0; e < world.events().size(); ++e) {
      const Event &one = world.events()[e], &other = loaded.events()[e];
      EXPECT_EQ(one.instance, other.instance) << e;
      EXPECT_EQ(one.id, other.id);
      if (one.kind != EventKind::sensed) continue;
      EXPECT_EQ(one.instance.index, 1 + told % 4);
      ++told;
    }
  }
  EXPECT_EQ(told, 160u);
}

/// Worlds of one hash have one future, whatever their steps were.
TEST(SceneMoments, chance_follows_from_what_is_hashed) {
  Material loose = materials::fir();
  loose.spread.deflection = 0.1;
  const auto world_after = [&](int steps) {
    Scene scene;
    add_thing(scene, BoxShape{{0.009, 5, 5}},
              {.transform = {.position = {50, 0, 0}}, .material = *scene.add_material(loose)});
    World world = make_world({}, scene);
    for (int i = 0; i < steps; ++i) world.step(0.25 / steps);
    world.step(1.0 / 64);
    BodyDef body{.collision = {.on_hit = OnHit::impact}};
    EXPECT_TRUE(world.spawn(bullet(), {.position = {0, 2, 0}, .speed = 780}, body));
    return world;
  };
  World one = world_after(4), other = world_after(8);
  ASSERT_EQ(one.hash(), other.hash());
  std::vector<Vec3d> ways;
  for (World* world : {&one, &other}) {
    for (const Event& e : run_for(*world, 0.2, 1.0 / 64))
      if (e.kind == EventKind::penetrated) ways.push_back(e.velocity);
  }
  ASSERT_EQ(ways.size(), 2u);
  EXPECT_EQ(ways[0], ways[1]);
  EXPECT_EQ(one.hash(), other.hash());
  run_for(one, 1.0 / 64, 1.0 / 64);
  EXPECT_TRUE(one.spawn(bullet(), {.position = {0, 2, 0}, .speed = 780}, {.collision = {.on_hit = OnHit::impact}}));
  const auto later = run_for(one, 0.2, 1.0 / 64);
  const auto out = std::ranges::find(later, EventKind::penetrated, &Event::kind);
  ASSERT_NE(out, later.end());
  EXPECT_GT(length(out->velocity - ways[0]), 1e-3) << "at another time";
}

/// Rows get other columns where a world has things to meet. What the original loop carries from its last frame goes
/// along: a scene that is nowhere near changes no path.
TEST(SceneMoments, the_first_scene_changes_no_path) {
  const Scene far = *trough().scene();
  for (const Fidelity& fidelity : {Fidelity::classic(), Fidelity::game(), Fidelity::small_arms()}) {
    WorldDef def{.ground = {.mode = GroundMode::none}};
    World alone = make_world(def), meets = make_world(def);
    ProjectileDef p = bullet();
    p.fidelity = fidelity;
    const Launch launch{.position = {0, 1000, 0}, .speed = 300, .elevation = 1.2};
    const ProjectileId id = *alone.spawn(p, launch);
    ASSERT_EQ(*meets.spawn(p, launch), id);
    for (int i = 0; i < 30; ++i) {
      if (i == 10) {
        ASSERT_TRUE(meets.set_scene(far));
      }
      alone.step(1.0 / 60), meets.step(1.0 / 60);
      EXPECT_TRUE(test::same_bits(meets[id].state().position.y, alone[id].state().position.y)) << i;
      EXPECT_TRUE(test::same_bits(meets[id].state().velocity.y, alone[id].state().velocity.y)) << i;
    }
  }
}

/// Each change wakes whoever sleeps then, though only the first one between two steps has to ask all.
TEST(SceneMoments, every_change_wakes_who_sleeps_then) {
  World world = trough();
  const ShapeId ball = *world.add_shape(SphereShape{1});
  const ProjectileId id = *world.spawn(stone(), {.position = {0, 50, 0}}, {.collision = {.on_hit = OnHit::bounce}});
  const auto change = [&] { return *world.add_instance({.shape = ball, .transform = {.position = {0, 100, 0}}}); };
  const auto put_to_sleep = [&] { return world[id].sleep().ok() && world[id].is_asleep(); };
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(put_to_sleep());
    change();
    EXPECT_FALSE(world[id].is_asleep());
    const InstanceId other = change();
    ASSERT_TRUE(put_to_sleep());
    const Snapshot then = world.snapshot();
    ASSERT_TRUE(world.remove_instance(other));
    EXPECT_FALSE(world[id].is_asleep());
    ASSERT_TRUE(world.restore(then));
    EXPECT_TRUE(world[id].is_asleep());
    ASSERT_TRUE(world.move_instance(other, {.position = {0, 90, 0}}));
    EXPECT_FALSE(world[id].is_asleep());
    world.step(1.0 / 60);
  }
  ASSERT_TRUE(put_to_sleep());
  ASSERT_TRUE(world.set_scene(*trough().scene()));
  EXPECT_FALSE(world[id].is_asleep());
}

/// What moves wakes who sleeps in its way, wherever in the step it comes by, sets out or ends.
TEST(SceneMoments, what_comes_by_wakes_who_sleeps) {
  struct Case {
    SceneMotion motion;
    Vec3d half;
    bool on_it;  // the ball lies on what moves
  };
  const auto keys = [](std::initializer_list<MotionKey> list) { return KeyedMotion{{list}}; };
  const Vec3d hammer{0.1, 0.2, 0.2};
  const Case cases[] = {
      {SteadyMotion{.start = 0, .velocity = {100, 0, 0}}, hammer, false},
      {keys({{.time = 0, .position = {-1, 0.25, 0}},
             {.time = 1.0001, .position = {-1, 0.25, 0}},
             {.time = 1.0101, .position = {-0.1, 0.25, 0}}}),
       hammer, false},
      {keys({{.time = 0, .position = {0, -0.5, 0}},
             {.time = 1.005, .position = {0, -0.5, 0}},
             {.time = 3, .position = {0, -4.5, 0}}}),
       {5, 0.5, 5},
       true},
  };
  for (const Case& c : cases) {
    Scene scene;
    const bool steady = std::holds_alternative<SteadyMotion>(c.motion);
    add_thing(scene, BoxShape{c.half}, {.transform = {.position = {steady ? -100.4 : 0, 0.25, 0}}, .motion = c.motion});
    const ShapeId floor = *scene.add_shape(BoxShape{{5, 0.5, 5}});
    ASSERT_TRUE(c.on_it || scene.add({.shape = floor, .transform = {.position = {0, -0.5, 0}}}));
    World world = make_world({.ground = {.mode = GroundMode::none}}, scene);
    BodyDef body{.sleep_time = 0.1, .restitution = 0, .collision = {.on_hit = OnHit::bounce, .radius = 0.05}};
    const ProjectileId id = *world.spawn(stone(), {.position = {0, 0.0500001, 0}}, body);
    run_for(world, 0.9, 1.0 / 60);
    ASSERT_TRUE(world[id].is_asleep());
    std::vector<double> woke;
    for (const Event& e : run_for(world, 0.6, 1.0 / 60))
      if (e.kind == EventKind::woke) woke.push_back(e.time);
    ASSERT_EQ(woke.size(), 1u);
    EXPECT_NEAR(woke[0], 1.0, 0.02);
    EXPECT_GT(length(world[id].position() - Vec3d{0, 0.05, 0}), 0.05) << "it was struck, or fell";
  }
}

/// A gate of 1 m that comes with 2 m/s from 3 m away is entered after 1.25 s and left after 1.75 s, by who sleeps too.
TEST(SceneMoments, a_sensor_in_motion_tells_of_who_sleeps) {
  for (const bool sleeps : {true, false})
    for (const double radius : {0.0, 0.05}) {
      Scene scene;
      const ShapeId gate = *scene.add_shape(BoxShape{{0.5, 0.5, 0.5}});
      ASSERT_TRUE(scene.add({.shape = gate,
                             .transform = {.position = {-3, 0, 0}},
                             .sensor = true,
                             .motion = SteadyMotion{.velocity = {2, 0, 0}}}));
      World world = make_world({.ground = {.mode = GroundMode::bounce}}, scene);
      BodyDef body{.can_sleep = sleeps, .sleep_time = 0.1, .collision = {.on_hit = OnHit::bounce, .radius = radius}};
      const ProjectileId id = *world.spawn(stone(), {}, body);
      run_for(world, 0.9, 1.0 / 60);
      ASSERT_EQ(world[id].is_asleep(), sleeps);
      std::vector<Event> told = run_for(world, 1.1, 1.0 / 60);
      std::erase_if(told, [](const Event& e) { return e.kind != EventKind::sensed && e.kind != EventKind::left; });
      ASSERT_EQ(told.size(), 2u) << radius;
      EXPECT_EQ(told[0].kind, EventKind::sensed);
      EXPECT_NEAR(told[0].time, 1.25, 1e-9);
      EXPECT_EQ(told[1].kind, EventKind::left);
      EXPECT_NEAR(told[1].time, 1.75, 1e-9);
      run_for(world, 1, 1.0 / 60);
      EXPECT_EQ(world[id].is_asleep(), sleeps) << "it sleeps again when the gate has passed";
    }
}

TEST(SceneMoments, the_hash_sees_the_scene) {
  World world = trough();
  const std::uint64_t before = world.hash();
  const ShapeId ball = *world.add_shape(SphereShape{1});
  const InstanceId added = *world.add_instance({.shape = ball});
  const std::uint64_t with = world.hash();
  EXPECT_NE(with, before);
  ASSERT_TRUE(world.move_instance(added, {.position = {1, 0, 0}}));
  EXPECT_NE(world.hash(), with);
  ASSERT_TRUE(world.remove_scene());
  EXPECT_EQ(world.scene(), nullptr);
  EXPECT_NE(world.hash(), before);
}

TEST(SceneMoments, snapshots_keep_the_scene_that_was) {
  World world = trough();
  throw_in(world, 12);
  run_for(world, 0.5, 1.0 / 60);
  const Snapshot then = world.snapshot();
  const auto play = [&] {
    run_for(world, 0.5, 1.0 / 60);
    return world.hash();
  };
  const std::uint64_t first = play();
  ASSERT_TRUE(world.remove_scene());
  run_for(world, 0.5, 1.0 / 60);
  ASSERT_TRUE(world.restore(then));
  ASSERT_NE(world.scene(), nullptr);
  EXPECT_EQ(play(), first);
  ASSERT_TRUE(world.restore(then));
  for (const InstanceId id : {InstanceId{1, 1}, InstanceId{2, 1}}) ASSERT_TRUE(world.remove_instance(id));
  run_for(world, 0.5, 1.0 / 60);
  EXPECT_NE(world.hash(), first);
  ASSERT_TRUE(world.restore(then));
  EXPECT_EQ(world.scene()->size(), 3u);
  EXPECT_EQ(play(), first);
}

TEST(SceneMoments, a_recording_plays_every_change_again) {
  World world{};
  std::vector<std::byte> bytes;
  ASSERT_TRUE(world.record(record_into(bytes)));
  {
    const World model = trough();
    ASSERT_TRUE(world.set_scene(*model.scene()));
  }
  throw_in(world, 12);
  run_for(world, 0.3, 1.0 / 60);
  const ShapeId ball = *world.add_shape(SphereShape{0.5});
  const MaterialId soft = *world.add_material({.restitution = 0.1});
  const InstanceId added = *world.add_instance({.shape = ball, .transform = {.position = {0, 3, 1}}, .material = soft});
  run_for(world, 0.2, 1.0 / 60);
  ASSERT_TRUE(world.set_instance_motion(added, SteadyMotion{world.time(), {-3, 0, 0}, {0, 1, 0}}));
  run_for(world, 0.2, 1.0 / 60);
  ASSERT_TRUE(world.move_instance(added, {.position = {2, 2, 0}}));
  ASSERT_TRUE(world.set_instance_layers(added, 2));
  run_for(world, 0.2, 1.0 / 60);
  ASSERT_TRUE(world.remove_instance(added));
  ASSERT_TRUE(world.remove_shape(ball));
  run_for(world, 0.2, 1.0 / 60);
  const ReplayReport report = replayed(world, bytes);
  EXPECT_GT(report.hashes, 60u);
}

TEST(SceneMoments, changes_of_no_scene_are_refused) {
  World world{};
  EXPECT_EQ(world.add_shape(SphereShape{1}).error().text(),
            "scene: error: the world has no scene; World::set_scene() gives it one");
  EXPECT_FALSE(world.remove_shape({1, 1}));
  EXPECT_FALSE(world.add_material({}));
  EXPECT_FALSE(world.add_instance({}));
  EXPECT_FALSE(world.remove_instance({1, 1}));
  EXPECT_FALSE(world.move_instance({1, 1}, {}));
  EXPECT_FALSE(world.set_instance_motion({1, 1}, AtRest{}));
  EXPECT_FALSE(world.set_instance_layers({1, 1}, 1));
  EXPECT_FALSE(world.remove_scene());
  ASSERT_TRUE(world.set_scene(Scene()));
  EXPECT_FALSE(world.remove_instance({1, 1}));
  EXPECT_TRUE(world.add_shape(SphereShape{1}));
}

TEST(SceneMoments, bad_collisions_are_refused_with_their_place) {
  World world{};
  const auto why = [&](const CollisionDef& collision) {
    const auto kind = world.add_kind(stone(), {.collision = collision});
    return kind ? "" : kind.error().text();
  };
  EXPECT_NE(why({.on_hit = static_cast<OnHit>(17)}).find("body.collision.on_hit"), std::string::npos);
  EXPECT_NE(why({.radius = -1}).find("body.collision.radius"), std::string::npos);
  EXPECT_NE(why({.radius = 1e-308}).find("body.collision.radius"), std::string::npos) << "its spin would be no number";
  EXPECT_NE(why({.radius = std::nan("")}).find("body.collision.radius"), std::string::npos);
  EXPECT_NE(why({.inertia = 0}).find("body.collision.inertia"), std::string::npos);
  EXPECT_EQ(why({.radius = 1, .inertia = 2.0 / 3}), "");
}

}  // namespace physim::world_scene_moments_test
