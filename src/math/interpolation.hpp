// Curves through points: straight lines, monotone cubics (PCHIP) and natural cubic splines, as piecewise polynomials.
//
// Sources: F. N. Fritsch, J. Butland, "A method for constructing local monotone piecewise cubic interpolants", SIAM J.
// Sci. Stat. Comput. 5 (1984) 300-304 (slopes); C. de Boor, "A Practical Guide to Splines" (2001), ch. IV (natural
// spline: continuous second derivative, zero at both ends).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "physim/fidelity.hpp"

namespace physim {

/// y = c0 + c1 s + c2 s^2 + c3 s^3 with s = x - knots[i] between knots i and i + 1; held constant outside.
struct PiecewiseCubic {
  std::vector<double> knots;
  std::vector<std::array<double, 4>> pieces;  // one fewer than knots

  [[nodiscard]] double operator()(double x) const;
};

/// Numbers in order, each once.
[[nodiscard]] std::vector<double> rising(std::vector<double> numbers);

/// The curve through (x[i], y[i]); x strictly rising, at least one point.
[[nodiscard]] PiecewiseCubic interpolate(std::span<const double> x, std::span<const double> y, Interpolation how);

/// A piecewise cubic on equal cells: y = r0 + r1 t + r2 t^2 + r3 t^3, t = (x - start) / cell - i, in cell i.
struct UniformCubic {
  double start = 0;
  double cell = 1;
  std::vector<std::array<double, 4>> rows;
};

/// Finds equal cells with borders at every knot, so that nothing is resampled: exact but for rounding.
/// Nothing where that takes more than `max_cells` cells.
[[nodiscard]] std::optional<UniformCubic> on_uniform_cells(const PiecewiseCubic& curve, int max_cells);

}  // namespace physim
