// A tree of boxes whose items come, go and move, at a cost that follows its depth.
//
// Where an item goes in is found by the area that boxes grow by; rotations keep the tree as deep as a balanced one.
// Source: E. Catto, "Dynamic Bounding Volume Hierarchies", Game Developers Conference (2019); G. M. Adelson-Velsky,
//   E. M. Landis, "An algorithm for the organization of information", Soviet Mathematics Doklady 3 (1962) 1259-1263.
#pragma once

#include <cstdint>
#include <vector>

#include "collide/bvh.hpp"

namespace physim::collide {

class Tree {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// The leaf of an item, by which it is taken out again.
  std::uint32_t insert(const Bounds& box, std::uint32_t item);
  void remove(std::uint32_t leaf);
  [[nodiscard]] const Bounds& box(std::uint32_t leaf) const {
    PHYSIM_ASSERT(leaf < nodes_.size() && nodes_[leaf].height == 0);
    return nodes_[leaf].box;
  }
  [[nodiscard]] std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }
  /// Levels below the root; -1 where there is nothing.
  [[nodiscard]] int height() const { return root_ == kNone ? -1 : nodes_[root_].height; }

  /// Calls visit(item, segment) for each item whose box a segment may meet, as Bvh::along() does.
  template <class Visit>
  void along(Segment& segment, const Visit& visit) const {
    if (root_ == kNone || !about(segment).meets(nodes_[root_].box)) return;
    const BoxTest test(segment);
    if (!(test.enters(nodes_[root_].box, segment.reach) <= segment.reach)) return;
    const auto enters = [&](std::uint32_t node) { return test.enters(nodes_[node].box, segment.reach); };
    std::uint32_t stack[kDeepest];
    double in[kDeepest];
    int waiting = 0;
    const auto wait = [&](std::uint32_t node, double at) {
      PHYSIM_ASSERT(waiting < kDeepest);
      stack[waiting] = node;
      in[waiting++] = at;
    };
    wait(root_, enters(root_));
    while (waiting > 0) {
      --waiting;
      if (!(in[waiting] <= segment.reach)) continue;
      const Node& node = nodes_[stack[waiting]];
      if (node.height == 0) {
        visit(node.item, segment);
        continue;
      }
      const double left = enters(node.child[0]), right = enters(node.child[1]);
      const bool left_first = left <= right;
      wait(node.child[left_first ? 1 : 0], left_first ? right : left);
      wait(node.child[left_first ? 0 : 1], left_first ? left : right);
    }
  }
  /// Calls visit(item, within) for each item whose box is not farther from p than `within`, which visit shortens.
  template <class Visit>
  void around(const Vec3d& p, double& within, const Visit& visit) const {
    std::uint32_t stack[kDeepest];
    int waiting = 0;
    if (root_ != kNone) stack[waiting++] = root_;
    while (waiting > 0) {
      const Node& node = nodes_[stack[--waiting]];
      if (node.box.least_distance(p) > within) continue;
      if (node.height == 0) {
        visit(node.item, within);
        continue;
      }
      const bool left_first =
          nodes_[node.child[0]].box.least_distance(p) <= nodes_[node.child[1]].box.least_distance(p);
      PHYSIM_ASSERT(waiting + 2 <= kDeepest);
      stack[waiting++] = node.child[left_first ? 1 : 0];
      stack[waiting++] = node.child[left_first ? 0 : 1];
    }
  }
  /// Calls visit(box) for the box of each node.
  template <class Visit>
  void boxes(const Visit& visit) const {
    std::vector<std::uint32_t> waiting;
    if (root_ != kNone) waiting.push_back(root_);
    while (!waiting.empty()) {
      const Node& node = nodes_[waiting.back()];
      waiting.pop_back();
      visit(node.box);
      if (node.height > 0) waiting.insert(waiting.end(), {node.child[1], node.child[0]});
    }
  }
  /// Calls visit(item) for each item whose box meets another one.
  template <class Visit>
  void overlapping(const Bounds& box, const Visit& visit) const {
    std::uint32_t stack[kDeepest];
    int waiting = 0;
    if (root_ != kNone) stack[waiting++] = root_;
    while (waiting > 0) {
      const Node& node = nodes_[stack[--waiting]];
      if (!node.box.meets(box)) continue;
      if (node.height == 0) {
        visit(node.item);
        continue;
      }
      PHYSIM_ASSERT(waiting + 2 <= kDeepest);
      stack[waiting++] = node.child[1];
      stack[waiting++] = node.child[0];
    }
  }

 private:
  /// A box that holds a segment: most are away from all items, and are told by that.
  [[nodiscard]] PHYSIM_INLINE static Bounds about(const Segment& s) {
    Bounds box{s.from, s.from};
    box.take(s.from + s.along);
    box.widen(s.radius + 8 * std::numeric_limits<double>::epsilon() * s.extent());
    return box;
  }

  struct Node {
    Bounds box;
    std::uint32_t parent;
    std::uint32_t child[2];  // of inner nodes
    std::uint32_t item;      // of leaves; of free nodes the next free one
    int height;              // of leaves 0
  };
  static constexpr int kDeepest = 100;  // 1.44 log2 of 2^32 leaves, and as many that wait

  std::uint32_t take_node();
  [[nodiscard]] std::uint32_t sibling_for(const Bounds& box) const;
  void replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by);
  void refit_from(std::uint32_t node);
  void refit(std::uint32_t node);
  [[nodiscard]] std::uint32_t balanced(std::uint32_t node);
  [[nodiscard]] std::uint32_t rotated(std::uint32_t node, int side);

  std::vector<Node> nodes_;
  std::uint32_t root_ = kNone, free_ = kNone;
};

}  // namespace physim::collide
