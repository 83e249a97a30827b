#include "study/estimates.hpp"

#include <algorithm>

#include "base/ieee_mode.hpp"
#include "math/elementary.hpp"
#include "study/indices.hpp"
#include "study/over_inputs.hpp"
#include "study/shard.hpp"
#include "study/zone.hpp"

namespace physim {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr double kTwoSided = 1.959963984540054;  // normal, 95 %
/// Student's t of 1, 2, ... degrees of freedom, 95 %.
constexpr double kTwoSidedStudent[] = {12.706204736, 4.302652730, 3.182446305, 2.776445105, 2.570581836,
                                       2.446911851,  2.364624252, 2.306004135, 2.262157163, 2.228138852,
                                       2.200985160,  2.178812830, 2.160368656, 2.144786688, 2.131449546};
static_assert(std::size(kTwoSidedStudent) == kReplicates - 1);

/// So many errors is an interval of 95 % wide to each side, by so many replicates ...
double two_sided(std::size_t parts) {
  PHYSIM_ASSERT(parts <= kReplicates);
  return parts < 2 ? kNotKnown : kTwoSidedStudent[parts - 2];
}
/// ... or of shots that know nothing of each other.
double two_sided(const StudyPlanRecord& plan, const ShardSums& sums) {
  PHYSIM_ASSERT(sums.replicates.size() == kReplicates);
  if (plan.is_plain()) return kTwoSided;
  const auto parts = std::ranges::count_if(sums.replicates, [](const Replicate& part) { return part.shots > 0; });
  return two_sided(static_cast<std::size_t>(parts));
}

/// The standard error of the mean of parts, by their differences; NaN of fewer than two.
double error_of(std::span<const double> parts) {
  const auto count = static_cast<double>(parts.size());
  double sum = 0, squares = 0;
  for (const double part : parts) sum += part;
  const double mean = sum / count;
  for (const double part : parts) squares += (part - mean) * (part - mean);
  return count < 2 ? kNotKnown : std::sqrt(squares / (count - 1) / count);
}

/// Replicates that all have as many hits tell nothing of the error: the interval of as many independent shots, or of
/// independent occasions where shots have one in common.
Interval interval_of_equal_replicates(const StudyPlanRecord& plan, const HitCount& count) {
  const std::uint64_t each = plan.shots_in_common();
  PHYSIM_ASSERT(each >= 1 && count.hits <= count.shots);
  return wilson_interval(count.hits / each, count.shots / each);
}

/// The mean of distances or spreads, with the error that independent ones have; else by those of the replicates.
template <class Moments>
Estimate mean_distance(const StudyPlanRecord& plan, const ShardSums& all, const SampleMoments& m,
                       const Moments& of_replicate) {
  if (m.count == 0) return {kNotKnown, kNotKnown};
  if (plan.is_plain()) return {m.mean[0], m.standard_error(0)};
  std::vector<double> means;
  for (const ReplicateDistances& replicate : all.distances)
    if (const SampleMoments* part = of_replicate(replicate); part && part->count > 0) means.push_back(part->mean[0]);
  return {m.mean[0], error_of(means)};
}

RadiusResult radius_result(const StudyPlanRecord& plan, const ShardSums& all, const DistanceSums& sums,
                           SampleMoments ReplicateDistances::*of_replicate) {
  RadiusResult r;
  r.mean = mean_distance(plan, all, sums.moments,
                         [&](const ReplicateDistances& replicate) { return &(replicate.*of_replicate); });
  r.r50 = sums.cells.quantile(0.5);
  r.r90 = sums.cells.quantile(0.9);
  r.r95 = sums.cells.quantile(0.95);
  r.cells = sums.cells;
  return r;
}

/// The axes of the covariance of the plane: eigenvalues of a symmetric 2 x 2 matrix.
EllipseResult ellipse_of(const SampleMoments& m) {
  PHYSIM_ASSERT(m.size() >= 2 && m.count > 0);
  const double a = m.covariance(0, 0), b = m.covariance(0, 1), c = m.covariance(1, 1);
  const double middle = 0.5 * (a + c), half = 0.5 * (a - c), turn = std::sqrt(half * half + b * b);
  return {m.mean[0], m.mean[1], std::sqrt(std::max(0.0, middle + turn)), std::sqrt(std::max(0.0, middle - turn)),
          turn > 0 ? 0.5 * atan2(b, half) : 0};
}

/// Intervals as of independent shots; else by replicates, which a stage does not have.
StudyStage stage_result(const StudyPlanRecord& plan, const StageSums& sums) {
  const bool plain = plan.is_plain(), some = sums.distance.count > 0;
  StudyStage stage{.shots = sums.shots};
  stage.distance = {some ? sums.distance.mean[0] : kNotKnown,
                    some && plain ? sums.distance.standard_error(0) : kNotKnown};
  for (std::size_t i = 0; i < sums.hits.size(); ++i) {
    const double p = static_cast<double>(sums.hits[i]) / static_cast<double>(sums.shots);
    const Interval interval = plain ? wilson_interval(sums.hits[i], sums.shots) : Interval{kNotKnown, kNotKnown};
    const double error = plain ? std::sqrt(p * (1 - p) / static_cast<double>(sums.shots)) : kNotKnown;
    stage.hits.push_back({plan.study.targets[i].name, sums.hits[i], {p, error}, interval.low, interval.high});
  }
  return stage;
}

void put_plane(const StudyPlanRecord& plan, const ShardSums& sums, StudyResult& result) {
  const Study& study = plan.study;
  result.from_aim = radius_result(plan, sums, sums.from_aim, &ReplicateDistances::from_aim);
  result.from_centre = radius_result(plan, sums, sums.from_centre, &ReplicateDistances::from_centre);
  if (sums.moments.count > 0) result.ellipse = ellipse_of(sums.moments);
  for (std::size_t i = 0; i < sums.spreads.size(); ++i) {
    const SampleMoments& m = sums.spreads[i].moments;
    if (m.count == 0) continue;
    const Estimate mean = mean_distance(plan, sums, m, [&](const ReplicateDistances& replicate) {
      return i < replicate.spreads.size() ? &replicate.spreads[i] : nullptr;
    });
    result.spreads.push_back(
        {study.group_sizes[i], m.count, mean, std::sqrt(m.covariance(0, 0)), sums.spreads[i].cells});
  }
  if (plan.is_plain()) result.zone = zone_of(sums.reach, sums.moments.count);
}

}  // namespace

bool QuantityResult::varies() const {
  const IeeeMode mode;
  constexpr double kRounding = 1e-12;
  return deviation > kRounding * std::max(std::abs(least), std::abs(most));
}

Interval wilson_interval(std::uint64_t hits, std::uint64_t shots) {
  PHYSIM_ASSERT(hits <= shots);
  if (shots == 0) return {0, 1};
  const auto n = static_cast<double>(shots);
  const double p = static_cast<double>(hits) / n, zz = kTwoSided * kTwoSided / n;
  const double centre = p + 0.5 * zz, half = kTwoSided * std::sqrt(p * (1 - p) / n + 0.25 * zz / n);
  return {hits == 0 ? 0 : (centre - half) / (1 + zz), hits == shots ? 1 : (centre + half) / (1 + zz)};
}

Estimate mean_of_quantity(const StudyPlanRecord& plan, const ShardSums& sums, std::size_t quantity) {
  const SampleMoments& m = sums.moments;
  if (m.count == 0) return {kNotKnown, kNotKnown};
  if (plan.is_plain()) return {m.mean[quantity], m.standard_error(quantity)};
  const auto mean = [&](const Replicate& part) {
    return part.moments.count > 0 ? part.moments.mean[quantity] : kNotKnown;
  };
  return {m.mean[quantity], over_replicates(sums, mean).error};
}

HitResult hit_result(const StudyPlanRecord& plan, std::size_t target, const HitCount& count, double whole,
                     std::span<const double> parts) {
  PHYSIM_ASSERT(target < plan.study.targets.size() && count.shots > 0);
  HitResult hit{.name = plan.study.targets[target].name, .hits = count.hits};
  if (plan.is_plain()) {
    const Interval interval = wilson_interval(count.hits, count.shots);
    hit.probability = {whole, std::sqrt(whole * (1 - whole) / static_cast<double>(count.shots))};
    hit.low = interval.low, hit.high = interval.high;
    return hit;
  }
  const double error = error_of(parts);
  hit.probability = {whole, error};
  const double half = two_sided(parts.size()) * error;
  hit.low = std::max(0.0, whole - half);
  hit.high = std::min(1.0, whole + half);
  if (error > 0) return hit;
  const Interval interval = interval_of_equal_replicates(plan, count);
  hit.low = std::min(whole, interval.low), hit.high = std::max(whole, interval.high);
  return hit;
}

HitResult hits_on(const StudyPlanRecord& plan, const ShardSums& sums, std::size_t target) {
  PHYSIM_ASSERT(target < plan.study.targets.size() && sums.shots > 0);
  const std::uint64_t hits = sums.hits.empty() ? 0 : sums.hits[target];
  // A refused shot is not a miss.
  const std::uint64_t flown = std::max<std::uint64_t>(sums.shots - sums.refused, 1);
  const double per_flown = static_cast<double>(sums.shots) / static_cast<double>(flown);
  std::vector<double> parts;
  for (const Replicate& part : sums.replicates)
    if (part.shots > 0)
      parts.push_back(per_flown * (part.hits.empty() ? 0.0 : static_cast<double>(part.hits[target])) /
                      static_cast<double>(part.shots));
  return hit_result(plan, target, {hits, flown}, static_cast<double>(hits) / static_cast<double>(flown), parts);
}

double width_of(const StudyPlanRecord& plan, const ShardSums& sums) {
  PHYSIM_ASSERT(plan.study.until_width.has_value());
  const StudyWidth& asked = *plan.study.until_width;
  if (asked.target) {
    const HitResult hit = hits_on(plan, sums, *asked.target);
    return hit.high - hit.low;
  }
  const double error = mean_of_quantity(plan, sums, asked.quantity).error;
  return 2 * two_sided(plan, sums) * error;
}

StudyResult figures_of(const StudyPlanRecord& plan, const ShardSums& sums) {
  const Study& study = plan.study;
  StudyResult result;
  result.shards = sums.shots / study.shard_shots;
  result.shots = sums.shots, result.refused = sums.refused, result.not_arrived = sums.not_arrived;
  if (sums.refusal) result.first_refusal = Error{sums.refusal->message, sums.refusal->place, sums.refusal->hint};
  const std::size_t n = study.quantities.size();
  const bool some = sums.moments.count > 0;
  for (std::size_t q = 0; q < n; ++q)
    result.quantities.push_back({study.quantities[q], mean_of_quantity(plan, sums, q),
                                 some ? std::sqrt(sums.moments.covariance(q, q)) : kNotKnown,
                                 some ? sums.cells[q].least : kNotKnown, some ? sums.cells[q].most : kNotKnown,
                                 sums.cells[q]});
  for (std::size_t i = 0; i < n * n; ++i)
    result.covariance.push_back(some ? sums.moments.covariance(i / n, i % n) : kNotKnown);
  if (plan.has_plane()) put_plane(plan, sums, result);
  for (std::size_t i = 0; i < study.targets.size(); ++i) result.hits.push_back(hits_on(plan, sums, i));
  if (!plan.in_space.empty()) result.in_space = radius_result(plan, sums, sums.in_space, &ReplicateDistances::in_space);
  for (const StageSums& stage : sums.stages) result.stages.push_back(stage_result(plan, stage));
  for (const SumOfShot& shot : sums.worst)
    result.worst.push_back({shot.shot, shot.distance, drawn_by(plan, shot.shot)});
  result.over_inputs = hits_over_inputs(plan, sums);
  if (study.indices && some) result.indices = indices_of(plan, sums, result.quantities);
  PHYSIM_ASSERT(sums.places.size() == plan.places.size());
  for (std::size_t i = 0; i < plan.places.size(); ++i) result.at.push_back(figures_of(plan.places[i], sums.places[i]));
  return result;
}

}  // namespace physim
