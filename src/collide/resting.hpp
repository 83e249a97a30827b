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

  class Walk;
  /// Calls visit(thing, segment) for what a segment may meet, as Bvh::along() does.
  template <class Visit>
  void along(Segment& segment, const Visit& visit) const {
    const BoxTest test(segment);
    const auto visit_old = [&](std::uint32_t place, Segment& s) {
      if (order_[place] != Tree::kNone) visit(order_[place], s);
    };
    old_.along(segment, test, visit_old);
    along_recent(segment, test, visit);
  }
  /// Calls visit(thing, segment) for those of them that came lately.
  template <class Visit>
  void along_recent(Segment& segment, const BoxTest& test, const Visit& visit) const {
    recent_.along(segment, test, visit);
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

/// Where a segment is on its way through the things that have stood for long.
class RestingThings::Walk {
 public:
  void begin(const RestingThings& things, const Segment& segment, const BoxTest& test) {
    place_ = end_ = 0;
    some_ = boxes_.begin(things.old_, segment, test);
  }
  /// The next thing that the segment may meet, whose reach may be shorter than it was; Tree::kNone: there is no other.
  std::uint32_t next(const RestingThings& things, const Segment& segment) {
    while (true) {
      for (; place_ < end_;)
        if (const std::uint32_t thing = things.order_[place_++]; thing != Tree::kNone) return thing;
      if (end_ > 0) some_ = boxes_.next(segment);
      end_ = 0;
      while (some_ && !boxes_.is_at_items()) some_ = boxes_.look(things.old_);
      if (!some_) return Tree::kNone;
      place_ = boxes_.first();
      end_ = boxes_.end();
    }
  }

 private:
  Bvh::Walk boxes_;
  bool some_;                  // boxes are left
  std::uint32_t place_, end_;  // of the items that it is at; end_ 0: at none
};

}  // namespace physim::collide
