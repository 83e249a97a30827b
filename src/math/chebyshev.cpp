#include "math/chebyshev.hpp"

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "math/elementary.hpp"

namespace physim {

namespace {

/// Coefficients of u^j in T_k, row k: T_k+1 = 2 u T_k - T_k-1.
std::vector<std::vector<double>> chebyshev_polynomials(std::size_t n) {
  std::vector<std::vector<double>> t(n, std::vector<double>(n, 0.0));
  for (std::size_t k = 0; k < n; ++k) {
    if (k < 2) t[k][k] = 1;
    for (std::size_t j = 0; k >= 2 && j < n; ++j) t[k][j] = (j > 0 ? 2 * t[k - 1][j - 1] : 0) - t[k - 2][j];
  }
  return t;
}

}  // namespace

ChebyshevFit::ChebyshevFit(int terms) {
  PHYSIM_ASSERT(terms > 0);
  const auto n = static_cast<std::size_t>(terms);
  const auto t = chebyshev_polynomials(n);
  matrix_.assign(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = kPi * (static_cast<double>(i) + 0.5) / terms;
    points_.push_back(cos(angle));
    for (std::size_t k = 0; k < n; ++k) {
      // Weight of the value at point i in the coefficient of T_k, spread over the powers in T_k.
      const double weight = (k == 0 ? 1.0 : 2.0) / terms * cos(static_cast<double>(k) * angle);
      for (std::size_t j = 0; j <= k; ++j) matrix_[j * n + i] += weight * t[k][j];
    }
  }
}

}  // namespace physim
