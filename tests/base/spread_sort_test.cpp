#include "base/spread_sort.hpp"

#include <gtest/gtest.h>

#include <random>

namespace physim::base_spread_sort_test {

struct Item {
  double place;
  int at;
  bool operator==(const Item&) const = default;
};
bool is_before(const Item& a, const Item& b) { return a.place != b.place ? a.place < b.place : a.at < b.at; }

void expect_sorted(std::vector<Item> list) {
  std::vector<Item> expected = list, spare;
  std::ranges::sort(expected, is_before);
  spread_sort(
      list, spare, [](const Item& item) { return item.place; }, is_before);
  EXPECT_EQ(list, expected);
}

TEST(SpreadSort, sorts_what_is_spread_in_any_way) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> part(0, 1);
  for (const int count : {0, 1, 2, 63, 64, 65, 1000, 5000, 30000})
    for (int kind = 0; kind < 6; ++kind) {
      std::vector<Item> list;
      for (int i = 0; i < count; ++i) {
        const double u = part(random);
        const double place[] = {u, 100 + 1e-3 * u, std::floor(8 * u), 7.0, i == 0 ? 1e300 : u, std::exp(-40 * u)};
        list.push_back({place[kind], static_cast<int>(random() % 5) + 10 * i});
      }
      expect_sorted(list);
      std::ranges::reverse(list);
      expect_sorted(list);
    }
}

TEST(SpreadSort, sorts_places_at_the_ends_of_numbers) {
  std::vector<Item> list;
  for (int i = 0; i < 200; ++i) list.push_back({i % 2 == 0 ? -1.7e308 : 1.7e308, 200 - i});
  expect_sorted(list);
  for (Item& item : list) item.place *= 1e-320;
  expect_sorted(list);
}

}  // namespace physim::base_spread_sort_test
