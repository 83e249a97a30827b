// Many projectiles at once are treated like each by itself: large worlds, and calls for many.
#include <gtest/gtest.h>

#include "physim/world.hpp"

namespace physim::world_world_size_test {

WorldDef small_def() { return {.ground = {.mode = GroundMode::land}, .threading = {.threads = 1}}; }

ProjectileDef ball(const Fidelity& fidelity) {
  return {.mass = 0.01, .diameter = 0.008, .drag = {.damping = 0.9, .k1 = 0.0001, .k2 = 0.00001}, .fidelity = fidelity};
}

Launch launch(std::size_t i) {
  const double part = 0.001 * static_cast<double>(i % 1000);
  Launch l;
  l.position = {static_cast<double>(i % 300), 0.05, 1};
  l.velocity = Vec3d{100 + 20 * part, i % 16 == 0 ? -1.0 : 3 + part, part};  // one in 16 lands at once
  return l;
}

std::vector<Launch> launches(std::size_t count, std::size_t stride) {
  std::vector<Launch> list;
  for (std::size_t i = 0; i < count; i += stride) list.push_back(launch(i));
  return list;
}

Fidelity without_drag() {
  Fidelity f = Fidelity::game();
  f.drag = DragModel::off;
  return f;
}

/// Steps that do not fit into the caches are stored in another way: no number may change.
TEST(WorldSize, large_worlds_give_the_numbers_of_small_ones) {
  constexpr std::size_t kCount = 560000;
  constexpr std::size_t kStride = 1001;
  World large = std::move(World::create(small_def()).value());
  World small = std::move(World::create(small_def()).value());
  std::vector<ProjectileId> ids(kCount);
  ASSERT_EQ(large.spawn(*large.add_kind(ball(Fidelity::game())), launches(kCount, 1), ids), kCount);
  std::vector<ProjectileId> few(launches(kCount, kStride).size());
  small.spawn(*small.add_kind(ball(Fidelity::game())), launches(kCount, kStride), few);
  std::size_t landed = 0;
  for (int step = 0; step < 4; ++step) {
    large.step(1.0 / 60);
    small.step(1.0 / 60);
    landed += small.events().size();
  }
  EXPECT_GT(landed, few.size() / 20);
  for (std::size_t i = 0; i < few.size(); ++i) {
    const ProjectileId id = ids[i * kStride];
    ASSERT_EQ(large[id].status(), small[few[i]].status()) << i;
    ASSERT_EQ(large[id].state(), small[few[i]].state()) << i;
    ASSERT_EQ(large[id].previous_position(), small[few[i]].previous_position()) << i;
  }
}

TEST(WorldSize, calls_for_many_do_what_calls_for_each_do) {
  constexpr std::size_t kCount = 1000;
  World many = std::move(World::create(small_def()).value());
  World each = std::move(World::create(small_def()).value());
  const std::vector<Launch> shots = launches(kCount, 1);
  std::vector<ProjectileId> ids(2 * kCount);
  for (const Fidelity& f : {Fidelity::game(), Fidelity::constant_air()}) {
    const std::size_t first = f == Fidelity::game() ? 0 : kCount;
    const KindId kind = *each.add_kind(ball(f));
    many.spawn(*many.add_kind(ball(f)), shots, std::span(ids).subspan(first, kCount));
    for (std::size_t i = 0; i < kCount; ++i) EXPECT_EQ(*each.spawn(kind, shots[i]), ids[first + i]);
  }
  const auto compare = [&] {
    many.step(1.0 / 240);
    each.step(1.0 / 240);
    ASSERT_EQ(many.size(), each.size());
    for (const ProjectileId id : ids) {
      ASSERT_EQ(many[id].status(), each[id].status());
      ASSERT_EQ(many[id].state(), each[id].state());
      ASSERT_EQ(many[id].fidelity_in_use().fidelity, each[id].fidelity_in_use().fidelity);
    }
  };
  std::vector<ProjectileId> some;  // of both kinds in turns, some of them twice
  for (std::size_t i = 0; i < kCount; i += 3) some.insert(some.end(), {ids[i], ids[2 * kCount - 1 - i], ids[i / 2]});
  compare();
  std::size_t moved = 0;
  for (const ProjectileId id : some) moved += each[id].set_fidelity(without_drag()) ? 1u : 0u;
  EXPECT_EQ(many.set_fidelity(some, without_drag()), moved);
  compare();
  std::size_t gone = 0;
  for (const ProjectileId id : some) gone += each[id].despawn() ? 1u : 0u;
  EXPECT_EQ(many.despawn(some), gone);
  EXPECT_LT(gone, some.size());
  compare();
  EXPECT_EQ(many.set_fidelity(some, Fidelity::game()), 0u);  // they are gone
}

}  // namespace physim::world_world_size_test
