// Figures of a study with their errors.
//
// Symbols: p = h / n hits of n shots, z = 1.96 of 95 %. Wilson's interval: (p + z^2 / 2n +- z sqrt(p (1 - p) / n +
//   z^2 / 4n^2)) / (1 + z^2 / n). A figure of R replicates: their mean, and their deviation over sqrt(R).
// Source: E. B. Wilson, "Probable Inference, the Law of Succession, and Statistical Inference", J. Am. Stat. Assoc. 22
//   (1927) 209; A. B. Owen, Monte Carlo Theory, Methods and Examples, ch. 17.4, for replicates.
#pragma once

#include <cmath>
#include <limits>

#include "study/plan.hpp"
#include "study/sums.hpp"

namespace physim {

inline bool is_finite(double x) { return x - x == 0; }

struct Interval {
  double low, high;
};
[[nodiscard]] Interval wilson_interval(std::uint64_t hits, std::uint64_t shots);

/// How many of a number of shots hit.
struct HitCount {
  std::uint64_t hits, shots;
};
/// The hit probability of a target, `whole` of all shots, with its error: by Wilson of random shots, else by what it is
/// in each of `parts` that know nothing of each other.
[[nodiscard]] HitResult hit_result(const StudyPlanRecord& plan, std::size_t target, const HitCount& count, double whole,
                                   std::span<const double> parts);

/// The mean of a figure over the replicates that have shots, and its error by their differences; NaN of fewer than two.
template <class Figure>
[[nodiscard]] Estimate over_replicates(const ShardSums& sums, const Figure& figure) {
  double count = 0, sum = 0, squares = 0;
  for (const Replicate& part : sums.replicates)
    if (part.shots > 0) sum += figure(part), ++count;
  if (count == 0) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const double mean = sum / count;
  for (const Replicate& part : sums.replicates)
    if (part.shots > 0) squares += (figure(part) - mean) * (figure(part) - mean);
  if (count < 2) return {mean, std::numeric_limits<double>::quiet_NaN()};
  return {mean, std::sqrt(squares / (count - 1) / count)};
}

[[nodiscard]] Estimate mean_of_quantity(const StudyPlanRecord& plan, const ShardSums& sums, std::size_t quantity);
[[nodiscard]] HitResult hits_on(const StudyPlanRecord& plan, const ShardSums& sums, std::size_t target);
/// From end to end of the 95 % interval of what Study::until_width names.
[[nodiscard]] double width_of(const StudyPlanRecord& plan, const ShardSums& sums);
[[nodiscard]] StudyResult figures_of(const StudyPlanRecord& plan, const ShardSums& sums);

}  // namespace physim
