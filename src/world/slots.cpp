#include "world/slots.hpp"

namespace physim {

std::uint32_t SlotTable::take() {
  std::uint32_t index = first_free_;
  if (index != 0) {
    PHYSIM_ASSERT(!slots_[index].is(kAlive));
    first_free_ = slots_[index].row;
    if (first_free_ == 0) last_free_ = 0;
    // Slots that were freed at random lie all over the memory: the next one is fetched while this one is filled.
    prefetch_at(&slots_[first_free_]);
    prefetch_at(&birth_[first_free_]);
    prefetch_at(&rest_[first_free_]);
  } else {
    index = size();
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
  if (last_free_ != 0)
    slots_[last_free_].row = index;
  else
    first_free_ = index;
  last_free_ = index;
}

void SlotTable::restore(std::vector<Slot> slots, const std::vector<std::uint32_t>& free) {
  PHYSIM_ASSERT(!slots.empty() && free.size() < slots.size());
  slots_ = std::move(slots);
  birth_.assign(slots_.size(), 0);
  rest_.assign(slots_.size(), {});
  alive_ = size() - 1 - static_cast<std::uint32_t>(free.size());
  first_free_ = free.empty() ? 0 : free.front();
  last_free_ = free.empty() ? 0 : free.back();
  for (std::size_t i = 0; i + 1 < free.size(); ++i) slots_[free[i]].row = free[i + 1];
}

void SlotTable::reserve(std::size_t more) {
  slots_.reserve(slots_.size() + more);
  birth_.reserve(slots_.size() + more);
  rest_.reserve(slots_.size() + more);
}

std::size_t SlotTable::bytes() const {
  return slots_.capacity() * sizeof(Slot) + birth_.capacity() * sizeof(double) + rest_.capacity() * sizeof(Rest);
}

}  // namespace physim
