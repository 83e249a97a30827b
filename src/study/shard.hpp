// One shard of a study: its inputs are drawn, flown and added up; shots are kept where that is asked for alone.
#pragma once

#include <span>
#include <vector>

#include "study/plan.hpp"
#include "study/sums.hpp"

namespace physim {

/// Flies shards, with memory of its own: one for each thread.
class ShardFlyer {
 public:
  explicit ShardFlyer(const StudyPlanRecord& plan) : plan_(plan) {}

  [[nodiscard]] ShardSums fly(std::uint64_t shard);
  /// Its shots one by one.
  [[nodiscard]] StudyShots shots_of(std::uint64_t shard);

 private:
  struct Block {
    std::vector<double> numbers;
    std::vector<std::span<double>> columns;
    void set_size(std::size_t columns_wanted, std::size_t rows);
  };
  ModelTold evaluate(const Block& inputs, Block& quantities);
  void add_arrived(std::uint64_t shard, ShardSums& sums);
  void add_plane(std::uint64_t shard, ShardSums& sums);
  void mark_hits();
  void gather_arrived();
  void add_spreads(ShardSums& sums);
  void add_indices(std::uint64_t shard, IndexSums& sums);
  void add_distances(DistanceSums& sums) const;

  const StudyPlanRecord& plan_;
  ModelScratch scratch_;
  Block inputs_, quantities_;                     // of all shots
  std::vector<std::span<const double>> arrived_;  // quantities of those that arrived ...
  Block gathered_;                                // ... where some did not ...
  std::vector<std::uint32_t> shots_;              // ... and which these are
  std::vector<double> distances_;
  std::vector<std::uint8_t> hits_;                                           // of each target, each shot
  Block other_inputs_, other_quantities_, mixed_inputs_, mixed_quantities_;  // of Sobol indices
};

}  // namespace physim
