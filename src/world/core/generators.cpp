#include "world/core/generators.hpp"

#include <algorithm>

#include "base/archive.hpp"

namespace physim {

ForceId Generators::add(const ForceDef& def, double now) {
  std::uint32_t index;
  if (free_.empty()) {
    index = static_cast<std::uint32_t>(all_.size());
    all_.emplace_back();
  } else {
    index = free_.back();
    free_.pop_back();
  }
  Generator& g = all_[index];
  PHYSIM_ASSERT(!g.active && !g.begun);
  g.active = true;
  g.def = def;
  g.start = now + def.delay;
  g.end = g.start + def.duration;
  order_.push_back(index);
  return {index, g.generation};
}

void Generators::begin(std::uint32_t index, bool in_group) {
  Generator& g = (*this)[index];
  PHYSIM_ASSERT(g.active && !g.begun);
  g.begun = true;
  if (in_group) groups_.push_back(index);
}

void Generators::erase(std::uint32_t index) {
  Generator& g = (*this)[index];
  PHYSIM_ASSERT(g.active);
  std::erase(order_, index);
  std::erase(groups_, index);
  const std::uint32_t generation = g.generation + 1;
  g = {};
  g.generation = generation;
  free_.push_back(index);
}

void Generators::count(std::uint32_t slot, bool on) {
  if (on) {
    ++named_[slot];
  } else if (const auto at = named_.find(slot); at != named_.end() && --at->second == 0) {
    named_.erase(at);
  }
}

bool Generators::restore(std::vector<Generator> all, std::vector<std::uint32_t> free,
                         std::vector<std::uint32_t> order) {
  if (all.empty() || all[0].active || free.size() + order.size() + 1 != all.size()) return false;
  std::vector<bool> seen(all.size());
  const auto fits = [&](std::uint32_t index, bool active) {
    const bool good = index > 0 && index < all.size() && !seen[index] && all[index].active == active;
    if (good) seen[index] = true;
    return good;
  };
  for (const std::uint32_t index : free)
    if (!fits(index, false) || all[index].begun) return false;
  for (const std::uint32_t index : order) {
    if (!fits(index, true)) return false;
    auto& ids = all[index].def.target.ids;
    if (!std::ranges::is_sorted(ids)) return false;
  }
  all_ = std::move(all);
  free_ = std::move(free);
  order_ = std::move(order);
  return true;
}

std::size_t Generators::bytes() const {
  std::size_t bytes = all_.capacity() * sizeof(Generator);
  for (const Generator& g : all_) bytes += (g.def.target.ids.capacity() + g.except.capacity()) * sizeof(ProjectileId);
  return bytes + named_.size() * 32;
}

void Generators::add_to(Hash& hash, const Kinds& kinds) const {
  for (const std::uint32_t index : order_) {
    const Generator& g = all_[index];
    const ForceDef& def = g.def;
    hash.add(hash_of(index, g.begun, g.start, g.end, def.law, def.target.ids, def.target.layers, g.except));
    hash.add(kinds.hash_of(def.target.kind));
  }
  for (const Generator& g : all_) hash.add(std::uint64_t{g.generation});
  for (const std::uint32_t index : free_) hash.add(std::uint64_t{index});
}

}  // namespace physim
