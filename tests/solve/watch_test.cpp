// Watching: what is told by bits of lanes, against the words of the definitions.
#include "solve/watch.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace physim::solve_watch_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kNumbers[] = {-1, 0, 1, kNan};

bool rises_through(double from, double to) { return from < 0 && to >= 0; }
bool falls_through(double from, double to) { return from > 0 && to <= 0; }
bool is_crossed(Crossing direction, double from, double to) {
  return (direction != Crossing::falling && rises_through(from, to)) ||
         (direction != Crossing::rising && falls_through(from, to));
}
bool turns_behind(double from, double to, double rate_from, double rate_to) {
  return (from <= 0 && to <= 0 && rate_from > 0 && rate_to <= 0) ||
         (from >= 0 && to >= 0 && rate_from < 0 && rate_to >= 0);
}

SideBits side(double x, int lane) { return {(x >= 0 ? 1u : 0u) << lane, (x <= 0 ? 1u : 0u) << lane}; }
Standing stand(double value, double rate, int lane) { return {side(value, lane), side(rate, lane)}; }

void for_all(const auto& f) {
  for (const double from : kNumbers)
    for (const double to : kNumbers)
      for (const double rate_from : kNumbers)
        for (const double rate_to : kNumbers) f(from, to, rate_from, rate_to);
}

TEST(Watch, bits_of_lanes_say_what_numbers_say) {
  for (const Crossing direction : {Crossing::any, Crossing::rising, Crossing::falling}) {
    for (const bool terminal : {false, true}) {
      const EventSpec spec{EventKind::height, 0, direction, terminal};  // nothing lands by it
      for_all([&](double from, double to, double rate_from, double rate_to) {
        const bool once = is_crossed(direction, from, to), twice = turns_behind(from, to, rate_from, rate_to);
        EXPECT_EQ(crosses(direction, from, to), once);
        EXPECT_EQ(may_cross_twice(from, to, rate_from, rate_to), twice);
        for (const int lane : {0, 7, 31}) {
          Detected d;
          d.add(spec, stand(from, rate_from, lane), stand(to, rate_to, lane), true);
          const unsigned bit = 1u << lane;
          EXPECT_EQ(d.some, once || twice ? bit : 0u) << from << to << rate_from << rate_to;
          EXPECT_EQ(d.surely_terminal, terminal && once && !twice ? bit : 0u) << from << to << rate_from << rate_to;
          EXPECT_EQ(d.maybe_terminal, terminal && (once || twice) ? bit : 0u) << from << to << rate_from << rate_to;
        }
      });
    }
  }
}

/// What begins a step on the ground, not upwards, and ends it below has landed, in a flight.
TEST(Watch, what_drops_from_the_ground_has_landed) {
  const EventSpec ground{EventKind::ground, 0, Crossing::falling, true};
  for_all([&](double from, double to, double rate_from, double rate_to) {
    const bool drops = from == 0 && rate_from <= 0 && to < 0;
    const bool once = is_crossed(ground.direction, from, to), twice = turns_behind(from, to, rate_from, rate_to);
    for (const bool lands : {false, true}) {
      Detected d;
      d.add(ground, stand(from, rate_from, 3), stand(to, rate_to, 3), lands);
      EXPECT_EQ(d.some != 0, once || twice || (lands && drops)) << from << to << rate_from << rate_to;
    }
  });
}

bool same(const SideBits& a, const SideBits& b) { return a.at_least == b.at_least && a.at_most == b.at_most; }

TEST(Watch, lanes_are_taken_over_alone) {
  const Standing all({0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}), none({0, 0}, {0, 0});
  Standing some = all;
  some.take(none, 0x800000f0);
  EXPECT_TRUE(same(some.value(), {0x7fffff0f, 0x7fffff0f}) && same(some.rate(), {0x7fffff0f, 0x7fffff0f}));
  const Standing rising({0x80000000, 0}, {0x80000000, 0});  // in lane 31 above, rising
  some.take(rising, 31, 2);
  EXPECT_TRUE(same(some.value(), {0x7fffff0f, 0x7fffff0b}) && same(some.rate(), {0x7fffff0f, 0x7fffff0b}));
  some.take(rising, 31, 6);
  EXPECT_TRUE(same(some.value(), {0x7fffff4f, 0x7fffff0b}) && same(some.rate(), {0x7fffff4f, 0x7fffff0b}));
  some.take(rising, 31, 31);
  EXPECT_TRUE(same(some.value(), {0xffffff4f, 0x7fffff0b}) && same(some.rate(), {0xffffff4f, 0x7fffff0b}));
}

}  // namespace physim::solve_watch_test
