// What worlds tell: to many readers at once, of many projectiles, and in words where they refuse.
#include <set>
#include <thread>
#include <unordered_map>

#include "world/world_support.hpp"

namespace physim::world_reading_test {

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

/// Each that is alive once, with the numbers that it tells itself.
void expect_columns(const World& world) {
  std::vector<WorldColumns> all(3);
  world.columns(all);
  std::set<ProjectileId> found;
  for (const WorldColumns& columns : all)
    std::visit(
        [&](const auto& c) {
          const auto at = [](const auto& column, std::size_t i) {
            return Vec3d{double(column[0][i]), double(column[1][i]), double(column[2][i])};
          };
          for (std::size_t i = 0; i < c.index.size(); ++i) {
            const ProjectileId id = world.id_at(c.index[i]);
            ASSERT_TRUE(id);
            EXPECT_TRUE(found.insert(id).second);
            EXPECT_EQ(at(c.position, i), world[id].position());
            EXPECT_EQ(at(c.previous, i), world[id].previous_position());
            EXPECT_EQ(at(c.velocity, i), world[id].velocity());
          }
        },
        columns);
  EXPECT_EQ(found.size(), world.size());
}

TEST(Reading, columns_are_what_each_tells_itself) {
  World world;
  std::vector<ProjectileId> ids;
  for (const Fidelity& fidelity : {Fidelity::arcade(), Fidelity::game(), Fidelity::constant_air()})
    for (const Precision precision : {Precision::float32, Precision::float64})
      for (int i = 0; i < 70; ++i) {
        ProjectileDef p = stone();
        p.fidelity = fidelity;
        p.fidelity.precision = precision;
        Launch launch{.position = {0.1 * i, 50, 0}, .velocity = Vec3d{5, 9, 0.3 * i}};
        ids.push_back(*world.spawn(p, launch, {}, i % 9 == 0 ? 0.4 : 0));
      }
  expect_columns(world);
  for (int i = 0; i < 120; ++i) {
    world.step(1.0 / 60);
    if (i % 10 == 0) world[ids[static_cast<std::size_t>(i)]].despawn();
    if (i % 10 == 5) world[ids[static_cast<std::size_t>(i)]].set_kinematic(true);
    if (i % 7 == 0) expect_columns(world);
  }
  EXPECT_EQ(world.id_at(0), ProjectileId{});
  EXPECT_EQ(world.id_at(ids[0].index), ProjectileId{}) << "it is gone";
  EXPECT_EQ(world.id_at(1'000'000), ProjectileId{});
}

TEST(Reading, columns_may_be_read_by_several_threads) {
  World world = World::create({.ground = {.mode = GroundMode::none}}).value();
  ProjectileDef p = stone();
  p.fidelity = Fidelity::arcade();
  for (int i = 0; i < 2000; ++i) EXPECT_TRUE(world.spawn(p, {.position = {0.1 * i, 900, 0}, .speed = 10}));
  for (int i = 0; i < 100; ++i) world.step(1.0 / 60);
  std::vector<std::thread> readers;
  for (int i = 0; i < 6; ++i) readers.emplace_back([&world] { expect_columns(world); });
  for (std::thread& reader : readers) reader.join();
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
  const auto made = World::create({.step = 1e-30});
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

}  // namespace physim::world_reading_test
