// One shard of a study: its inputs are drawn, flown and added up; shots are kept where that is asked for alone.
#pragma once

#include <memory>

#include "study/plan.hpp"
#include "study/sums.hpp"

namespace physim {

/// Flies shards, with its own memory: one for each thread.
class ShardFlyer {
 public:
  explicit ShardFlyer(const StudyPlanRecord& plan) : plan_(plan), memory_(plan.spare->take()) {
    for (const StudyPlanRecord& place : plan.places) places_.push_back(std::make_unique<ShardFlyer>(place));
  }
  ShardFlyer(const ShardFlyer&) = delete;
  ShardFlyer& operator=(const ShardFlyer&) = delete;
  ~ShardFlyer() { plan_.spare->give_back(std::move(memory_)); }

  [[nodiscard]] ShardSums fly(std::uint64_t shard);
  /// Its shots one by one.
  [[nodiscard]] StudyShots shots_of(std::uint64_t shard);

 private:
  using Columns = std::span<const std::span<double>>;
  /// Into its own block, and that of each place.
  ModelTold evaluate(const ShotBlock& inputs, ShotBlock ShardMemory::*into);
  [[nodiscard]] ShardSums add_up(std::uint64_t shard, const ModelTold& told, Columns inputs);
  [[nodiscard]] StudyShots shots_told();
  void add_arrived(std::uint64_t shard, ShardSums& sums);
  void add_plane(std::uint64_t shard, ShardSums& sums);
  void add_worst(std::uint64_t shard, ShardSums& sums) const;
  void mark_hits();
  void gather_arrived();
  void add_spreads(ShardSums& sums);
  void add_indices(std::uint64_t shard, ShardSums& sums);
  void add_indices_of(std::size_t group, ShardSums& sums, std::size_t replicate) const;
  void add_distances(DistanceSums& sums) const;

  const StudyPlanRecord& plan_;
  std::unique_ptr<ShardMemory> memory_;
  ShardMemory& m_ = *memory_;
  std::vector<std::unique_ptr<ShardFlyer>> places_;  // which add up what this one flies
};

}  // namespace physim
