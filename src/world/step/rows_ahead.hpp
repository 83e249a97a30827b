// Rows that want to know how far their way is clear: casts of several together cost less than one by one.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/assert.hpp"
#include "base/unset.hpp"
#include "collide/scene_by_motion.hpp"

namespace physim {

/// What a tube ahead of something is found by.
struct TubeAhead {
  collide::ClearQuery query;
  double room = 0;  // of the tube; 0: none [m]
};

class RowsAhead {
 public:
  [[nodiscard]] bool is_full() const { return count_ == kMost; }
  [[nodiscard]] bool is_empty() const { return count_ == 0; }
  void add(std::uint32_t row, const TubeAhead& ahead) {
    PHYSIM_ASSERT(!is_full());
    rows_[count_] = row;
    room_[count_] = ahead.room;
    (*queries_)[count_++] = ahead.query;
  }
  /// Calls take(row, ahead) for each of them, in the order in which they were added, and forgets them.
  template <class Take>
  void look(const Scene& scene, const Take& take) {
    PHYSIM_ASSERT(count_ <= kMost);
    SceneByMotion(scene).clear_parts(std::span(*queries_).first(count_));
    for (std::size_t i = 0; i < count_; ++i) take(rows_[i], TubeAhead{(*queries_)[i], room_[i]});
    count_ = 0;
  }

 private:
  static constexpr std::size_t kMost = 64;

  std::size_t count_ = 0;
  std::array<std::uint32_t, kMost> rows_;
  std::array<double, kMost> room_;
  Unset<std::array<collide::ClearQuery, kMost>> queries_;
};

}  // namespace physim
