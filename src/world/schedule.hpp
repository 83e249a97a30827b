// Schedules: what is due for projectiles at a time. Launches that wait, and the ends of those that grow old.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "world/slots.hpp"

namespace physim {

/// What is due, and when.
struct Due {
  double time = 0;  // [s]
  ProjectileId id;
};

/// What is due soon is a sorted run, and a heap of those that came since it was sorted, which join it when they are
/// many. What is due later lies in parts of time, unordered: who adds a million does not search all of them for each
/// that is taken. The order in which they are taken follows from times and ids alone.
class Schedule {
 public:
  void add(double time, ProjectileId id) {
    PHYSIM_ASSERT(time == time && id);
    const std::int64_t part = part_of(time);
    if (part > reached_) return later(part).push_back({time, id});
    fresh_.push_back({time, id});
    std::push_heap(fresh_.begin(), fresh_.end(), Later{});
  }
  /// Takes out the next one alive that is due by now, if there is one.
  std::optional<Due> take(double now, const SlotTable& slots) {
    reach(part_of(now));
    if (fresh_.size() > kFew + left() / 8) sort_soon();
    while (const Due* next = next_soon()) {
      if (next->time > now) break;
      const Due due = *next;
      drop(next);
      if (slots.find(due.id)) return due;
    }
    return std::nullopt;
  }
  /// Likewise; null where there is none.
  ProjectileId take_due(double now, const SlotTable& slots) {
    const std::optional<Due> due = take(now, slots);
    return due ? due->id : ProjectileId{};
  }
  /// In no order.
  [[nodiscard]] std::vector<Due> all() const {
    std::vector<Due> list(run_.begin() + static_cast<std::ptrdiff_t>(taken_), run_.end());
    list.insert(list.end(), fresh_.begin(), fresh_.end());
    for (const Part& part : later_) list.insert(list.end(), part.due.begin(), part.due.end());
    return list;
  }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = (run_.capacity() + fresh_.capacity()) * sizeof(Due) + later_.capacity() * sizeof(Part);
    for (const Part& part : later_) sum += part.due.capacity() * sizeof(Due);
    return sum;
  }

 private:
  static constexpr std::size_t kFew = 32;
  struct Later {
    bool operator()(const Due& a, const Due& b) const {
      return a.time != b.time ? a.time > b.time : a.id.index > b.id.index;
    }
  };
  struct Part {
    std::int64_t number;
    std::vector<Due> due;
  };
  static bool is_before(const Due& a, const Due& b) { return Later{}(b, a); }
  /// The number of the part of time that a moment lies in.
  static std::int64_t part_of(double time) {
    constexpr double kPartsPerSecond = 64, kMost = 1e15;
    return static_cast<std::int64_t>(std::floor(std::clamp(time, -kMost, kMost) * kPartsPerSecond));
  }
  /// What is due in a part.
  std::vector<Due>& later(std::int64_t number) {
    if (last_ < later_.size() && later_[last_].number == number) return later_[last_].due;
    const auto at = std::ranges::lower_bound(later_, number, std::ranges::greater{}, &Part::number);
    last_ = static_cast<std::size_t>(at - later_.begin());
    if (at == later_.end() || at->number != number) later_.insert(at, Part{number, {}});
    return later_[last_].due;
  }
  void reach(std::int64_t part) {
    if (part <= reached_) return;
    reached_ = part;
    if (later_.empty() || later_.back().number > part) return;
    for (; !later_.empty() && later_.back().number <= part; later_.pop_back())
      fresh_.insert(fresh_.end(), later_.back().due.begin(), later_.back().due.end());
    sort_soon();
  }

  // ------------------------------------------------------------------------------------------- what is due soon
  [[nodiscard]] std::size_t left() const { return run_.size() - taken_; }
  void sort_soon() {
    if (!std::ranges::is_sorted(fresh_, is_before)) std::ranges::sort(fresh_, is_before);
    run_.erase(run_.begin(), run_.begin() + static_cast<std::ptrdiff_t>(std::exchange(taken_, 0)));
    const auto middle = static_cast<std::ptrdiff_t>(run_.size());
    run_.insert(run_.end(), fresh_.begin(), fresh_.end());
    fresh_.clear();
    if (middle > 0) std::inplace_merge(run_.begin(), run_.begin() + middle, run_.end(), is_before);
  }
  /// The first of them; null: there is none.
  [[nodiscard]] const Due* next_soon() const {
    const Due* const sorted = left() > 0 ? &run_[taken_] : nullptr;
    if (fresh_.empty()) return sorted;
    return sorted != nullptr && !is_before(fresh_.front(), *sorted) ? sorted : fresh_.data();
  }
  void drop(const Due* next) {
    if (next != fresh_.data()) return void(++taken_);
    std::pop_heap(fresh_.begin(), fresh_.end(), Later{});
    fresh_.pop_back();
  }

  std::vector<Due> run_;     // in order
  std::size_t taken_ = 0;    // of these, from the first on
  std::vector<Due> fresh_;   // the first one is due next
  std::vector<Part> later_;  // parts of time that are not reached yet, the last one comes next
  std::size_t last_ = 0;     // of these, to which somebody was added last
  std::int64_t reached_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace physim
