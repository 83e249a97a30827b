// Means and products of deviations of several quantities, added up part by part.
//
// Symbols: n numbers, m their mean, M = sum of (x - m)(y - m') over them. Two parts a and b with d = m_b - m_a:
//   m = m_a + d n_b / n, M = M_a + M_b + d d' n_a n_b / n. Within a part M is summed about the part's own mean.
// Source: T. F. Chan, G. H. Golub, R. J. LeVeque, "Updating Formulae and a Pairwise Algorithm for Computing Sample
//   Variances", Stanford STAN-CS-79-773 (1979), eqs. 2.1.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace physim {

struct SampleMoments {
  std::uint64_t count = 0;
  std::vector<double> mean;
  std::vector<double> products;  // n (n + 1) / 2, by rows of the upper triangle

  [[nodiscard]] std::size_t size() const { return mean.size(); }
  [[nodiscard]] double product(std::size_t i, std::size_t j) const;
  /// Unbiased [unit of i times unit of j]; 0 of fewer than two.
  [[nodiscard]] double covariance(std::size_t i, std::size_t j) const;
  /// Standard error of the mean of independent numbers; NaN of fewer than two.
  [[nodiscard]] double standard_error(std::size_t i) const;
};

/// Adds up columns of one length.
[[nodiscard]] SampleMoments moments_of(std::span<const std::span<const double>> columns);
/// Takes in another part, of as many quantities or none.
void join(SampleMoments& all, const SampleMoments& more);

}  // namespace physim
