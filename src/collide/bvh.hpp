// A tree of boxes over items: which of them may a segment meet, the nearer ones first?
//
// Built by the surface area heuristic over bins; the same items give the same tree on every machine. A node keeps the
// boxes of four children in float, rounded outwards, and compares them at once; what a segment loses in float is added
// to its radius, so no item is lost.
// Source: I. Wald, "On fast construction of SAH-based bounding volume hierarchies", IEEE Symposium on Interactive Ray
//   Tracing (2007); A. Williams, S. Barrus, R. K. Morley, P. Shirley, "An efficient and robust ray-box intersection
//   algorithm", Journal of Graphics Tools 10 (2005) 49-54; T. Ize, "Robust BVH ray traversal", Journal of Computer
//   Graphics Techniques 2 (2013) 12-27 (how wide the far side must be made).
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "collide/segment.hpp"
#include "math/pack.hpp"
#include "physim/infinity.hpp"

namespace physim::collide {

/// An axis-aligned box; empty where low > high.
struct Bounds {
  Vec3d low{kInfinity, kInfinity, kInfinity};
  Vec3d high{-kInfinity, -kInfinity, -kInfinity};

  void take(const Vec3d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void take(const Bounds& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
  }
  /// Moves all sides out.
  void widen(double by) {
    low -= Vec3d{by, by, by};
    high += Vec3d{by, by, by};
  }
  /// Leaves what lies in another one, too.
  void meet(const Bounds& other) {
    low = {std::max(low.x, other.low.x), std::max(low.y, other.low.y), std::max(low.z, other.low.z)};
    high = {std::min(high.x, other.high.x), std::min(high.y, other.high.y), std::min(high.z, other.high.z)};
  }
  /// The largest coordinate.
  [[nodiscard]] double extent() const {
    double most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) most = std::max({most, std::abs(low[axis]), std::abs(high[axis])});
    return most;
  }
  [[nodiscard]] bool meets(const Bounds& other) const {
    return low.x <= other.high.x && low.y <= other.high.y && low.z <= other.high.z && other.low.x <= high.x &&
           other.low.y <= high.y && other.low.z <= high.z;
  }
  /// Not more than the distance of p.
  [[nodiscard]] double least_distance(const Vec3d& p) const {
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double beyond = std::max({low[axis] - p[axis], p[axis] - high[axis], 0.0});
      square += beyond * beyond;
    }
    return std::sqrt(square) * (1 - 8 * std::numeric_limits<double>::epsilon());
  }
  [[nodiscard]] Vec3d middle() const { return (low + high) * 0.5; }
  /// Half of its surface.
  [[nodiscard]] double area() const {
    const Vec3d d = high - low;
    return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

/// A segment, ready to be compared with boxes.
class BoxTest {
 public:
  explicit BoxTest(const Segment& s)
      : from_(s.from), per_along_{finite_inverse(s.along.x), finite_inverse(s.along.y), finite_inverse(s.along.z)} {
    // A radius is rounded with the coordinates that it is added to.
    if (s.radius > 0) radius_ = s.radius + 8 * std::numeric_limits<double>::epsilon() * s.extent();
  }

  /// Where the segment enters a box; infinite where it passes it, or beyond `reach`.
  [[nodiscard]] const Vec3d& per_along() const { return per_along_; }
  PHYSIM_INLINE double enters(const Bounds& box, double reach) const {
    double in = 0, out = reach;
    cut(box.low.x, box.high.x, from_.x, per_along_.x, in, out);
    cut(box.low.y, box.high.y, from_.y, per_along_.y, in, out);
    cut(box.low.z, box.high.z, from_.z, per_along_.z, in, out);
    return in <= out ? in : kInfinity;
  }

 private:
  /// Three roundings on each side: the far one is moved out by more than they are.
  PHYSIM_INLINE void cut(double low, double high, double from, double per_along, double& in, double& out) const {
    const double one = (low - from - radius_) * per_along, other = (high - from + radius_) * per_along;
    in = std::max(in, std::min(one, other));
    out = std::min(out, std::max(one, other) * (1 + 8 * std::numeric_limits<double>::epsilon()));
  }

  Vec3d from_, per_along_;
  double radius_ = 0;
};

/// Four floats at a time: the same operations on every machine.
using Quad = Pack<float, 4>;
[[nodiscard]] PHYSIM_INLINE Quad larger(const Quad& a, const Quad& b) {
#if defined(__SSE2__)
  Quad c;  // g++ 12 does not see that a selection is one instruction
  c.r[0] = (Quad::Register)_mm_max_ps((__m128)a.r[0], (__m128)b.r[0]);
  return c;
#else
  return max(a, b);
#endif
}
/// A bit for each lane in which a <= b.
[[nodiscard]] PHYSIM_INLINE unsigned lanes_up_to(const Quad& a, const Quad& b) {
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps((__m128)a.r[0], (__m128)b.r[0])));
#else
  unsigned lanes = 0;
  for (int i = 0; i < 4; ++i) lanes |= a[i] <= b[i] ? 1u << i : 0u;
  return lanes;
#endif
}

/// A box of an item to be put into a tree.
struct BvhItem {
  float low[4], high[4];  // the fourth numbers are the bits of the item's own and 0

  BvhItem(const Bounds& box, std::uint32_t number)
      : low{float_below(box.low.x), float_below(box.low.y), float_below(box.low.z), std::bit_cast<float>(number)},
        high{float_above(box.high.x), float_above(box.high.y), float_above(box.high.z), 0} {}
  [[nodiscard]] std::uint32_t number() const { return std::bit_cast<std::uint32_t>(low[3]); }
};

class Bvh {
 public:
  Bvh() = default;
  /// Puts items into the order of its leaves, in which they are visited by their places.
  explicit Bvh(std::span<BvhItem> items);

  [[nodiscard]] std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

  /// Calls visit(place, segment) for each item that the segment may meet; visit shortens segment.reach where farther
  /// items do not matter any more.
  template <class Visit>
  PHYSIM_INLINE void along(Segment& segment, const Visit& visit) const {
    if (nodes_.empty()) return;
    const BoxTest whole(segment);
    const double base = whole.enters(root_, segment.reach);
    if (!(base <= segment.reach)) return;
    const QuadTest test(segment, whole.per_along(), root_, base);
    Waiting stack[kStack];
    int waiting = 0;
    Waiting at{0, 0, 0};
    float reach = test.reach(segment);
    while (true) {
      if (at.count > 0) {
        for (std::uint32_t i = at.first; i < at.first + at.count; ++i) visit(i, segment);
        reach = test.reach(segment);
      } else {
        const Node& node = nodes_[at.first];
        Quad in;
        if (unsigned lanes = test.enters(node, reach, in); lanes != 0) {
          at = node.child(std::countr_zero(lanes), in);
          // The nearest one is walked on to; those beyond wait, the farthest at the bottom.
          for (const int first = waiting; (lanes &= lanes - 1) != 0;) {
            Waiting other = node.child(std::countr_zero(lanes), in);
            if (other.in < at.in) std::swap(at, other);
            PHYSIM_ASSERT(waiting < kStack);
            int place = waiting++;
            for (; place > first && stack[place - 1].in < other.in; --place) stack[place] = stack[place - 1];
            stack[place] = other;
          }
          continue;
        }
      }
      do {
        if (waiting == 0) return;
        at = stack[--waiting];
      } while (at.in > reach);
    }
  }

  /// Calls visit(place) for each item whose box meets another one.
  template <class Visit>
  void overlapping(const Bounds& box, const Visit& visit) const {
    if (nodes_.empty() || !root_.meets(box)) return;
    std::uint32_t stack[kStack];
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
      const Node& node = nodes_[stack[--waiting]];
      for (int lane = 0; lane < 4; ++lane) {
        if (!node.box(lane).meets(box)) continue;
        if (node.count[lane] == 0) {
          PHYSIM_ASSERT(waiting < kStack);
          stack[waiting++] = node.first[lane];
        }
        for (std::uint32_t i = 0; i < node.count[lane]; ++i) visit(node.first[lane] + i);
      }
    }
  }
  /// Calls visit(box) for the boxes of children.
  template <class Visit>
  void boxes(const Visit& visit) const {
    for (const Node& node : nodes_)
      for (int lane = 0; lane < 4; ++lane)
        if (node.plane[lane] <= node.plane[kSides + lane]) visit(node.box(lane));
  }
  /// Calls visit(place, within) for each item whose box is not farther from p than `within`, which visit shortens. With
  /// `kRoughly`, a box that is farther than it is large counts for what is in it.
  template <bool kRoughly = false, class Visit>
  void around(const Vec3d& p, double& within, const Visit& visit) const {
    if (nodes_.empty() || root_.least_distance(p) > within) return;
    const QuadPoint point(p, root_);
    Waiting stack[kStack];
    int waiting = 0;
    stack[waiting++] = {0, 0, 0};
    while (waiting > 0) {
      const Waiting at = stack[--waiting];
      if (static_cast<double>(at.in) > within) continue;
      if (at.count > 0) {
        for (std::uint32_t i = at.first; i < at.first + at.count; ++i) visit(i, within);
        continue;
      }
      const Node& node = nodes_[at.first];
      const Quad distance = point.least_distance(node);
      unsigned lanes = lanes_up_to(distance, Quad(float_above(std::min(within, kFarthest))));
      if (kRoughly) {
        for (unsigned far = lanes & ~lanes_up_to(distance, node.sizes()); far != 0; far &= far - 1) {
          const int lane = std::countr_zero(far);
          within = std::min(within, static_cast<double>(distance[lane]));
          lanes &= ~(1u << lane);
        }
      }
      for (const int first = waiting; lanes != 0; lanes &= lanes - 1) {
        const Waiting child = node.child(std::countr_zero(lanes), distance);
        PHYSIM_ASSERT(waiting < kStack);
        int place = waiting++;
        for (; place > first && stack[place - 1].in < child.in; --place) stack[place] = stack[place - 1];
        stack[place] = child;
      }
    }
  }

 private:
  class Builder;
  static constexpr int kStack = 256;
  static constexpr std::size_t kSides = 12;       // of four boxes, low or high
  static constexpr double kFloatSlack = 0x1p-22;  // what coordinates lose in float, four times

  struct Waiting {
    std::uint32_t first, count;
    float in;
  };

  /// Four children, or fewer: boxes beyond are empty.
  struct alignas(128) Node {
    float plane[2 * kSides];  // low sides by axis and child, then high ones
    std::uint32_t first[4];   // its items' first place, or of an inner child its node
    std::uint8_t count[4];    // of its items; 0: an inner child

    [[nodiscard]] Bounds box(int lane) const {
      const float *low = plane + lane, *high = low + kSides;
      return {{low[0], low[4], low[8]}, {high[0], high[4], high[8]}};
    }
    [[nodiscard]] PHYSIM_INLINE Waiting child(int lane, const Quad& in) const {
      return {first[lane], count[lane], in[lane]};
    }
    /// From corner to corner.
    [[nodiscard]] PHYSIM_INLINE Quad sizes() const {
      Quad sum(0.0f);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Quad size = Quad::load(plane + kSides + 4 * axis) - Quad::load(plane + 4 * axis);
        sum = sum + size * size;
      }
      return sqrt(sum);
    }
  };
  /// A segment from where it enters the tree on, ready to be compared with four boxes in float. What it is rounded to
  /// is added to its radius.
  class QuadTest {
   public:
    QuadTest(const Segment& s, const Vec3d& per_along, const Bounds& root, double base) : base_(base) {
      const Vec3d from = s.at(base);
      double most = root.extent();
      for (std::size_t axis = 0; axis < 3; ++axis) most = std::max(most, std::abs(from[axis]));
      const double slack =
          s.radius + kFloatSlack * (most + s.radius) + 4 * std::numeric_limits<double>::epsilon() * s.extent();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        near_at_[axis] = (per_along[axis] < 0 ? kSides : 0) + 4 * axis;
        far_at_[axis] = (per_along[axis] < 0 ? 0 : kSides) + 4 * axis;
        const double sign = per_along[axis] < 0 ? -1 : 1;
        near_[axis] = Quad(static_cast<float>(from[axis] + sign * slack));
        far_[axis] = Quad(static_cast<float>(from[axis] - sign * slack));
        per_along_[axis] = Quad(static_cast<float>(std::clamp(per_along[axis], -1e30, 1e30)));
      }
    }
    /// As far as boxes are looked at.
    [[nodiscard]] float reach(const Segment& s) const { return float_above(s.reach - base_) * (1 + 0x1p-20f); }
    /// The boxes that are entered, and where.
    PHYSIM_INLINE unsigned enters(const Node& node, float reach, Quad& in) const {
      // Written out for the three axes: g++ keeps the loop, and waits for it at each of them.
      const auto entry = [&](std::size_t i) {
        return (Quad::load(node.plane + near_at_[i]) - near_[i]) * per_along_[i];
      };
      const auto exit = [&](std::size_t i) { return (Quad::load(node.plane + far_at_[i]) - far_[i]) * per_along_[i]; };
      in = larger(entry(2), larger(entry(1), larger(entry(0), Quad(0.0f))));
      const Quad out = min(exit(2), min(exit(1), min(exit(0), Quad(reach))));
      return lanes_up_to(in, out * (1 + 0x1p-20f));
    }

   private:
    Quad near_[3], far_[3], per_along_[3];
    std::size_t near_at_[3], far_at_[3];  // the sides of each axis that are entered and left
    double base_;
  };

  /// A point, ready to be compared with four boxes in float.
  class QuadPoint {
   public:
    QuadPoint(const Vec3d& p, const Bounds& root) {
      const double slack = kFloatSlack * (root.extent() + length(p));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low_[axis] = Quad(static_cast<float>(p[axis] - slack));
        high_[axis] = Quad(static_cast<float>(p[axis] + slack));
      }
    }
    /// Not more than the distances of four boxes; infinite for empty ones.
    [[nodiscard]] PHYSIM_INLINE Quad least_distance(const Node& node) const {
      Quad sum(0.0f);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Quad below = Quad::load(node.plane + 4 * axis) - high_[axis];
        const Quad beyond = larger(larger(low_[axis] - Quad::load(node.plane + kSides + 4 * axis), below), Quad(0.0f));
        sum = sum + beyond * beyond;
      }
      return sqrt(sum) * (1 - 0x1p-20f);
    }

   private:
    Quad low_[3], high_[3];
  };

  std::vector<Node> nodes_;
  Bounds root_;
};

}  // namespace physim::collide
