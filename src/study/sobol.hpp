// Sobol's sequence, scrambled: points that fill the unit cube more evenly than random ones.
//
// Symbols: v_k direction numbers of a dimension, 52 binary digits behind the point; i index of a point, g = i ^ (i >>
// 1)
//   its Gray code; x = sum over the bits k of g of v_k, without carry. s, a degree and inner coefficients of a
//   primitive polynomial, m_1 ... m_s its first odd numbers; v_k = m_k / 2^k.
// Scrambling: digit r of x becomes digit r plus a random sum of the digits before it (a lower triangular matrix), and
//   all digits a random shift: independent ones for each seed, replicate and dimension. The variance of means is that
//   of Owen's nested scrambling, and it has no cost per point, as it is put into the v_k.
// Source: S. Joe, F. Y. Kuo, "Constructing Sobol Sequences with Better Two-Dimensional Projections", SIAM J. Sci.
//   Comput. 30 (2008) 2635, with the numbers of its file new-joe-kuo-6.21201; J. Matousek, "On the L2-Discrepancy for
//   Anchored Boxes", J. Complexity 14 (1998) 527, sec. 2; A. B. Owen, "Variance with Alternative Scramblings of Digital
//   Nets", ACM Trans. Model. Comput. Simul. 13 (2003) 363.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace physim {

inline constexpr unsigned kSobolDimensions = 64;
inline constexpr unsigned kSobolDigits = 52;

/// One dimension of the sequence.
struct SobolDimension {
  std::array<std::uint64_t, kSobolDigits> directions{};  // v_k, the first digit highest
  std::uint64_t shift = 0;
};

/// A dimension < kSobolDimensions without scrambling.
[[nodiscard]] SobolDimension sobol_dimension(unsigned dimension);
/// The first 2^bits points of a dimension, scrambled; replicates are independent of each other.
[[nodiscard]] SobolDimension scrambled_dimension(std::uint64_t seed, unsigned dimension, std::uint32_t replicate,
                                                 unsigned bits = kSobolDigits);
/// Points first, first + 1, ... below 2^52, in the middle of their cells: 0 < x < 1.
void fill_sobol(const SobolDimension& dimension, std::uint64_t first, std::span<double> numbers);

}  // namespace physim
