// The normal distribution against erfc of the C library in long double.
#include "math/normal.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "random_shots.hpp"

namespace physim::math_normal_test {

long double cdf(long double z) { return 0.5L * std::erfc(-z / std::sqrt(2.0L)); }

TEST(Normal, cumulative_function) {
  test::Random r(1);
  double worst = 0;
  for (int i = 0; i < 200'000; ++i) {
    const double z = r.in(-37, 8);
    worst = std::max(worst, static_cast<double>(std::abs((normal_cdf(z) - cdf(z)) / cdf(z))));
  }
  EXPECT_LT(worst, 1.1e-15);
  EXPECT_EQ(normal_cdf(0), 0.5);
  EXPECT_EQ(normal_cdf(-std::numeric_limits<double>::infinity()), 0);
  EXPECT_EQ(normal_cdf(std::numeric_limits<double>::infinity()), 1);
  EXPECT_TRUE(std::isnan(normal_cdf(std::nan(""))));
}

/// Two steps of Newton's method, from what is found.
TEST(Normal, quantiles) {
  test::Random r(2);
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double p = i % 2 == 0 ? r.in(0, 1) : std::pow(10.0, r.in(-300, 0));
    const double z = normal_quantile(p);
    if (std::abs(z) < 1e-3) continue;
    long double exact = z;
    for (int k = 0; k < 2; ++k) {
      const long double over = exact < 0 ? cdf(exact) - p : (1 - static_cast<long double>(p)) - cdf(-exact);
      exact -= over / (std::exp(-exact * exact / 2) / std::sqrt(2 * std::acos(-1.0L)));
    }
    worst = std::max(worst, static_cast<double>(std::abs((z - exact) / exact)));
  }
  EXPECT_LT(worst, 1.2e-15);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-15);
  EXPECT_EQ(normal_quantile(0.5), 0);
}

}  // namespace physim::math_normal_test
