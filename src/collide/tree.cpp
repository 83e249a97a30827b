#include "collide/tree.hpp"

namespace physim::collide {
namespace {

double area_of(const Bounds& a, const Bounds& b) {
  Bounds both = a;
  both.take(b);
  return both.area();
}

}  // namespace

std::uint32_t Tree::take_node() {
  if (free_ == kNone) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t node = free_;
  free_ = nodes_[node].item;
  return node;
}

std::uint32_t Tree::insert(const Bounds& box, std::uint32_t item) {
  PHYSIM_ASSERT(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z);
  const std::uint32_t leaf = take_node();
  nodes_[leaf] = {box, kNone, {kNone, kNone}, item, 0};
  if (root_ == kNone) return root_ = leaf;
  const std::uint32_t sibling = sibling_for(box), parent = take_node();
  const std::uint32_t above = nodes_[sibling].parent;
  nodes_[parent] = {{}, above, {sibling, leaf}, kNone, 1};
  nodes_[sibling].parent = nodes_[leaf].parent = parent;
  replace_child(above, sibling, parent);
  refit_from(parent);
  return leaf;
}

void Tree::remove(std::uint32_t leaf) {
  PHYSIM_ASSERT(leaf < nodes_.size() && nodes_[leaf].height == 0);
  const std::uint32_t parent = nodes_[leaf].parent;
  nodes_[leaf].item = free_;
  free_ = leaf;
  if (parent == kNone) return void(root_ = kNone);
  const Node gone = nodes_[parent];
  const std::uint32_t sibling = gone.child[gone.child[0] == leaf ? 1 : 0];
  nodes_[sibling].parent = gone.parent;
  replace_child(gone.parent, parent, sibling);
  nodes_[parent].item = free_;
  free_ = parent;
  refit_from(gone.parent);
}

/// Down the tree, as long as a child grows by less than a new parent here would cost.
std::uint32_t Tree::sibling_for(const Bounds& box) const {
  std::uint32_t node = root_;
  while (nodes_[node].height > 0) {
    const Node& n = nodes_[node];
    const double both = area_of(n.box, box), growth = both - n.box.area();
    const auto cost_below = [&](std::uint32_t child) {
      const Node& c = nodes_[child];
      return area_of(c.box, box) - (c.height == 0 ? 0 : c.box.area()) + growth;
    };
    const double left = cost_below(n.child[0]), right = cost_below(n.child[1]);
    if (both < left && both < right) break;
    node = n.child[left <= right ? 0 : 1];
  }
  return node;
}

void Tree::replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
  if (parent == kNone) return void(root_ = by);
  Node& n = nodes_[parent];
  PHYSIM_ASSERT(n.child[0] == child || n.child[1] == child);
  n.child[n.child[0] == child ? 0 : 1] = by;
}

void Tree::refit(std::uint32_t node) {
  Node& n = nodes_[node];
  PHYSIM_ASSERT(n.child[0] < nodes_.size() && n.child[1] < nodes_.size());
  const Node &left = nodes_[n.child[0]], &right = nodes_[n.child[1]];
  n.box = left.box;
  n.box.take(right.box);
  n.height = 1 + std::max(left.height, right.height);
}

void Tree::refit_from(std::uint32_t node) {
  for (; node != kNone; node = nodes_[node].parent) {
    refit(node);
    node = balanced(node);
  }
}

/// The root of what was below a node, whose children differ by a level at most.
std::uint32_t Tree::balanced(std::uint32_t node) {
  const Node& n = nodes_[node];
  const int lean = nodes_[n.child[1]].height - nodes_[n.child[0]].height;
  return lean > 1 ? rotated(node, 1) : lean < -1 ? rotated(node, 0) : node;
}

/// Lifts the higher child of a node above it; the lower one of its own children comes down.
std::uint32_t Tree::rotated(std::uint32_t node, int side) {
  const std::uint32_t up = nodes_[node].child[side], above = nodes_[node].parent;
  PHYSIM_ASSERT(nodes_[up].height > nodes_[nodes_[node].child[1 - side]].height);
  const std::uint32_t first = nodes_[up].child[0], second = nodes_[up].child[1];
  const bool first_stays = nodes_[first].height >= nodes_[second].height;
  const std::uint32_t down = first_stays ? second : first;
  nodes_[up].parent = above;
  replace_child(above, node, up);
  nodes_[up].child[0] = first_stays ? first : second;
  nodes_[up].child[1] = node;
  nodes_[node].parent = up;
  nodes_[node].child[side] = down;
  nodes_[down].parent = node;
  refit(node);
  refit(up);
  return up;
}

}  // namespace physim::collide
