// Which paths of a step may touch: boxes around them, in columns of cells across the axis in which they are spread
// most, sorted along it in each column. A cell is about twice as wide as boxes are by and large, so that each lies in
// few.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/assert.hpp"
#include "world/couple/pairs.hpp"

namespace physim {

class PairSweep {
 public:
  explicit PairSweep(const std::vector<Collider>& colliders) : colliders_(colliders) {
    choose_cells();
    boxes_.reserve(colliders.size());
    for (std::uint32_t i = 0; i < colliders.size(); ++i) {
      boxes_.push_back(colliders[i].box);
      const collide::Bounds& box = boxes_[i];
      if (!is_there(box)) continue;
      widest_ = std::max(widest_, box.high[along_] - box.low[along_]);
      each_column(box, [&](std::uint64_t column) { places_.push_back({column, box.low[along_], i}); });
    }
    std::sort(places_.begin(), places_.end());
  }

  /// Calls visit(i, j), i < j, for all pairs of boxes that meet.
  template <class Visit>
  void each(const Visit& visit) const {
    for (auto at = places_.begin(); at != places_.end(); ++at) {
      const collide::Bounds& box = boxes_[at->index];
      for (auto next = at + 1; next != places_.end() && next->column == at->column; ++next) {
        if (next->low > box.high[along_]) break;
        const collide::Bounds& other = boxes_[next->index];
        if (box.meets(other) && first_common(box, other) == at->column)
          visit(std::min(at->index, next->index), std::max(at->index, next->index));
      }
    }
  }

  /// It has another path now.
  void note_new(std::uint32_t i) {
    PHYSIM_ASSERT(i < colliders_.size() && colliders_[i].is_new);
    new_.push_back(i);
  }

  /// Calls visit(j) for all others with a box that meets its own.
  template <class Visit>
  void each_beside(std::uint32_t i, const Visit& visit) const {
    PHYSIM_ASSERT(i < colliders_.size());
    const collide::Bounds& box = colliders_[i].box;
    if (!is_there(box)) return;
    each_column(box, [&](std::uint64_t column) {
      auto at = std::lower_bound(places_.begin(), places_.end(), Place{column, box.low[along_] - widest_, 0});
      for (; at != places_.end() && at->column == column && at->low <= box.high[along_]; ++at) {
        const collide::Bounds& other = boxes_[at->index];
        if (box.meets(other) && first_common(box, other) == column && at->index != i && !colliders_[at->index].is_new)
          visit(at->index);
      }
    });
    for (const std::uint32_t j : new_)
      if (j != i && colliders_[j].box.meets(box)) visit(j);
  }

 private:
  struct Place {
    std::uint64_t column;
    double low;  // side of its box along the axis
    std::uint32_t index;

    bool operator<(const Place& other) const {
      if (column != other.column) return column < other.column;
      return low != other.low ? low < other.low : index < other.index;
    }
  };
  /// Cells across one axis.
  struct Cells {
    std::size_t axis = 0;
    double start = 0, size = 0;
    double last = 0;  // the number of the last one

    /// Where a coordinate lies; those outside are in the outermost ones.
    [[nodiscard]] std::uint32_t of(double x) const {
      return last > 0 ? static_cast<std::uint32_t>(std::clamp(std::floor((x - start) / size), 0.0, last)) : 0;
    }
  };

  [[nodiscard]] static bool is_there(const collide::Bounds& box) { return box.low.x <= box.high.x; }
  [[nodiscard]] static std::uint64_t column_of(std::uint32_t i, std::uint32_t j) { return std::uint64_t{i} << 32 | j; }

  void choose_cells() {
    collide::Bounds all;
    Vec3d sizes;
    double count = 0;
    for (const Collider& c : colliders_) {
      if (!is_there(c.box)) continue;
      all.take(c.box);
      sizes += c.box.high - c.box.low;
      ++count;
    }
    if (count == 0) return;
    const Vec3d spread = all.high - all.low;
    along_ = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t axis = (along_ + 1 + k) % 3;
      const double size = std::max(2 * sizes[axis] / count, spread[axis] / std::sqrt(count));
      across_[k] = {axis, all.low[axis], size, size > 0 ? std::floor(spread[axis] / size) : 0.0};
    }
  }

  template <class F>
  void each_column(const collide::Bounds& box, const F& f) const {
    const Cells &one = across_[0], &other = across_[1];
    for (std::uint32_t i = one.of(box.low[one.axis]); i <= one.of(box.high[one.axis]); ++i)
      for (std::uint32_t j = other.of(box.low[other.axis]); j <= other.of(box.high[other.axis]); ++j)
        f(column_of(i, j));
  }
  /// The first column that two boxes share: the pair is reported there.
  [[nodiscard]] std::uint64_t first_common(const collide::Bounds& a, const collide::Bounds& b) const {
    const auto first = [&](const Cells& cells) {
      return std::max(cells.of(a.low[cells.axis]), cells.of(b.low[cells.axis]));
    };
    return column_of(first(across_[0]), first(across_[1]));
  }

  const std::vector<Collider>& colliders_;
  std::size_t along_ = 0;
  std::array<Cells, 2> across_{};
  std::vector<collide::Bounds> boxes_;  // that they had at first
  std::vector<Place> places_;           // of these
  std::vector<std::uint32_t> new_;      // those that have other boxes now
  double widest_ = 0;                   // along the axis, of the boxes at first [m]
};

}  // namespace physim
