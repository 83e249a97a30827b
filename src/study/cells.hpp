// Counting numbers in cells that are fine about a centre and grow with the distance from it.
//
// Symbols: y = (x - centre) / scale, t = 1 + |y|. The cell of y >= 0 is what the exponent and the first 8 binary digits
//   of t say, k = 0, 1, ...; that of y < 0 is -1 - k. A cell is at most t / 256 wide in y.
// Source: the mapping of DDSketch (C. Masson, J. E. Rim, H. K. Lee, "DDSketch: A Fast and Fully-Mergeable Quantile
//   Sketch", Proc. VLDB 12 (2019) 2195) by bits in the place of logarithms, about a centre.
#pragma once

#include <span>

#include "physim/study.hpp"
#include "study/shard_job.hpp"

namespace physim {

/// Counts numbers, none of which is NaN. Beyond 2^40 scales they count as that far.
void count_into(CountedCells& cells, std::span<const double> numbers);
/// Counts numbers with a known least and most.
void count_into(CountedCells& cells, std::span<const double> numbers, const LeastAndMost& ends);
/// Adds the counts of cells with the same centre and scale.
void join(CountedCells& cells, const CountedCells& others);

}  // namespace physim
