// Numbers that belong together: a correlation matrix, and its root.
//
// Symbols: C correlations, symmetric, with ones on the diagonal; L its lower triangular root, C = L L^T; s independent
//   numbers of a normal distribution with deviation 1. L s has deviation 1 and correlations C.
// Source: A.-L. Cholesky's decomposition; G. H. Golub, C. F. Van Loan, Matrix Computations (1996), sec. 4.2.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "physim/result.hpp"

namespace physim {

/// L by rows, n (n + 1) / 2 numbers, of C by rows, n n numbers. An error, which names the entries, where C is no
/// correlation matrix. `names`: of its rows. `place`: where C stands.
[[nodiscard]] Result<std::vector<double>> correlation_root(std::span<const double> matrix,
                                                           std::span<const std::string> names,
                                                           const std::string& place);

/// Puts L s into the place of s: one column for each row.
void correlate(std::span<const double> root, std::span<const std::span<double>> columns);

}  // namespace physim
