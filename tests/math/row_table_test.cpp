// Cubics from rows of a table: the same bits for a number and for every lane of a pack.
#include "math/row_table.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace physim::math_row_table_test {

template <class P>
class RowTableTest : public testing::Test {};
using Packs = testing::Types<Pack<float, 4>, Pack<float, 8>, Pack<float, 16>, Pack<float, 32>, Pack<double, 2>,
                             Pack<double, 4>, Pack<double, 8>, Pack<double, 16>>;
TYPED_TEST_SUITE(RowTableTest, Packs);

TYPED_TEST(RowTableTest, lanes_read_their_own_rows) {
  using S = ScalarOf<TypeParam>;
  std::vector<S> rows(4 * 300);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = S(int((i * 7919) % 1009)) / S(311) - S(1.5);
  for (int start = 0; start < 300; start += 7) {
    TypeParam index(S(0)), t(S(0));
    for (int lane = 0; lane < kLanes<TypeParam>; ++lane) {
      index.set(lane, S((start * 31 + lane * 53) % 300));
      t.set(lane, S((start + lane * 13) % 101) / S(100));
    }
    const TypeParam y = row_cubic(rows.data(), index, t);
    for (int lane = 0; lane < kLanes<TypeParam>; ++lane)
      ASSERT_EQ(y[lane], row_cubic(rows.data(), index[lane], t[lane])) << lane;
  }
}

TYPED_TEST(RowTableTest, evaluates_the_cubic) {
  using S = ScalarOf<TypeParam>;
  const std::vector<S> rows = {9, 9, 9, 9, 1, -2, 3, 4};
  const TypeParam y = row_cubic(rows.data(), TypeParam(S(1)), TypeParam(S(0.5)));
  for (int lane = 0; lane < kLanes<TypeParam>; ++lane) EXPECT_EQ(y[lane], S(1 - 1 + 0.75 + 0.5));
}

TEST(RowTable, reaches_the_last_row_of_a_large_pool) {
  const int last = (1 << 20) - 1;
  std::vector<float> rows(4u << 20);
  rows[4 * std::size_t(last)] = 42;
  const auto y = row_cubic(rows.data(), Pack<float, 8>(float(last)), Pack<float, 8>(0.0f));
  EXPECT_EQ(y[7], 42);
  EXPECT_EQ(row_cubic(rows.data(), float(last), 0.0f), 42);
}

}  // namespace physim::math_row_table_test
