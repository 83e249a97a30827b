// Polynomials by Estrin's scheme, where every operation is exact: small whole numbers.
#include "math/polynomial.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace physim::math_polynomial_test {

/// sum of (i + 1) 2^i for i < n = (n - 1) 2^n + 1
template <int N>
void expect_sum_of() {
  double whole[N];
  float single[N];
  Pack<double, 4> lanes[N];
  for (int i = 0; i < N; ++i) {
    whole[i] = i + 1;
    single[i] = static_cast<float>(i + 1);
    for (int lane = 0; lane < 4; ++lane) set_lane(lanes[i], lane, i + 1.0 + lane);
  }
  const double sum = (N - 1) * static_cast<double>(1ull << N) + 1, ones = static_cast<double>(1ull << N) - 1;
  EXPECT_EQ(polynomial(2.0, whole), sum) << N;
  EXPECT_EQ(static_cast<double>(polynomial(2.0f, single)), static_cast<double>(static_cast<float>(sum))) << N;
  const Pack<double, 4> own = polynomial(Pack<double, 4>(2.0), lanes);
  for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(lane_of(own, lane), sum + lane * ones) << N << ", lane " << lane;
}

TEST(Polynomial, of_every_length_is_its_sum) {
  [&]<int... kN>(std::integer_sequence<int, kN...>) { (expect_sum_of<kN + 1>(), ...); }
  (std::make_integer_sequence<int, 20>());
  expect_sum_of<32>();
}

TEST(Polynomial, takes_the_first_terms_where_it_is_told) {
  const double c[] = {1, 2, 3, 4, 5};
  EXPECT_EQ((polynomial<3>(10.0, c)), 321);
  EXPECT_EQ((polynomial<1>(10.0, c)), 1);
}

}  // namespace physim::math_polynomial_test
