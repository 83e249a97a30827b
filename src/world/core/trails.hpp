// Trails: the past places of an emitter's particles, each in its own ring. An emitter without a trail has no
// memory here.
#pragma once

#include <cstdint>
#include <vector>

#include "physim/emitter.hpp"

namespace physim {

/// A place where a particle has been.
struct TrailPlace {
  Vec3d position;   // [m]
  double time = 0;  // [s]
};

/// The trail of one particle, as a save holds it.
struct SavedTrail {
  std::uint32_t slot = 0;
  std::uint64_t number = 0;          // of the particle among those of its emitter
  std::vector<TrailPlace> places{};  // from the oldest on
};

class Trails {
 public:
  /// Where a particle is, `now`; of one that is new here, where it was `before`. A place nearer than `def.distance` to
  /// the last one is not noted.
  void note(const TrailDef& def, std::uint32_t slot, std::uint64_t number, const TrailPlace& before,
            const TrailPlace& now);
  /// Drops the trails for which is_gone(slot, number) says so.
  template <class F>
  void drop(const F& is_gone) {
    for (Ring& ring : rings_)
      if (ring.count > 0 && is_gone(ring.slot, ring.number)) drop(ring);
  }
  void clear() { *this = {}; }

  /// Calls f with each place of a particle that is not older than a time, from the oldest on.
  template <class F>
  void each_place(std::uint32_t slot, std::uint64_t number, double since, const F& f) const {
    const Ring* ring = find(slot, number);
    if (!ring) return;
    for (std::uint32_t i = 0; i < ring->count; ++i) {
      const TrailPlace& place = place_of(*ring, i);
      if (place.time >= since) f(place);
    }
  }

  [[nodiscard]] std::vector<SavedTrail> saved() const;
  /// One of a save; false where it makes no sense.
  bool restore(const TrailDef& def, const SavedTrail& trail);
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// Places first .. first + most - 1 of all, of which `count` are taken, the oldest at `oldest`.
  struct Ring {
    std::uint32_t slot = 0, count = 0, oldest = 0;
    std::uint64_t number = 0;
  };
  [[nodiscard]] const Ring* find(std::uint32_t slot, std::uint64_t number) const;
  Ring& begin(const TrailDef& def, std::uint32_t slot, std::uint64_t number);
  void push(Ring& ring, const TrailPlace& place);
  void drop(Ring& ring);
  [[nodiscard]] std::size_t index_of(const Ring& ring, std::uint32_t i) const;
  [[nodiscard]] const TrailPlace& place_of(const Ring& ring, std::uint32_t i) const {
    return places_[index_of(ring, i)];
  }

  std::uint32_t most_ = 0;  // places of a ring
  std::vector<Ring> rings_;
  std::vector<TrailPlace> places_;      // ring by ring
  std::vector<std::uint32_t> of_slot_;  // 1 + the ring of a slot, 0: none
  std::vector<std::uint32_t> free_;     // rings
};

}  // namespace physim
