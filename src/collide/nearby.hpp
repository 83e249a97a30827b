// What rests near a group of segments: looked for once for all of them.
#pragma once

#include "collide/content.hpp"

namespace physim::collide {

class Nearby {
 public:
  /// What is asked for and meets a box.
  Nearby(const SceneContent& scene, const SceneFilter& filter, const Bounds& box);

  /// Calls visit(index, segment, start) for what a segment that lies in the box may meet, as Bvh::along() does; start:
  /// of its walk through the tree of a mesh, or null.
  template <class Visit>
  void along(Segment& segment, const Visit& visit) const {
    if (is_crowded_)
      return scene_.resting.along(segment, [&](std::uint32_t index, Segment& s) { visit(index, s, nullptr); });
    if (is_alone_) return visit(things_[0].index, segment, things_[0].start_or_null());
    if (count_ == 0) return;
    const QuadTest test(segment, BoxTest(segment).per_along(), extent_, 0);
    for (int quad = 0; 4 * quad < count_; ++quad) {
      Quad in;
      for (unsigned lanes = test.enters(boxes_[quad], test.reach(segment), in); lanes != 0; lanes &= lanes - 1) {
        const Thing& thing = things_[4 * quad + std::countr_zero(lanes)];
        visit(thing.index, segment, thing.start_or_null());
      }
    }
  }

 private:
  static constexpr int kMost = 12;
  struct Thing {
    std::uint32_t index;
    bool has_start;
    Bvh::Start start;

    [[nodiscard]] const Bvh::Start* start_or_null() const { return has_start ? &start : nullptr; }
  };

  void add(std::uint32_t index, const Bounds& box);

  const SceneContent& scene_;
  int count_ = 0;
  bool is_crowded_ = false;  // there is more: each segment finds its own
  bool is_alone_ = false;    // a shape that looks where it is itself
  double extent_ = 0;        // of boxes_
  QuadBoxes boxes_[kMost / 4];
  Thing things_[kMost];
};

}  // namespace physim::collide
