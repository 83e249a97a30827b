// How segments are cast into a scene: what they may meet is asked one by one where it crosses them.
#pragma once

#include <tuple>

#include "collide/content.hpp"
#include "collide/sweep.hpp"

namespace physim::collide {

/// Calls visit(index) for what moves and may be near between two times: visit_tree(tree) where the tree knows of them.
template <class VisitTree, class Visit>
void for_movers(const SceneContent& scene, double from, double to, const VisitTree& visit_tree, const Visit& visit) {
  if (scene.movers.empty()) return;
  if (from >= scene.covered_from && to <= scene.covered_to) return visit_tree(scene.moving);
  for (const std::uint32_t index : scene.movers) visit(index);
}

/// The place of a thing that is nearest to a point; none: it is farther than `within`, or not asked about.
[[nodiscard]] SceneNearest nearest_thing(const SceneContent& scene, std::uint32_t index, const Vec3d& point,
                                         double within, const SceneFilter& filter, double time);

/// Which things are asked about.
enum class Which { all, resting, moving };
[[nodiscard]] inline bool is_of(Which which, const SceneContent::InstanceSlot& slot) {
  return which == Which::all || (which == Which::moving) == (slot.path != nullptr);
}

/// Calls look_at(index, segment) for what rests and look_at_mover(index, segment) for what moves, of what no box holds.
template <class LookAt, class LookAtMover>
void boundless_along(const SceneContent& scene, Which which, Segment& segment, const LookAt& look_at,
                     const LookAtMover& look_at_mover) {
  for (const std::uint32_t index : scene.unbounded) {
    if (!is_of(which, scene.instances[index])) continue;
    if (scene.instances[index].path)
      look_at_mover(index, segment);
    else
      look_at(index, segment);
  }
}
/// Calls look_at_mover(index, segment) for what moves in boxes and may be met between two times.
template <class LookAtMover>
void movers_along(const SceneContent& scene, Segment& segment, double from, double to,
                  const LookAtMover& look_at_mover) {
  for_movers(
      scene, from, to, [&](const Tree& tree) { tree.along(segment, look_at_mover); },
      [&](std::uint32_t index) {
        const SceneContent::InstanceSlot& slot = scene.instances[index];
        const Bounds box = slot.path->bounds(bounds_of(*slot.shape), from, to);
        if (BoxTest(segment).enters(box, segment.reach) <= segment.reach) look_at_mover(index, segment);
      });
}
/// Calls look_at(index, segment) for what rests and look_at_mover(index, segment) for what moves and may be met between
/// two times; both may shorten the segment's reach.
template <class LookAt, class LookAtMover>
void things_along(const SceneContent& scene, Which which, Segment& segment, double from, double to,
                  const LookAt& look_at, const LookAtMover& look_at_mover) {
  boundless_along(scene, which, segment, look_at, look_at_mover);
  if (which != Which::moving) scene.resting.along(segment, look_at);
  if (which != Which::resting) movers_along(scene, segment, from, to, look_at_mover);
}

/// What crosses a segment of one thing: calls take(index, crossing, segment), which shortens the segment's reach.
template <bool kExits, class Take>
struct Look {
  const SceneContent& scene;
  const SceneSegment& asked;
  const SceneFilter& filter;
  Take take;

  void at_rest(std::uint32_t index, Segment& s) const {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (!slot.is_asked(filter)) return;
    Segment inside = slot.placement.inside(s);
    const auto taken = [&](const Crossing& crossing, Segment& within) {
      if (!kExits && slot.lets_through(filter, crossing)) return;
      take(index, crossing, s);
      within.reach = s.reach;
    };
    cross<kExits>(*slot.shape, inside, taken);
  }
  void at_mover(std::uint32_t index, Segment& s) const {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (!slot.is_asked(filter)) return;
    const auto taken = [&](const Crossing& crossing, Segment& within) {
      if (kExits || !slot.lets_through(filter, crossing)) take(index, crossing, within);
    };
    Sweep<kExits, decltype(taken)>(*slot.shape, *slot.path, asked.time, asked.duration, s, taken);
  }
};

/// Calls take(index, crossing, segment) for whatever a segment meets; take shortens the segment's reach.
template <bool kExits, class Take>
void cross_all(const SceneContent& scene, const SceneSegment& asked, double radius, const SceneFilter& filter,
               const Take& take, Which which = Which::all) {
  if (!is_sound(asked)) return;
  Segment segment{asked.from, asked.to - asked.from, radius, 1};
  const Look<kExits, const Take&> look{scene, asked, filter, take};
  things_along(
      scene, which, segment, asked.time, asked.time + asked.duration,
      [&look](std::uint32_t index, Segment& s) { look.at_rest(index, s); },
      [&look](std::uint32_t index, Segment& s) { look.at_mover(index, s); });
}

/// What is met first of what is taken.
struct FirstCrossing {
  Crossing crossing{.t = kInfinity};
  std::uint32_t thing = 0;  // 0: none

  void take(std::uint32_t index, const Crossing& other, Segment& s) {
    // Met at once, the one of the lowest numbers is first, whatever the tree looks like.
    const bool first =
        other.t < crossing.t || (other.t == crossing.t && std::tie(index, other.primitive, other.triangle) <
                                                              std::tie(thing, crossing.primitive, crossing.triangle));
    if (!first) return;
    crossing = other;
    thing = index;
    s.reach = other.t;
  }
};

/// What a crossing of a segment by a thing comes to.
[[nodiscard]] inline SceneHit hit_of(const SceneContent& scene, std::uint32_t index, const Crossing& crossing,
                                     const SceneSegment& asked) {
  const SceneContent::InstanceSlot& slot = scene.instances[index];
  PHYSIM_ASSERT(slot.alive && crossing.t >= 0 && crossing.t <= 1);
  SceneHit hit{.part = crossing.t,
               .position = asked.from + (asked.to - asked.from) * crossing.t,
               .normal = slot.placement.turned(crossing.normal),
               .time = asked.time + asked.duration * crossing.t,
               .instance = {index, slot.generation},
               .primitive = crossing.primitive,
               .material = material_of(*slot.shape, crossing.primitive, crossing.triangle).value_or(slot.def.material),
               .entering = crossing.entering,
               .starts_inside = crossing.starts_inside};
  if (!slot.path) return hit;
  hit.normal = slot.path->placement(hit.time).turned(crossing.normal);
  const MotionState state = slot.path->at(hit.time);
  const Vec3d touched = hit.starts_inside ? hit.position : hit.position - hit.normal * asked.radius;
  hit.velocity = state.velocity + cross(state.angular_velocity, touched - state.position);
  return hit;
}

}  // namespace physim::collide
