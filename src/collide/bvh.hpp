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

#include "base/prefetch.hpp"
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

  class Walk;

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
    const QuadTest test(segment, whole.per_along(), extent_, base);
    float reach = test.reach(segment);
    Waiting stack[kStack], at{0, 0, 0};
    int waiting = 0;
    for (bool on = true; on;) {
      if (at.count == 0) {
        on = descend(test, reach, at, stack, waiting);
        continue;
      }
      for (std::uint32_t i = at.first; i < at.first + at.count; ++i) visit(i, segment);
      reach = test.reach(segment);
      on = pop(reach, at, stack, waiting);
    }
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

  /// Compares the children of a node and goes on to the nearest of them; those beyond wait, the farthest at the bottom.
  /// False where nothing is left.
  PHYSIM_INLINE bool descend(const QuadTest& test, float reach, Waiting& at, Waiting* stack, int& waiting) const {
    const Node& node = nodes_[at.first];
    Quad in;
    unsigned lanes = test.enters(node, reach, in);
    if (lanes == 0) return pop(reach, at, stack, waiting);
    at = node.child(std::countr_zero(lanes), in);
    for (const int first = waiting; (lanes &= lanes - 1) != 0;) {
      Waiting other = node.child(std::countr_zero(lanes), in);
      if (other.in < at.in) std::swap(at, other);
      PHYSIM_ASSERT(waiting < kStack);
      int place = waiting++;
      for (; place > first && stack[place - 1].in < other.in; --place) stack[place] = stack[place - 1];
      stack[place] = other;
    }
    return true;
  }
  /// Goes on to what waits within reach; false where nothing does.
  PHYSIM_INLINE static bool pop(float reach, Waiting& at, const Waiting* stack, int& waiting) {
    do {
      if (waiting == 0) return false;
      at = stack[--waiting];
    } while (at.in > reach);
    return true;
  }

  std::vector<Node> nodes_;
  Bounds root_;
  double extent_ = 0;  // of root_
};

/// Where a segment is on its way through a tree, which may wait there as long as one likes: at a node, or at items.
class Bvh::Walk {
 public:
  /// Goes to the root; false where the segment passes it.
  PHYSIM_INLINE bool begin(const Bvh& tree, const Segment& segment, const BoxTest& whole) {
    if (tree.nodes_.empty()) return false;
    const double base = whole.enters(tree.root_, segment.reach);
    if (!(base <= segment.reach)) return false;
    test_ = QuadTest(segment, whole.per_along(), tree.extent_, base);
    reach_ = test_.reach(segment);
    waiting_ = 0;
    at_ = {0, 0, 0};
    return true;
  }

  [[nodiscard]] bool is_at_items() const { return at_.count > 0; }
  /// The places of its items.
  [[nodiscard]] std::uint32_t first() const { return at_.first; }
  [[nodiscard]] std::uint32_t end() const { return at_.first + at_.count; }

  /// Compares the children of the node that it is at and goes on; false where nothing is left.
  PHYSIM_INLINE bool look(const Bvh& tree) {
    Waiting at = at_;
    int waiting = waiting_;
    const bool on = tree.descend(test_, reach_, at, stack_, waiting);
    at_ = at;
    waiting_ = waiting;
    return on;
  }
  /// Goes on from items, which may have shortened the segment's reach, to what waits; false where nothing does.
  PHYSIM_INLINE bool next(const Segment& segment) {
    reach_ = test_.reach(segment);
    return pop(reach_, at_, stack_, waiting_);
  }
  /// Has the node that it is at brought from memory.
  PHYSIM_INLINE void prefetch(const Bvh& tree) const {
    const auto* node = &tree.nodes_[at_.first];
    prefetch_at(node);
    prefetch_at(node, 64);
  }

 private:
  QuadTest test_;
  Waiting at_;
  float reach_;
  int waiting_;
  Waiting stack_[kStack];
};

}  // namespace physim::collide
