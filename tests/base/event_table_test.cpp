// The table of events: names that are told apart, an order without doubt, and what the documentation says of them.
#include "base/event_table.hpp"

#include <set>

#include "cli/program.hpp"
#include "physim/names.hpp"

namespace physim::base_event_table_test {

TEST(EventTable, names_are_told_apart_and_read_back) {
  std::set<std::string_view> names;
  for (const EventRow& row : kEventTable) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(name(row.kind), row.name);
    EXPECT_EQ(value_of<EventKind>(row.name), row.kind);
  }
}

TEST(EventTable, events_of_one_moment_have_one_order_in_worlds) {
  std::set<int> orders;
  for (const EventRow& row : kEventTable)
    EXPECT_TRUE(row.in_worlds == InWorlds::never || orders.insert(row.order).second) << row.name;
}

TEST(EventTable, what_is_watched_may_be_asked_for_and_nothing_else) {
  EXPECT_TRUE(is_watchable(EventKind::rail_exit));
  EXPECT_FALSE(is_watchable(EventKind::spawned));
  for (const EventRow& row : kEventTable) {
    EXPECT_EQ(is_watchable(row.kind), row.watch != Watch::none) << row.name;
    EXPECT_FALSE(row.in_flights && row.watch == Watch::none) << row.name;
  }
}

TEST(EventTable, the_guide_to_worlds_names_all_that_worlds_tell) {
  const std::string page = testing_cli::read(PHYSIM_SOURCE_DIR "/docs/world.md");
  for (const EventRow& row : kEventTable) {
    if (row.in_worlds == InWorlds::never) continue;
    EXPECT_NE(page.find("`" + std::string(row.name) + "`"), std::string::npos) << row.name;
  }
}

}  // namespace physim::base_event_table_test
