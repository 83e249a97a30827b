// The parts of a world's state, each by itself: slots, pools, schedules, generators, the clock.
#include <gtest/gtest.h>

#include <deque>

#include "random_shots.hpp"
#include "world/core/clock.hpp"
#include "world/core/generators.hpp"
#include "world/core/pools.hpp"
#include "world/core/schedule.hpp"
#include "world/core/slots.hpp"

namespace physim::world_rooms_test {

std::uint32_t spawn(SlotTable& slots) {
  const std::uint32_t index = slots.take();
  slots.come_alive(index, 0);
  return index;
}

TEST(SlotTable, slots_are_used_again_in_the_order_they_became_free) {
  SlotTable slots;
  for (std::uint32_t i = 1; i <= 3; ++i) EXPECT_EQ(spawn(slots), i);
  slots.release(2, LifeStatus::landed);
  slots.release(1, LifeStatus::retired);
  EXPECT_EQ(slots.alive(), 1u);
  std::vector<std::uint32_t> free;
  slots.each_free([&](std::uint32_t index) { free.push_back(index); });
  EXPECT_EQ(free, (std::vector<std::uint32_t>{2, 1}));
  EXPECT_EQ(spawn(slots), 2u);
  EXPECT_EQ(spawn(slots), 1u);
  EXPECT_EQ(spawn(slots), 4u);
}

TEST(SlotTable, the_order_of_free_slots_holds_while_many_come_and_go) {
  SlotTable slots;
  std::deque<std::uint32_t> alive, free;
  test::Random r(5);
  for (int i = 0; i < 20000; ++i) {
    if (alive.empty() || r.one_in(2) || (i < 1000 && r.one_in(2))) {
      const std::uint32_t expected = free.empty() ? slots.size() : free.front();
      if (!free.empty()) free.pop_front();
      ASSERT_EQ(spawn(slots), expected);
      alive.push_back(expected);
    } else {
      const auto at = static_cast<std::size_t>(r.below(static_cast<int>(alive.size())));
      slots.release(alive[at], LifeStatus::expired);
      free.push_back(alive[at]);
      alive.erase(alive.begin() + static_cast<std::ptrdiff_t>(at));
    }
    if (i % 500 != 0) continue;
    std::deque<std::uint32_t> told;
    slots.each_free([&](std::uint32_t index) { told.push_back(index); });
    ASSERT_EQ(told, free);
  }
}

TEST(SlotTable, an_id_names_one_use_of_a_slot) {
  SlotTable slots;
  const std::uint32_t index = spawn(slots);
  const ProjectileId first = slots.id_of(index);
  EXPECT_NE(slots.find(first), nullptr);
  slots.release(index, LifeStatus::expired);
  EXPECT_EQ(slots.find(first), nullptr);
  EXPECT_EQ(slots[index].status(), LifeStatus::expired);
  spawn(slots);
  EXPECT_EQ(slots.find(first), nullptr);
  EXPECT_NE(slots.find(slots.id_of(index)), nullptr);
  EXPECT_EQ(slots.find({}), nullptr);
  EXPECT_EQ(slots.find({99, 1}), nullptr);
}

TEST(Pools, the_oldest_is_the_first_that_is_still_there) {
  Pools pools({{"few", 3, WhenFull::replace_oldest}, {"many", 2, WhenFull::refuse}});
  for (const std::uint32_t slot : {5u, 9u, 2u}) pools.join(0, slot);
  EXPECT_TRUE(pools.is_full(0));
  EXPECT_TRUE(pools.replaces(0));
  EXPECT_EQ(pools.oldest(0), 5u);
  pools.leave(0, 9);  // from the middle
  pools.leave(0, 5);
  EXPECT_EQ(pools.oldest(0), 2u);
  pools.join(0, 5);
  EXPECT_EQ(pools.oldest(0), 2u);
  EXPECT_FALSE(pools.is_full(0));
  EXPECT_FALSE(pools.replaces(1));
  pools.join(1, 1);
  pools.join(1, 3);
  EXPECT_TRUE(pools.is_full(1));
}

TEST(Schedule, who_is_due_comes_in_order_of_time_then_of_slots) {
  SlotTable slots;
  for (int i = 0; i < 4; ++i) spawn(slots);
  Schedule schedule;
  schedule.add(2, slots.id_of(3));
  schedule.add(1, slots.id_of(4));
  schedule.add(2, slots.id_of(2));
  schedule.add(1, slots.id_of(1));
  slots.release(4, LifeStatus::retired);  // whoever is gone is passed over
  EXPECT_FALSE(schedule.take_due(0.5, slots));
  EXPECT_EQ(schedule.take_due(2, slots), slots.id_of(1));
  EXPECT_EQ(schedule.take_due(2, slots), slots.id_of(2));
  EXPECT_EQ(schedule.take_due(2, slots), slots.id_of(3));
  EXPECT_FALSE(schedule.take_due(9, slots));
}

TEST(Generators, places_are_used_again_under_new_ids) {
  Generators generators;
  const ForceId first = generators.add({.law = GravityForce{}, .target = ForceTarget::everything()}, 2);
  const ForceId second = generators.add({.law = GravityForce{}, .target = ForceTarget::everything()}, 3);
  EXPECT_EQ(generators.order(), (std::vector<std::uint32_t>{first.index, second.index}));
  EXPECT_EQ(generators.find(second)->start, 3);
  generators.begin(first.index, true);
  EXPECT_EQ(generators.groups(), std::vector<std::uint32_t>{first.index});
  generators.erase(first.index);
  EXPECT_TRUE(generators.groups().empty());
  EXPECT_EQ(generators.find(first), nullptr);
  const ForceId third = generators.add({.law = GravityForce{}, .target = ForceTarget::everything()}, 4);
  EXPECT_EQ(third.index, first.index);
  EXPECT_NE(third, first);
  EXPECT_EQ(generators.order(), (std::vector<std::uint32_t>{second.index, third.index}));
}

TEST(Generators, count_by_how_many_a_slot_is_named) {
  Generators generators;
  generators.count(7, true);
  generators.count(7, true);
  generators.count(7, false);
  EXPECT_TRUE(generators.is_named(7));
  generators.count(7, false);
  EXPECT_FALSE(generators.is_named(7));
  generators.count(7, false);  // it was forgotten in between
  EXPECT_FALSE(generators.is_named(7));
}

TEST(Clock, time_is_counted_in_steps_of_one_length) {
  Clock clock;
  clock.dt = 0.1;
  for (int i = 0; i < 10; ++i) clock.tick();
  EXPECT_EQ(clock.time(), 10 * 0.1);
  clock.start_epoch();
  clock.start_run(0.25);
  clock.tick();
  EXPECT_EQ(clock.time(), 10 * 0.1 + 0.25);
  EXPECT_EQ(clock.now(), 1);
  EXPECT_EQ(clock.steps, 11u);
}

}  // namespace physim::world_rooms_test
