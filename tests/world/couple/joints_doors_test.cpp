// Joints through every door of a world: bad input, leaving, sleep, snapshots, saves, recordings, hashes, kernels.
#include "world/joints_support.hpp"
#include "world/random_session.hpp"

namespace physim::world_joints_doors_test {

using namespace test_joints;
using test::near;

TEST(JointDoors, bad_joints_are_refused_with_a_place) {
  World world = World::create(falling()).value();
  const ProjectileId a = put(world, mass_of(1), bob(), {0, 0, 0}), b = put(world, mass_of(1), bob(), {1, 0, 0});
  const ProjectileId same = put(world, mass_of(1), bob(), {0, 0, 0}), gone = put(world, mass_of(1), bob(), {5, 0, 0});
  ASSERT_TRUE(world[gone].despawn());
  const auto refused = [&](const Joint& joint, const std::string& place) {
    const auto id = world.add_joint(joint);
    ASSERT_FALSE(id);
    EXPECT_EQ(id.error().place, place) << id.error().text();
  };
  const double nan = test::kNan;
  refused({.b = b}, "joint.a");
  refused({.a = gone, .b = b}, "joint.a");
  refused({.a = {99, 1}}, "joint.a");
  refused({.a = a, .b = gone}, "joint.b");
  refused({.a = a, .b = a}, "joint.b");
  refused({.kind = static_cast<JointKind>(5), .a = a}, "joint.kind");
  refused({.a = a, .point = {0, nan, 0}}, "joint.point");
  refused({.a = a, .point = {2e15, 0, 0}}, "joint.point");
  for (const double length : {nan, -1.0, 0.0, kInfinity, 1e16})
    refused({.a = a, .b = b, .length = length}, "joint.length");
  refused({.kind = JointKind::spring, .a = a, .b = b, .length = -1}, "joint.length");
  refused({.a = a, .b = same}, "joint.length");
  refused({.a = a}, "joint.length");  // it lies at its point
  const ProjectileId far = put(world, mass_of(1), bob(), {2e15, 0, 0});
  refused({.a = a, .b = far}, "joint.length");  // a length that is measured: load() would refuse the save
  for (const double e : {nan, -0.1, 1.1})
    refused({.kind = JointKind::cable, .a = a, .b = b, .restitution = e}, "joint.restitution");
  refused({.a = a, .b = b, .restitution = 0.5}, "joint.restitution");
  for (const double k : {nan, -1.0, kInfinity}) {
    refused({.kind = JointKind::spring, .a = a, .b = b, .stiffness = k}, "joint.stiffness");
    refused({.kind = JointKind::spring, .a = a, .b = b, .damping = k}, "joint.damping");
  }
  EXPECT_EQ(world.joint_counts().joints, 0u);
  for (int i = 0; i < 64; ++i) join(world, {.a = a, .b = b});
  refused({.a = a, .point = {0, 1, 0}}, "joint.a");
  EXPECT_FALSE(world.remove_joint({}));
  EXPECT_FALSE(world.remove_joint({65, 1}));
}

TEST(JointDoors, ids_tell_joints_that_are_gone) {
  World world = World::create(falling()).value();
  const ProjectileId a = put(world, mass_of(1), bob(), {0, -1, 0});
  const JointId first = join(world, {.a = a});
  ASSERT_NE(world.joint(first), nullptr);
  EXPECT_EQ(world.joint(first)->length, 1);
  EXPECT_TRUE(world.remove_joint(first));
  EXPECT_FALSE(world.remove_joint(first));
  const JointId second = join(world, {.kind = JointKind::cable, .a = a, .length = 2});
  EXPECT_EQ(second.index, first.index);
  EXPECT_NE(second, first);
  EXPECT_EQ(world.joint(first), nullptr);
  EXPECT_EQ(world.joints(), std::vector<JointId>{second});
  EXPECT_EQ(world.joint_state(first).length, 0);
  EXPECT_EQ(world.joint_state(second).length, 1);
}

TEST(JointDoors, a_joint_ends_with_its_projectile_and_is_told) {
  WorldDef def = falling();
  def.ground.mode = GroundMode::land;
  def.ground.height = -10;
  World world = World::create(def).value();
  const ProjectileId a = put(world, mass_of(1), bob(), {0, 0, 0}), b = put(world, mass_of(1), bob(), {1, 0, 0});
  BodyDef old = bob();
  old.despawn.older = 0.1;
  const ProjectileId dies = put(world, mass_of(1), old, {2, 0, 0});
  const JointId ab = join(world, {.a = a, .b = b}), bd = join(world, {.a = dies, .b = b});
  const JointId point = join(world, {.a = a, .point = {0, 1, 0}});
  std::vector<JointEvent> told;
  for (int i = 0; i < 12; ++i) {
    world.step(1.0 / 60);
    for (const JointEvent& e : world.joint_events()) told.push_back(e);
  }
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].kind, JointEventKind::ended);
  EXPECT_EQ(told[0].joint, bd);
  EXPECT_EQ(told[0].projectile, dies);
  EXPECT_NE(world.joint(ab), nullptr);
  world.forget_events();
  ASSERT_TRUE(world[a].despawn());
  ASSERT_EQ(world.joint_events().size(), 2u);
  EXPECT_EQ(world.joint_events()[0].joint, ab);
  EXPECT_EQ(world.joint_events()[1].joint, point);
  EXPECT_TRUE(world.joints().empty());
  for (int i = 0; i < 600 && world[b].is_alive(); ++i) world.step(1.0 / 60);
  EXPECT_EQ(world[b].status(), LifeStatus::landed);
  // clear() takes them along.
  const ProjectileId c = put(world, mass_of(1), bob(), {0, 0, 0}), d = put(world, mass_of(1), bob(), {1, 0, 0});
  join(world, {.a = c, .b = d});
  world.clear();
  EXPECT_EQ(world.joint_counts().joints, 0u);
}

TEST(JointDoors, kinematic_and_pending_ends_stand_still) {
  World world = World::create(falling()).value();
  BodyDef held = bob();
  held.kinematic = true;
  const ProjectileId hand = put(world, mass_of(1), held, {0, 0, 0}), ball = put(world, mass_of(1), bob(), {0, -1, 0});
  join(world, {.a = hand, .b = ball});
  const auto later = must(world.spawn(mass_of(1), {.position = {5, 0, 0}, .velocity = Vec3d{}}, bob(), 0.5));
  const ProjectileId swings = put(world, mass_of(1), bob(), {5, -1, 0});
  join(world, {.a = later, .b = swings});
  for (int i = 0; i < 29; ++i) world.step(1.0 / 60);
  EXPECT_EQ(world[hand].position(), Vec3d{});
  EXPECT_TRUE(near(world[ball].position(), {0, -1, 0}, 0, 1e-12));
  EXPECT_TRUE(near(world[swings].position(), {5, -1, 0}, 0, 1e-12));
  for (int i = 0; i < 60; ++i) world.step(1.0 / 60);
  EXPECT_LT(world[later].position().y, -1);  // both fall now
  EXPECT_TRUE(near(world[later].position() - world[swings].position(), {0, 1, 0}, 0, 1e-9));
  ASSERT_TRUE(world[hand].set_position({0.5, 0, 0}));
  world.step(1.0 / 60);
  EXPECT_TRUE(near(length(world[ball].position() - world[hand].position()), 1, 1e-9));
}

TEST(JointDoors, a_net_sleeps_and_wakes_as_a_whole) {
  World world = World::create(falling()).value();
  BodyDef sleeper{.sleep_time = 0.3};
  std::vector<ProjectileId> links;
  for (int i = 1; i <= 5; ++i) {
    links.push_back(put(world, mass_of(1), sleeper, {0, -1.0 * i, 0}));
    join(world, {.kind = JointKind::cable, .a = links.back(), .b = i > 1 ? links[links.size() - 2] : ProjectileId{}});
  }
  const auto asleep = [&] {
    return std::ranges::count_if(links, [&](ProjectileId id) { return world[id].is_asleep(); });
  };
  for (int i = 0; i < 60; ++i) world.step(1.0 / 60);
  EXPECT_EQ(asleep(), 5);
  EXPECT_TRUE(near(world[links[4]].position(), {0, -5, 0}, 0, 1e-12));
  ASSERT_TRUE(world[links[4]].apply_impulse({1, 0, 0}));
  world.step(1.0 / 60);
  EXPECT_EQ(asleep(), 0);
  // Who sleeps by a call wakes with the others.
  ASSERT_TRUE(world[links[0]].sleep());
  world.step(1.0 / 60);
  EXPECT_EQ(asleep(), 0);
  // What loses its hold falls.
  World other = World::create(falling()).value();
  const ProjectileId ball = put(other, mass_of(1), sleeper, {0, -1, 0});
  const JointId rod = join(other, {.a = ball});
  for (int i = 0; i < 60; ++i) other.step(1.0 / 60);
  ASSERT_TRUE(other[ball].is_asleep());
  ASSERT_TRUE(other.remove_joint(rod));
  other.step(1.0 / 60);
  EXPECT_LT(other[ball].velocity().y, -0.1);
}

/// A net of all kinds of joints, with slack cables, that falls on a bouncing ground and meets others.
World net(Precision precision = Precision::float64) {
  WorldDef def = falling();
  def.ground = {GroundMode::bounce, -3, 0.8, 0.5};
  World world = World::create(def).value();
  std::mt19937 random(5);
  const auto real = [&] { return static_cast<double>(random() % 1000) / 500 - 1; };
  std::vector<ProjectileId> all;
  for (int i = 0; i < 40; ++i) {
    BodyDef body = test_pairs::ball(0.1, 0.6, 0.2);
    body.gravity_scale = 1;
    all.push_back(
        put(world, mass_of(0.5 + i % 3, precision), body, {real() * 3, real(), real() * 3}, {real(), real(), 0}));
  }
  for (std::size_t i = 0; i < 60; ++i) {
    Joint joint{.kind = static_cast<JointKind>(i % 3), .a = all[random() % 40], .b = all[random() % 40]};
    if (joint.kind == JointKind::cable) joint.restitution = 0.3, joint.length = 3;
    if (joint.kind == JointKind::spring) joint.stiffness = 40, joint.damping = 0.1;
    if (joint.a != joint.b) world.add_joint(joint);
  }
  return world;
}

TEST(JointDoors, snapshots_and_saves_go_on_to_the_bit) {
  for (const Precision precision : {Precision::float64, Precision::float32}) {
    World world = net(precision);
    for (int i = 0; i < 50; ++i) world.step(1.0 / 60);
    auto loaded = reloaded(world);
    EXPECT_EQ(loaded.hash(), world.hash());
    EXPECT_EQ(loaded.joints(), world.joints());
    const Snapshot then = world.snapshot();
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 50; ++i) {
      world.step(1.0 / 60);
      loaded.step(1.0 / 60);
      hashes.push_back(world.hash());
      ASSERT_EQ(loaded.hash(), hashes.back()) << i;
    }
    ASSERT_TRUE(world.remove_joint(world.joints()[3]));
    EXPECT_NE(world.hash(), hashes.back());
    ASSERT_TRUE(world.restore(then));
    for (int i = 0; i < 50; ++i) {
      world.step(1.0 / 60);
      ASSERT_EQ(world.hash(), hashes[static_cast<std::size_t>(i)]);
    }
    // Ids go on the same way, too.
    ASSERT_TRUE(world.remove_joint(world.joints()[3]));
    ASSERT_TRUE(loaded.remove_joint(loaded.joints()[3]));
    const Joint again{.a = world.ids()[1], .point = {0, 9, 0}};
    EXPECT_EQ(*world.add_joint(again), *loaded.add_joint(again));
    EXPECT_EQ(world.hash(), loaded.hash());
  }
}

TEST(JointDoors, damaged_saves_are_refused_or_sound) {
  World world = net();
  world.step(1.0 / 60);
  auto saved = *world.save();
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    auto bad = saved;
    bad[20 + random() % (bad.size() - 20)] ^= std::byte{static_cast<unsigned char>(1 + random() % 255)};
    EXPECT_FALSE(World::load(bad));
  }
}

TEST(JointDoors, kernels_and_threads_change_no_bit) {
  std::vector<std::uint64_t> hashes;
  for (const char* kernel : {"scalar", "base"})
    for (const unsigned threads : {1u, 3u}) {
      ASSERT_TRUE(use_kernel(kernel));
      World source = net();
      World world = *World::load(*source.save(), {.threading = {threads, 4}});
      for (int i = 0; i < 60; ++i) world.step(1.0 / 60);
      hashes.push_back(world.hash());
    }
  use_kernel("");
  EXPECT_EQ(std::ranges::count(hashes, hashes[0]), 4);
}

TEST(JointDoors, recordings_hold_joints) {
  WorldDef def = falling();
  World world = World::create(def).value();
  std::vector<std::byte> bytes;
  ASSERT_TRUE(world.record(record_into(bytes)));
  const ProjectileId a = put(world, mass_of(1), bob(), {0, -1, 0}), b = put(world, mass_of(2), bob(), {1, -1, 0});
  const JointId rod = join(world, {.a = a});
  join(world, {.kind = JointKind::spring, .a = a, .b = b, .stiffness = 30, .damping = 1});
  const JointId cable = join(world, {.kind = JointKind::cable, .a = b, .length = 3, .restitution = 0.5});
  for (int i = 0; i < 120; ++i) world.step(1.0 / 60);
  EXPECT_FALSE(world.add_joint({.a = a, .b = a}));
  ASSERT_TRUE(world.remove_joint(rod));
  world.advance(0.5);
  ASSERT_TRUE(world.remove_joint(cable));
  for (int i = 0; i < 30; ++i) world.step(1.0 / 60);
  replayed(world, bytes);
}

TEST(JointDoors, random_sessions_with_joints_agree_with_their_replay_and_their_save) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    World world = make_world(test::session_world());
    std::vector<std::byte> bytes;
    ASSERT_TRUE(world.record(record_into(bytes)));
    test::RandomSession session(world, seed);
    std::mt19937 random(seed);
    for (int i = 0; i < 1500; ++i) {
      session.act();
      if (random() % 4 != 0) continue;
      const std::vector<ProjectileId> ids = world.ids();
      const std::vector<JointId> joints = world.joints();
      if (!joints.empty() && random() % 6 == 0) static_cast<void>(world.remove_joint(joints[random() % joints.size()]));
      if (ids.empty()) continue;
      if (!joints.empty() && random() % 6 == 0) {
        const auto some = [&] { return random() % 9 - 4.0; };
        static_cast<void>(world.move_joint(joints[random() % joints.size()], {{some(), 5, some()}, {some(), 0, 0}}));
      }
      Joint joint{.kind = static_cast<JointKind>(random() % 5), .a = ids[random() % ids.size()]};
      if (random() % 4 != 0) joint.b = ids[random() % ids.size()];
      if (random() % 2 == 0) joint.length = 0.1 + random() % 20;
      if (joint.kind == JointKind::cable) joint.restitution = random() % 5 / 4.0;
      joint.stiffness = random() % 1000;
      joint.damping = random() % 5;
      if (random() % 8 == 0) joint.break_force = 1 + random() % 1000;
      if (joint.kind == JointKind::hinge) joint.low_angle = -1.0 - random() % 2;
      if (joint.kind == JointKind::slider) joint.length = {}, joint.high = random() % 30;
      if (joint.kind >= JointKind::hinge) joint.axis = {1.0 + random() % 3, random() % 3 - 1.0, 0};
      if (!joint.b && random() % 2 == 0) joint.velocity = {random() % 3 - 1.0, 0, 0.5};
      static_cast<void>(world.add_joint(joint));
    }
    EXPECT_GT(world.joint_counts().joints, 0u);
    const auto saved = must(world.save());
    ASSERT_TRUE(world.stop_recording());
    ReplayOptions options;
    options.custom_forces.assign(1000, {[](const ForceBatch& b) {
                                   for (std::size_t i = 0; i < b.id.size(); ++i) b.force[i].y += b.mass[i] * 3;
                                 }});
    const auto report = must(replay(bytes, options));
    EXPECT_FALSE(report.difference) << report.difference->what << " in " << report.difference->call;
    auto loaded = must(World::load(saved, options));
    EXPECT_EQ(loaded.hash(), world.hash());
    for (int i = 0; i < 30; ++i) world.step(1.0 / 60), loaded.step(1.0 / 60);
    EXPECT_EQ(loaded.hash(), world.hash());
  }
}

TEST(JointDoors, a_world_without_joints_has_the_hash_it_had) {
  World world = World::create(falling()).value(), other = World::create(falling()).value();
  for (World* w : {&world, &other}) put(*w, mass_of(1), bob(), {0, 0, 0});
  EXPECT_EQ(world.hash(), other.hash());
  const JointId id = join(other, {.a = other.ids()[0], .point = {0, 1, 0}});
  EXPECT_NE(world.hash(), other.hash());
  ASSERT_TRUE(other.remove_joint(id));
  EXPECT_NE(world.hash(), other.hash());  // the next id will be another one
}

}  // namespace physim::world_joints_doors_test
