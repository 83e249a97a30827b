#include "study/correlation.hpp"

#include <cmath>

#include "base/assert.hpp"
#include "base/text.hpp"

namespace physim {
namespace {

std::string entry_text(std::span<const std::string> names, std::size_t row, std::size_t column) {
  return names[row] + " with " + names[column];
}

Status check_entries(std::span<const double> matrix, std::span<const std::string> names, const std::string& place) {
  const std::size_t n = names.size();
  if (matrix.size() != n * n)
    return Error{"has " + std::to_string(matrix.size()) + " numbers for " + std::to_string(n) + " inputs", place,
                 "give " + std::to_string(n * n) + ", row by row"};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double c = matrix[i * n + j];
      if (i == j && c != 1) return Error{entry_text(names, i, j) + " is " + short_text(c) + ", not 1", place, ""};
      if (!(std::abs(c) <= 1))
        return Error{entry_text(names, i, j) + " is " + short_text(c) + ", not between -1 and 1", place, ""};
      if (c != matrix[j * n + i])
        return Error{
            entry_text(names, i, j) + " is " + short_text(c) + ", the other way round " + short_text(matrix[j * n + i]),
            place, "give both the same number"};
    }
  return {};
}

}  // namespace

Result<std::vector<double>> correlation_root(std::span<const double> matrix, std::span<const std::string> names,
                                             const std::string& place) {
  if (auto status = check_entries(matrix, names, place); !status) return status.error();
  const std::size_t n = names.size();
  constexpr double kLeast = 1e-12;  // of a variance that is not explained by the rows before
  std::vector<double> root(n * (n + 1) / 2);
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return root[i * (i + 1) / 2 + j]; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[i * n + j];
      for (std::size_t k = 0; k < j; ++k) rest -= at(i, k) * at(j, k);
      if (j < i) {
        at(i, j) = rest / at(j, j);
      } else if (rest > kLeast) {
        at(i, i) = std::sqrt(rest);
      } else {
        std::size_t most = 0;
        for (std::size_t k = 1; k < i; ++k)
          if (std::abs(matrix[i * n + k]) > std::abs(matrix[i * n + most])) most = k;
        return Error{"is not positive definite: " + entry_text(names, i, most) + " = " +
                         short_text(matrix[i * n + most]) + " contradicts the correlations before it",
                     place, "no numbers can have all of these correlations; lower them"};
      }
    }
  return root;
}

void correlate(std::span<const double> root, std::span<const std::span<double>> columns) {
  const std::size_t n = columns.size();
  PHYSIM_ASSERT(n > 0 && root.size() == n * (n + 1) / 2);
  for (std::size_t shot = 0; shot < columns[0].size(); ++shot)
    for (std::size_t i = n; i-- > 0;) {  // upwards, as rows need what stands above them
      double sum = 0;
      for (std::size_t j = 0; j <= i; ++j) sum += root[i * (i + 1) / 2 + j] * columns[j][shot];
      columns[i][shot] = sum;
    }
}

}  // namespace physim
