// Distribution: how likely each value of an uncertain number is.
#pragma once

#include <variant>
#include <vector>

#include "physim/infinity.hpp"
#include "physim/result.hpp"

namespace physim {

/// The bell curve.
struct NormalDistribution {
  double mean = 0;       ///< [unit of the number]
  double deviation = 1;  ///< standard deviation, above 0 [unit of the number]

  bool operator==(const NormalDistribution&) const = default;
};

/// As likely everywhere between two ends.
struct UniformDistribution {
  double low = 0;   ///< [unit of the number]
  double high = 1;  ///< above low [unit of the number]

  bool operator==(const UniformDistribution&) const = default;
};

/// From nothing at the ends up to a peak, in straight lines.
struct TriangularDistribution {
  double low = 0;     ///< [unit of the number]
  double peak = 0.5;  ///< most likely; low <= peak <= high [unit of the number]
  double high = 1;    ///< above low [unit of the number]

  bool operator==(const TriangularDistribution&) const = default;
};

/// A number above zero whose logarithm is normal, by what it has itself.
struct LognormalDistribution {
  double mean = 1;       ///< of the number, above 0 [unit of the number]
  double deviation = 1;  ///< of the number, above 0 [unit of the number]

  bool operator==(const LognormalDistribution&) const = default;
};

/// A bell curve of which only the part between two ends is there. Mean and deviation are those of the whole curve.
struct TruncatedNormalDistribution {
  double mean = 0;          ///< [unit of the number]
  double deviation = 1;     ///< above 0 [unit of the number]
  double low = -kInfinity;  ///< -infinity: none [unit of the number]
  double high = kInfinity;  ///< above low; infinity: none [unit of the number]

  bool operator==(const TruncatedNormalDistribution&) const = default;
};

/// Some values, such as a column of measurements.
struct DiscreteDistribution {
  std::vector<double> values{};   ///< at least one, in any order [unit of the number]
  std::vector<double> weights{};  ///< how likely each is, as parts of their sum; empty: all the same [-]

  bool operator==(const DiscreteDistribution&) const = default;
};

using Distribution = std::variant<NormalDistribution, UniformDistribution, TriangularDistribution,
                                  LognormalDistribution, TruncatedNormalDistribution, DiscreteDistribution>;

/// Says what is wrong with a distribution, by its member.
[[nodiscard]] Status check(const Distribution& distribution);

// The following are told of a distribution that check() finds nothing wrong with; of others they are NaN.

/// [unit of the number]
[[nodiscard]] double mean_of(const Distribution& distribution);
/// [unit of the number, squared]
[[nodiscard]] double variance_of(const Distribution& distribution);
/// The value that a part 0 < p < 1 of all numbers lies below [unit of the number]; p outside: NaN.
[[nodiscard]] double quantile_of(const Distribution& distribution, double p);
/// The part of all numbers that is not above x [-].
[[nodiscard]] double probability_up_to(const Distribution& distribution, double x);

}  // namespace physim
