// Firing: what an emitter lets out at one moment inside of a step, and the order in which that happens.
#pragma once

#include <tuple>

#include "world/emitter_step.hpp"

namespace physim {

/// What fires at one moment. Small: queues move it about.
struct Firing {
  static constexpr std::uint32_t kNothing = ~0u;
  double time = 0;
  std::uint32_t emitter = 0;
  std::uint32_t rank = 0;             // of one moment: its own first, then by distance, then for others
  std::uint64_t parent = 0, sub = 0;  // number of the particle, and which of its subs
  std::uint32_t parent_emitter = 0;
  std::uint32_t by = kNothing;  // a sub-emitter: what set it off, in EmitterScratch::causes
  std::uint64_t order = 0;      // in which they were found
  EmitMoment moment;

  /// Later, for a queue whose top is the first.
  bool operator<(const Firing& other) const { return key() > other.key(); }

 private:
  [[nodiscard]] std::tuple<double, std::uint32_t, std::uint32_t, std::uint32_t, std::uint64_t, std::uint64_t,
                           std::uint64_t>
  key() const {
    return {time, emitter, rank, parent_emitter, parent, sub, order};
  }
};

}  // namespace physim
