// Schedules: what is due for projectiles at a time. Launches that wait, and the ends of those that grow old.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/append.hpp"
#include "world/core/slots.hpp"

namespace physim {

/// What is due, and when.
struct Due {
  double time = 0;  // [s]
  ProjectileId id;
};

/// What is due soon is a sorted run, and a heap of those that came since it was sorted, which join it when they are
/// many. What is due later lies in parts of time, unordered: adding a million does not search all of them for each
/// that is taken. The order in which they are taken follows from times and ids alone.
class Schedule {
 public:
  void add(double time, ProjectileId id) {
    PHYSIM_ASSERT(time == time && id);
    const std::int64_t part = part_of(time);
    if (part > reached_) return append(later(part), {time, id});
    append(fresh_, {time, id});
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
  /// As take(); null if nothing is due.
  ProjectileId take_due(double now, const SlotTable& slots) {
    const std::optional<Due> due = take(now, slots);
    return due ? due->id : ProjectileId{};
  }
  /// In no order.
  [[nodiscard]] std::vector<Due> all() const {
    std::vector<Due> list(run_.begin() + static_cast<std::ptrdiff_t>(taken_), run_.end());
    list.insert(list.end(), fresh_.begin(), fresh_.end());
    for (const auto& [part, due] : later_) list.insert(list.end(), due.begin(), due.end());
    return list;
  }
  /// As they are saved: the same regardless of their history.
  [[nodiscard]] std::vector<Due> in_order() const {
    std::vector<Due> list = all();
    std::ranges::sort(list, {}, [](const Due& due) { return std::tuple(due.time, due.id.index, due.id.generation); });
    return list;
  }
  [[nodiscard]] std::size_t bytes() const {
    constexpr std::size_t kLinks = 4 * sizeof(void*);  // of each part in the tree of them
    std::size_t sum = (run_.capacity() + fresh_.capacity()) * sizeof(Due);
    for (const auto& part : later_) sum += sizeof part + kLinks + part.second.capacity() * sizeof(Due);
    return sum;
  }

 private:
  static constexpr std::size_t kFew = 32;
  struct Later {
    bool operator()(const Due& a, const Due& b) const {
      return a.time != b.time ? a.time > b.time : a.id.index > b.id.index;
    }
  };
  /// The part of the last insertion: the next one mostly belongs there, too. A copy of a schedule has its own
  /// parts.
  struct Recent {
    std::int64_t number = 0;
    std::vector<Due>* due = nullptr;

    Recent() = default;
    Recent(const Recent&) {}
    Recent& operator=(const Recent&) {
      due = nullptr;
      return *this;
    }
  };
  static bool is_before(const Due& a, const Due& b) { return Later{}(b, a); }
  /// The number of the part of time that a moment lies in.
  static std::int64_t part_of(double time) {
    constexpr double kPartsPerSecond = 64, kMost = 1e15;
    return static_cast<std::int64_t>(std::floor(std::clamp(time, -kMost, kMost) * kPartsPerSecond));
  }
  /// What is due in a part.
  std::vector<Due>& later(std::int64_t number) {
    if (recent_.due == nullptr || recent_.number != number) {
      recent_.number = number;
      recent_.due = &later_[number];
    }
    return *recent_.due;
  }
  void reach(std::int64_t part) {
    if (part <= reached_) return;
    reached_ = part;
    if (later_.empty() || later_.begin()->first > part) return;
    for (auto at = later_.begin(); at != later_.end() && at->first <= part; at = later_.erase(at))
      fresh_.insert(fresh_.end(), at->second.begin(), at->second.end());
    recent_.due = nullptr;
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
  /// The first of them; null: none.
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

  std::vector<Due> run_;                            // in order
  std::size_t taken_ = 0;                           // of these, from the first on
  std::vector<Due> fresh_;                          // the first one is due next
  std::map<std::int64_t, std::vector<Due>> later_;  // by the number of parts of time that are not reached yet
  Recent recent_;                                   // of these
  std::int64_t reached_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace physim
