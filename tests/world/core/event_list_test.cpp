// The list of what was told: in few bytes or whole, in order, and as it is read.
#include "world/core/event_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "random_shots.hpp"

namespace physim::world_event_list_test {

/// A plain one, or one that says more.
Event random_event(test::Random& r, std::uint32_t told) {
  Event e{.kind = r.one_in(2) ? EventKind::spawned : EventKind::expired,
          .reason = r.one_in(2) ? Reason::none : Reason::older};
  e.id = {static_cast<std::uint32_t>(1 + r.below(4)), told};
  e.value = static_cast<double>(r.below(5));
  e.time = r.one_in(2) ? 1 : r.in(0, 2);
  e.position = {r.in(-9, 9), 0.25, r.one_in(3) ? r.in(-9, 9) : 1e30};
  e.velocity = {r.in(-9, 9), -0.0, r.in(-9, 9)};
  if (r.one_in(4)) e.normal = {0, 1, 0}, e.energy = 3;
  return e;
}
void add(EventList& list, const Event& e) {
  if (e.energy != 0) return list.add(e);
  list.add({e.kind, e.reason, e.id, static_cast<std::uint32_t>(e.value), e.time, e.position, e.velocity});
}
bool is_same(const Event& a, const Event& b) {
  return a.kind == b.kind && a.reason == b.reason && a.direction == b.direction && a.id == b.id && a.value == b.value &&
         a.time == b.time && a.position == b.position && a.velocity == b.velocity && a.normal == b.normal &&
         a.energy == b.energy && a.instance == b.instance && a.other == b.other;
}
bool comes_before(const Event& a, const Event& b) {
  const auto key = [](const Event& e) { return std::tuple(e.time, e.id.index, row_of(e.kind).order); };
  return key(a) < key(b);
}

TEST(EventList, tells_what_was_told_in_order_while_more_comes) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    test::Random r(seed);
    EventList list;
    GivenEvents given;
    std::vector<EventKey> spare;
    std::vector<Event> told;
    std::vector<std::pair<std::span<const Event>, std::vector<Event>>> read;  // as given, and as it was then
    for (std::uint32_t i = 0, count = static_cast<std::uint32_t>(r.below(400)); i < count; ++i) {
      told.push_back(random_event(r, i));
      add(list, told.back());
      if (r.one_in(60)) {
        list.put_in_order(spare, given);
        std::ranges::stable_sort(told, comes_before);
      }
      if (!r.one_in(20)) continue;
      const std::span<const Event> all = list.all(given);
      read.emplace_back(all, std::vector(all.begin(), all.end()));
      ASSERT_TRUE(std::ranges::equal(all, told, is_same)) << "seed " << seed;
    }
    ASSERT_EQ(list.size(), told.size());
    ASSERT_TRUE(std::ranges::equal(list.all(given), told, is_same)) << "seed " << seed;
    for (const auto& [now, then] : read) ASSERT_TRUE(std::ranges::equal(now, then, is_same)) << "seed " << seed;
    list.clear();
    EXPECT_TRUE(list.all(given).empty());
  }
}

TEST(EventList, is_copied_with_what_was_told) {
  test::Random r(3);
  EventList list;
  GivenEvents given;
  for (std::uint32_t i = 0; i < 100; ++i) add(list, random_event(r, i));
  const EventList copy = list;
  EXPECT_TRUE(std::ranges::equal(list.all(given), copy.all(given), is_same));
  const std::span<const Event> all = list.all(given);
  const std::vector<Event> then(all.begin(), all.end());
  list.leave(given);
  list = copy;
  EXPECT_TRUE(std::ranges::equal(all, then, is_same));
  EXPECT_TRUE(std::ranges::equal(list.all(given), then, is_same));
}

TEST(EventList, many_at_once_are_as_one_by_one) {
  EventList list, other;
  GivenEvents given;
  const auto told = [](std::size_t i) {
    const double x = static_cast<double>(i);
    return PlainEvent{EventKind::spawned, Reason::none, {static_cast<std::uint32_t>(i + 1), 7}, 3, 0.5 * x,
                      {x, 0.1, -x},       {1, 2, x}};
  };
  list.add_each(100, told);
  for (std::size_t i = 0; i < 100; ++i) other.add(told(i));
  EXPECT_TRUE(std::ranges::equal(list.all(given), other.all(given), is_same));
}

TEST(EventList, room_that_was_reserved_is_enough) {
  EventList list;
  list.reserve(64);
  const std::size_t bytes = list.bytes();
  for (std::uint32_t i = 0; i < 64; ++i) list.add(PlainEvent{.id = {1 + i, 1}});
  EXPECT_EQ(list.bytes(), bytes);
}

TEST(EventList, copies_have_shown_nothing) {
  EventList list;
  GivenEvents given;
  for (std::uint32_t i = 0; i < 64; ++i) list.add(PlainEvent{.id = {1 + i, 1}});
  const std::size_t unread = EventList(list).bytes();
  EXPECT_EQ(list.all(given).size(), 64U);
  EXPECT_EQ(EventList(list).bytes(), unread);
  EventList other;
  other = list;
  EXPECT_TRUE(std::ranges::equal(list.all(given), other.all(given), is_same));
  const std::size_t before = given.size();
  EventList().leave(given);
  EXPECT_EQ(given.size(), before) << "who has shown nothing leaves nothing";
}

TEST(EventList, keeps_plain_ones_in_few_bytes) {
  EventList list;
  for (std::uint32_t i = 0; i < 1000; ++i) list.add(PlainEvent{.id = {1 + i, 1}});
  EXPECT_LT(list.bytes(), 1100 * sizeof(Event));
  EXPECT_LT(list.bytes(), 1000 * 2 * 64 + 4096);
}

}  // namespace physim::world_event_list_test
