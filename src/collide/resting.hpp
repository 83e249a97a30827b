// Things at rest, in a tree that is fast to walk. Those that come and go change it where they are; when it has grown by
// them, or they have been many, it is built anew, so that a change costs as much as the tree is deep, by and large.
#pragma once

#include <vector>

#include "collide/bvh.hpp"

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
    return places_.capacity() * sizeof(Place) + (order_.capacity() + free_.capacity()) * sizeof(std::uint32_t) +
           tree_.bytes();
  }

  static constexpr std::uint32_t kNone = 0xffffffff;

  [[nodiscard]] const Bvh& tree() const { return tree_; }
  /// What is at a place of it; kNone: it is gone.
  [[nodiscard]] std::uint32_t thing(std::uint32_t place) const { return order_[place]; }
  /// Calls visit(thing, segment) for what a segment may meet, as Bvh::along() does.
  template <class Visit>
  void along(Segment& segment, const Visit& visit) const {
    tree_.along(segment, [&](std::uint32_t place, Segment& s) {
      if (order_[place] != kNone) visit(order_[place], s);
    });
  }
  /// Calls visit(thing, within) for what is not farther from p than `within`, which visit shortens.
  template <class Visit>
  void around(const Vec3d& p, double& within, const Visit& visit) const {
    tree_.around(p, within, [&](std::uint32_t place, double& least) {
      if (order_[place] != kNone && box(order_[place]).least_distance(p) <= least) visit(order_[place], least);
    });
  }
  /// Calls visit(thing) for what has a box that meets another one.
  template <class Visit>
  void overlapping(const Bounds& box, const Visit& visit) const {
    tree_.overlapping(box, [&](std::uint32_t place) {
      if (order_[place] != kNone && places_[order_[place]].box.meets(box)) visit(order_[place]);
    });
  }
  /// Calls visit(box) for the boxes of the tree.
  template <class Visit>
  void boxes(const Visit& visit) const {
    tree_.boxes(visit);
  }

 private:
  struct Place {
    Bounds box;
    std::uint32_t at = 0;  // in order_
    bool there = false;
  };

  void put_in_order();

  std::vector<Place> places_;  // by thing
  Bvh tree_;
  std::vector<std::uint32_t> order_;  // things by the places of the tree; kNone: it is gone
  std::vector<std::uint32_t> free_;   // places that are no item's
  std::size_t count_ = 0;
  std::size_t built_ = 0, came_ = 0;  // so many were there when the tree was built, and came since
};

}  // namespace physim::collide
