#include "world/core/pools.hpp"

namespace physim {

void Pools::link(Pool& pool, std::uint32_t slot) {
  if (links_.size() <= slot) links_.resize(slot + std::size_t{1});
  links_[slot] = {pool.newest, 0};
  if (pool.newest != 0) links_[pool.newest].newer = slot;
  pool.newest = slot;
  if (pool.oldest == 0) pool.oldest = slot;
}

void Pools::unlink(Pool& pool, std::uint32_t slot) {
  PHYSIM_ASSERT(slot < links_.size());
  const Link link = links_[slot];
  (link.older != 0 ? links_[link.older].newer : pool.oldest) = link.newer;
  (link.newer != 0 ? links_[link.newer].older : pool.newest) = link.older;
}

void Pools::add_to(Hash& hash) const {
  for (const Pool& pool : pools_) {
    hash.add(pool.count, pool.oldest);
    for (std::uint32_t slot = pool.oldest; slot != 0; slot = links_[slot].newer) hash.add(slot, pool.newest);
  }
}

}  // namespace physim
