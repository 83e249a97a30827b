#include <algorithm>

#include "study/correlation.hpp"
#include "study/draw_job.hpp"
#include "study/plan.hpp"

namespace physim {
namespace {

/// Each number of an occasion becomes those of its rounds, from the last on, as both lie in one column.
void repeat(std::span<double> column, std::size_t rounds) {
  PHYSIM_ASSERT(rounds > 0 && column.size() % rounds == 0);
  for (std::size_t i = column.size(); i-- > 0;) column[i] = column[i / rounds];
}

}  // namespace

void draw(const StudyPlanRecord& plan, const Sampler& sampler, std::uint64_t shard, unsigned first_dimension,
          std::span<const std::span<double>> columns) {
  const Study& study = plan.study;
  PHYSIM_ASSERT(columns.size() == study.inputs.size() && columns[0].size() % study.rounds == 0);
  for (const InputGroup& group : plan.groups) {
    std::vector<std::span<double>> drawn;
    const bool by_occasion = study.inputs[group.inputs[0]].drawn_for == DrawnFor::occasion;
    const std::size_t rounds = by_occasion ? study.rounds : 1;
    for (const std::size_t input : group.inputs) {
      const std::span<double> numbers = columns[input].first(columns[input].size() / rounds);
      sampler.fill(first_dimension + static_cast<unsigned>(input), shard, numbers);
      drawn.push_back(numbers);
    }
    if (!group.root.empty()) {
      for (const auto& numbers : drawn) draw_kernel().normal_quantiles(numbers.data(), numbers.size());
      correlate(group.root, drawn);
    }
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const Quantiles& quantiles = plan.quantiles[group.inputs[i]];
      group.root.empty() ? quantiles.from_units(drawn[i]) : quantiles.from_scores(drawn[i]);
      if (rounds > 1) repeat(columns[group.inputs[i]], rounds);
    }
  }
}

}  // namespace physim
