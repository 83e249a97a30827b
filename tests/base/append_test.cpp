#include "base/append.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace physim::base_append_test {

struct Item {
  std::uint32_t number;
  double value;
  bool operator==(const Item&) const = default;
};

TEST(Append, is_push_back_in_memory_that_doubles) {
  std::vector<Item> list, expected;
  int moves = 0;
  for (std::uint32_t i = 0; i < 10000; ++i) {
    const Item* const before = list.data();
    append(list, {i, 0.5 * i});
    expected.push_back({i, 0.5 * i});
    moves += list.data() != before ? 1 : 0;
  }
  EXPECT_EQ(list, expected);
  EXPECT_LE(moves, 11);  // 16, 32 ... 16384
}

TEST(Append, takes_memory_once_for_many) {
  std::vector<int> list(3);
  make_room(list, 100);
  const std::size_t room = list.capacity();
  EXPECT_GE(room, 103U);
  const int* const before = list.data();
  make_room(list, room - list.size());
  for (int i = 3; i < 103; ++i) append(list, i);
  EXPECT_EQ(list.data(), before);
  EXPECT_EQ(list.back(), 102);
}

}  // namespace physim::base_append_test
