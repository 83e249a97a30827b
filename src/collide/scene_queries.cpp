// Questions to a scene.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "collide/cast.hpp"
#include "collide/cast_batch.hpp"
#include "collide/clear_batch.hpp"
#include "collide/clear_look.hpp"
#include "collide/scene_by_motion.hpp"
#include "physim/scene.hpp"

namespace physim {
namespace collide {
namespace {

bool any_hit(const SceneContent& scene, const SceneSegment& asked, const SceneFilter& filter, Which which) {
  bool some = false;
  const auto take = [&](std::uint32_t, const Crossing&, Segment& s) {
    some = true;
    s.reach = -1;
  };
  cross_all<false>(scene, asked, asked.radius, filter, take, which);
  return some;
}

}  // namespace
}  // namespace collide

SceneHit Scene::first_hit(const SceneSegment& segment, const SceneFilter& filter) const {
  const IeeeMode mode;
  SceneHit hit;
  collide::first_hit(*impl_, segment, filter, hit);
  if (impl_->engine) impl_->engine->first_hits({&segment, 1}, filter.layers, {&hit, 1});
  return hit;
}

bool Scene::any_hit(const SceneSegment& segment, const SceneFilter& filter) const {
  const IeeeMode mode;
  const bool some = collide::any_hit(*impl_, segment, filter, collide::Which::all);
  if (some || !impl_->engine) return some;
  SceneHit hit;
  impl_->engine->first_hits({&segment, 1}, filter.layers, {&hit, 1});
  return bool(hit);
}

std::vector<SceneHit> Scene::all_hits(const SceneSegment& segment, const SceneFilter& filter) const {
  const IeeeMode mode;
  struct Met {
    std::uint32_t index;
    collide::Crossing crossing;
  };
  std::vector<Met> met;
  SceneSegment points = segment;
  points.radius = segment.radius >= 0 ? 0 : segment.radius;
  collide::cross_all<true>(*impl_, segment, 0, filter,
                           [&](std::uint32_t index, const collide::Crossing& crossing, collide::Segment&) {
                             met.push_back({index, crossing});
                           });
  std::ranges::sort(met, [](const Met& a, const Met& b) {
    const collide::Crossing &one = a.crossing, &other = b.crossing;
    return std::tie(a.index, one.t, other.entering, one.primitive, one.triangle) <
           std::tie(b.index, other.t, one.entering, other.primitive, other.triangle);
  });
  std::vector<SceneHit> hits;
  hits.reserve(met.size());
  for (const Met& each : met) hits.push_back(collide::hit_of(*impl_, each.index, each.crossing, points));
  // Through an edge two triangles are passed at once; where chords along a curve meet, they tell of one place twice.
  const auto same = [&](const SceneHit& a, const SceneHit& b) {
    const bool moves = impl_->instances[a.instance.index].path != nullptr;
    const bool differ = a.primitive != b.primitive &&  // parts of a compound may share a face
                        std::holds_alternative<collide::Compound>(*impl_->instances[a.instance.index].shape);
    return a.instance == b.instance && a.entering == b.entering && !differ && b.part - a.part <= (moves ? 4e-9 : 1e-12);
  };
  hits.erase(std::unique(hits.begin(), hits.end(), same), hits.end());
  if (impl_->engine) impl_->engine->all_hits(points, filter.layers, hits);
  std::ranges::stable_sort(hits, {}, &SceneHit::part);
  return hits;
}

void Scene::first_hits(std::span<const SceneSegment> segments, std::span<SceneHit> into, const SceneFilter& filter,
                       TaskRunner* runner) const {
  const std::size_t count = std::min(segments.size(), into.size());
  collide::first_hits(*impl_, bytes(), segments.first(count), into.first(count), filter, runner);
  if (!impl_->engine) return;
  const IeeeMode mode;
  impl_->engine->first_hits(segments.first(count), filter.layers, into.first(count));
}

SceneNearest collide::nearest_thing(const SceneContent& scene, std::uint32_t index, const Vec3d& point, double within,
                                    const SceneFilter& filter, double time) {
  const SceneContent::InstanceSlot& slot = scene.instances[index];
  if (!slot.is_asked(filter)) return {};
  const Placement placement = slot.placement_at(time);
  double own = within / placement.scale();
  const auto near = nearest_of(*slot.shape, placement.inside(point), own);
  if (!near || (slot.one_way && filter.from_front && !slot.is_front(near->away))) return {};
  const double distance = own * placement.scale();
  return {distance,
          distance == 0 ? point : placement.outside(near->position),
          {index, slot.generation},
          near->primitive,
          material_of(*slot.shape, near->primitive, near->triangle).value_or(slot.def.material),
          placement.turned(near->away)};
}

SceneNearest Scene::nearest(const Vec3d& point, double within, const SceneFilter& filter, double time) const {
  const IeeeMode mode;
  SceneNearest found;
  if (!collide::is_near(point) || !(within >= 0) || !collide::is_soon(time)) return found;
  const auto look_at = [&](std::uint32_t index, double& least) {
    const SceneNearest near = collide::nearest_thing(*impl_, index, point, least, filter, time);
    if (!near || (found && (near.distance > found.distance ||
                            (near.distance == found.distance && index > found.instance.index))))
      return;
    found = near;
    least = near.distance;
  };
  for (const std::uint32_t index : impl_->unbounded) look_at(index, within);
  impl_->resting.around(point, within, look_at);
  collide::for_movers(
      *impl_, time, time, [&](const collide::Tree& tree) { tree.around(point, within, look_at); },
      [&](std::uint32_t index) { look_at(index, within); });
  return found;
}

namespace collide {
namespace {

/// Not more than the distance of p from a thing between two times, nor than `least`; but not less than that of its box,
/// so that it does not matter which boxes the tree has looked at.
double thing_clearance(const SceneContent& scene, std::uint32_t index, const Vec3d& p, double least, double from,
                       double to) {
  const SceneContent::InstanceSlot& slot = scene.instances[index];
  const Bounds own = bounds_of(*slot.shape);
  double beside = 0;
  if (own.low.x <= own.high.x)
    beside = (slot.path ? slot.path->bounds(own, from, to) : scene.resting.box(index)).least_distance(p);
  if (beside >= least) return least;
  const Placement placement = slot.placement_at(from);
  const double approach = slot.path && from < to ? slot.path->most_approach(p, from, to) * (to - from) : 0;
  // What p is rounded to on its way into the frame of the thing, and what comes nearer meanwhile.
  const double lost = approach + 1e-14 * (length(p) + length(placement.position()));
  const double found = clearance_of(*slot.shape, placement.inside(p)) * placement.scale();
  PHYSIM_ASSERT(found >= 0 && beside >= 0);
  return std::min(least, std::max(beside, found * (1 - 1e-14) - lost));
}

double clearance_in(const SceneContent& scene, const Vec3d& point, double reach, const SceneFilter& filter, double from,
                    double to, Which which) {
  if (!is_near(point) || !(reach >= 0) || !is_soon(from) || !is_soon(to) || !(from <= to)) return 0;
  if (scene.engine) return 0;  // nobody knows how far its things are
  double least = std::min(reach, kFarthest);
  const auto look_at = [&](std::uint32_t index, double& within) {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (!slot.is_asked(filter) || !is_of(which, slot)) return;
    within = thing_clearance(scene, index, point, within, from, to);
  };
  for (const std::uint32_t index : scene.unbounded) look_at(index, least);
  if (which != Which::moving) scene.resting.around(point, least, look_at);
  if (which == Which::resting) return least;
  for_movers(
      scene, from, to, [&](const Tree& tree) { tree.around(point, least, look_at); },
      [&](std::uint32_t index) { look_at(index, least); });
  return least;
}

double clear_part_in(const SceneContent& scene, const SceneSegment& asked, const SceneFilter& filter, Which which) {
  if (!is_sound(asked) || scene.engine) return 0;
  Segment segment{asked.from, asked.to - asked.from, asked.radius, 1};
  const ClearLook look{scene, asked, filter};
  things_along(
      scene, which, segment, asked.time, asked.time + asked.duration,
      [&](std::uint32_t index, Segment& s) { look.at_rest(index, s); },
      [&](std::uint32_t index, Segment& s) { look.at_mover(index, s); });
  return std::max(0.0, segment.reach);
}

}  // namespace
}  // namespace collide

double Scene::clearance(const Vec3d& point, double reach, const SceneFilter& filter, double from, double to) const {
  const IeeeMode mode;
  return collide::clearance_in(*impl_, point, reach, filter, from, to, collide::Which::all);
}

double Scene::clear_part(const SceneSegment& asked, const SceneFilter& filter) const {
  const IeeeMode mode;
  return collide::clear_part_in(*impl_, asked, filter, collide::Which::all);
}

double SceneByMotion::clearance(const Vec3d& point, double reach, const SceneFilter& filter) const {
  return collide::clearance_in(content_, point, reach, filter, 0, 0, collide::Which::resting);
}

double SceneByMotion::clear_part(const SceneSegment& segment, const SceneFilter& filter) const {
  return collide::clear_part_in(content_, segment, filter, collide::Which::resting);
}

void SceneByMotion::clear_parts(std::span<collide::ClearQuery> queries) const {
  if (!content_.engine) return collide::clear_parts(content_, queries);
  for (collide::ClearQuery& query : queries) query.part = 0;  // nobody knows how far its things are
}

bool SceneByMotion::meets_mover(const SceneSegment& segment, const SceneFilter& filter) const {
  return collide::any_hit(content_, segment, filter, collide::Which::moving);
}

std::vector<InstanceId> Scene::overlaps(const Vec3d& middle, double radius, const SceneFilter& filter,
                                        double time) const {
  const IeeeMode mode;
  std::vector<InstanceId> found;
  if (!collide::is_near(middle) || !(radius >= 0 && radius <= collide::kFarthest) || !collide::is_soon(time))
    return found;
  const auto look_at = [&](std::uint32_t index) {
    const Impl::InstanceSlot& slot = impl_->instances[index];
    if (!slot.is_asked(filter)) return;
    const collide::Placement placement = slot.placement_at(time);
    double own = radius / placement.scale();
    if (nearest_of(*slot.shape, placement.inside(middle), own)) found.push_back({index, slot.generation});
  };
  for (const std::uint32_t index : impl_->unbounded) look_at(index);
  const Vec3d about{radius, radius, radius};
  const collide::Bounds box{middle - about, middle + about};
  impl_->resting.overlapping(box, look_at);
  collide::for_movers(
      *impl_, time, time, [&](const collide::Tree& tree) { tree.overlapping(box, look_at); }, look_at);
  std::ranges::sort(found);
  return found;
}

bool Scene::is_reached(const Vec3d& middle, double radius, const SceneFilter& filter, double from, double to) const {
  const IeeeMode mode;
  if (!collide::is_sound({middle, middle, radius, from, to - from}) || !collide::is_soon(to)) return false;
  collide::Segment segment{middle, {}, radius, 1};
  bool some = false;
  const auto look_at = [&](std::uint32_t index, collide::Segment& s) {
    const Impl::InstanceSlot& slot = impl_->instances[index];
    if (some || !slot.path || !slot.is_asked(filter) || slot.path->rests(from, to)) return;
    const auto taken = [&](const collide::Crossing&, collide::Segment& within) {
      some = true;
      within.reach = -1;
    };
    collide::Sweep<false, decltype(taken)>(*slot.shape, *slot.path, from, to - from, s, taken);
  };
  for (const std::uint32_t index : impl_->unbounded) look_at(index, segment);
  collide::for_movers(
      *impl_, from, to, [&](const collide::Tree& tree) { tree.along(segment, look_at); },
      [&](std::uint32_t index) { look_at(index, segment); });
  return some;
}

}  // namespace physim
