// What fires next, beside a plain sort of all that waits.
#include "world/couple/emitter_firing.hpp"

#include <gtest/gtest.h>

#include "random_shots.hpp"

namespace physim::world_emitter_firing_test {

Firing random_firing(test::Random& r, std::uint64_t order) {
  return {.time = r.one_in(2) ? 1 : r.in(0, 2),
          .emitter = static_cast<std::uint32_t>(1 + r.below(3)),
          .rank = static_cast<std::uint32_t>(r.below(3)),
          .parent = static_cast<std::uint64_t>(r.below(2)),
          .order = order};
}
bool is_same(const Firing& a, const Firing& b) { return a.order == b.order; }

TEST(FiringQueue, gives_firings_in_order_while_others_come) {
  test::Random r(6);
  FiringQueue queue;
  std::vector<Firing> waiting;
  const auto later = [](const Firing& a, const Firing& b) { return a < b; };
  for (std::uint64_t i = 0; i < 5000; ++i) {
    if (r.one_in(2) || waiting.empty()) {
      const Firing firing = random_firing(r, i);
      const bool is_first = std::ranges::all_of(waiting, [&](const Firing& other) { return other < firing; });
      ASSERT_EQ(queue.comes_before_all(firing), is_first);
      queue.push(firing);
      waiting.push_back(firing);
      continue;
    }
    std::ranges::sort(waiting, later);  // the last one is next
    ASSERT_EQ(queue.next_time(), waiting.back().time);
    ASSERT_TRUE(is_same(queue.next(), waiting.back()));
    ASSERT_TRUE(is_same(queue.pop(), waiting.back()));
    waiting.pop_back();
    ASSERT_EQ(queue.empty(), waiting.empty());
  }
}

TEST(FiringQueue, takes_turns_of_many_that_fire_at_equal_times) {
  constexpr std::uint32_t kEmitters = 40;
  test::Random r(8);
  FiringQueue queue;
  for (std::uint32_t emitter = 1; emitter <= kEmitters; ++emitter) queue.push({.time = 0, .emitter = emitter});
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const Firing firing = queue.pop();
    ASSERT_EQ(firing.emitter, 1 + i % kEmitters);
    ASSERT_EQ(firing.time, i / kEmitters);
    queue.push({.time = firing.time + 1, .emitter = firing.emitter});
  }
}

}  // namespace physim::world_emitter_firing_test
