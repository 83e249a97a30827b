// Joints whose points move, against closed forms: at a steady velocity, faster and faster, on things that turn.
#include "world/joints_support.hpp"
#include "world/random_session.hpp"

namespace physim::world_joints_anchor_test {

using namespace test_joints;
using test::near;

constexpr JointKind kAll[] = {JointKind::rod, JointKind::cable, JointKind::spring, JointKind::hinge, JointKind::slider};

/// A joint of each kind between a ball and a point, as it may be.
Joint joint_of(JointKind kind, ProjectileId ball) {
  Joint joint{.kind = kind, .a = ball};
  if (kind == JointKind::spring) joint.stiffness = 40, joint.damping = 0.5;
  if (kind == JointKind::hinge) joint.axis = {1, 1, 3};
  if (kind == JointKind::slider) joint.axis = {2, 1, 0.5};
  return joint;
}

/// A scene with one thing.
Scene scene_of(const InstanceDef& thing, InstanceId& id) {
  Scene scene;
  InstanceDef made = thing;
  made.shape = scene.add_shape(BoxShape{{0.1, 0.1, 0.1}}).value();
  id = scene.add(made).value();
  return scene;
}

TEST(JointAnchor, a_point_that_moves_steadily_is_one_at_rest_seen_from_a_frame_that_moves) {
  const Vec3d velocity{7, 2, -3}, at{0.8, 0.4, 0.2}, own{0.3, -0.5, 0.4};
  for (const JointKind kind : kAll) {
    World rests = World::create(falling()).value(), moves = World::create(falling()).value();
    const ProjectileId a = put(rests, mass_of(2), bob(), at, own),
                       b = put(moves, mass_of(2), bob(), at, own + velocity);
    join(rests, joint_of(kind, a));
    Joint joint = joint_of(kind, b);
    joint.velocity = velocity;
    const JointId moved = join(moves, joint);
    for (int i = 0; i < 300; ++i) {
      rests.step(1.0 / 60), moves.step(1.0 / 60);
      ASSERT_TRUE(near(moves[b].position() - velocity * moves.time(), rests[a].position(), 0, 1e-9)) << i;
      ASSERT_TRUE(near(moves[b].velocity() - velocity, rests[a].velocity(), 0, 1e-9)) << i;
    }
    EXPECT_EQ(moves.joint_counts().unsolved, rests.joint_counts().unsolved);
    EXPECT_TRUE(near(moves.joint(moved)->point - joint.point, velocity * 5, 0, kind == JointKind::hinge ? 1 : 1e-10));
  }
}

TEST(JointAnchor, a_heavy_ball_on_a_light_chain_is_carried_as_it_hangs) {
  const Vec3d velocity{4, 0, 1};
  const auto build = [&](World& world, const Vec3d& v) {
    std::vector<ProjectileId> links;
    for (int i = 1; i <= 10; ++i) {
      const double mass = i == 10 ? 1000 : 0.001;
      links.push_back(put(world, mass_of(mass), bob(), Vec3d{0.05, -0.0866, 0} * i, v));
      join(world,
           {.a = links.back(), .b = i > 1 ? links[links.size() - 2] : ProjectileId{}, .velocity = i > 1 ? Vec3d{} : v});
    }
    return links.back();
  };
  World rests = World::create(falling()).value(), moves = World::create(falling()).value();
  const ProjectileId a = build(rests, {}), b = build(moves, velocity);
  for (int i = 0; i < 180; ++i) rests.step(1.0 / 60), moves.step(1.0 / 60);
  EXPECT_TRUE(near(moves[b].position() - velocity * moves.time(), rests[a].position(), 0, 1e-5));
  EXPECT_EQ(moves.joint_counts().unsolved, 0u);
}

TEST(JointAnchor, a_train_that_gets_faster_holds_its_pendulum_back) {
  // Smooth keys are a parabola: the train has 1.5 m/s^2 for 8 s. What hangs in it is at rest at atan(a / g).
  const double a = 1.5, angle = std::atan2(a, kGravity);
  InstanceId train;
  const KeyedMotion motion{{{.time = 0}, {.time = 8, .position = {a * 32, 0, 0}, .velocity = {a * 8, 0, 0}}},
                           MotionCurve::smooth};
  const Scene scene = scene_of({.motion = motion}, train);
  World world = make_world(falling(), scene);
  const ProjectileId ball = put(world, mass_of(2), bob(), {-std::sin(angle), 2 - std::cos(angle), 0});
  const JointId rod = join(world, {.a = ball, .point = {0, 2, 0}, .thing = train});
  for (int i = 0; i < 420; ++i) {
    world.step(1.0 / 60);
    const double x = a / 2 * world.time() * world.time();
    ASSERT_TRUE(near(world[ball].position() - Vec3d{x, 2, 0}, {-std::sin(angle), -std::cos(angle), 0}, 0, 1e-8)) << i;
  }
  EXPECT_TRUE(near(world.joint_state(rod).tension, 2 * std::hypot(a, kGravity), 1e-6));
  EXPECT_EQ(world.joint_counts().unsolved, 0u);
}

TEST(JointAnchor, a_caller_moves_a_point_along_any_way) {
  // The same train, moved by calls in steps: a polygon whose corners are on its way.
  const double a = 1.5, angle = std::atan2(a, kGravity), dt = 1.0 / 240;
  World world = World::create(falling()).value();
  const ProjectileId ball = put(world, mass_of(2), bob(), {-std::sin(angle), -std::cos(angle), 0});
  const JointId rod = join(world, {.a = ball});
  const auto place = [&](double t) { return Vec3d{a / 2 * t * t, 0, 0}; };
  for (int i = 0; i < 240 * 5; ++i) {
    const double now = world.time();
    ASSERT_TRUE(world.move_joint(rod, {place(now), (place(now + dt) - place(now)) * (1 / dt)}));
    world.step(dt);
    ASSERT_TRUE(near(length(world[ball].position() - place(world.time())), 1, 1e-12));
    ASSERT_TRUE(near(world[ball].position() - place(world.time()), {-std::sin(angle), -std::cos(angle), 0}, 0, 4e-3));
  }
}

/// A turntable with a rod of 0.6 m at 0.5 m from its axis.
struct Turntable {
  double omega = 3, radius = 0.5, rod = 0.6;
  World world = World::create(falling()).value();
  ProjectileId ball;
  JointId joint;
  InstanceId table;

  explicit Turntable(double angle) {
    Scene scene = scene_of(
        {.transform = {.position = {0, 1, 0}, .scale = 2}, .motion = SteadyMotion{.angular_velocity = {0, omega, 0}}},
        table);
    EXPECT_TRUE(world.set_scene(scene));
    const double out = radius + rod * std::sin(angle);
    ball = put(world, mass_of(1.5), bob(), {out, 1 - rod * std::cos(angle), 0}, {0, 0, -omega * out});
    joint = join(world, {.a = ball, .point = {radius / 2, 0, 0}, .length = rod, .thing = table});
  }
  [[nodiscard]] Vec3d anchor(double t) const {
    return {radius * std::cos(omega * t), 1, -radius * std::sin(omega * t)};
  }
};

TEST(JointAnchor, on_a_turntable_a_pendulum_stands_out) {
  // tan(angle) = omega^2 (radius + rod sin(angle)) / g.
  double angle = 0.5;
  const Turntable unit(0);
  for (int i = 0; i < 200; ++i)
    angle = std::atan(unit.omega * unit.omega * (unit.radius + unit.rod * std::sin(angle)) / kGravity);
  Turntable t(angle);
  for (int i = 0; i < 960; ++i) {
    t.world.step(1.0 / 480);
    const Vec3d to = t.world[t.ball].position() - t.anchor(t.world.time());
    ASSERT_TRUE(near(length(to), t.rod, 1e-11)) << i;
    ASSERT_TRUE(near(to.y, -t.rod * std::cos(angle), 0, 1e-4)) << i;
  }
  EXPECT_TRUE(near(t.world.joint_state(t.joint).tension, 1.5 * kGravity / std::cos(angle), 1e-4));
  EXPECT_EQ(t.world.joint_counts().unsolved, 0u);
}

TEST(JointAnchor, errors_fall_with_the_square_of_the_step) {
  const auto place_after = [](double dt) {
    Turntable t(0.2);
    for (int i = 0; i < static_cast<int>(std::round(1.5 / dt)); ++i) {
      t.world.step(dt);
      EXPECT_LT(std::abs(length(t.world[t.ball].position() - t.anchor(t.world.time())) - t.rod), 1e-11);
    }
    return t.world[t.ball].position();
  };
  const Vec3d truth = place_after(1.0 / 8192);
  const double coarse = length(place_after(1.0 / 128) - truth), fine = length(place_after(1.0 / 256) - truth);
  EXPECT_GT(coarse / fine, 3.7);
  EXPECT_LT(coarse / fine, 4.3);
}

TEST(JointAnchor, a_crane_that_starts_wakes_what_hangs_from_it) {
  InstanceId crane;
  const Scene scene = scene_of(
      {.motion = KeyedMotion{{{.time = 0}, {.time = 2}, {.time = 4, .position = {1, 0, 0}}}, MotionCurve::straight}},
      crane);
  World world = make_world(falling(), scene);
  const ProjectileId load = put(world, mass_of(50), {.sleep_time = 0.3}, {0, -3, 0});
  join(world, {.kind = JointKind::cable, .a = load, .thing = crane});
  for (int i = 0; i < 110; ++i) world.step(1.0 / 60);
  EXPECT_TRUE(world[load].is_asleep());
  for (int i = 0; i < 70; ++i) world.step(1.0 / 60);
  EXPECT_FALSE(world[load].is_asleep());
  EXPECT_GT(world[load].position().x, 0.1);
  // A thing that goes slower than what counts as rest keeps it awake, too.
  ASSERT_TRUE(world.set_instance_motion(crane, SteadyMotion{.start = world.time(), .velocity = {1e-4, 0, 0}}));
  for (int i = 0; i < 300; ++i) world.step(1.0 / 60);
  EXPECT_FALSE(world[load].is_asleep());
}

TEST(JointAnchor, a_joint_ends_with_its_thing) {
  for (const bool whole_scene : {false, true}) {
    InstanceId thing;
    const Scene scene = scene_of({}, thing);
    World world = make_world(falling(), scene);
    const ProjectileId ball = put(world, mass_of(1), bob(), {0, -1, 0}),
                       other = put(world, mass_of(1), bob(), {1, 0, 0});
    const JointId on_it = join(world, {.a = ball, .thing = thing});
    const JointId beside = join(world, {.a = other, .point = {1, 1, 0}});
    world.step(1.0 / 60);
    ASSERT_TRUE(whole_scene ? world.remove_scene() : world.remove_instance(thing));
    ASSERT_EQ(world.joint_events().size(), 1u);
    EXPECT_EQ(world.joint_events()[0].kind, JointEventKind::ended);
    EXPECT_EQ(world.joint_events()[0].joint, on_it);
    EXPECT_EQ(world.joint_events()[0].projectile, ball);
    EXPECT_EQ(world.joint(on_it), nullptr);
    EXPECT_NE(world.joint(beside), nullptr);
    world.step(1.0 / 60);
    EXPECT_LT(world[ball].position().y, -1);
  }
}

/// Pendulums at a point that calls move and at a thing that turns, and a chain between them.
World carried(std::vector<JointId>& joints, std::vector<std::byte>* recorded = nullptr) {
  InstanceId thing;
  const Scene scene = scene_of({.transform = {.position = {2, 0, 0}},
                                .motion = SteadyMotion{.velocity = {0.3, 0, 0}, .angular_velocity = {0.5, 2, 1}}},
                               thing);
  World world = World::create(falling()).value();
  if (recorded) {
    EXPECT_TRUE(world.record(record_into(*recorded)));
  }
  EXPECT_TRUE(world.set_scene(scene));
  const ProjectileId a = put(world, mass_of(1), bob(), {0, -1, 0}), b = put(world, mass_of(2), bob(), {2, -1, 0.5});
  joints = {join(world, {.a = a, .velocity = {0.2, 0, 0}}),
            join(world, {.a = b, .point = {0.3, 0.2, 0}, .break_force = 1e6, .thing = thing}),
            join(world, {.kind = JointKind::cable, .a = a, .b = b, .length = 2.5})};
  return world;
}

TEST(JointAnchor, it_is_kept_and_played_again_to_the_bit) {
  std::vector<JointId> joints;
  std::vector<std::byte> recorded;
  World world = carried(joints, &recorded);
  const auto run = [&](World& w, int from, int to) {
    for (int i = from; i < to; ++i) {
      const Vec3d velocity{0.1 * (i % 5), 0.1, 0};
      ASSERT_TRUE(i % 7 != 0 || w.move_joint(joints[0], {w.joint(joints[0])->point, velocity}));
      w.step(1.0 / 60);
    }
  };
  run(world, 0, 40);
  const auto saved = must(world.save());
  const Snapshot then = world.snapshot();
  run(world, 40, 120);
  const std::uint64_t hash = world.hash();
  ASSERT_TRUE(world.restore(then));
  run(world, 40, 120);
  EXPECT_EQ(world.hash(), hash);
  for (const unsigned threads : {1u, 3u}) {
    auto loaded = must(World::load(saved, {.threading = {threads, 1}}));
    run(loaded, 40, 120);
    EXPECT_EQ(loaded.hash(), hash);
  }
  replayed(world, recorded);
}

TEST(JointAnchor, bad_points_are_refused_with_a_place) {
  std::vector<JointId> joints;
  World world = carried(joints);
  const ProjectileId a = world.ids()[0], b = world.ids()[1];
  const auto refused = [&](const Joint& joint, const std::string& place) {
    const auto id = world.add_joint(joint);
    ASSERT_FALSE(id);
    EXPECT_EQ(id.error().place, place) << id.error().text();
  };
  const InstanceId thing = world.joint(joints[1])->thing;
  refused({.a = a, .velocity = {test::kNan, 0, 0}}, "joint.velocity");
  refused({.a = a, .velocity = {2e9, 0, 0}}, "joint.velocity");
  refused({.a = a, .b = b, .velocity = {1, 0, 0}}, "joint.velocity");
  refused({.a = a, .velocity = {1, 0, 0}, .thing = thing}, "joint.velocity");
  refused({.a = a, .b = b, .thing = thing}, "joint.thing");
  refused({.a = a, .thing = {77, 1}}, "joint.thing");
  refused({.a = a, .thing = {thing.index, thing.generation + 1}}, "joint.thing");
  EXPECT_EQ(world.move_joint(joints[0], {{0, test::kNan, 0}, {}}).error().place, "joint.point");
  EXPECT_EQ(world.move_joint(joints[0], {{0, 0, 0}, {0, kInfinity, 0}}).error().place, "joint.velocity");
  EXPECT_FALSE(world.move_joint(joints[1], {{0, 0, 0}, {}})) << "its point is a thing's";
  EXPECT_FALSE(world.move_joint(joints[2], {{0, 0, 0}, {}})) << "it holds two projectiles";
  EXPECT_FALSE(world.move_joint({}, {}));
  EXPECT_TRUE(world.move_joint(joints[0], {{0, 0.5, 0}, {1, 0, 0}}));
}

}  // namespace physim::world_joints_anchor_test
