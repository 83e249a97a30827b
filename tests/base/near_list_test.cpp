#include "base/near_list.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace physim::base_near_list_test {

struct Item {
  std::uint64_t number;
  double value;
  bool operator==(const Item&) const = default;
};
Item item(std::uint64_t i) { return {i, 0.5 * static_cast<double>(i)}; }

using Room = NearRoom<Item, 4>;
using List = NearList<Item, 4>;

const std::byte* place_of(const void* memory) { return static_cast<const std::byte*>(memory); }
bool is_in(const Room& room, const List& list) {
  const std::byte *const begin = place_of(&room), *const at = place_of(list.data());
  return at >= begin && at < begin + sizeof(Room);
}

TEST(NearList, begins_in_its_room_and_leaves_it_when_it_grows) {
  Room room;
  List list{List::allocator_type(room)};
  list.reserve(4);
  for (std::uint64_t i = 0; i < 4; ++i) list.push_back(item(i));
  EXPECT_TRUE(is_in(room, list));
  for (std::uint64_t i = 4; i < 1000; ++i) list.push_back(item(i));
  EXPECT_FALSE(is_in(room, list));
  for (std::uint64_t i = 0; i < 1000; ++i) EXPECT_EQ(list[i], item(i));
}

TEST(NearList, lends_its_room_to_one_list_at_a_time) {
  Room room;
  List first{List::allocator_type(room)}, second{List::allocator_type(room)};
  first.push_back(item(1));
  second.push_back(item(2));
  EXPECT_TRUE(is_in(room, first));
  EXPECT_FALSE(is_in(room, second));
  EXPECT_EQ(first.front(), item(1));
  EXPECT_EQ(second.front(), item(2));
  first = List{List::allocator_type(room)};
  List third{List::allocator_type(room)};
  third.push_back(item(3));
  EXPECT_TRUE(is_in(room, third));
}

TEST(NearList, what_resize_adds_stays_as_it_is) {
  Room room;
  List list{List::allocator_type(room)};
  list.resize(4);
  for (std::uint64_t i = 0; i < 4; ++i) list[i] = item(i);
  list.resize(1);
  list.resize(4);
  for (std::uint64_t i = 0; i < 4; ++i) EXPECT_EQ(list[i], item(i));
  list.push_back({});  // what is given is put there
  EXPECT_EQ(list.back(), Item());
}

}  // namespace physim::base_near_list_test
