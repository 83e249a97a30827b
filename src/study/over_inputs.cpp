#include "study/over_inputs.hpp"

#include <algorithm>

#include "study/estimates.hpp"

namespace physim {
namespace {

/// One part of one input, over all replicates.
class PartOfInput {
 public:
  PartOfInput(const StudyPlanRecord& plan, const ShardSums& sums, std::size_t place)
      : plan_(plan), sums_(sums), place_(place) {}

  [[nodiscard]] std::uint64_t shots() const {
    std::uint64_t all = 0;
    for (const PartSums& replicate : sums_.over_inputs) all += shots_of(replicate);
    return all;
  }
  [[nodiscard]] HitResult hits_on(std::size_t target) const {
    std::uint64_t hits = 0;
    for (const PartSums& replicate : sums_.over_inputs) hits += hits_of(replicate, target);
    const std::uint64_t all = shots();
    const double whole = static_cast<double>(hits) / static_cast<double>(all);
    std::vector<double> parts;
    for (const PartSums& replicate : sums_.over_inputs)
      if (const std::uint64_t own = shots_of(replicate); own > 0)
        parts.push_back(static_cast<double>(hits_of(replicate, target)) / static_cast<double>(own));
    return hit_result(plan_, target, {hits, all}, whole, parts);
  }

 private:
  [[nodiscard]] std::uint64_t shots_of(const PartSums& replicate) const {
    return replicate.shots.empty() ? 0 : replicate.shots[place_];
  }
  [[nodiscard]] std::uint64_t hits_of(const PartSums& replicate, std::size_t target) const {
    return replicate.hits.empty() ? 0 : replicate.hits[place_ * plan_.study.targets.size() + target];
  }

  const StudyPlanRecord& plan_;
  const ShardSums& sums_;
  std::size_t place_;
};

}  // namespace

void put_edges(StudyPlanRecord& plan) {
  if (!plan.study.over_inputs) return;
  const std::uint32_t parts = *plan.study.over_inputs;
  PHYSIM_ASSERT(parts >= 2 && plan.quantiles.size() == plan.study.inputs.size());
  for (const Quantiles& quantile : plan.quantiles) {
    std::vector<double>& edges = plan.edges.emplace_back();
    for (std::uint32_t i = 1; i < parts; ++i) edges.push_back(quantile(static_cast<double>(i) / parts));
  }
}

PartSums part_sums_of(const StudyPlanRecord& plan, std::span<const std::span<double>> inputs,
                      std::span<const std::uint8_t> hits) {
  const std::size_t targets = plan.study.targets.size(), shots = inputs[0].size();
  PHYSIM_ASSERT(plan.edges.size() == inputs.size() && hits.size() == targets * shots);
  const std::size_t parts = plan.edges[0].size() + 1;
  PartSums sums;
  sums.shots.resize(inputs.size() * parts);
  sums.hits.resize(inputs.size() * parts * targets);
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    const std::vector<double>& edges = plan.edges[input];
    for (std::size_t i = 0; i < shots; ++i) {
      const auto part = static_cast<std::size_t>(std::ranges::upper_bound(edges, inputs[input][i]) - edges.begin());
      const std::size_t place = input * parts + part;
      ++sums.shots[place];
      for (std::size_t target = 0; target < targets; ++target)
        sums.hits[place * targets + target] += hits[target * shots + i];
    }
  }
  return sums;
}

std::vector<HitsOverInput> hits_over_inputs(const StudyPlanRecord& plan, const ShardSums& sums) {
  std::vector<HitsOverInput> results;
  for (std::size_t input = 0; input < plan.edges.size(); ++input) {
    HitsOverInput over{.input = input};
    const std::vector<double>& edges = plan.edges[input];
    const std::size_t parts = edges.size() + 1;
    for (std::size_t i = 0; i < parts; ++i) {
      const PartOfInput part(plan, sums, input * parts + i);
      const std::uint64_t shots = part.shots();
      if (shots == 0) continue;
      const double middle = (static_cast<double>(i) + 0.5) / static_cast<double>(parts);
      InputPart result{.low = i == 0 ? -kInfinity : edges[i - 1],
                       .middle = plan.quantiles[input](middle),
                       .high = i + 1 == parts ? kInfinity : edges[i],
                       .shots = shots};
      for (std::size_t target = 0; target < plan.study.targets.size(); ++target)
        result.hits.push_back(part.hits_on(target));
      over.parts.push_back(std::move(result));
    }
    results.push_back(std::move(over));
  }
  return results;
}

}  // namespace physim
