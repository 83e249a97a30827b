// Sobol indices: which part of a variance comes from which inputs.
//
// Symbols: f a quantity, V its variance; A and B two independent sets of shots, AB shots of A that take one group of
//   inputs from B. First-order index S = mean of f_B (f_AB - f_A) / V, total index T = mean of (f_A - f_AB)^2 / (2 V).
//   f is counted from near its mean, which changes no index and saves digits. An index is a ratio: the error of n / V
//   is that of (n - index V') / V, n and V' of one replicate.
// Source: A. Saltelli et al., "Variance Based Sensitivity Analysis of Model Output", Comput. Phys. Commun. 181 (2010)
//   259, table 2 (b) for S and (f), M. J. W. Jansen's (1999), for T; W. G. Cochran, Sampling Techniques (1977), 6.4,
//   for errors of ratios.
#pragma once

#include <vector>

#include "study/plan.hpp"
#include "study/sums.hpp"

namespace physim {

/// Adds the shots of a block for one group of inputs: columns of each quantity of A, B and AB.
void add_index_sums(const StudyPlanRecord& plan, std::size_t group, std::span<const std::span<double>> a,
                    std::span<const std::span<double>> b, std::span<const std::span<double>> ab, IndexSums& sums);
/// NaN for quantities that do not vary.
[[nodiscard]] std::vector<IndexResult> indices_of(const StudyPlanRecord& plan, const ShardSums& sums,
                                                  const std::vector<QuantityResult>& quantities);

}  // namespace physim
