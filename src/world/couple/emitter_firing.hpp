// Firing: what an emitter emits at one moment inside of a step, and the order of these moments.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "world/couple/emitter_step.hpp"

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

  /// Whether it comes later, for a queue that has the first on top.
  bool operator<(const Firing& other) const { return time != other.time ? time > other.time : key() > other.key(); }

 private:
  [[nodiscard]] std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint64_t, std::uint64_t, std::uint64_t>
  key() const {
    return {emitter, rank, parent_emitter, parent, sub, order};
  }
};

/// What fires next. The first one waits apart: mostly an emitter's next moment comes before any other, and is not
/// sorted in. Those that came in order are a run, as are next moments of emitters that fire alternately. A heap orders
/// the others by what distinguishes most of them. Each stays where it was put.
class FiringQueue {
  struct Waiting {
    double time;
    std::uint32_t emitter;
    std::uint32_t at;  // in waiting_
  };
  [[nodiscard]] auto is_later() const {
    return [this](const Waiting& a, const Waiting& b) {
      if (a.time != b.time) return a.time > b.time;
      if (a.emitter != b.emitter) return a.emitter > b.emitter;
      return waiting_[a.at] < waiting_[b.at];
    };
  }

 public:
  [[nodiscard]] bool empty() const { return !first_ && !has_others(); }
  void push(const Firing& firing) {
    PHYSIM_ASSERT(firing.time == firing.time);
    if (!comes_before_all(firing)) return wait(firing);
    if (first_) wait(*first_);
    first_ = firing;
  }
  /// When the first one is; infinite: the queue is empty [s].
  [[nodiscard]] double next_time() const {
    return first_ ? first_->time : has_others() ? next_other().time : kInfinity;
  }
  /// Whether one that is not in it would be the next.
  [[nodiscard]] bool comes_before_all(const Firing& firing) const {
    return first_ ? *first_ < firing : !has_others() || waiting_[next_other().at] < firing;
  }
  [[nodiscard]] const Firing& next() const {
    PHYSIM_ASSERT(!empty());
    return first_ ? *first_ : waiting_[next_other().at];
  }
  Firing pop() {
    PHYSIM_ASSERT(!empty());
    if (first_) return *std::exchange(first_, std::nullopt);
    const std::uint32_t at = next_other().at;
    if (is_run_next()) {
      drop_of_run();
    } else {
      std::pop_heap(heap_.begin(), heap_.end(), is_later());
      heap_.pop_back();
    }
    free_.push_back(at);
    return waiting_[at];
  }

 private:
  [[nodiscard]] bool has_others() const { return !run_.empty() || !heap_.empty(); }
  [[nodiscard]] bool is_run_next() const {
    return heap_.empty() || (!run_.empty() && is_later()(heap_.front(), run_[taken_]));
  }
  [[nodiscard]] const Waiting& next_other() const {
    PHYSIM_ASSERT(has_others());
    return is_run_next() ? run_[taken_] : heap_.front();
  }
  void drop_of_run() {
    constexpr std::size_t kFew = 64;
    if (++taken_ < kFew + run_.size() / 2 && taken_ < run_.size()) return;
    run_.erase(run_.begin(), run_.begin() + static_cast<std::ptrdiff_t>(std::exchange(taken_, 0)));
  }
  void wait(const Firing& firing) {
    auto at = static_cast<std::uint32_t>(waiting_.size());
    if (free_.empty()) {
      waiting_.push_back(firing);
    } else {
      at = free_.back();
      free_.pop_back();
      waiting_[at] = firing;
    }
    const Waiting waits{firing.time, firing.emitter, at};
    if (run_.empty() || !is_later()(run_.back(), waits)) return run_.push_back(waits);
    heap_.push_back(waits);
    std::push_heap(heap_.begin(), heap_.end(), is_later());
  }

  std::optional<Firing> first_;  // before all others
  std::vector<Waiting> run_;     // in order, those before taken_ are gone
  std::size_t taken_ = 0;
  std::vector<Waiting> heap_;  // the first one is next
  std::vector<Firing> waiting_;
  std::vector<std::uint32_t> free_;  // places in waiting_
};

}  // namespace physim
