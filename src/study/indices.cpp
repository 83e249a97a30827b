#include "study/indices.hpp"

#include "study/estimates.hpp"

namespace physim {

void add_index_sums(const StudyPlanRecord& plan, std::size_t group, std::span<const std::span<double>> a,
                    std::span<const std::span<double>> b, std::span<const std::span<double>> ab, IndexSums& sums) {
  const std::size_t quantities = a.size(), count = a[0].size();
  sums.counts.resize(plan.groups.size());
  sums.first.resize(plan.groups.size() * quantities);
  sums.total.resize(plan.groups.size() * quantities);
  PHYSIM_ASSERT(group < sums.counts.size() && b.size() == quantities && ab.size() == quantities);
  for (std::size_t i = 0; i < count; ++i) {
    bool arrived = true;
    for (std::size_t q = 0; q < quantities; ++q) arrived = arrived && is_finite(a[q][i] + b[q][i] + ab[q][i]);
    if (!arrived) continue;
    ++sums.counts[group];
    for (std::size_t q = 0; q < quantities; ++q) {
      const double change = ab[q][i] - a[q][i];
      sums.first[group * quantities + q] += (b[q][i] - plan.grids[q].centre) * change;
      sums.total[group * quantities + q] += change * change;
    }
  }
}

std::vector<IndexResult> indices_of(const StudyPlanRecord& plan, const ShardSums& sums,
                                    const std::vector<QuantityResult>& figures) {
  std::vector<IndexResult> results;
  const std::size_t quantities = figures.size();
  PHYSIM_ASSERT(quantities == plan.study.quantities.size());
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t group = 0; group < plan.groups.size(); ++group) {
    IndexResult result{.inputs = plan.groups[group].inputs};
    for (std::size_t q = 0; q < quantities; ++q) {
      if (!figures[q].varies()) {
        result.first.push_back({kNone, kNone}), result.total.push_back({kNone, kNone});
        continue;
      }
      const double variance = sums.moments.covariance(q, q);
      const auto index = [&](std::vector<double> IndexSums::*sum, double factor) {
        const auto share = [&](const Replicate& part) {
          return factor * (part.indices.*sum)[group * quantities + q] /
                 static_cast<double>(part.indices.counts[group]) / variance;
        };
        const double whole = over_replicates(sums, share).value;
        // The variance is of the same shots, and goes up and down with the sums over them.
        const auto off = [&](const Replicate& part) {
          return share(part) - whole * part.moments.covariance(q, q) / variance;
        };
        return Estimate{whole, over_replicates(sums, off).error};
      };
      result.first.push_back(index(&IndexSums::first, 1));
      result.total.push_back(index(&IndexSums::total, 0.5));
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace physim
