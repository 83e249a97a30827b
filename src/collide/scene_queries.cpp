// Questions to a scene.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "collide/content.hpp"
#include "collide/order.hpp"
#include "collide/question.hpp"
#include "collide/scene_parts.hpp"
#include "collide/sweep.hpp"
#include "physim/scene.hpp"

namespace physim {
namespace collide {
namespace {

/// Calls visit(index) for what moves and may be near between two times: visit_tree(tree) where the tree knows of them.
template <class VisitTree, class Visit>
void for_movers(const SceneContent& scene, double from, double to, const VisitTree& visit_tree, const Visit& visit) {
  if (scene.movers.empty()) return;
  if (from >= scene.covered_from && to <= scene.covered_to) return visit_tree(scene.moving);
  for (const std::uint32_t index : scene.movers) visit(index);
}

/// Which things are asked about.
enum class Which { all, resting, moving };
bool is_of(Which which, const SceneContent::InstanceSlot& slot) {
  return which == Which::all || (which == Which::moving) == (slot.path != nullptr);
}

/// Calls look_at(index, segment) for what rests and look_at_mover(index, segment) for what moves and may be met between
/// two times; both may shorten the segment's reach.
template <class LookAt, class LookAtMover>
void things_along(const SceneContent& scene, Which which, Segment& segment, double from, double to,
                  const LookAt& look_at, const LookAtMover& look_at_mover) {
  for (const std::uint32_t index : scene.unbounded) {
    if (!is_of(which, scene.instances[index])) continue;
    if (scene.instances[index].path)
      look_at_mover(index, segment);
    else
      look_at(index, segment);
  }
  if (which != Which::moving) scene.resting.along(segment, look_at);
  if (which == Which::resting) return;
  for_movers(
      scene, from, to, [&](const Tree& tree) { tree.along(segment, look_at_mover); },
      [&](std::uint32_t index) {
        const SceneContent::InstanceSlot& slot = scene.instances[index];
        const Bounds box = slot.path->bounds(bounds_of(*slot.shape), from, to);
        if (BoxTest(segment).enters(box, segment.reach) <= segment.reach) look_at_mover(index, segment);
      });
}

SceneHit hit_of(const SceneContent& scene, std::uint32_t index, const Crossing& crossing, const SceneSegment& asked) {
  const SceneContent::InstanceSlot& slot = scene.instances[index];
  PHYSIM_ASSERT(slot.alive && crossing.t >= 0 && crossing.t <= 1);
  SceneHit hit{.part = crossing.t,
               .position = asked.from + (asked.to - asked.from) * crossing.t,
               .normal = slot.placement.turned(crossing.normal),
               .time = asked.time + asked.duration * crossing.t,
               .instance = {index, slot.generation},
               .primitive = crossing.primitive,
               .material = material_of(*slot.shape, crossing).value_or(slot.def.material),
               .entering = crossing.entering,
               .starts_inside = crossing.starts_inside};
  if (!slot.path) return hit;
  hit.normal = slot.path->placement(hit.time).turned(crossing.normal);
  const MotionState state = slot.path->at(hit.time);
  const Vec3d touched = hit.starts_inside ? hit.position : hit.position - hit.normal * asked.radius;
  hit.velocity = state.velocity + cross(state.angular_velocity, touched - state.position);
  return hit;
}

/// Calls take(index, crossing, segment) for whatever a segment meets; take shortens the segment's reach.
template <bool kExits, class Take>
void cross_all(const SceneContent& scene, const SceneSegment& asked, double radius, const SceneFilter& filter,
               const Take& take, Which which = Which::all) {
  if (!is_sound(asked)) return;
  Segment segment{asked.from, asked.to - asked.from, radius, 1};
  const auto look_at = [&](std::uint32_t index, Segment& s) {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (!slot.is_asked(filter)) return;
    Segment inside = slot.placement.inside(s);
    const auto taken = [&](const Crossing& crossing, Segment& within) {
      take(index, crossing, s);
      within.reach = s.reach;
    };
    cross<kExits>(*slot.shape, inside, taken);
  };
  const auto look_at_mover = [&](std::uint32_t index, Segment& s) {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (!slot.is_asked(filter)) return;
    const auto taken = [&](const Crossing& crossing, Segment& within) { take(index, crossing, within); };
    Sweep<kExits, decltype(taken)>(*slot.shape, *slot.path, asked.time, asked.duration, s, taken);
  };
  things_along(scene, which, segment, asked.time, asked.time + asked.duration, look_at, look_at_mover);
}

bool any_hit(const SceneContent& scene, const SceneSegment& asked, const SceneFilter& filter, Which which) {
  bool some = false;
  const auto take = [&](std::uint32_t, const Crossing&, Segment& s) {
    some = true;
    s.reach = -1;
  };
  cross_all<false>(scene, asked, asked.radius, filter, take, which);
  return some;
}

/// What a segment meets first; where it meets nothing, `into` stays as it is.
void first_hit(const SceneContent& scene, const SceneSegment& asked, const SceneFilter& filter, SceneHit& into) {
  Crossing best;
  best.t = kInfinity;
  std::uint32_t who = 0;
  const auto take = [&](std::uint32_t index, const Crossing& crossing, Segment& s) {
    // Met at once, the one of the lowest numbers is first, whatever the tree looks like.
    const auto numbers = std::tie(index, crossing.primitive, crossing.triangle);
    const bool first =
        crossing.t < best.t || (crossing.t == best.t && numbers < std::tie(who, best.primitive, best.triangle));
    if (!first) return;
    best = crossing;
    who = index;
    s.reach = crossing.t;
  };
  cross_all<false>(scene, asked, asked.radius, filter, take);
  if (who != 0) into = hit_of(scene, who, best, asked);
}

/// Many segments, one after the other as they come or sorted by place.
struct Batch {
  static constexpr std::size_t kTask = 256;
  static constexpr SceneHit kNothing{};

  const SceneContent& scene;
  std::span<const SceneSegment> segments;
  std::span<SceneHit> into;
  const SceneFilter& filter;
  std::vector<std::uint32_t> order;  // empty: as they come

  void sort() {
    order = order_by_place(segments);
    PHYSIM_ASSERT(order.size() == into.size());
    // One after the other, so that out of order only those are written that meet something.
    std::ranges::fill(into, kNothing);
  }
  static void run(void* self, std::size_t task) {
    const IeeeMode mode;
    const Batch& batch = *static_cast<const Batch*>(self);
    const std::size_t begin = task * kTask, end = std::min(batch.segments.size(), begin + kTask);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t at = batch.order.empty() ? i : batch.prefetched(i);
      if (batch.order.empty()) batch.into[i] = kNothing;
      first_hit(batch.scene, batch.segments[at], batch.filter, batch.into[at]);
    }
  }

 private:
  /// The i-th of the order; what is soon needed is on its way from where it lies in memory.
  [[nodiscard]] std::size_t prefetched(std::size_t i) const {
    constexpr std::size_t kAhead = 16;
    if (i + kAhead < order.size()) {
      const SceneSegment& next = segments[order[i + kAhead]];
      __builtin_prefetch(&next);
      __builtin_prefetch(&next.radius);
    }
    return order[i];
  }
};

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
  // From here on it pays to look for neighbours: what they look at is read once, but they lie all over the memory.
  constexpr std::size_t kMany = 2048, kCached = 1 << 20;
  const std::size_t count = std::min(segments.size(), into.size());
  collide::Batch batch{*impl_, segments.first(count), into.first(count), filter, {}};
  if (count >= kMany && count <= std::numeric_limits<std::uint32_t>::max() && bytes() >= kCached) batch.sort();
  const std::size_t tasks = (count + collide::Batch::kTask - 1) / collide::Batch::kTask;
  if (runner && tasks > 1)
    runner->run(tasks, collide::Batch::run, &batch);
  else
    for (std::size_t task = 0; task < tasks; ++task) collide::Batch::run(&batch, task);
  if (!impl_->engine) return;
  const IeeeMode mode;
  impl_->engine->first_hits(batch.segments, filter.layers, batch.into);
}

SceneNearest Scene::nearest(const Vec3d& point, double within, const SceneFilter& filter, double time) const {
  const IeeeMode mode;
  SceneNearest found;
  if (!collide::is_near(point) || !(within >= 0) || !collide::is_soon(time)) return found;
  const auto look_at = [&](std::uint32_t index, double& least) {
    const Impl::InstanceSlot& slot = impl_->instances[index];
    if (!slot.is_asked(filter)) return;
    const collide::Placement placement = slot.placement_at(time);
    double own = least / placement.scale();
    const auto place = nearest_of(*slot.shape, placement.inside(point), own);
    const double distance = own * placement.scale();
    if (!place ||
        (found && (distance > found.distance || (distance == found.distance && index > found.instance.index))))
      return;
    found = {distance, distance == 0 ? point : placement.outside(*place), {index, slot.generation}};
    least = distance;
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
  const auto look_at = [&](std::uint32_t index, Segment& s) {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (!slot.is_asked(filter)) return;
    const double own = clear_part_of(*slot.shape, slot.placement.inside(s));
    if (own >= s.reach) return;
    // What it is rounded to on its way into the frame of the thing.
    const double lost = 1e-14 * (s.extent() + length(slot.placement.position())) / length(s.along);
    s.reach = std::max(0.0, own * (1 - 1e-14) - lost);
  };
  const double end = asked.time + asked.duration;
  // What moves may be anywhere in the box of its way.
  const auto look_at_mover = [&](std::uint32_t index, Segment& s) {
    const SceneContent::InstanceSlot& slot = scene.instances[index];
    if (!slot.is_asked(filter)) return;
    const Bounds own = bounds_of(*slot.shape);
    if (own.low.x > own.high.x) return void(s.reach = 0);
    const double in = BoxTest(s).enters(slot.path->bounds(own, asked.time, end), s.reach);
    if (in <= s.reach) s.reach = in * (1 - 1e-14);
  };
  things_along(scene, which, segment, asked.time, end, look_at, look_at_mover);
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

double SceneParts::clearance(const Vec3d& point, double reach, const SceneFilter& filter) const {
  return collide::clearance_in(content_, point, reach, filter, 0, 0, collide::Which::resting);
}

double SceneParts::clear_part(const SceneSegment& segment, const SceneFilter& filter) const {
  return collide::clear_part_in(content_, segment, filter, collide::Which::resting);
}

bool SceneParts::meets_mover(const SceneSegment& segment, const SceneFilter& filter) const {
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
