// Curves through points: what each interpolation promises, and that equal cells change nothing.
#include "math/interpolation.hpp"
#include "must.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "physim/projectile.hpp"

namespace physim::math_interpolation_test {

constexpr Interpolation kAll[] = {Interpolation::linear, Interpolation::pchip, Interpolation::cubic};

// Unequal steps, a flat piece, a hill and a cliff.
const std::vector<double> kX = {0, 0.5, 0.6, 1.1, 2.3, 2.4, 4.0};
const std::vector<double> kY = {1, 1, 3, 2.5, 2.6, 0.2, 0.1};

/// Derivative number `order` of piece i at s from its left knot.
double derivative(const PiecewiseCubic& curve, std::size_t i, double s, int order) {
  const auto& c = curve.pieces[i];
  if (order == 1) return c[1] + s * (2 * c[2] + 3 * s * c[3]);
  return 2 * c[2] + 6 * s * c[3];
}

TEST(Interpolation, goes_through_every_point) {
  for (const Interpolation how : kAll) {
    const PiecewiseCubic curve = interpolate(kX, kY, how);
    for (std::size_t i = 0; i < kX.size(); ++i) EXPECT_NEAR(curve(kX[i]), kY[i], 4e-15) << int(how) << ' ' << i;
  }
}

TEST(Interpolation, holds_the_end_values_outside) {
  for (const Interpolation how : kAll) {
    const PiecewiseCubic curve = interpolate(kX, kY, how);
    EXPECT_EQ(curve(-7), 1);
    EXPECT_NEAR(curve(100), 0.1, 1e-15);
  }
}

TEST(Interpolation, one_point_is_a_constant) {
  const double x[] = {0.8}, y[] = {0.47};
  for (const Interpolation how : kAll) {
    const PiecewiseCubic curve = interpolate(x, y, how);
    for (const double at : {-1.0, 0.0, 0.8, 1.3, 50.0}) EXPECT_EQ(curve(at), 0.47);
  }
}

TEST(Interpolation, two_points_are_a_straight_line_however_read) {
  const double x[] = {1, 3}, y[] = {2, 8};
  for (const Interpolation how : kAll) EXPECT_NEAR(interpolate(x, y, how)(1.7), 4.1, 1e-14);
}

TEST(Interpolation, linear_lies_on_the_chord) {
  const PiecewiseCubic curve = interpolate(kX, kY, Interpolation::linear);
  EXPECT_NEAR(curve(0.55), 2.0, 1e-14);
  EXPECT_NEAR(curve(1.7), 2.55, 1e-14);
}

TEST(Interpolation, pchip_is_monotone_between_points_and_never_overshoots) {
  const PiecewiseCubic curve = interpolate(kX, kY, Interpolation::pchip);
  for (std::size_t i = 0; i + 1 < kX.size(); ++i) {
    const double low = std::min(kY[i], kY[i + 1]) - 1e-14;
    const double high = std::max(kY[i], kY[i + 1]) + 1e-14;
    double last = kY[i];
    for (int k = 0; k <= 200; ++k) {
      const double y = curve(kX[i] + (kX[i + 1] - kX[i]) * k / 200);
      EXPECT_GE(y, low);
      EXPECT_LE(y, high);
      EXPECT_GE((y - last) * (kY[i + 1] - kY[i]), -1e-14) << "not monotone in piece " << i;
      last = y;
    }
  }
}

TEST(Interpolation, pchip_reproduces_a_straight_line) {
  std::vector<double> y;
  for (const double x : kX) y.push_back(3 - 2 * x);
  const PiecewiseCubic curve = interpolate(kX, y, Interpolation::pchip);
  for (double x = 0; x <= 4; x += 0.01) EXPECT_NEAR(curve(x), 3 - 2 * x, 1e-14);
}

// By hand for steps 1, 2, 1 and secants 1, 1/2, 3: the weights are 5, 4 and 4, 5, so that
// m1 = 9 / (5/1 + 4/(1/2)) and m2 = 9 / (4/(1/2) + 5/3).
TEST(Interpolation, pchip_slopes_are_the_weighted_harmonic_means) {
  const double x[] = {0, 1, 3, 4}, y[] = {0, 1, 2, 5};
  const PiecewiseCubic curve = interpolate(x, y, Interpolation::pchip);
  EXPECT_NEAR(curve.pieces[1][1], 9.0 / 13, 1e-15);
  EXPECT_NEAR(curve.pieces[2][1], 27.0 / 29, 1e-15);
}

TEST(Interpolation, slopes_join_where_they_should) {
  for (const Interpolation how : {Interpolation::pchip, Interpolation::cubic}) {
    const PiecewiseCubic curve = interpolate(kX, kY, how);
    for (std::size_t i = 0; i + 2 < kX.size(); ++i)
      EXPECT_NEAR(derivative(curve, i, kX[i + 1] - kX[i], 1), derivative(curve, i + 1, 0, 1), 1e-11);
  }
}

TEST(Interpolation, cubic_has_continuous_curvature_and_natural_ends) {
  const PiecewiseCubic curve = interpolate(kX, kY, Interpolation::cubic);
  for (std::size_t i = 0; i + 2 < kX.size(); ++i)
    EXPECT_NEAR(derivative(curve, i, kX[i + 1] - kX[i], 2), derivative(curve, i + 1, 0, 2), 1e-9);
  EXPECT_NEAR(derivative(curve, 0, 0, 2), 0, 1e-11);
  EXPECT_NEAR(derivative(curve, kX.size() - 2, kX.back() - kX[kX.size() - 2], 2), 0, 1e-11);
}

// y'' = 6 x on [0, 1] and 12 - 6 x on [1, 2]: cubic pieces, continuous curvature, none at the ends.
TEST(Interpolation, cubic_is_exact_on_a_natural_spline) {
  const auto spline = [](double x) { return x * x * x - (x > 1 ? 2 * (x - 1) * (x - 1) * (x - 1) : 0) + x; };
  const double x[] = {0, 1, 2};
  const double y[] = {spline(0), spline(1), spline(2)};
  const PiecewiseCubic curve = interpolate(x, y, Interpolation::cubic);
  for (double at = 0; at <= 2; at += 0.01) EXPECT_NEAR(curve(at), spline(at), 1e-14);
}

TEST(Interpolation, cubic_converges_with_the_fourth_power_of_the_spacing) {
  const auto error = [](int n) {
    std::vector<double> x, y;
    for (int i = 0; i <= n; ++i) {
      x.push_back(3.14159265358979323846 * i / n);  // sin has natural ends at 0 and pi
      y.push_back(std::sin(x.back()));
    }
    const PiecewiseCubic curve = interpolate(x, y, Interpolation::cubic);
    double worst = 0;
    for (double at = 0; at < 3.14; at += 0.001) worst = std::max(worst, std::abs(curve(at) - std::sin(at)));
    return worst;
  };
  EXPECT_NEAR(std::log2(error(20) / error(40)), 4, 0.1);
}

double evaluate(const UniformCubic& u, double x) {
  const double cells = static_cast<double>(u.rows.size());
  const double inside = std::clamp((x - u.start) / u.cell, 0.0, cells);
  const double i = std::min(std::floor(inside), cells - 1);
  const auto& r = u.rows[static_cast<std::size_t>(i)];
  const double t = inside - i;
  return r[0] + t * (r[1] + t * (r[2] + t * r[3]));
}

TEST(Interpolation, equal_cells_are_the_same_polynomial_for_every_standard_drag_function) {
  for (int table = int(DragTable::g1); table <= int(DragTable::ra4); ++table) {
    std::vector<double> mach, cd;
    for (const DragPoint& p : drag_points(static_cast<DragTable>(table))) {
      mach.push_back(p.mach);
      cd.push_back(p.coefficient);
    }
    for (const Interpolation how : kAll) {
      const PiecewiseCubic curve = interpolate(mach, cd, how);
      const auto uniform = must(on_uniform_cells(curve, 16384), table);
      EXPECT_LE(uniform.rows.size(), 2000u) << table;  // the points of all nine are multiples of 0.005 or coarser
      for (double x = -0.1; x < 6; x += 0.00137) ASSERT_NEAR(evaluate(uniform, x), curve(x), 2e-14) << table;
    }
  }
}

TEST(Interpolation, equal_cells_refuse_points_that_fit_no_grid) {
  const std::vector<double> x = {0, 0.31830988618, 1, 2.71828182845};
  const std::vector<double> y = {1, 2, 1.5, 0};
  EXPECT_FALSE(on_uniform_cells(interpolate(x, y, Interpolation::cubic), 1000));
}

TEST(Interpolation, equal_cells_do_not_move_points_that_nearly_fit) {
  const std::vector<double> x = {0, 0.5, 1 + 1e-7, 1.5, 2};
  const std::vector<double> y = {0.2, 0.3, 0.9, 0.7, 0.6};
  const PiecewiseCubic curve = interpolate(x, y, Interpolation::linear);
  const auto uniform = on_uniform_cells(curve, 16384);
  if (!uniform) return;  // searched instead: right as well
  for (double at = 0; at < 2; at += 0.001) ASSERT_NEAR(evaluate(*uniform, at), curve(at), 1e-12);
}

}  // namespace physim::math_interpolation_test
