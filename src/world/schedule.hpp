// Schedules: what is due for projectiles at a time. Launches that wait, and the ends of those that grow old.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "world/slots.hpp"

namespace physim {

/// What is due, and when.
struct Due {
  double time = 0;  // [s]
  ProjectileId id;
};

class Schedule {
 public:
  void add(double time, ProjectileId id) {
    PHYSIM_ASSERT(time == time && id);
    heap_.push_back({time, id});
    std::push_heap(heap_.begin(), heap_.end(), is_later);
  }
  /// Takes out the next one alive that is due by now, if there is one.
  std::optional<Due> take(double now, const SlotTable& slots) {
    while (!heap_.empty() && heap_.front().time <= now) {
      const Due due = heap_.front();
      std::pop_heap(heap_.begin(), heap_.end(), is_later);
      heap_.pop_back();
      if (slots.find(due.id)) return due;
    }
    return std::nullopt;
  }
  /// Likewise; null where there is none.
  ProjectileId take_due(double now, const SlotTable& slots) {
    const std::optional<Due> due = take(now, slots);
    return due ? due->id : ProjectileId{};
  }
  [[nodiscard]] const std::vector<Due>& all() const { return heap_; }  // in no order
  [[nodiscard]] std::size_t bytes() const { return heap_.capacity() * sizeof(Due); }

 private:
  static bool is_later(const Due& a, const Due& b) {
    return a.time != b.time ? a.time > b.time : a.id.index > b.id.index;
  }
  std::vector<Due> heap_;  // the first one is due next
};

}  // namespace physim
