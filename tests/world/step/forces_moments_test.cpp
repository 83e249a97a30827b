// Force generators of a crowded world: threads, kernels, snapshots and hashes; and numbers that are none.
#include "world/force_support.hpp"

namespace physim::world_forces_moments_test {

using test::kInfinity;
using test::kNan;
using test::near;

// --------------------------------------------------------------------------------------------------- moments
/// Everything at once: several integrators, precisions, springs, groups, a function, times.
World busy_world(unsigned threads, bool backwards, std::vector<ProjectileId>& ids) {
  WorldDef def = empty_space(true);
  def.ground.mode = GroundMode::bounce;
  def.threading = {threads, 8};
  World world = make(def);
  ids.assign(90, {});
  for (int n = 0; n < 90; ++n) {
    const int k = backwards ? 89 - n : n;
    const Precision p = k % 2 == 0 ? Precision::float32 : Precision::float64;
    const Launch launch = at({0.3 * k, 1 + 0.1 * (k % 7), 0.01 * k * k}, {0.1 * k, 2, -0.05 * k});
    ids[static_cast<std::size_t>(k)] = *world.spawn(
        ball(rung(test::kIntegrators[static_cast<std::size_t>(k) % std::size(test::kIntegrators)], p), 1 + 0.1 * k),
        launch);
  }
  for (unsigned k = 0; k + 7 < 90; k += 3) {
    Spring law{.other = ids[k + (k % 2 == 0 ? 7 : 5)], .stiffness = 2, .damping = 0.1};
    world[ids[k]].add_force(law);
  }
  ForceDef gust = force(LinearQuadraticDragForce{0.1, 0.02, {3, 0, 0}}, ForceTarget::everything());
  gust.delay = 0.3;
  gust.duration = 1.234;
  world.add_force(gust);
  world.add_force(force(CustomForce{[](const ForceBatch& b) {
                          for (std::size_t i = 0; i < b.force.size(); ++i) b.force[i] = b.position[i] * -0.01;
                        }},
                        ForceTarget::everything()));
  return world;
}

TEST(WorldForces, neither_threads_nor_the_order_of_coming_matter) {
  std::vector<ProjectileId> ids[3];
  World worlds[] = {busy_world(1, false, ids[0]), busy_world(7, false, ids[1]), busy_world(1, true, ids[2])};
  for (int k = 0; k < 200; ++k) {
    for (World& w : worlds) ASSERT_TRUE(w.step(1.0 / 60));
    ASSERT_EQ(worlds[0].hash(), worlds[1].hash()) << k;
    for (std::size_t i = 0; i < ids[0].size(); ++i)
      ASSERT_EQ(worlds[0][ids[0][i]].state(), worlds[2][ids[2][i]].state()) << k << " " << i;
  }
}

TEST(WorldForces, have_the_same_bits_with_every_kernel) {
  std::vector<std::uint64_t> hashes;
  for (const std::string& name : kernels()) {
    ASSERT_TRUE(use_kernel(name));
    std::vector<ProjectileId> ids;
    World world = busy_world(1, false, ids);
    steps(world, 100, 1.0 / 60);
    hashes.push_back(world.hash());
    EXPECT_EQ(hashes.back(), hashes.front()) << name;
  }
  use_kernel("");
}

TEST(WorldForces, go_on_from_a_snapshot_bit_for_bit) {
  std::vector<ProjectileId> ids;
  World world = busy_world(1, false, ids);
  steps(world, 30, 1.0 / 60);
  const Snapshot then = world.snapshot();
  const std::uint64_t hash = world.hash();
  std::vector<std::uint64_t> hashes;
  for (int k = 0; k < 100; ++k) world.step(1.0 / 60), hashes.push_back(world.hash());
  world[ids[3]].add_force(ConstantForce{{1, 2, 3}});
  world[ids[6]].despawn();
  steps(world, 10, 1.0 / 60);
  ASSERT_TRUE(world.restore(then));
  EXPECT_EQ(world.hash(), hash);
  for (const std::uint64_t expected : hashes) {
    world.step(1.0 / 60);
    ASSERT_EQ(world.hash(), expected);
  }
}

TEST(WorldForces, the_hash_knows_what_generators_will_do) {
  const auto hash_with = [](double duration, double size) {
    World world = make(empty_space());
    const ProjectileId id = *world.spawn(ball(rung(Integrator::rk4)), at({}));
    world[id].add_force(ConstantForce{{size, 0, 0}}, duration);
    return world.hash();
  };
  EXPECT_EQ(hash_with(1, 1), hash_with(1, 1));
  EXPECT_NE(hash_with(1, 1), hash_with(2, 1));
  EXPECT_NE(hash_with(1, 1), hash_with(1, 2));
}

// --------------------------------------------------------------------------------------------------- bad numbers
TEST(WorldForces, what_is_no_number_retires_only_whom_it_hits) {
  for (const Integrator i : test::kIntegrators) {
    for (const double bad : {kNan, kInfinity}) {
      World world = make(empty_space());
      std::vector<ProjectileId> ids;
      for (int k = 0; k < 20; ++k) ids.push_back(*world.spawn(ball(rung(i)), at({1.0 * k, 0, 0}, {0, 1, 0})));
      Spring law{.other = ids[8]};
      const ForceId to_bad = *world[ids[9]].add_force(law);
      law.other = ids[7];
      const ForceId from_bad = *world[ids[8]].add_force(law);
      world.add_force(force(CustomForce{[&](const ForceBatch& b) {
                              for (std::size_t k = 0; k < b.force.size(); ++k)
                                if (b.id[k] == ids[8]) b.force[k] = {0, bad, 0};
                            }},
                            ForceTarget::everything()));
      steps(world, 3, 0.1);
      EXPECT_EQ(world.size(), 19u) << test::text(i);
      EXPECT_EQ(world[ids[8]].status(), LifeStatus::retired);
      for (const ProjectileId id : world.ids()) EXPECT_TRUE(std::isfinite(length(world[id].position())));
      EXPECT_FALSE(world.is_active(to_bad));
      EXPECT_FALSE(world.is_active(from_bad));
      EXPECT_EQ(world.counters().retired, 1u);
    }
  }
}

TEST(WorldForces, refuse_what_makes_no_sense) {
  World world = make(empty_space());
  const ProjectileId a = *world.spawn(ball(rung(Integrator::rk4)), at({}));
  const ProjectileId b = *world.spawn(ball(rung(Integrator::rk4)), at({}));
  ASSERT_TRUE(world[b].despawn());
  const auto place_of = [&](const ForceDef& f) {
    const auto added = world.add_force(f);
    return added ? "it was added" : added.error().place;
  };
  EXPECT_EQ(place_of(force(ConstantForce{{kNan, 0, 0}}, {.ids = {a}, .kind = {}})), "force.force");
  EXPECT_EQ(place_of(force(ConstantForce{}, {})), "force.target");
  EXPECT_EQ(place_of(force(ConstantForce{}, {.ids = {a, b}, .kind = {}})), "force.target.ids[1]");
  EXPECT_EQ(place_of(force(ConstantForce{}, {.ids = {}, .kind = KindId{77}})), "force.target.kind");
  Spring law{.other = b};
  EXPECT_EQ(place_of(force(law, {.ids = {a}, .kind = {}})), "force.other");
  ForceDef timed = force(ConstantForce{}, {.ids = {a}, .kind = {}});
  timed.duration = -1;
  EXPECT_EQ(place_of(timed), "force.duration");
  timed.duration = 1;
  timed.delay = kInfinity;
  EXPECT_EQ(place_of(timed), "force.delay");
  EXPECT_FALSE(world.remove_force(ForceId{}));
  EXPECT_FALSE(world.remove_force(ForceId{5, 1}));
  EXPECT_EQ(world.force_count(), 0u);
  const ForceId f = *world[a].add_force(ConstantForce{});
  EXPECT_FALSE(world[b].remove_force(f));
  EXPECT_EQ(world.force_count(), 1u);
}

}  // namespace physim::world_forces_moments_test
