// Firing: what an emitter lets out at one moment inside of a step, and the order in which that happens.
#pragma once

#include <optional>
#include <queue>
#include <tuple>
#include <utility>

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
  bool operator<(const Firing& other) const { return time != other.time ? time > other.time : key() > other.key(); }

 private:
  [[nodiscard]] std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint64_t, std::uint64_t, std::uint64_t>
  key() const {
    return {emitter, rank, parent_emitter, parent, sub, order};
  }
};

/// What fires next. The first one waits apart: mostly an emitter's next moment comes before anybody else's, and is not
/// sorted in.
class FiringQueue {
 public:
  [[nodiscard]] bool empty() const { return !first_ && others_.empty(); }
  void push(const Firing& firing) {
    PHYSIM_ASSERT(firing.time == firing.time);
    if (!comes_before_all(firing)) return others_.push(firing);
    if (first_) others_.push(*first_);
    first_ = firing;
  }
  /// When the first one is; infinite: there is none [s].
  [[nodiscard]] double next_time() const {
    return first_ ? first_->time : others_.empty() ? kInfinity : others_.top().time;
  }
  /// Whether one that is not in it would be the next.
  [[nodiscard]] bool comes_before_all(const Firing& firing) const {
    return first_ ? *first_ < firing : others_.empty() || others_.top() < firing;
  }
  Firing pop() {
    PHYSIM_ASSERT(!empty());
    if (first_) return *std::exchange(first_, std::nullopt);
    const Firing next = others_.top();
    others_.pop();
    return next;
  }

 private:
  std::optional<Firing> first_;  // before all others
  std::priority_queue<Firing> others_;
};

}  // namespace physim
