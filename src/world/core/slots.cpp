#include "world/core/slots.hpp"

#include <algorithm>
#include <bit>

#include "base/append.hpp"

namespace physim {

std::uint32_t SlotTable::take_new() {
  const std::uint32_t index = size();
  free_.reserve(index + std::size_t{1});                            // so that leaving projectiles need no memory
  make_room(slots_, 1), make_room(birth_, 1), make_room(rest_, 1);  // all of them or none
  slots_.emplace_back();
  birth_.push_back(0);
  rest_.emplace_back();
  slots_[index].generation = 1;
  return index;
}

void FreeSlots::reserve(std::size_t slots) {
  if (slots <= ring_.size()) return;
  std::vector<std::uint32_t> larger(std::bit_ceil(std::max<std::size_t>(16, slots)));
  for (std::uint32_t i = 0; i < count_; ++i) larger[i] = ahead(i);
  ring_ = std::move(larger);
  first_ = 0;
}

void SlotTable::restore(std::vector<Slot> slots, const std::vector<std::uint32_t>& free) {
  PHYSIM_ASSERT(!slots.empty() && free.size() < slots.size());
  slots_ = std::move(slots);
  birth_.assign(slots_.size(), 0);
  rest_.assign(slots_.size(), {});
  alive_ = size() - 1 - static_cast<std::uint32_t>(free.size());
  free_ = {};
  free_.reserve(slots_.size());
  for (const std::uint32_t index : free) free_.add(index);
}

void SlotTable::reserve(std::size_t more) {
  free_.reserve(slots_.size() + more);
  slots_.reserve(slots_.size() + more);
  birth_.reserve(slots_.size() + more);
  rest_.reserve(slots_.size() + more);
}

std::size_t SlotTable::bytes() const {
  return slots_.capacity() * sizeof(Slot) + birth_.capacity() * sizeof(double) + rest_.capacity() * sizeof(Rest) +
         free_.bytes();
}

}  // namespace physim
