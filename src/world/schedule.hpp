// Schedules: what is due for projectiles at a time. Launches that wait, and the ends of those that grow old.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "world/slots.hpp"

namespace physim {

/// What is due, and when.
struct Due {
  double time = 0;  // [s]
  ProjectileId id;
};

/// What is due soon is a heap, what is due later lies in parts of time, unordered: who adds a million does not search
/// all of them for each that is taken. The order in which they are taken follows from times and ids alone.
class Schedule {
 public:
  void add(double time, ProjectileId id) {
    PHYSIM_ASSERT(time == time && id);
    const std::int64_t part = part_of(time);
    if (part > reached_) return later_[part].push_back({time, id});
    soon_.push_back({time, id});
    std::push_heap(soon_.begin(), soon_.end(), Later{});
  }
  /// Takes out the next one alive that is due by now, if there is one.
  std::optional<Due> take(double now, const SlotTable& slots) {
    reach(part_of(now));
    while (!soon_.empty() && soon_.front().time <= now) {
      const Due due = soon_.front();
      std::pop_heap(soon_.begin(), soon_.end(), Later{});
      soon_.pop_back();
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
    std::vector<Due> list = soon_;
    for (const auto& [part, due] : later_) list.insert(list.end(), due.begin(), due.end());
    return list;
  }
  [[nodiscard]] std::size_t bytes() const {
    constexpr std::size_t kNode = 72;  // of a part
    std::size_t sum = soon_.capacity() * sizeof(Due);
    for (const auto& [part, due] : later_) sum += kNode + due.capacity() * sizeof(Due);
    return sum;
  }

 private:
  struct Later {
    bool operator()(const Due& a, const Due& b) const {
      return a.time != b.time ? a.time > b.time : a.id.index > b.id.index;
    }
  };
  /// The number of the part of time that a moment lies in.
  static std::int64_t part_of(double time) {
    constexpr double kPartsPerSecond = 64, kMost = 1e15;
    return static_cast<std::int64_t>(std::floor(std::clamp(time, -kMost, kMost) * kPartsPerSecond));
  }
  void reach(std::int64_t part) {
    if (part <= reached_) return;
    reached_ = part;
    while (!later_.empty() && later_.begin()->first <= part) {
      const std::vector<Due>& due = later_.begin()->second;
      soon_.insert(soon_.end(), due.begin(), due.end());
      later_.erase(later_.begin());
    }
    std::make_heap(soon_.begin(), soon_.end(), Later{});
  }

  std::vector<Due> soon_;                           // the first one is due next
  std::map<std::int64_t, std::vector<Due>> later_;  // by parts of time that are not reached yet
  std::int64_t reached_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace physim
