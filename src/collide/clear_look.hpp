// How far along a segment the spheres about its points touch nothing: what each thing says of it.
#pragma once

#include "collide/cast.hpp"

namespace physim::collide {

/// Shortens the reach of a segment to where a thing may be touched.
struct ClearLook {
  const SceneContent& scene;
  const SceneSegment& asked;
  const SceneFilter& filter;

  void at_rest(std::uint32_t index, Segment& s) const {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (slot.is_asked(filter)) shorten(slot, clear_part_of(*slot.shape, slot.placement.inside(s)), s);
  }
  /// `own`: as far as it is clear in the frame of the thing.
  static void shorten(const SceneContent::InstanceSlot& slot, double own, Segment& s) {
    if (own >= s.reach) return;
    // What it is rounded to on its way into the frame of the thing.
    const double lost = 1e-14 * (s.extent() + length(slot.placement.position())) / length(s.along);
    s.reach = std::max(0.0, own * (1 - 1e-14) - lost);
  }
  /// What moves may be anywhere in the box of its way.
  void at_mover(std::uint32_t index, Segment& s) const {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (!slot.is_asked(filter)) return;
    const Bounds own = bounds_of(*slot.shape);
    if (own.low.x > own.high.x) return void(s.reach = 0);
    const double in = BoxTest(s).enters(slot.path->bounds(own, asked.time, asked.time + asked.duration), s.reach);
    if (in <= s.reach) s.reach = in * (1 - 1e-14);
  }
};

}  // namespace physim::collide
