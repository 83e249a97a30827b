#include "world/generators.hpp"

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

void Generators::add_to(Hash& hash) const {
  for (const std::uint32_t index : order_) {
    const Generator& g = all_[index];
    hash.add(hash_of(index, g.begun, g.start, g.end, g.def, g.except));
  }
  for (const Generator& g : all_) hash.add(std::uint64_t{g.generation});
  for (const std::uint32_t index : free_) hash.add(std::uint64_t{index});
}

}  // namespace physim
