// Polynomials that stand for a smooth function on an interval.
//
// Interpolation at the Chebyshev points is within a small factor of the best polynomial there is; for an analytic
// function its error falls geometrically with the number of terms. The result is written in powers of
// u = (x - middle) / half width, -1 <= u <= 1, ready for Estrin's scheme.
// Source: L. N. Trefethen, Approximation Theory and Approximation Practice (2013), ch. 3 and 8.
#pragma once

#include <vector>

namespace physim {

/// Fits polynomials of a fixed number of terms. Values at the points go in, powers of u come out: a matrix does it.
class ChebyshevFit {
 public:
  explicit ChebyshevFit(int terms);

  /// Where in -1..1 to evaluate the function.
  [[nodiscard]] const std::vector<double>& points() const { return points_; }
  /// Coefficients of u^0, u^1, ... from the values at the points: row j, as long as there are points, gives that of
  /// u^j.
  [[nodiscard]] const std::vector<double>& matrix() const { return matrix_; }

 private:
  std::vector<double> points_;
  std::vector<double> matrix_;
};

}  // namespace physim
