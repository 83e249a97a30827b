// Rough powers and logarithms: as good as they say, over all that a step's control feeds them, and the same in packs.
#include "math/rough_power.hpp"

#include "support.hpp"

namespace physim::math_rough_power_test {

template <class S>
class RoughPower : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RoughPower, Precisions);

TYPED_TEST(RoughPower, logarithms_lie_on_lines_between_powers_of_two) {
  using S = TypeParam;
  double above = -1, below = -1;
  for (S x = S(1e-30); x < S(1e30); x *= S(1.0007)) {
    const double error = double(log2_roughly(x)) - std::log2(double(x));
    above = std::max(above, error), below = std::max(below, -error);
  }
  EXPECT_LT(above, 1e-6);  // rounding alone
  EXPECT_LT(below, 0.0862);
  EXPECT_GT(below, 0.086);  // 1 - log2(e ln 2), Mitchell's figure
  for (int k = -100; k <= 100; ++k) {
    EXPECT_EQ(log2_roughly(std::ldexp(S(1), k)), S(k));
    EXPECT_EQ(log2_roughly(std::ldexp(S(1.375), k)), S(k) + S(0.375));
  }
}

TYPED_TEST(RoughPower, powers_lie_on_lines_between_whole_exponents) {
  using S = TypeParam;
  double above = -1, below = -1;
  for (S x = S(-119); x < S(119); x += S(0.0137)) {
    const double error = double(exp2_roughly(x)) / std::exp2(double(x)) - 1;
    above = std::max(above, error), below = std::max(below, -error);
  }
  EXPECT_LT(below, 1e-4);  // a float keeps 14 binary digits behind the point here
  EXPECT_LT(above, 0.062);
  EXPECT_GT(above, 0.061);
  for (int k = -100; k <= 100; ++k) {
    EXPECT_EQ(exp2_roughly(S(k)), std::ldexp(S(1), k));
    EXPECT_EQ(exp2_roughly(S(k) + S(0.375)), std::ldexp(S(1.375), k));
  }
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

}  // namespace physim::math_rough_power_test
