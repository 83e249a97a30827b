#include "world/core/trails.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/checker.hpp"
#include "math/vec3.hpp"

namespace physim {

const Trails::Ring* Trails::find(std::uint32_t slot, std::uint64_t number) const {
  if (slot >= of_slot_.size() || of_slot_[slot] == 0) return nullptr;
  const Ring& ring = rings_[of_slot_[slot] - 1];
  return ring.count > 0 && ring.slot == slot && ring.number == number ? &ring : nullptr;
}

std::size_t Trails::index_of(const Ring& ring, std::uint32_t i) const {
  PHYSIM_ASSERT(i < most_);
  const auto first = static_cast<std::size_t>(&ring - rings_.data()) * most_;
  return first + (ring.oldest + i) % most_;
}

Trails::Ring& Trails::begin(const TrailDef& def, std::uint32_t slot, std::uint64_t number) {
  PHYSIM_ASSERT(def.points > 0 && (most_ == 0 || most_ == def.points));
  most_ = def.points;
  if (of_slot_.size() <= slot) of_slot_.resize(std::max<std::size_t>(slot + 1, of_slot_.size() * 2));
  std::uint32_t& at = of_slot_[slot];
  if (at != 0) drop(rings_[at - 1]);  // of one that was there before
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(rings_.size()));
    rings_.emplace_back();
    places_.resize(rings_.size() * most_);
  }
  at = free_.back() + 1;
  free_.pop_back();
  rings_[at - 1] = {slot, 0, 0, number};
  return rings_[at - 1];
}

void Trails::push(Ring& ring, const TrailPlace& place) {
  if (ring.count < most_)
    ++ring.count;
  else
    ring.oldest = (ring.oldest + 1) % most_;
  PHYSIM_ASSERT(ring.count > 0 && places_.size() == rings_.size() * most_);
  places_[index_of(ring, ring.count - 1)] = place;
}

void Trails::drop(Ring& ring) {
  const auto index = static_cast<std::uint32_t>(&ring - rings_.data());
  if (of_slot_[ring.slot] == index + 1) of_slot_[ring.slot] = 0;
  ring = {};
  free_.push_back(index);
}

void Trails::note(const TrailDef& def, std::uint32_t slot, std::uint64_t number, const TrailPlace& before,
                  const TrailPlace& now) {
  Ring* ring = const_cast<Ring*>(find(slot, number));
  if (!ring) {
    ring = &begin(def, slot, number);
    push(*ring, before);
  }
  const TrailPlace& last = place_of(*ring, ring->count - 1);
  if (now.time > last.time && length(now.position - last.position) >= def.distance) push(*ring, now);
}

std::vector<SavedTrail> Trails::saved() const {
  std::vector<SavedTrail> all;
  for (const Ring& ring : rings_) {
    if (ring.count == 0) continue;
    SavedTrail& trail = all.emplace_back();
    trail.slot = ring.slot;
    trail.number = ring.number;
    for (std::uint32_t i = 0; i < ring.count; ++i) trail.places.push_back(place_of(ring, i));
  }
  std::ranges::sort(all, {}, &SavedTrail::slot);  // whatever rings they lie in
  return all;
}

bool Trails::restore(const TrailDef& def, const SavedTrail& trail) {
  const bool fits = !trail.places.empty() && trail.places.size() <= def.points && !find(trail.slot, trail.number);
  if (!fits) return false;
  Ring& ring = begin(def, trail.slot, trail.number);
  for (const TrailPlace& place : trail.places) {
    if (!finite(place.position) || !std::isfinite(place.time)) return false;
    push(ring, place);
  }
  return true;
}

std::size_t Trails::bytes() const {
  return rings_.capacity() * sizeof(Ring) + places_.capacity() * sizeof(TrailPlace) +
         (of_slot_.capacity() + free_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace physim
