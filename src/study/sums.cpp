#include "study/sums.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "study/cells.hpp"

namespace physim {
namespace {

void join_distances(DistanceSums& all, const DistanceSums& more) {
  join(all.moments, more.moments);
  join(all.cells, more.cells);
}

template <class T>
void add_each(std::vector<T>& all, const std::vector<T>& more) {
  if (all.empty()) all.resize(more.size());
  PHYSIM_ASSERT(more.empty() || all.size() == more.size());
  for (std::size_t i = 0; i < more.size(); ++i) all[i] += more[i];
}

void join_replicate(Replicate& all, const Replicate& more) {
  all.shots += more.shots;
  join(all.moments, more.moments);
  add_each(all.hits, more.hits);
  add_each(all.indices.counts, more.indices.counts);
  add_each(all.indices.first, more.indices.first);
  add_each(all.indices.total, more.indices.total);
}

void join_distances(ReplicateDistances& all, const ReplicateDistances& more) {
  join(all.from_aim, more.from_aim);
  join(all.from_centre, more.from_centre);
  join(all.in_space, more.in_space);
  if (all.spreads.empty()) all.spreads.resize(more.spreads.size());
  PHYSIM_ASSERT(more.spreads.empty() || all.spreads.size() == more.spreads.size());
  for (std::size_t i = 0; i < more.spreads.size(); ++i) join(all.spreads[i], more.spreads[i]);
}

/// The first is kept, then each that has a tenth more shots than the one before: some 300 of them for 10^15 shots. The
/// last of all is always there.
void thin(std::vector<StageSums>& stages) {
  PHYSIM_ASSERT(!stages.empty());
  std::vector<StageSums> kept;
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (kept.empty() || i + 1 == stages.size() || 10 * stages[i].shots >= 11 * kept.back().shots)
      kept.push_back(std::move(stages[i]));
  stages = std::move(kept);
}

void join_stages(std::vector<StageSums>& all, const std::vector<StageSums>& later) {
  PHYSIM_ASSERT(!all.empty() && !later.empty());
  const StageSums before = all.back();
  for (const StageSums& stage : later) {
    StageSums& sum = all.emplace_back(before);
    sum.shots += stage.shots;
    add_each(sum.hits, stage.hits);
    join(sum.distance, stage.distance);
  }
  thin(all);
}

bool is_worse(const SumOfShot& a, const SumOfShot& b) {
  return a.distance != b.distance ? a.distance > b.distance : a.shot < b.shot;
}

}  // namespace

void put_worst(std::vector<SumOfShot>& shots, const SumOfShot& shot) {
  PHYSIM_ASSERT(shots.size() <= kWorstShots);
  shots.insert(std::ranges::upper_bound(shots, shot, is_worse), shot);
  if (shots.size() > kWorstShots) shots.pop_back();
}

void keep_worst(std::vector<SumOfShot>& shots) {
  PHYSIM_ASSERT(shots.size() <= 2 * kWorstShots);
  const auto kept = shots.begin() + static_cast<std::ptrdiff_t>(std::min(kWorstShots, shots.size()));
  std::partial_sort(shots.begin(), kept, shots.end(), is_worse);
  shots.erase(kept, shots.end());
}

void join(ShardSums& all, const ShardSums& later) {
  PHYSIM_ASSERT(all.cells.size() == later.cells.size() && all.spreads.size() == later.spreads.size());
  PHYSIM_ASSERT(all.replicates.size() == later.replicates.size());
  all.shots += later.shots;
  all.refused += later.refused;
  all.not_arrived += later.not_arrived;
  if (!all.refusal) all.refusal = later.refusal;
  join(all.moments, later.moments);
  for (std::size_t i = 0; i < all.cells.size(); ++i) join(all.cells[i], later.cells[i]);
  join_distances(all.from_aim, later.from_aim);
  join_distances(all.from_centre, later.from_centre);
  join_distances(all.in_space, later.in_space);
  for (std::size_t i = 0; i < all.spreads.size(); ++i) join_distances(all.spreads[i], later.spreads[i]);
  add_each(all.hits, later.hits);
  for (std::size_t i = 0; i < later.reach.size(); ++i)
    if (i < all.reach.size())
      all.reach[i] = std::max(all.reach[i], later.reach[i]);
    else
      all.reach.push_back(later.reach[i]);
  all.worst.insert(all.worst.end(), later.worst.begin(), later.worst.end());
  keep_worst(all.worst);
  for (std::size_t i = 0; i < all.replicates.size(); ++i) join_replicate(all.replicates[i], later.replicates[i]);
  join_stages(all.stages, later.stages);
  PHYSIM_ASSERT(all.over_inputs.size() == later.over_inputs.size());
  for (std::size_t i = 0; i < all.over_inputs.size(); ++i) {
    add_each(all.over_inputs[i].shots, later.over_inputs[i].shots);
    add_each(all.over_inputs[i].hits, later.over_inputs[i].hits);
  }
  PHYSIM_ASSERT(all.distances.size() == later.distances.size() && all.places.size() == later.places.size());
  for (std::size_t i = 0; i < all.distances.size(); ++i) join_distances(all.distances[i], later.distances[i]);
  for (std::size_t i = 0; i < all.places.size(); ++i) join(all.places[i], later.places[i]);
}

}  // namespace physim
