#include "collide/cast_batch.hpp"

#include <algorithm>
#include <limits>

#include "base/ieee_mode.hpp"
#include "base/prefetch.hpp"
#include "collide/cast.hpp"
#include "collide/order.hpp"

namespace physim::collide {
namespace {

constexpr std::size_t kTask = 256;  // segments
constexpr std::size_t kTurns = 8;   // segments of which each waits for the memory while the others have their turn
constexpr SceneHit kNothing{};

/// Segments, one after the other as they come or sorted by place.
struct Batch {
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
  /// The number of the i-th segment, whose hit is none yet.
  [[nodiscard]] std::size_t taken(std::size_t i) const {
    if (order.empty()) {
      into[i] = kNothing;
      return i;
    }
    constexpr std::size_t kAhead = 16;
    if (i + kAhead < order.size()) prefetch(order[i + kAhead]);
    return order[i];
  }
  /// A segment and the place of its hit are on their way from where they lie in memory.
  void prefetch(std::size_t number) const {
    const SceneSegment* segment = &segments[number];
    const SceneHit* hit = &into[number];
    constexpr std::size_t kLine = 64;
    static_assert(sizeof(SceneSegment) <= 2 * kLine && sizeof(SceneHit) <= 2 * kLine);
    prefetch_at(segment);
    prefetch_at(segment, sizeof(SceneSegment) - 1);
    prefetch_to_write(hit);
    prefetch_to_write(hit, kLine);
    prefetch_to_write(hit, sizeof(SceneHit) - 1);
  }
};

/// A segment on its way through a scene, which stops at each look into a large mesh: what it looks at next is brought
/// from memory, and others have their turn meanwhile.
class Cast {
 public:
  /// False where it is at its end already.
  bool begin(const Batch& batch, std::size_t number) {
    batch_ = &batch;
    asked_ = &batch.segments[number];
    into_ = &batch.into[number];
    if (!is_sound(*asked_)) return false;
    first_ = {};
    segment_ = {asked_->from, asked_->to - asked_->from, asked_->radius, 1};
    boundless_along(
        batch.scene, Which::all, segment_, [this](std::uint32_t index, Segment&) { look().at_rest(index, segment_); },
        [this](std::uint32_t index, Segment&) { look().at_mover(index, segment_); });
    const BoxTest test(segment_);
    recent_ = 0;
    batch.scene.resting.along_recent(segment_, test, [this](std::uint32_t index, Segment&) {
      if (recent_ < kRecent && batch_->scene.large_mesh(index))
        recent_meshes_[recent_++] = index;
      else
        look().at_rest(index, segment_);
    });
    std::reverse(recent_meshes_, recent_meshes_ + recent_);
    things_.begin(batch.scene.resting, segment_, test);
    return go_on();
  }
  /// False where it is at its end.
  PHYSIM_INLINE bool step() {
    const bool on = mesh_.step([this](const Crossing& crossing, Segment& within) {
      first_.take(thing_, crossing, segment_);
      within.reach = segment_.reach;
    });
    return on || go_on();
  }

 private:
  static constexpr std::size_t kRecent = 4;

  struct Take {
    FirstCrossing* first;
    void operator()(std::uint32_t index, const Crossing& crossing, Segment& s) const {
      first->take(index, crossing, s);
    }
  };
  [[nodiscard]] Look<false, Take> look() { return {batch_->scene, *asked_, batch_->filter, {&first_}}; }
  /// To the next large mesh, past all else.
  bool go_on() {
    const SceneContent& scene = batch_->scene;
    while (true) {
      thing_ = recent_ > 0 ? recent_meshes_[--recent_] : things_.next(scene.resting, segment_);
      if (thing_ == Tree::kNone) break;
      const SceneContent::InstanceSlot& slot = scene.instances[thing_];
      const Mesh* mesh = scene.large_mesh(thing_);
      if (!mesh)
        look().at_rest(thing_, segment_);
      else if (slot.is_asked(batch_->filter) && mesh_.begin(*mesh, slot.placement.inside(segment_)))
        return true;
    }
    movers_along(scene, segment_, asked_->time, asked_->time + asked_->duration,
                 [this](std::uint32_t index, Segment& s) { look().at_mover(index, s); });
    if (first_.thing != 0) *into_ = hit_of(scene, first_.thing, first_.crossing, *asked_);
    return false;
  }

  const Batch* batch_;
  const SceneSegment* asked_;
  SceneHit* into_;
  Segment segment_;
  FirstCrossing first_;
  std::uint32_t thing_;                   // whose mesh it is on its way through
  std::uint32_t recent_meshes_[kRecent];  // that came lately and are yet to be looked at, the first one last
  std::size_t recent_;                    // how many of those
  RestingThings::Walk things_;
  Mesh::Walk mesh_;
};

/// Several at a time, which go on in turn.
void cast_in_turn(const Batch& batch, std::size_t begin, std::size_t end) {
  Cast casts[kTurns];
  Cast* active[kTurns];
  std::size_t count = 0;
  const auto begin_next = [&](Cast& cast) {
    while (begin < end)
      if (cast.begin(batch, batch.taken(begin++))) return true;
    return false;
  };
  for (Cast& cast : casts)
    if (begin_next(cast)) active[count++] = &cast;
  while (count > 0)
    for (std::size_t i = 0; i < count;)
      if (active[i]->step() || begin_next(*active[i]))
        ++i;
      else
        active[i] = active[--count];
}

void cast_one_by_one(const Batch& batch, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t at = batch.taken(i);
    first_hit(batch.scene, batch.segments[at], batch.filter, batch.into[at]);
  }
}

void run(void* self, std::size_t task) {
  const IeeeMode mode;
  const Batch& batch = *static_cast<const Batch*>(self);
  const std::size_t begin = task * kTask, end = std::min(batch.segments.size(), begin + kTask);
  if (batch.scene.large_meshes > 0 && end - begin > 1)
    cast_in_turn(batch, begin, end);
  else
    cast_one_by_one(batch, begin, end);
}

}  // namespace

void first_hit(const SceneContent& scene, const SceneSegment& asked, const SceneFilter& filter, SceneHit& into) {
  FirstCrossing first;
  cross_all<false>(scene, asked, asked.radius, filter,
                   [&](std::uint32_t index, const Crossing& crossing, Segment& s) { first.take(index, crossing, s); });
  if (first.thing != 0) into = hit_of(scene, first.thing, first.crossing, asked);
}

void first_hits(const SceneContent& scene, std::size_t bytes, std::span<const SceneSegment> segments,
                std::span<SceneHit> into, const SceneFilter& filter, TaskRunner* runner) {
  // From here on it pays to look for neighbours: what they look at is read once, but they lie all over the memory. On
  // the way through large meshes several in turn wait less than neighbours do, which wait for the same memory.
  constexpr std::size_t kMany = 2048, kCached = 1 << 20;
  const std::size_t count = segments.size();
  PHYSIM_ASSERT(count == into.size());
  Batch batch{scene, segments, into, filter, {}};
  const bool sortable = count >= kMany && count <= std::numeric_limits<std::uint32_t>::max();
  if (sortable && bytes >= kCached && scene.large_meshes == 0) batch.sort();
  const std::size_t tasks = (count + kTask - 1) / kTask;
  if (runner && tasks > 1)
    runner->run(tasks, run, &batch);
  else
    for (std::size_t task = 0; task < tasks; ++task) run(&batch, task);
}

}  // namespace physim::collide
