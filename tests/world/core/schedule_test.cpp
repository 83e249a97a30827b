// What is due for projectiles, taken in order of time and index whatever lies near or far, beside a plain sort.
#include "world/core/schedule.hpp"

#include <gtest/gtest.h>

#include <random>
#include <tuple>

namespace physim::world_schedule_test {

std::tuple<double, std::uint32_t> key(const Due& due) { return {due.time, due.id.index}; }

ProjectileId come_alive(SlotTable& slots) {
  const std::uint32_t index = slots.take();
  slots.come_alive(index, 0);
  return slots.id_of(index);
}

/// Takes what is due by now, and checks it against a sort of all that waits.
void take_all(Schedule& schedule, const SlotTable& slots, double now, std::vector<Due>& waiting) {
  std::ranges::sort(waiting, {}, key);
  std::size_t taken = 0;
  while (const auto due = schedule.take(now, slots)) {
    ASSERT_LT(taken, waiting.size());
    ASSERT_EQ(key(*due), key(waiting[taken]));
    ++taken;
  }
  waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(taken));
  ASSERT_TRUE(waiting.empty() || waiting.front().time > now);
}

TEST(Schedule, TakesInOrderOfTimeAndIndex) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0, 1);
  for (const double span : {0.01, 1.0, 300.0, 1e12}) {
    SlotTable slots;
    Schedule schedule;
    std::vector<Due> waiting;
    for (double now = 0; now < 0.5; now += 0.01 * part(random)) {
      for (int i = 0; i < 40; ++i) {
        // Some at one time, some that are due already.
        const double time = i % 4 == 0 ? now + span / 2 : now + span * part(random) - 0.005;
        const Due due{time, come_alive(slots)};
        schedule.add(due.time, due.id);
        waiting.push_back(due);
      }
      take_all(schedule, slots, now, waiting);
      ASSERT_EQ(schedule.all().size(), waiting.size());
    }
    take_all(schedule, slots, 1e300, waiting);
    EXPECT_TRUE(waiting.empty());
  }
}

/// What is saved says nothing of how it came there, and a copy goes its own way.
TEST(Schedule, IsSavedInOrderWhateverBecameOfIt) {
  SlotTable slots;
  Schedule lived;
  for (int i = 0; i < 500; ++i) lived.add(0.01 * ((7 * i) % 500), come_alive(slots));
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(lived.take(1.5, slots));
  for (int i = 0; i < 20; ++i) lived.add(i % 2 == 0 ? 1.2 : 3.0, come_alive(slots));
  const auto keys_of = [](const Schedule& schedule) {
    std::vector<std::tuple<double, std::uint32_t>> keys;
    for (const Due& due : schedule.in_order()) keys.push_back(key(due));
    return keys;
  };
  Schedule loaded;
  for (const Due& due : lived.in_order()) loaded.add(due.time, due.id);
  EXPECT_EQ(keys_of(loaded), keys_of(lived));
  const auto before = keys_of(loaded);
  Schedule copy = loaded;
  copy.add(9, come_alive(slots)), copy.add(9, come_alive(slots));
  EXPECT_EQ(keys_of(loaded), before);
  EXPECT_EQ(copy.all().size(), before.size() + 2);
}

TEST(Schedule, TakesManyThatCameForSoonInOrder) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> part(0, 1);
  SlotTable slots;
  Schedule schedule;
  std::vector<Due> waiting;
  for (const int count : {20, 500, 3, 2000, 40}) {
    take_all(schedule, slots, 1e-3, waiting);  // what comes next is due in a part that is reached
    for (int i = 0; i < count; ++i) {
      waiting.push_back({0.015 * part(random), come_alive(slots)});
      schedule.add(waiting.back().time, waiting.back().id);
    }
    take_all(schedule, slots, 0.01 * part(random), waiting);
    ASSERT_EQ(schedule.all().size(), waiting.size());
  }
  take_all(schedule, slots, 1, waiting);
  EXPECT_TRUE(waiting.empty());
}

TEST(Schedule, HoldsTimesBeyondAllParts) {
  SlotTable slots;
  Schedule schedule;
  std::vector<Due> waiting;
  for (const double time : {1e300, -1e300, 1e15, 2e15, 0.0}) {
    waiting.push_back({time, come_alive(slots)});
    schedule.add(time, waiting.back().id);
  }
  take_all(schedule, slots, 1.5e15, waiting);
  EXPECT_EQ(waiting.size(), 2u);
  take_all(schedule, slots, 1e301, waiting);
  EXPECT_TRUE(waiting.empty());
}

TEST(Schedule, PassesOverThoseThatAreGone) {
  SlotTable slots;
  Schedule schedule;
  const ProjectileId gone = come_alive(slots), there = come_alive(slots);
  schedule.add(1, gone);
  schedule.add(2, there);
  slots.release(gone.index, LifeStatus::retired);
  EXPECT_FALSE(schedule.take(1.5, slots));
  EXPECT_EQ(schedule.take_due(2, slots), there);
  EXPECT_FALSE(schedule.take(1e9, slots));
}

}  // namespace physim::world_schedule_test
