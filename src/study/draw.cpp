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

/// Shots for which a group is drawn once.
std::size_t rounds_of(const Study& study, const InputGroup& group) {
  return study.inputs[group.inputs[0]].drawn_for == DrawnFor::occasion ? study.rounds : 1;
}

/// Evenly spread numbers of a group's inputs become what is drawn.
void distribute(const StudyPlanRecord& plan, const InputGroup& group, std::span<const std::span<double>> drawn) {
  PHYSIM_ASSERT(drawn.size() == group.inputs.size());
  if (!group.root.empty()) {
    for (const auto& numbers : drawn) draw_kernel().normals(numbers.data(), numbers.size(), {});
    correlate(group.root, drawn);
  }
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const Quantiles& quantiles = plan.quantiles[group.inputs[i]];
    group.root.empty() ? quantiles.from_units(drawn[i]) : quantiles.from_scores(drawn[i]);
  }
}

/// An input that is drawn alone at random: block by block, which stays in the fastest cache until it is done.
void draw_alone(const StudyPlanRecord& plan, const Sampler& sampler, std::uint64_t shard, unsigned dimension,
                std::size_t input, std::span<double> numbers) {
  constexpr std::size_t kBlock = 1024;
  for (std::size_t i = 0; i < numbers.size(); i += kBlock) {
    const std::span<double> block = numbers.subspan(i, std::min(kBlock, numbers.size() - i));
    sampler.fill_random(dimension, shard * numbers.size() + i, block);
    plan.quantiles[input].from_units(block);
  }
}

}  // namespace

void draw(const StudyPlanRecord& plan, const Sampler& sampler, std::uint64_t shard, unsigned first_dimension,
          std::span<const std::span<double>> columns) {
  const Study& study = plan.study;
  PHYSIM_ASSERT(columns.size() == study.inputs.size() && columns[0].size() % study.rounds == 0);
  for (const InputGroup& group : plan.groups) {
    std::vector<std::span<double>> drawn;
    const std::size_t rounds = rounds_of(study, group);
    const bool alone = group.root.empty() && sampler.sampling == Sampling::random;
    for (const std::size_t input : group.inputs) {
      const std::span<double> numbers = columns[input].first(columns[input].size() / rounds);
      const unsigned dimension = first_dimension + static_cast<unsigned>(input);
      alone ? draw_alone(plan, sampler, shard, dimension, input, numbers) : sampler.fill(dimension, shard, numbers);
      drawn.push_back(numbers);
    }
    if (!alone) distribute(plan, group, drawn);
    for (const std::size_t input : group.inputs)
      if (rounds > 1) repeat(columns[input], rounds);
  }
}

std::vector<double> drawn_by(const StudyPlanRecord& plan, std::uint64_t shot) {
  const Study& study = plan.study;
  const Sampler sampler{study.sampling, study.seed};
  const std::uint64_t shard = shot / study.shard_shots;
  const auto place = static_cast<std::size_t>(shot % study.shard_shots);
  std::vector<double> inputs(study.inputs.size());
  for (const InputGroup& group : plan.groups) {
    std::vector<std::span<double>> drawn;
    const std::size_t rounds = rounds_of(study, group);
    for (const std::size_t input : group.inputs) {
      inputs[input] = sampler.number(static_cast<unsigned>(input), shard, study.shard_shots / rounds, place / rounds);
      drawn.push_back(std::span(inputs).subspan(input, 1));
    }
    distribute(plan, group, drawn);
  }
  return inputs;
}

}  // namespace physim
