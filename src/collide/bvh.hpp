// A tree of boxes over items: which of them may a segment meet, the nearer ones first?
//
// Built by the surface area heuristic over bins; the same items give the same tree on every machine. A node keeps the
// boxes of four children in float, rounded outwards, and compares them at once; what a segment loses in float is added
// to its radius, so no item is lost.
// Source: I. Wald, "On fast construction of SAH-based bounding volume hierarchies", IEEE Symposium on Interactive Ray
//   Tracing (2007).
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "collide/quad_boxes.hpp"

namespace physim::collide {

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
    if (!nodes_.empty()) along(segment, BoxTest(segment), visit);
  }
  /// Calls them with the test that was made of the segment.
  template <class Visit>
  PHYSIM_INLINE void along(Segment& segment, const BoxTest& whole, const Visit& visit) const {
    if (nodes_.empty()) return;
    const double base = whole.enters(root_, segment.reach);
    if (!(base <= segment.reach)) return;
    walk(QuadTest(segment, whole.per_along(), extent_, base), segment, visit);
  }

  /// Calls visit(place) for each item that may meet a box.
  template <class Visit>
  void overlapping(const Bounds& box, const Visit& visit) const {
    if (nodes_.empty() || !root_.meets(box)) return;
    const QuadOverlap overlap(box);
    std::uint32_t stack[kStack];
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
      const Node& node = nodes_[stack[--waiting]];
      for (unsigned lanes = overlap.meets(node); lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
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
        if (node.plane[lane] <= node.plane[Node::kSides + lane]) visit(node.box(lane));
  }
  /// Calls visit(place, within) for each item whose box is not farther from p than `within`, which visit shortens. With
  /// `kRoughly`, a box that is farther than it is large counts for what is in it.
  template <bool kRoughly = false, class Visit>
  void around(const Vec3d& p, double& within, const Visit& visit) const {
    if (nodes_.empty() || root_.least_distance(p) > within) return;
    const QuadPoint point(p, extent_);
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

  struct Waiting {
    std::uint32_t first, count;
    float in;
  };

  /// Four children, or fewer: boxes beyond are empty.
  struct alignas(128) Node : QuadBoxes {
    std::uint32_t first[4];  // its items' first place, or of an inner child its node
    std::uint8_t count[4];   // of its items; 0: an inner child

    [[nodiscard]] PHYSIM_INLINE Waiting child(int lane, const Quad& in) const {
      return {first[lane], count[lane], in[lane]};
    }
  };

  template <class Visit>
  PHYSIM_INLINE void walk(const QuadTest& test, Segment& segment, const Visit& visit) const {
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

  std::vector<Node> nodes_;
  Bounds root_;
  double extent_ = 0;  // of root_
};

}  // namespace physim::collide
