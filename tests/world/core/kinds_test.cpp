// Kinds: those that nobody uses are let go, whatever snapshots, forces and recordings need of them stays.
#include "world/core/kinds.hpp"

#include "world/world_support.hpp"

namespace physim::world_kinds_test {

ProjectileDef stone_of(double mass) {
  ProjectileDef p = stone();
  p.mass = mass;
  return p;
}

TEST(Kinds, definitions_that_nobody_uses_are_let_go) {
  World world;
  std::size_t early = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto id = must(world.spawn(stone_of(1 + i * 1e-5), {.position = {0, 9, 0}}));
    EXPECT_EQ(world[id].mass(), 1 + i * 1e-5);
    ASSERT_TRUE(world[id].despawn());
    if (i % 100 == 0) world.forget_events();
    if (i == 2000) early = world.memory();
  }
  EXPECT_LT(world.memory(), early + 100'000);
  EXPECT_LT(world.memory(), 4u << 20);
}

TEST(Kinds, memory_tells_of_definitions_in_use) {
  World world;
  const std::size_t none = world.memory();
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(world.spawn(stone_of(1 + i * 1e-5), {.position = {0, 9, 0}}));
  const std::size_t each = (world.memory() - none) / 1000;
  EXPECT_GT(each, sizeof(Kind) + sizeof(Prepared));
  EXPECT_LT(each, 8000u);
  for (const ProjectileId id : world.ids()) EXPECT_GT(world[id].mass(), 0.99);
}

TEST(Kinds, one_that_add_kind_gave_stays) {
  World world;
  const KindId kept = *world.add_kind(stone_of(5));
  for (int i = 0; i < 3000; ++i) {
    const auto id = world.spawn(stone_of(1 + i * 1e-3), {.position = {0, 9, 0}});
    world[*id].despawn();
  }
  const auto id = must(world.spawn(kept, {.position = {0, 9, 0}}));
  EXPECT_EQ(world[id].mass(), 5);
  EXPECT_EQ(*world.add_kind(stone_of(5)), kept);
}

TEST(Kinds, the_number_of_a_forgotten_one_means_nothing) {
  World world;
  const ProjectileId first = *world.spawn(stone_of(7), {.position = {0, 9, 0}});
  const KindId kind = world[first].kind();
  EXPECT_TRUE(world.spawn(kind, {.position = {0, 9, 0}}));
  world.clear();
  EXPECT_TRUE(world.spawn(kind, {.position = {0, 9, 0}})) << "it is idle, and not forgotten";
  world.clear();
  for (std::size_t i = 0; i < 2 * kMostIdleKinds; ++i) {
    const auto id = world.spawn(stone_of(1 + static_cast<double>(i) * 1e-3), {.position = {0, 9, 0}});
    EXPECT_NE(world[*id].kind(), kind);
    world[*id].despawn();
  }
  EXPECT_FALSE(world.spawn(kind, {.position = {0, 9, 0}}));
  const ProjectileId again = *world.spawn(stone_of(7), {.position = {0, 9, 0}});
  EXPECT_NE(world[again].kind(), kind) << "no number is given twice";
  EXPECT_EQ(world[again].mass(), 7);
}

/// Spawns and takes out so many kinds that all idle ones are forgotten and let go.
void flood(World& world) {
  for (std::size_t i = 0; i < 4 * kMostIdleKinds; ++i)
    world[*world.spawn(stone_of(100 + static_cast<double>(i)), {.position = {0, 9, 0}})].despawn();
}

TEST(Kinds, one_that_is_idle_for_the_longest_is_not_let_go_as_it_is_spawned) {
  WorldDef def{.pools = {{"one", 1, WhenFull::replace_oldest}}};
  World world = make_world(def);
  for (int round = 0; round < 5; ++round)
    for (std::size_t i = 0; i <= kMostIdleKinds + 1; ++i) {  // the next one is always the one idle for the longest
      const auto id = must(world.spawn(stone_of(1 + static_cast<double>(i)), {.position = {0, 9, 0}}));
      ASSERT_EQ(world[id].mass(), 1 + static_cast<double>(i));
      ASSERT_TRUE(world.spawn(world[id].kind(), {.position = {0, 9, 0}}));
      ASSERT_FALSE(world.spawn(stone_of(1e9), {.position = {0, 9, 0}, .speed = -1}));
      ASSERT_TRUE(world.step(0.001));
    }
}

TEST(Kinds, a_snapshot_keeps_what_it_needs) {
  World world = make_world({.ground = {.mode = GroundMode::none}});
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(world.spawn(stone_of(1 + i), {.position = {0, 50, 0}}));
  const Snapshot then = world.snapshot();
  const std::uint64_t hash = world.hash();
  world.step(0.01);
  const std::uint64_t later = world.hash();
  for (int round = 0; round < 3; ++round) {
    world.clear();
    flood(world);
    ASSERT_TRUE(world.restore(then));
    EXPECT_EQ(world.hash(), hash);
    double sum = 0;
    for (const ProjectileId id : world.ids()) sum += world[id].mass();
    EXPECT_EQ(sum, 210);
    world.step(0.01);
    EXPECT_EQ(world.hash(), later);
  }
}

TEST(Kinds, snapshots_of_every_frame_keep_little) {
  World world;
  std::vector<Snapshot> last(8);
  std::size_t most = 0;
  for (std::size_t i = 0; i < 20'000; ++i) {
    const auto id = world.spawn(stone_of(1 + static_cast<double>(i) * 1e-5), {.position = {0, 9, 0}});
    last[i % last.size()] = world.snapshot();
    world[*id].despawn();
    if (i % 16 == 0) world.forget_events();
    most = std::max(most, world.memory());
  }
  EXPECT_LT(most, 4u << 20);
}

TEST(Kinds, a_force_finds_its_kind_by_number) {
  World world;
  flood(world);
  const KindId kind = *world.add_kind(stone_of(3));
  ASSERT_TRUE(world.add_force({.law = ConstantAcceleration{{2, 0, 0}}, .target = {{}, kind, 0}}));
  flood(world);
  const ProjectileId id = *world.spawn(kind, {.position = {0, 50, 0}});
  const ProjectileId other = *world.spawn(stone_of(4), {.position = {0, 50, 0}});
  world.step(0.01);
  EXPECT_NEAR(world[id].velocity().x, 0.02, 1e-12);
  EXPECT_EQ(world[other].velocity().x, 0);
}

TEST(Kinds, wind_zones_know_kinds_that_come_and_go) {
  World world;
  ASSERT_TRUE(world.add_force({.law = WindZone{.velocity = {0, 0, 20}, .low = {-9, -9, -9}, .high = {9, 99, 9}},
                               .target = ForceTarget::everything()}));
  ProjectileDef p = bullet();
  p.fidelity = Fidelity::constant_air();
  for (int i = 0; i < 3000; ++i) {
    p.mass = 0.01 * (1 + i % 1500 * 1e-3);
    const ProjectileId id = *world.spawn(p, {.position = {0, 50, 0}, .speed = 10});
    world.step(0.01);
    EXPECT_GT(world[id].velocity().z, 0);
    world[id].despawn();
  }
  EXPECT_LT(world.memory(), 8u << 20);
}

TEST(Kinds, recordings_replay_whatever_is_let_go) {
  std::vector<std::byte> bytes;
  World world;
  ASSERT_TRUE(world.record(record_into(bytes)));
  std::vector<Snapshot> held;
  for (int i = 0; i < 1500; ++i) {
    const ProjectileId id = *world.spawn(stone_of(1 + i), {.position = {0, 9, 0}});
    if (i % 100 == 3) held.push_back(world.snapshot());
    if (i % 300 == 7) {
      ASSERT_TRUE(world.restore(held[held.size() / 2]));
    }
    if (i % 7 == 0) {
      ASSERT_TRUE(world.add_kind(stone_of(0.5 + i)));
    }
    world[id].despawn();
    if (i % 50 == 0) world.step(0.01);
  }
  replayed(world, bytes);
}

}  // namespace physim::world_kinds_test
