#include "world/step/change_key.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace physim::world_change_key_test {

Change change_of(std::uint32_t slot, Change::Kind kind) {
  Change change;
  change.slot = slot;
  change.kind = kind;
  return change;
}

TEST(ChangeKey, tells_slot_and_place) {
  const std::uint64_t key = ChangeKey::of(change_of(0xfffffffe, Change::Kind::sleep), 12345);
  EXPECT_EQ(ChangeKey::slot(key), 0xfffffffe);
  EXPECT_EQ(ChangeKey::at(key), 12345u);
}

TEST(ChangeKey, orders_by_slot_then_kind_then_as_they_were_told) {
  const std::vector<Change> told{change_of(7, Change::Kind::sleep), change_of(7, Change::Kind::spin),
                                 change_of(3, Change::Kind::stick), change_of(7, Change::Kind::spin),
                                 change_of(7, Change::Kind::remove)};
  std::vector<std::uint64_t> keys;
  for (const Change& change : told) keys.push_back(ChangeKey::of(change, keys.size()));
  std::ranges::sort(keys);
  std::vector<std::size_t> order;
  for (const std::uint64_t key : keys) order.push_back(ChangeKey::at(key));
  EXPECT_EQ(order, (std::vector<std::size_t>{2, 4, 1, 3, 0}));
}

}  // namespace physim::world_change_key_test
