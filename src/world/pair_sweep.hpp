// Which paths of a step may touch: boxes around them, sorted along the axis in which they are spread most.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "world/pairs.hpp"

namespace physim {

class PairSweep {
 public:
  explicit PairSweep(const std::vector<Collider>& colliders) : colliders_(colliders) {
    choose_axis();
    for (std::uint32_t i = 0; i < colliders.size(); ++i) {
      order_.push_back({low(i), i});
      widest_ = std::max(widest_, colliders[i].box.high[axis_] - low(i));
    }
    std::sort(order_.begin(), order_.end());
  }

  /// Calls visit(i, j), i < j, for all whose boxes meet.
  template <class Visit>
  void each(const Visit& visit) const {
    for (std::size_t at = 0; at < order_.size(); ++at) {
      const std::uint32_t i = order_[at].second;
      const double high = colliders_[i].box.high[axis_];
      for (std::size_t next = at + 1; next < order_.size() && order_[next].first <= high; ++next) {
        const std::uint32_t j = order_[next].second;
        if (colliders_[i].box.meets(colliders_[j].box)) visit(std::min(i, j), std::max(i, j));
      }
    }
  }

  /// It has another path now.
  void note_new(std::uint32_t i) { new_.push_back(i); }

  /// Calls visit(j) for all others whose boxes meet its own.
  template <class Visit>
  void each_beside(std::uint32_t i, const Visit& visit) const {
    const collide::Bounds& box = colliders_[i].box;
    auto at = std::lower_bound(order_.begin(), order_.end(), Place{box.low[axis_] - widest_, 0});
    for (; at != order_.end() && at->first <= box.high[axis_]; ++at)
      if (at->second != i && !colliders_[at->second].is_new && colliders_[at->second].box.meets(box)) visit(at->second);
    for (const std::uint32_t j : new_)
      if (j != i && colliders_[j].box.meets(box)) visit(j);
  }

 private:
  using Place = std::pair<double, std::uint32_t>;

  [[nodiscard]] double low(std::uint32_t i) const { return colliders_[i].box.low[axis_]; }

  void choose_axis() {
    collide::Bounds all;
    for (const Collider& c : colliders_) all.take(c.box);
    const Vec3d size = all.high - all.low;
    axis_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  const std::vector<Collider>& colliders_;
  std::size_t axis_ = 0;
  std::vector<Place> order_;        // by the low side of the boxes that they had at first
  std::vector<std::uint32_t> new_;  // those that have other boxes now
  double widest_ = 0;               // of the boxes of order_
};

}  // namespace physim
