// How likely targets are hit over each input: shots and hits by the part of its distribution that a shot's number is
// in.
//
// Parts are equally likely: their edges are quantiles. Of a list of values (DiscreteDistribution) several edges may be
// one number; parts between them are empty and are left out. Shots that do not arrive are misses, as in all figures.
#pragma once

#include "study/plan.hpp"
#include "study/sums.hpp"

namespace physim {

/// Edges between the parts of each input; none where they are not asked for.
void put_edges(StudyPlanRecord& plan);
/// Sums of a shard, from columns of its inputs, and whether each target was hit by each shot.
[[nodiscard]] PartSums part_sums_of(const StudyPlanRecord& plan, std::span<const std::span<double>> inputs,
                                    std::span<const std::uint8_t> hits);
[[nodiscard]] std::vector<HitsOverInput> hits_over_inputs(const StudyPlanRecord& plan, const ShardSums& sums);

}  // namespace physim
