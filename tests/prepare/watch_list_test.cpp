// The watch list: what is looked for in flights and in worlds.
#include "prepare/watch_list.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "prepare/conditions.hpp"

namespace physim::prepare_watch_list_test {

std::vector<EventKind> kinds_of(const WatchList& watch) {
  std::vector<EventKind> kinds;
  for (int i = 0; i < watch.count; ++i) kinds.push_back(watch.item[i].spec.kind);
  return kinds;
}

Conditions<double> constant_air() {
  return prepare_conditions({.atmosphere = {.model = AirModel::constant}}, by_steps(Fidelity::game(), true));
}

Until unguarded() { return {.ground = {}, .time = std::numeric_limits<double>::infinity()}; }

TEST(WatchList, a_flight_is_guarded_by_ground_range_and_time) {
  const WatchList watch = prepare_watch({.ground = 3, .time = 9, .range = 100}, constant_air(), Watcher::batch);
  EXPECT_EQ(kinds_of(watch), (std::vector{EventKind::ground, EventKind::range, EventKind::time}));
  for (int i = 0; i < watch.count; ++i) EXPECT_TRUE(watch.item[i].spec.terminal);
  EXPECT_EQ(watch.item[0].spec.value, 3);
}

TEST(WatchList, motors_and_rails_are_watched_where_there_are_some) {
  Conditions<double> c = constant_air();
  EXPECT_EQ(kinds_of(prepare_watch(unguarded(), c, Watcher::flight)), std::vector{EventKind::apex});
  EXPECT_EQ(kinds_of(prepare_watch(unguarded(), c, Watcher::world_with_apexes)), std::vector{EventKind::apex});
  c.has_motor = true;
  c.has_rail = true;
  EXPECT_EQ(kinds_of(prepare_watch(unguarded(), c, Watcher::world)),
            (std::vector{EventKind::ignition, EventKind::burnout, EventKind::rail_exit}));
  EXPECT_TRUE(kinds_of(prepare_watch(unguarded(), c, Watcher::batch)).empty());
}

TEST(WatchList, what_waits_for_no_value_waits_for_zero) {
  Until until = unguarded();
  until.events = {{.kind = EventKind::apex, .value = 7},
                  {.kind = EventKind::height, .value = 7},
                  {.kind = EventKind::burnout, .value = 7}};
  const WatchList watch = prepare_watch(until, constant_air(), Watcher::batch);
  ASSERT_EQ(kinds_of(watch), (std::vector{EventKind::apex, EventKind::height}));  // without a motor nothing burns out
  EXPECT_EQ(watch.item[0].spec.value, 0);
  EXPECT_EQ(watch.item[1].spec.value, 7);
}

}  // namespace physim::prepare_watch_list_test
