// The force at which a joint breaks, against closed forms.
#include "world/joints_support.hpp"

namespace physim::world_joints_break_test {

using namespace test_joints;
using test::near;

/// The events of a kind that a world tells until a time.
std::vector<JointEvent> events_until(World& world, double dt, double until, JointEventKind kind) {
  std::vector<JointEvent> all;
  while (world.time() < until - dt / 2) {
    world.step(dt);
    for (const JointEvent& e : world.joint_events())
      if (e.kind == kind) all.push_back(e);
  }
  return all;
}
std::vector<JointEvent> breaks_until(World& world, double dt, double until) {
  return events_until(world, dt, until, JointEventKind::broke);
}

TEST(JointBreak, a_pendulum_from_the_level_pulls_with_three_times_its_weight) {
  const double mass = 2, bottom = pendulum_period(1, kPi / 2) / 4;
  for (const double rate : {240.0, 1000.0, 4000.0})
    for (const double part : {2.99, 3.01}) {
      World world = World::create(falling()).value();
      const ProjectileId ball = put(world, mass_of(mass), bob(), {1, 0, 0});
      const JointId rod = join(world, {.a = ball, .break_force = part * mass * kGravity});
      const auto broken = breaks_until(world, 1 / rate, 5);
      ASSERT_EQ(broken.size(), part < 3 ? 1u : 0u) << rate;
      EXPECT_EQ(world.joint(rod) == nullptr, part < 3);
      if (part > 3) continue;
      // 3 m g cos(angle) is 2.99 m g at 0.0817 rad before the bottom, where it passes with (2 g / l)^(1/2).
      EXPECT_EQ(broken[0].joint, rod);
      EXPECT_EQ(broken[0].projectile, ball);
      EXPECT_TRUE(near(broken[0].time, bottom - std::acos(2.99 / 3) / std::sqrt(2 * kGravity), 0, 2 / rate));
    }
}

TEST(JointBreak, what_hangs_pulls_with_its_weight) {
  for (const JointKind kind : {JointKind::rod, JointKind::cable})
    for (const double part : {0.999999, 1.000001}) {
      World world = World::create(falling()).value();
      const ProjectileId ball = put(world, mass_of(3), bob(), {0, -2, 0});
      join(world, {.kind = kind, .a = ball, .break_force = part * 3 * kGravity});
      EXPECT_EQ(breaks_until(world, 1.0 / 60, 2).size(), part < 1 ? 1u : 0u);
      // It falls freely from the end of the first step on.
      const double falls = part < 1 ? world.time() - 1.0 / 60 : 0;
      EXPECT_TRUE(near(world[ball].velocity().y, -kGravity * falls, 1e-9, 1e-12));
    }
}

TEST(JointBreak, a_rod_breaks_when_it_pushes_too) {
  for (const double part : {0.999999, 1.000001}) {
    World world = World::create(falling()).value();
    const ProjectileId ball = put(world, mass_of(3), bob(), {0, 2, 0});
    join(world, {.a = ball, .break_force = part * 3 * kGravity});
    EXPECT_EQ(breaks_until(world, 1.0 / 60, 0.5).size(), part < 1 ? 1u : 0u);
  }
}

TEST(JointBreak, a_spring_breaks_at_its_stretch) {
  // Let go unstretched it swings about m g / k and pulls with m g (1 - cos(omega t)): 2 m g at most.
  const double mass = 2, k = 100, omega = std::sqrt(k / mass);
  for (const double part : {1.99, 2.01}) {
    World world = World::create(falling()).value();
    const ProjectileId ball = put(world, mass_of(mass), bob(), {0, -1, 0});
    const double dt = 1.0 / 2000, limit = part * mass * kGravity;
    join(world, {.kind = JointKind::spring, .a = ball, .length = 1, .stiffness = k, .break_force = limit});
    const auto broken = breaks_until(world, dt, 3);
    ASSERT_EQ(broken.size(), part < 2 ? 1u : 0u);
    for (const JointEvent& e : broken) EXPECT_TRUE(near(e.time, std::acos(1 - part) / omega, 0, 2 * dt));
  }
}

TEST(JointBreak, the_weakest_link_of_a_chain_breaks_and_what_it_held_falls) {
  World world = World::create(falling()).value();
  std::vector<ProjectileId> links;
  std::vector<JointId> joints;
  for (int i = 1; i <= 5; ++i) {
    links.push_back(put(world, mass_of(1), bob(), {0, -1.0 * i, 0}));
    // They carry 5, 4, 3, 2 and 1 weights; the third holds 2.5.
    joints.push_back(join(world, {.kind = JointKind::cable,
                                  .a = links.back(),
                                  .b = i > 1 ? links[links.size() - 2] : ProjectileId{},
                                  .break_force = (i == 3 ? 2.5 : 5.5) * kGravity}));
  }
  const auto broken = breaks_until(world, 1.0 / 120, 1);
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_EQ(broken[0].joint, joints[2]);
  EXPECT_TRUE(near(world[links[1]].position().y, -2, 1e-9));
  EXPECT_LT(world[links[2]].position().y, -7);
  EXPECT_TRUE(near(world.joint_state(joints[0]).tension, 2 * kGravity, 1e-6));
}

TEST(JointBreak, what_slept_falls_if_its_cable_breaks) {
  // A ball that sleeps on its cable gets heavier than that can hold.
  World world = World::create(falling()).value();
  const ProjectileId ball = put(world, mass_of(1), {.sleep_time = 0.3}, {0, -1, 0});
  join(world, {.kind = JointKind::cable, .a = ball, .break_force = 1.5 * kGravity});
  for (int i = 0; i < 60; ++i) world.step(1.0 / 60);
  ASSERT_TRUE(world[ball].is_asleep());
  ASSERT_TRUE(world[ball].set_mass(1.6));
  EXPECT_EQ(breaks_until(world, 1.0 / 60, world.time() + 0.1).size(), 1u);
  EXPECT_LT(world[ball].velocity().y, -0.5);
}

TEST(JointBreak, a_blow_counts_on_the_mean_of_its_step) {
  // A ball of 0.5 kg that falls for 0.8 m into a cable loses 0.5 kg times its speed in one step.
  const double impulse = 0.5 * std::sqrt(2 * kGravity * 0.8), dt = 1.0 / 500;
  for (const double part : {0.98, 1.02}) {
    World world = World::create(falling()).value();
    const ProjectileId ball = put(world, mass_of(0.5), bob(), {0, -0.4, 0});
    join(world, {.kind = JointKind::cable, .a = ball, .length = 1.2, .break_force = part * impulse / dt});
    EXPECT_EQ(breaks_until(world, dt, 1).size(), part < 1 ? 1u : 0u);
  }
}

TEST(JointBreak, it_is_kept_and_played_again_to_the_bit) {
  World world = World::create(falling()).value();
  std::vector<std::byte> recorded;
  ASSERT_TRUE(world.record(record_into(recorded)));
  const ProjectileId ball = put(world, mass_of(2), bob(), {1, 0, 0});
  const JointId rod = join(world, {.a = ball, .break_force = 2.9 * 2 * kGravity});
  for (int i = 0; i < 20; ++i) world.step(1.0 / 60);
  World loaded = reloaded(world);
  EXPECT_EQ(loaded.joint(rod)->break_force, 2.9 * 2 * kGravity);
  const Snapshot before = world.snapshot();
  EXPECT_EQ(breaks_until(world, 1.0 / 60, 1).size(), 1u);
  EXPECT_EQ(breaks_until(loaded, 1.0 / 60, 1).size(), 1u);
  EXPECT_EQ(world.hash(), loaded.hash());
  const std::uint64_t after = world.hash();
  ASSERT_TRUE(world.restore(before));
  EXPECT_EQ(breaks_until(world, 1.0 / 60, 1).size(), 1u);
  EXPECT_EQ(world.hash(), after);
  replayed(world, recorded);
}

TEST(JointBreak, bad_forces_are_refused_with_a_place) {
  World world = World::create(falling()).value();
  const ProjectileId ball = put(world, mass_of(2), bob(), {1, 0, 0});
  for (const double force : {test::kNan, -1.0, 0.0, kInfinity}) {
    const auto id = world.add_joint({.a = ball, .break_force = force});
    ASSERT_FALSE(id) << force;
    EXPECT_EQ(id.error().place, "joint.break_force");
  }
}

}  // namespace physim::world_joints_break_test
