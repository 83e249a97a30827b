// Distributions made ready to turn columns of evenly spread numbers into columns of their own.
#pragma once

#include <span>
#include <vector>

#include "physim/study.hpp"

namespace physim {

class Quantiles {
 public:
  /// `distribution`: one that check() finds nothing wrong with.
  explicit Quantiles(const Distribution& distribution);

  /// Turns numbers that lie evenly in (0, 1) into numbers of the distribution.
  void from_units(std::span<double> numbers) const;
  /// Turns numbers of a normal distribution with mean 0 and deviation 1 into those as far up in this one.
  void from_scores(std::span<double> numbers) const;
  /// The value below which a part 0 < p < 1 lies.
  [[nodiscard]] double operator()(double p) const;

 private:
  [[nodiscard]] double within_tails(double p) const;
  [[nodiscard]] double listed(double p) const;

  Distribution distribution_;
  double log_mean_ = 0, log_deviation_ = 0;  // of a lognormal number's logarithm
  double below_ = 0, inside_ = 1;            // of a truncated one: parts of the bell curve
  bool mirrored_ = false;                    // it is counted from the upper end, where digits are
  std::vector<double> values_, cumulated_;   // of a discrete one, rising
};

}  // namespace physim
