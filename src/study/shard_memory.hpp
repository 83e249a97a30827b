// Memory that shards of a study are flown in: some hundred kilobytes, which a shard leaves to the next one.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "study/model.hpp"

namespace physim {

/// Columns of numbers, side by side.
struct ShotBlock {
  std::vector<double> numbers;
  std::vector<std::span<double>> columns;
  void set_size(std::size_t columns_wanted, std::size_t rows);
};

/// What a thread flies shards in.
struct ShardMemory {
  ModelScratch scratch;
  ShotBlock inputs, quantities;                  // of all shots
  std::vector<std::span<const double>> arrived;  // quantities of those that arrived ...
  ShotBlock gathered;                            // ... where some did not ...
  std::vector<std::uint32_t> shots;              // ... and which these are
  std::vector<double> distances;
  std::vector<std::uint8_t> hits;                                            // of each target, each shot
  ShotBlock other_inputs, other_quantities, mixed_inputs, mixed_quantities;  // of Sobol indices
};

/// Memory that is not in use at the moment. A study is flown shard by shard, and many times: allocating it
/// again took as long as drawing two of a shot's inputs.
class SpareMemory {
 public:
  [[nodiscard]] std::unique_ptr<ShardMemory> take() {
    const std::lock_guard lock(mutex_);
    if (spare_.empty()) return std::make_unique<ShardMemory>();
    auto memory = std::move(spare_.back());
    spare_.pop_back();
    return memory;
  }
  void give_back(std::unique_ptr<ShardMemory> memory) {
    PHYSIM_ASSERT(memory != nullptr);
    const std::lock_guard lock(mutex_);
    spare_.push_back(std::move(memory));
  }
  [[nodiscard]] std::size_t count() const {
    const std::lock_guard lock(mutex_);
    return spare_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<ShardMemory>> spare_;
};

}  // namespace physim
