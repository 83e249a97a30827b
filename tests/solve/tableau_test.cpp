// The tableaus: consistency, order conditions, error weights and dense weights. A wrong digit anywhere shows.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <span>

#include "solve/explicit_runge_kutta.hpp"

namespace physim::solve_tableau_test {

template <class Tableau>
class TableauTest : public testing::Test {
 protected:
  static constexpr int kStages = Tableau::kStages;
  static double sum(const auto& term) {
    double total = 0;
    for (int i = 0; i < kStages; ++i) total += term(i);
    return total;
  }
};
using Tableaus = testing::Types<ExplicitEuler, Heun, Rk4, Rk43, Tsit5, Dop853>;
TYPED_TEST_SUITE(TableauTest, Tableaus);

constexpr double kRounding = 3e-14;  // coefficients up to 43, each good to 1e-16 of itself

TYPED_TEST(TableauTest, stages_stand_at_the_sum_of_their_row) {
  for (int i = 0; i < TypeParam::kStages; ++i)
    EXPECT_NEAR(this->sum([&](int j) { return j < i ? TypeParam::a[i][j] : 0.0; }), TypeParam::c[i], kRounding) << i;
}

TYPED_TEST(TableauTest, stages_depend_on_earlier_ones_only) {
  for (int i = 0; i < TypeParam::kStages; ++i)
    for (int j = i; j < TypeParam::kStages; ++j) EXPECT_EQ(TypeParam::a[i][j], 0);
}

TYPED_TEST(TableauTest, quadrature_conditions) {
  for (int k = 1; k <= TypeParam::kOrder; ++k)
    EXPECT_NEAR(this->sum([&](int i) { return TypeParam::b[i] * std::pow(TypeParam::c[i], k - 1); }), 1.0 / k,
                kRounding)
        << k;
}

/// sum_ij b_i c_i^l a_ij c_j^m = 1 / ((m + 1) (l + m + 2)) for l + m + 2 <= order.
TYPED_TEST(TableauTest, conditions_of_trees_with_two_levels) {
  for (int l = 0; l + 2 < TypeParam::kOrder; ++l)
    for (int m = 1; l + m + 2 <= TypeParam::kOrder; ++m) {
      const double total = this->sum([&](int i) {
        return TypeParam::b[i] * std::pow(TypeParam::c[i], l) *
               this->sum([&](int j) { return j < i ? TypeParam::a[i][j] * std::pow(TypeParam::c[j], m) : 0.0; });
      });
      EXPECT_NEAR(total, 1.0 / ((m + 1) * (l + m + 2)), kRounding) << l << ' ' << m;
    }
}

/// The tall tree: b A^(q-2) c = 1 / q!.
TYPED_TEST(TableauTest, conditions_of_tall_trees) {
  double u[16];
  for (int i = 0; i < TypeParam::kStages; ++i) u[i] = 1;
  double factorial = 1;
  for (int q = 1; q <= TypeParam::kOrder; ++q) {
    factorial *= q;
    EXPECT_NEAR(this->sum([&](int i) { return TypeParam::b[i] * u[i]; }), 1 / factorial, kRounding) << q;
    double next[16];
    for (int i = 0; i < TypeParam::kStages; ++i)
      next[i] = this->sum([&](int j) { return j < i ? TypeParam::a[i][j] * u[j] : 0.0; });
    for (int i = 0; i < TypeParam::kStages; ++i) u[i] = next[i];
  }
}

/// Error weights are the difference of two methods: they vanish on polynomials that both integrate exactly.
double moment(std::span<const double> weights, std::span<const double> c, int power) {
  double total = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) total += weights[i] * (power == 0 ? 1 : std::pow(c[i], power));
  return total;
}

TEST(Tableau, error_weights_see_what_the_lower_order_misses) {
  const double rk43_c[5] = {0, 0.4, 0.6, 1, 1};
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(moment(Rk43::kError, rk43_c, k), 0, 1e-16) << k;
  EXPECT_GT(std::abs(moment(Rk43::kError, rk43_c, 3)), 1e-3);
  const double tsit5_c[7] = {0, 0.161, 0.327, 0.9, 0.9800255409045097, 1, 1};
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(moment(Tsit5::kError, tsit5_c, k), 0, 1e-14) << k;
  EXPECT_GT(std::abs(moment(Tsit5::kError, tsit5_c, 4)), 1e-5);
  const std::span<const double> c(Dop853::c, 12);
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(moment(Dop853::kError5, c, k), 0, kRounding) << k;
  EXPECT_GT(std::abs(moment(Dop853::kError5, c, 5)), 1e-5);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(moment(Dop853::kError3, c, k), 0, kRounding) << k;
  EXPECT_GT(std::abs(moment(Dop853::kError3, c, 3)), 1e-5);
}

TEST(Tableau, dense_weights_of_tsit5_integrate_polynomials_up_to_any_point) {
  const double c[7] = {0, 0.161, 0.327, 0.9, 0.9800255409045097, 1, 1};
  for (double theta = 0.05; theta <= 1; theta += 0.05)
    for (int k = 1; k <= 4; ++k) {
      double total = 0;
      for (int j = 0; j < 7; ++j) {
        const double* p = Tsit5::kDense[j];
        total += theta * (p[0] + theta * (p[1] + theta * (p[2] + theta * p[3]))) * (k == 1 ? 1 : std::pow(c[j], k - 1));
      }
      EXPECT_NEAR(total, std::pow(theta, k) / k, 1e-13) << theta << ' ' << k;
    }
}

TEST(Tableau, dense_output_of_tsit5_ends_with_the_step) {
  for (int j = 0; j < 7; ++j) {
    const double* p = Tsit5::kDense[j];
    EXPECT_NEAR(p[0] + p[1] + p[2] + p[3], j < 6 ? Tsit5::b[j] : 0, 1e-13) << j;
  }
}

TEST(Tableau, rows_of_dop853_for_the_end_and_the_dense_output) {
  for (int j = 0; j < 12; ++j) EXPECT_EQ(Dop853::a[12][j], Dop853::b[j]);
  for (int i = 13; i < 16; ++i)
    EXPECT_NEAR(std::accumulate(Dop853::a[i], Dop853::a[i] + i, 0.0), Dop853::c[i], kRounding);
  for (int row = 0; row < 4; ++row)
    EXPECT_NEAR(std::accumulate(Dop853::kDense[row], Dop853::kDense[row] + 16, 0.0), 0, 1e-12) << row;
}

}  // namespace physim::solve_tableau_test
