// Linear equations with coefficients near the diagonal, at places that are symmetric: L U without a choice of
// pivots, within the envelope (George & Liu 1981, Computer Solution of Large Sparse Positive Definite Systems, chapter
// 4).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"

namespace physim {

class Envelope {
 public:
  /// One coefficient more, of row i and column j; those of one place are added up.
  struct Coefficient {
    std::uint32_t i = 0;
    std::uint32_t j = 0;
    double value = 0;
  };

  /// Takes n equations apart. What others imply already, or rules out, takes no part: its unknown is 0.
  void factor(std::size_t n, std::span<const Coefficient> coefficients) {
    lay_out(n, coefficients);
    for (std::size_t i = 0; i < n; ++i) reduce(i);
  }

  /// About how many multiplications that took.
  [[nodiscard]] double work() const {
    double work = 0;
    for (std::size_t i = 0; i < first_.size(); ++i) {
      PHYSIM_ASSERT(first_[i] <= i);
      const auto width = static_cast<double>(i - first_[i] + 1);
      work += width * width;
    }
    return work;
  }

  /// From the right hand sides to the unknowns.
  void solve(std::span<double> b) const {
    PHYSIM_ASSERT(b.size() == inverse_.size() && first_.size() == inverse_.size());
    for (std::size_t i = 0; i < b.size(); ++i)
      for (std::size_t j = first_[i]; j < i; ++j) b[i] -= lower_[at(i, j)] * b[j];
    for (std::size_t i = b.size(); i-- > 0;) {
      b[i] *= inverse_[i];
      for (std::size_t j = first_[i]; j < i; ++j) b[j] -= upper_[at(i, j)] * b[i];
    }
  }

 private:
  /// What must be left of a diagonal coefficient when all rows before are taken away, as a part of it [-].
  static constexpr double kLeast = 1e-11;

  /// Place of row i and column j of L, and of row j and column i of U; j <= i.
  [[nodiscard]] std::size_t at(std::size_t i, std::size_t j) const { return begin_[i] + j - first_[i]; }

  void lay_out(std::size_t n, std::span<const Coefficient> coefficients) {
    first_.resize(n);
    begin_.resize(n);
    inverse_.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) first_[i] = i;
    for (const Coefficient& c : coefficients) {
      PHYSIM_ASSERT(c.j < n && c.i < n);
      const std::size_t later = std::max(c.i, c.j);
      first_[later] = std::min<std::size_t>(first_[later], std::min(c.i, c.j));
    }
    std::size_t size = 0;
    for (std::size_t i = 0; i < n; ++i) {
      begin_[i] = size;
      size += i - first_[i] + 1;
    }
    lower_.assign(size, 0);
    upper_.assign(size, 0);
    for (const Coefficient& c : coefficients) {
      if (c.j <= c.i) lower_[at(c.i, c.j)] += c.value;
      if (c.i <= c.j) upper_[at(c.j, c.i)] += c.value;
    }
  }

  /// Row i of L and column i of U, from their coefficients and what stands before them.
  void reduce(std::size_t i) {
    const double whole = upper_[at(i, i)];
    double left = whole;
    for (std::size_t j = first_[i]; j < i; ++j) {
      double l = lower_[at(i, j)], u = upper_[at(i, j)];
      for (std::size_t k = std::max(first_[i], first_[j]); k < j; ++k) {
        l -= lower_[at(i, k)] * upper_[at(j, k)];
        u -= lower_[at(j, k)] * upper_[at(i, k)];
      }
      lower_[at(i, j)] = l * inverse_[j];
      upper_[at(i, j)] = u;
      left -= lower_[at(i, j)] * u;
    }
    inverse_[i] = whole > 0 && left > kLeast * whole ? 1 / left : 0;
  }

  std::vector<std::size_t> first_;  // column of each row's first coefficient
  std::vector<std::size_t> begin_;  // of each row's coefficients
  std::vector<double> lower_;       // L but for its diagonal of ones, row by row
  std::vector<double> upper_;       // U column by column
  std::vector<double> inverse_;     // of U's diagonal; 0: it takes no part
};

}  // namespace physim
