#include "world/core/rows.hpp"

#include <gtest/gtest.h>

#include "world/core/fields.hpp"

namespace physim::world_rows_test {

constexpr std::uint32_t kOwn = ~0u;

RowLayout quadratic_drag() {
  RowLayout layout;
  layout.float32 = true;
  layout.fields = {kBodyNumber.k1_per_mass, kBodyNumber.k2_per_mass};
  return layout;
}

class SharedNumbers : public testing::Test {
 protected:
  std::uint32_t add(double k1, double k2) {
    const std::uint32_t row = rows.push(rows.size());
    write(row, k1, k2);
    return row;
  }
  void write(std::uint32_t row, double k1, double k2) {
    Body<double> body{};
    body.k1_per_mass = k1;
    body.k2_per_mass = k2;
    rows.write_fields(row, body);
  }
  [[nodiscard]] std::uint32_t k1_mask() const { return rows.field_masks()[kBodyNumber.k1_per_mass]; }
  [[nodiscard]] std::uint32_t k2_mask() const { return rows.field_masks()[kBodyNumber.k2_per_mass]; }

  Rows rows{quadratic_drag()};
};

TEST_F(SharedNumbers, are_told_from_those_that_differ) {
  for (int i = 0; i < 100; ++i) add(1, 2);
  EXPECT_EQ(k1_mask(), 0u);
  EXPECT_EQ(k2_mask(), 0u);
  add(1, 3);
  EXPECT_EQ(k1_mask(), 0u);
  EXPECT_EQ(k2_mask(), kOwn);
}

TEST_F(SharedNumbers, end_with_a_first_row_that_differs) {
  add(1, 2);
  add(1, 2);
  write(0, 5, 2);
  EXPECT_EQ(k1_mask(), kOwn);
  EXPECT_EQ(k2_mask(), 0u);
}

TEST_F(SharedNumbers, stay_so_when_rows_leave) {
  for (int i = 0; i < 3; ++i) add(1, 2);
  rows.swap_remove(0);
  EXPECT_EQ(k1_mask(), 0u);
  add(1, 2);
  EXPECT_EQ(k1_mask(), 0u);
}

TEST_F(SharedNumbers, begin_anew_with_the_first_of_new_rows) {
  add(1, 2);
  add(3, 4);
  ASSERT_EQ(k1_mask(), kOwn);
  rows.clear();
  add(3, 4);
  add(3, 4);
  EXPECT_EQ(k1_mask(), 0u);
}

TEST_F(SharedNumbers, are_compared_in_copied_rows_too) {
  add(1, 2);
  Rows other(quadratic_drag());
  other.push_copy(rows, 0);
  write(0, 1, 7);
  other.push_copy(rows, 0);
  EXPECT_EQ(other.field_masks()[kBodyNumber.k1_per_mass], 0u);
  EXPECT_EQ(other.field_masks()[kBodyNumber.k2_per_mass], kOwn);
}

TEST_F(SharedNumbers, are_equal_in_every_bit) {
  add(0.0, 2);
  add(-0.0, 2);
  EXPECT_EQ(k1_mask(), kOwn);
}

TEST(Rows, that_change_their_numbers_while_they_step_share_none) {
  RowLayout closed = quadratic_drag();
  closed.clocked = true;
  Rows rows(closed);
  for (std::uint32_t i = 0; i < 2; ++i) rows.write_fields(rows.push(i), {});
  EXPECT_EQ(rows.field_masks()[closed.fields[0]], kOwn);
}

std::vector<std::uint32_t> changes_of(Rows& rows) {
  std::vector<std::uint32_t> changed;
  rows.take_changes([&](std::uint32_t row) { changed.push_back(row); });
  return changed;
}

TEST_F(SharedNumbers, rows_that_change_hands_are_noted_once) {
  for (int i = 0; i < 3; ++i) add(1, 2);
  rows.begin_changes();
  EXPECT_TRUE(changes_of(rows).empty());
  for (int i = 0; i < 97; ++i) add(1, 2);
  EXPECT_EQ(changes_of(rows).size(), 97u);
  EXPECT_TRUE(changes_of(rows).empty());
  rows.swap_remove(70);
  rows.swap_remove(5);
  rows.swap_remove(rows.size() - 1);  // nobody takes its place
  rows.note_change(2);
  EXPECT_EQ(changes_of(rows), (std::vector<std::uint32_t>{2, 5, 70}));
  rows.note_change(rows.size() - 1);
  rows.swap_remove(rows.size() - 1);  // there is no such row any more
  EXPECT_TRUE(changes_of(rows).empty());
  EXPECT_EQ(rows.push(7), 96u);
  EXPECT_EQ(changes_of(rows), (std::vector<std::uint32_t>{96}));
}

}  // namespace physim::world_rows_test
