// What worlds tell: to many readers at once, of many projectiles, and in words where they refuse.
#include <set>
#include <thread>
#include <unordered_map>

#include "world/world_support.hpp"

namespace physim {
namespace {

TEST(Reading, many_may_read_at_once) {
  World world = volley(200);
  const std::uint64_t hash = world.hash();
  const World& read = world;
  std::vector<std::thread> readers;
  std::vector<int> same(4);
  for (int i = 0; i < 4; ++i)
    readers.emplace_back([&, i] {
      for (int k = 0; k < 20; ++k) same[static_cast<std::size_t>(i)] += read.snapshot() && read.hash() == hash ? 1 : 0;
    });
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(same, std::vector(4, 20));
}

TEST(Reading, ids_are_keys_and_have_an_order) {
  World world = volley(5);
  std::unordered_map<ProjectileId, int> by_hash;
  std::set<ProjectileId> sorted;
  std::vector<ProjectileId> ids{{7, 7}};
  world.ids(ids);
  EXPECT_EQ(ids, world.ids());
  for (const ProjectileId id : ids) ++by_hash[id], sorted.insert(id);
  EXPECT_EQ(by_hash.size(), 5u);
  EXPECT_TRUE(std::ranges::equal(sorted, ids));
  EXPECT_LT((ProjectileId{1, 9}), (ProjectileId{2, 1}));
  EXPECT_LT((ProjectileId{1, 1}), (ProjectileId{1, 2}));
  EXPECT_LT(KindId{1}, KindId{2});
  EXPECT_NE(std::hash<ForceId>()({1, 1}), std::hash<ForceId>()({1, 2}));
}

TEST(Reading, places_to_draw_are_read_for_many) {
  World world = volley(5);
  world.advance(1.5 / 60);
  std::vector<ProjectileId> ids = world.ids();
  ids.push_back({99, 1});
  std::vector<Vec3d> places(ids.size(), Vec3d{1, 1, 1});
  world.render_positions(ids, places);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(places[i], world[ids[i]].render_position());
}

TEST(Reading, a_force_tells_how_many_feel_it) {
  World world;
  ProjectileDef deaf = stone();
  deaf.fidelity = Fidelity::arcade();
  const ProjectileId a = *world.spawn(deaf, {.position = {0, 9, 0}});
  const ProjectileId b = *world.spawn(stone(), {.position = {0, 9, 0}});
  const ForceId on_one = *world[a].add_force(ConstantForce{{1, 0, 0}});
  const ForceId on_all = *world.add_force({.law = ConstantForce{}, .target = ForceTarget::everything()});
  EXPECT_EQ(world.felt_by(on_one), 0u);
  EXPECT_EQ(world.felt_by(on_all), 1u);
  EXPECT_TRUE(world[a].set_fidelity(Fidelity::game()));
  EXPECT_EQ(world.felt_by(on_one), 1u);
  EXPECT_EQ(world.felt_by(on_all), 2u);
  EXPECT_TRUE(world[b].set_kinematic(true));
  EXPECT_EQ(world.felt_by(on_all), 1u);
  EXPECT_EQ(world.felt_by({77, 1}), 0u);
}

TEST(Reading, a_step_that_is_too_long_is_told_the_limit) {
  World world;
  const Status status = world.step(1e6);
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("1e6"), std::string::npos);
  EXPECT_TRUE(world.step(999'999));
}

TEST(Reading, a_step_too_short_to_be_divided_is_refused) {
  World world;
  const Status status = world.step(1e-30);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().place, "dt");
  EXPECT_TRUE(world.step(1e-9));
  WorldDef def;
  def.step = 1e-30;
  const auto made = World::create(def);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().place, "world.step");
}

TEST(Reading, numbers_in_errors_are_short) {
  World world;
  ProjectileDef p = stone();
  p.mass = -(0.1 + 0.2);
  const auto refused = world.spawn(p, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "must be a positive number, not -0.3");
}

}  // namespace
}  // namespace physim
