// Pools: limits on how many projectiles of some kinds exist, and which of them make room.
#pragma once

#include <vector>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "physim/body.hpp"

namespace physim {

class Pools {
 public:
  Pools() = default;
  explicit Pools(const std::vector<PoolDef>& defs) {
    for (const PoolDef& def : defs) pools_.push_back({def.maximum, def.when_full == WhenFull::replace_oldest});
  }

  [[nodiscard]] bool is_full(std::uint32_t pool) const { return pools_[pool].count >= pools_[pool].maximum; }
  /// How many more fit before a projectile has to make room.
  [[nodiscard]] std::uint32_t left(std::uint32_t pool) const {
    return is_full(pool) ? 0 : pools_[pool].maximum - pools_[pool].count;
  }
  [[nodiscard]] bool replaces(std::uint32_t pool) const { return pools_[pool].replaces; }
  /// The slot that was spawned first, of a pool that replaces it.
  [[nodiscard]] std::uint32_t oldest(std::uint32_t pool) const {
    PHYSIM_ASSERT(pools_[pool].replaces);
    return pools_[pool].oldest;
  }
  void join(std::uint32_t index, std::uint32_t slot) {
    PHYSIM_ASSERT(index < pools_.size());
    Pool& pool = pools_[index];
    PHYSIM_ASSERT(pool.count < pool.maximum);
    if (pool.replaces) link(pool, slot);
    ++pool.count;
  }
  void leave(std::uint32_t index, std::uint32_t slot) {
    Pool& pool = pools_[index];
    PHYSIM_ASSERT(pool.count > 0);
    --pool.count;
    if (pool.replaces) unlink(pool, slot);
  }
  /// Calls f with the slots of each pool that replaces its oldest, from the oldest on.
  template <class F>
  void each_by_age(const F& f) const {
    for (const Pool& pool : pools_)
      for (std::uint32_t slot = pool.oldest; slot != 0; slot = links_[slot].newer) f(slot);
  }
  [[nodiscard]] std::size_t bytes() const { return links_.capacity() * sizeof(Link); }
  /// The order of replacement in full pools.
  void add_to(Hash& hash) const;

 private:
  struct Pool {
    std::uint32_t maximum = 0;
    bool replaces = false;
    std::uint32_t count = 0;
    std::uint32_t oldest = 0;
    std::uint32_t newest = 0;
  };
  struct Link {
    std::uint32_t older = 0;
    std::uint32_t newer = 0;
  };
  void link(Pool& pool, std::uint32_t slot);
  void unlink(Pool& pool, std::uint32_t slot);

  std::vector<Pool> pools_;
  std::vector<Link> links_;  // by slot, as far as one of a pool that replaces was spawned
};

}  // namespace physim
