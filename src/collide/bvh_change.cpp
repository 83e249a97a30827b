// Items that come into a tree that is there already, and items that leave it.
#include "collide/bvh.hpp"

namespace physim::collide {
namespace {

/// As the tree keeps it.
Bounds kept(const Bounds& box) {
  const BvhItem item(box, 0);
  return {{item.low[0], item.low[1], item.low[2]}, {item.high[0], item.high[1], item.high[2]}};
}

/// The empty box of a node, where it has one; else that which grows least by taking another box.
int lane_for(const BvhNode& node, const Bounds& box) {
  Octet before[3], after[3];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Octet low(static_cast<float>(box.low[axis])), high(static_cast<float>(box.high[axis]));
    before[axis] = node.high(axis) - node.low(axis);
    after[axis] = max(node.high(axis), high) - min(node.low(axis), low);
  }
  const auto area = [](const Octet(&size)[3]) { return size[0] * size[1] + size[1] * size[2] + size[2] * size[0]; };
  const Octet more = area(after) - area(before);  // that of an empty box is infinite, as its size is, less than none
  int best = 0;
  for (int lane = 1; lane < 8; ++lane)
    if (more[lane] < more[best]) best = lane;
  return best;
}

/// A bit for each box of a node that holds another one.
unsigned lanes_about(const BvhNode& node, const Bounds& box) {
  unsigned lanes = 0xff;
  for (std::size_t axis = 0; axis < 3; ++axis)
    lanes &= lanes_at_most(node.low(axis), Octet(static_cast<float>(box.low[axis]))) &
             lanes_at_least(node.high(axis), Octet(static_cast<float>(box.high[axis])));
  return lanes;
}

}  // namespace

void Bvh::measure_root() {
  root_ = nodes_[0].about();
  extent_ = root_.low.x <= root_.high.x ? float_above(root_.extent()) : 0;
}

/// Goes down to where boxes grow least: to an empty one, or to items, which share a new node with it.
bool Bvh::insert(const Bounds& box, std::uint32_t place) {
  PHYSIM_ASSERT(box.low.x <= box.high.x);
  if (place >= BvhChild::kMostPlaces) return false;
  const Bounds own = kept(box);
  if (nodes_.empty()) nodes_.push_back(BvhNode::of_none());
  std::uint32_t at = 0;
  for (int level = 1; level < kMostLevels; ++level) {
    const int lane = lane_for(nodes_[at], own);
    const Bounds before = nodes_[at].box(lane);
    const BvhChild child(nodes_[at].child[lane]);
    const bool is_empty = nodes_[at].is_empty(lane);
    Bounds grown = before;
    grown.take(own);
    nodes_[at].put(lane, grown.low, grown.high, is_empty ? BvhChild::of_items(place, 1) : child);
    if (!is_empty && !child.has_items()) {
      at = child.node();
      continue;
    }
    if (!is_empty) {
      const auto next = static_cast<std::uint32_t>(nodes_.size());
      nodes_[at].child[lane] = BvhChild::of_node(next).bits();
      nodes_.push_back(BvhNode::of_none());
      nodes_[next].put(0, before.low, before.high, child);
      nodes_[next].put(1, own.low, own.high, BvhChild::of_items(place, 1));
    }
    measure_root();
    return true;
  }
  return false;
}

bool Bvh::remove(const Bounds& box, std::uint32_t place) {
  const Taken taken = remove_below(0, kept(box), place);
  PHYSIM_ASSERT(taken != Taken::none);
  measure_root();
  return taken == Taken::alone;
}

/// Boxes about it become as small as what is left in them.
Bvh::Taken Bvh::remove_below(std::uint32_t at, const Bounds& box, std::uint32_t place) {
  for (unsigned lanes = lanes_about(nodes_[at], box); lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    const BvhChild child(nodes_[at].child[lane]);
    if (child.has_items()) {
      if (place < child.first() || place >= child.end()) continue;
      if (child.end() - child.first() > 1) return Taken::from_others;
      nodes_[at].clear(lane);
      return Taken::alone;
    }
    const Taken taken = remove_below(child.node(), box, place);
    if (taken == Taken::none) continue;
    const Bounds left = nodes_[child.node()].about();
    nodes_[at].put(lane, left.low, left.high, child);
    return taken;
  }
  return Taken::none;
}

}  // namespace physim::collide
