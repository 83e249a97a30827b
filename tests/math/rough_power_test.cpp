// Rough powers and logarithms: as good as they say, over all that a step's control feeds them, and the same in packs.
#include "math/rough_power.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support.hpp"

namespace physim {
namespace {

template <class S>
class RoughPower : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RoughPower, Precisions);

TYPED_TEST(RoughPower, logarithms_keep_two_digits_behind_the_point) {
  using S = TypeParam;
  double worst = 0;
  for (S x = S(1e-30); x < S(1e30); x *= S(1.0007))
    worst = std::max(worst, std::abs(double(log2_roughly(x)) - std::log2(double(x))));
  EXPECT_LT(worst, 0.01);
  EXPECT_GT(worst, 0.001);  // it is rough; else log() does as well
  for (int k = -100; k <= 100; ++k) EXPECT_EQ(log2_roughly(std::ldexp(S(1), k)), S(k));
}

TYPED_TEST(RoughPower, powers_keep_two_digits) {
  using S = TypeParam;
  double worst = 0;
  for (S x = S(-119); x < S(119); x += S(0.0137))
    worst = std::max(worst, std::abs(double(exp2_roughly(x)) / std::exp2(double(x)) - 1));
  EXPECT_LT(worst, 0.01);
  EXPECT_GT(worst, 0.001);
  for (int k = -100; k <= 100; ++k) EXPECT_EQ(exp2_roughly(S(k)), std::ldexp(S(1), k));
}

TYPED_TEST(RoughPower, packs_give_the_bits_of_numbers) {
  using S = TypeParam;
  using P = Pack<S, 16>;
  for (S from = S(1e-16); from < S(1e16); from *= S(1.7)) {
    P x;
    for (int i = 0; i < 16; ++i) x.set(i, from * S(1 + 0.13 * i));
    const P log = log2_roughly(x), power = exp2_roughly(log);
    for (int i = 0; i < 16; ++i) {
      EXPECT_EQ(log[i], log2_roughly(x[i]));
      EXPECT_EQ(power[i], exp2_roughly(log[i]));
    }
  }
}

}  // namespace
}  // namespace physim
