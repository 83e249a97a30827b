#include "world/slots.hpp"

#include <algorithm>
#include <bit>

namespace physim {

std::uint32_t SlotTable::take() {
  constexpr std::uint32_t kAhead = 8;
  std::uint32_t index = 0;
  if (free_.size() > 0) {
    index = free_.take();
    PHYSIM_ASSERT(!slots_[index].is(kAlive));
    if (free_.size() > kAhead) prefetch_free(free_.ahead(kAhead));  // they lie all over the memory
  } else {
    index = size();
    free_.reserve(index + std::size_t{1});  // so that whoever leaves asks for no memory
    slots_.emplace_back();
    birth_.push_back(0);
    rest_.emplace_back();
  }
  ++slots_[index].generation;
  return index;
}

void SlotTable::come_alive(std::uint32_t index, std::uint32_t flags) {
  Slot& slot = (*this)[index];
  PHYSIM_ASSERT(!slot.is(kAlive) && (flags & kAlive) == 0);
  slot.flags = kAlive | flags;
  ++alive_;
}

/// Slots are used again in the order they became free, so that what became of a projectile is known for long.
void SlotTable::release(std::uint32_t index, LifeStatus status) {
  Slot& slot = (*this)[index];
  if (slot.is(kAlive)) {
    PHYSIM_ASSERT(alive_ > 0);
    --alive_;
  }
  slot.flags = 0;
  slot.set_status(status);
  slot.row = 0;
  free_.add(index);
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
