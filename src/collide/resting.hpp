// Things at rest: those that have stood for long in a tree that is fast to walk, those that came lately in one that is
// fast to change. When these have become many, all are put into the first one anew, so that a change costs as much as
// the tree is deep, by and large.
#pragma once

#include <vector>

#include "collide/bvh.hpp"
#include "collide/tree.hpp"

namespace physim::collide {

class RestingThings {
 public:
  /// Things have small numbers, each of which is there once at most.
  void insert(const Bounds& box, std::uint32_t thing);
  /// False where it is not there.
  bool remove(std::uint32_t thing);
  [[nodiscard]] const Bounds& box(std::uint32_t thing) const {
    PHYSIM_ASSERT(thing < places_.size() && places_[thing].there);
    return places_[thing].box;
  }
  [[nodiscard]] std::size_t bytes() const {
    return places_.capacity() * sizeof(Place) + order_.capacity() * sizeof(std::uint32_t) + old_.bytes() +
           recent_.bytes();
  }

  /// The tree of those that have stood for long.
  [[nodiscard]] const Bvh& tree() const { return old_; }
  /// What is at a place of it; Tree::kNone: it is gone.
  [[nodiscard]] std::uint32_t thing(std::uint32_t place) const { return order_[place]; }
  /// Calls visit(thing, segment) for what a segment may meet, as Bvh::along() does.
  template <class Visit>
  void along(Segment& segment, const Visit& visit) const {
    const auto visit_old = [&](std::uint32_t place, Segment& s) {
      if (order_[place] != Tree::kNone) visit(order_[place], s);
    };
    old_.along(segment, visit_old);
    along_recent(segment, visit);
  }
  /// Calls visit(thing, segment) for those of them that came lately.
  template <class Visit>
  void along_recent(Segment& segment, const Visit& visit) const {
    if (new_ > 0) recent_.along(segment, visit);
  }
  /// Calls visit(thing, within) for what is not farther from p than `within`, which visit shortens.
  template <class Visit>
  void around(const Vec3d& p, double& within, const Visit& visit) const {
    old_.around(p, within, [&](std::uint32_t place, double& least) {
      if (order_[place] != Tree::kNone && box(order_[place]).least_distance(p) <= least) visit(order_[place], least);
    });
    recent_.around(p, within, visit);
  }
  /// Calls visit(thing) for what has a box that meets another one.
  template <class Visit>
  void overlapping(const Bounds& box, const Visit& visit) const {
    old_.overlapping(box, [&](std::uint32_t place) {
      if (order_[place] != Tree::kNone && places_[order_[place]].box.meets(box)) visit(order_[place]);
    });
    recent_.overlapping(box, visit);
  }
  /// Calls visit(box) for the boxes of the trees.
  template <class Visit>
  void boxes(const Visit& visit) const {
    old_.boxes(visit);
    recent_.boxes(visit);
  }

 private:
  struct Place {
    Bounds box;
    std::uint32_t at = 0;  // in order_, or its leaf of recent_
    bool there = false, recent = false;
  };

  void put_in_order();

  std::vector<Place> places_;  // by thing
  Bvh old_;
  std::vector<std::uint32_t> order_;  // things leaf by leaf of old_; Tree::kNone: it is gone
  std::size_t gone_ = 0, new_ = 0;    // of those in old_, and how many are in recent_
  Tree recent_;
};

}  // namespace physim::collide
