// A tree of boxes over items: which of them may a segment meet, the nearer ones first?
//
// Built by the surface area heuristic over bins; the same items give the same tree on every machine. A node keeps the
// boxes of eight children in float, rounded outwards, and compares them at once; what a segment loses in float is added
// to its radius, so no item is lost.
// Source: I. Wald, "On fast construction of SAH-based bounding volume hierarchies", IEEE Symposium on Interactive Ray
//   Tracing (2007).
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "collide/bvh_node.hpp"

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
  /// Puts items, at most BvhChild::kMostPlaces, into the order of its leaves, in which they are visited by their
  /// places.
  explicit Bvh(std::span<BvhItem> items);
  /// Puts one more item into it, at a place where none is; false, and the tree has to be built anew, where it would
  /// become too deep.
  [[nodiscard]] bool insert(const Bounds& box, std::uint32_t place);
  /// Takes one out again. False where its place is beside that of others, who may still be asked about it.
  bool remove(const Bounds& box, std::uint32_t place);

  [[nodiscard]] std::size_t bytes() const { return nodes_.capacity() * sizeof(BvhNode); }
  [[nodiscard]] bool is_empty() const { return nodes_.empty(); }
  /// The first one is the root.
  [[nodiscard]] const BvhNode* nodes() const { return nodes_.data(); }
  /// Levels of nodes are never more.
  static constexpr int kMostLevels = 72;

  /// Sets a ray for a segment. Returns the part of the segment from which on it looks at boxes; infinite where the
  /// segment passes them all.
  PHYSIM_INLINE double begin(const Segment& segment, BoxRay& ray) const {
    PHYSIM_ASSERT(!is_empty());
    const Vec3d& p = segment.from;
    const bool is_far = std::max(std::abs(p.x), std::max(std::abs(p.y), std::abs(p.z))) > 2 * extent_;
    // Seen from far away, boxes would be less than what coordinates are rounded to.
    const double base = is_far ? BoxTest(segment).enters(root_, segment.reach) : 0;
    if (base <= segment.reach) {
      ray.set(segment, extent_, base);
      return base;
    }
    return kInfinity;
  }
  /// Calls visit(place, segment) for each item that the segment may meet; visit shortens segment.reach where farther
  /// items do not matter any more.
  template <class Visit>
  PHYSIM_INLINE void along(Segment& segment, const Visit& visit) const {
    if (nodes_.empty()) return;
    BoxRay ray;
    const double base = begin(segment, ray);
    if (base == kInfinity) return;
    Waiting stack[kStack], at{BvhChild(0), 0};
    int waiting = 0;
    for (bool on = true; on;) {
      if (!at.child.has_items()) {
        on = descend(ray, at, stack, waiting);
        continue;
      }
      for (std::uint32_t i = at.child.first(), end = at.child.end(); i < end; ++i) visit(i, segment);
      ray.set_reach(segment.reach, base);
      on = pop(ray.reach, at, stack, waiting);
    }
  }

  /// Calls visit(place) for each item that may meet a box.
  template <class Visit>
  void overlapping(const Bounds& box, const Visit& visit) const {
    if (nodes_.empty() || !root_.meets(box)) return;
    const BoxOverlap overlap(box);
    std::uint32_t stack[kStack];
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
      const BvhNode& node = nodes_[stack[--waiting]];
      for (unsigned lanes = overlap.meets(node); lanes != 0; lanes &= lanes - 1) {
        const BvhChild child(node.child[std::countr_zero(lanes)]);
        if (child.has_items()) {
          for (std::uint32_t i = child.first(), end = child.end(); i < end; ++i) visit(i);
        } else {
          PHYSIM_ASSERT(waiting < kStack);
          stack[waiting++] = child.node();
        }
      }
    }
  }
  /// Calls visit(box) for the boxes of children.
  template <class Visit>
  void boxes(const Visit& visit) const {
    for (const BvhNode& node : nodes_)
      for (int lane = 0; lane < 8; ++lane)
        if (const Bounds box = node.box(lane); box.low.x <= box.high.x) visit(box);
  }
  /// Calls visit(place, within) for each item whose box is not farther from p than `within`, which visit shortens. With
  /// `kRoughly`, a box that is farther than it is large counts for what is in it.
  template <bool kRoughly = false, class Visit>
  void around(const Vec3d& p, double& within, const Visit& visit) const {
    if (nodes_.empty() || root_.least_distance(p) > within) return;
    const BoxPoint point(p, extent_);
    Waiting stack[kStack];
    int waiting = 0;
    stack[waiting++] = {BvhChild(0), 0};
    while (waiting > 0) {
      const Waiting at = stack[--waiting];
      if (static_cast<double>(at.in) > within) continue;
      if (at.child.has_items()) {
        for (std::uint32_t i = at.child.first(), end = at.child.end(); i < end; ++i) visit(i, within);
        continue;
      }
      const BvhNode& node = nodes_[at.child.node()];
      const Octet distance = point.least_distance(node);
      unsigned lanes = lanes_at_most(distance, Octet(float_above(std::min(within, kFarthest))));
      if (kRoughly) {
        for (unsigned far = lanes & ~lanes_at_most(distance, node.sizes()); far != 0; far &= far - 1) {
          const int lane = std::countr_zero(far);
          within = std::min(within, static_cast<double>(distance[lane]));
          lanes &= ~(1u << lane);
        }
      }
      for (const int first = waiting; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        wait({BvhChild(node.child[lane]), distance[lane]}, first, stack, waiting);
      }
    }
  }

 private:
  class Builder;
  static constexpr int kStack = 7 * kMostLevels + 8;

  struct Waiting {
    BvhChild child;
    float in;
  };

  /// Puts one behind those from `first` on that are farther, and before the others.
  PHYSIM_INLINE static void wait(const Waiting& other, int first, Waiting* stack, int& waiting) {
    PHYSIM_ASSERT(waiting < kStack);
    int place = waiting++;
    for (; place > first && stack[place - 1].in < other.in; --place) stack[place] = stack[place - 1];
    stack[place] = other;
  }
  /// Compares the children of a node and goes on to the nearest of them; those beyond wait, the farthest at the bottom.
  /// False where nothing is left.
  PHYSIM_INLINE bool descend(const BoxRay& ray, Waiting& at, Waiting* stack, int& waiting) const {
    const BvhNode& node = nodes_[at.child.node()];
    Octet in;
    unsigned lanes = ray.enters(node, in);
    if (lanes == 0) return pop(ray.reach, at, stack, waiting);
    const auto child = [&](unsigned of) PHYSIM_INLINE_LAMBDA {
      const int lane = std::countr_zero(of);
      return Waiting{BvhChild(node.child[lane]), in[lane]};
    };
    at = child(lanes);
    for (const int first = waiting; (lanes &= lanes - 1) != 0;) {
      Waiting other = child(lanes);
      if (other.in < at.in) std::swap(at, other);
      wait(other, first, stack, waiting);
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

  /// How an item was taken out of what is below a node.
  enum class Taken { none, from_others, alone };
  Taken remove_below(std::uint32_t node, const Bounds& box, std::uint32_t place);
  void measure_root();

  std::vector<BvhNode> nodes_;
  Bounds root_;
  float extent_ = 0;  // of root_
};

}  // namespace physim::collide
