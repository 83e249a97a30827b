// Parts of a step: they tile it from wherever a contact leaves the flight, and are short near what was touched.
#include "flight/step_parts.hpp"

#include <gtest/gtest.h>

#include <random>

namespace physim::flight_step_parts_test {

TEST(StepParts, a_step_that_touches_nothing_is_one_part) {
  StepParts parts(10, false);
  EXPECT_EQ(parts.next(), 0.0);
  EXPECT_EQ(parts.end(), 10);
  EXPECT_TRUE(parts.is_last());
  EXPECT_EQ(parts.next(), std::nullopt);
}

TEST(StepParts, short_ones_are_equal_and_as_long_as_they_may_be) {
  StepParts parts(0.3, true);
  int count = 0;
  double last = 0;
  while (const auto from = parts.next()) {
    EXPECT_EQ(*from, last);
    EXPECT_NEAR(parts.end() - *from, 0.3 / 9, 1e-12);  // 0.3 s in thirtieths of a second
    last = parts.end();
    ++count;
  }
  EXPECT_EQ(count, 9);
  EXPECT_EQ(last, 0.3);
}

TEST(StepParts, contacts_anywhere_leave_no_gap_and_reach_the_end) {
  std::mt19937 random(5);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < 200; ++i) {
    const double length = 0.001 + unit();
    StepParts parts(length, i % 2 == 0);
    double now = 0;
    bool touched = false;
    while (const auto from = parts.next()) {
      ASSERT_EQ(*from, now);
      ASSERT_GT(parts.end(), now);
      ASSERT_LE(parts.end() - now, touched ? kLongestPart * (1 + 1e-6) : length);
      now = parts.end();
      if (unit() < 0.6) continue;
      now = *from + (now - *from) * unit();
      touched = true;
      parts.come_near(now);
      if (unit() < 0.3) now += 0.9 * (length - now);  // it slid on, beyond the part or not
      parts.come_to(now);
      parts.go_on(now);
    }
    EXPECT_EQ(now, length);
  }
}

TEST(StepParts, bounces_are_counted_anew_in_each_part) {
  StepParts parts(0.2, true);
  for (int part = 0; parts.next(); ++part) {
    int bounces = 0;
    while (parts.may_bounce()) ++bounces;
    EXPECT_EQ(bounces, 16) << part;
  }
}

TEST(StepParts, a_last_part_is_followed_by_none) {
  StepParts parts(1, true);
  EXPECT_EQ(parts.next(), 0.0);
  EXPECT_FALSE(parts.is_last());
  parts.make_last();
  EXPECT_TRUE(parts.is_last());
  EXPECT_EQ(parts.next(), std::nullopt);
}

}  // namespace physim::flight_step_parts_test
