#include "collide/cast_batch.hpp"

#include <algorithm>
#include <limits>

#include "base/ieee_mode.hpp"
#include "base/prefetch.hpp"
#include "collide/cast_crowd.hpp"
#include "collide/cast_field.hpp"
#include "collide/order.hpp"

namespace physim::collide {
namespace {

constexpr std::size_t kTask = 256;  // segments
constexpr std::size_t kFew = 4;     // so many are worth more work than each alone
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

/// What a segment meets first.
class FirstHit {
 public:
  static constexpr Which kWhich = Which::all;
  static constexpr Asks kAsks = Asks::first_hit;

  /// False where it makes no sense.
  bool put(const Batch& batch, std::size_t number) {
    batch_ = &batch;
    asked_ = &batch.segments[number];
    into_ = &batch.into[number];
    prefetch_to_write(into_);
    prefetch_to_write(into_, 64);
    prefetch_to_write(into_, sizeof(SceneHit) - 1);
    first_ = {};
    segment_ = {asked_->from, asked_->to - asked_->from, asked_->radius, 1};
    return is_sound(*asked_);
  }
  [[nodiscard]] const SceneContent& scene() const { return batch_->scene; }
  [[nodiscard]] const SceneFilter& filter() const { return batch_->filter; }
  [[nodiscard]] const SceneSegment& asked() const { return *asked_; }
  [[nodiscard]] Segment& segment() { return segment_; }
  void at_rest(std::uint32_t index) { look().at_rest(index, segment_); }
  void at_mover(std::uint32_t index) { look().at_mover(index, segment_); }
  void look(const Mesh& mesh, std::uint32_t index, std::uint32_t first, std::uint32_t end, Segment& inside) {
    inside.reach = segment_.reach;
    const Shear unused{};  // by spheres
    for (std::uint32_t i = first; i < end; ++i) take(mesh, index, i, meets(inside, unused, mesh.triangle(i)), inside);
  }
  void pass(const Mesh& mesh, std::uint32_t index, std::uint32_t triangle, double t, Segment& inside) {
    inside.reach = segment_.reach;
    take(mesh, index, triangle, crossing_at(t, inside, mesh.triangle(triangle)), inside);
  }
  void leaves(std::uint32_t, const Segment&) {}
  void end() { *into_ = first_.thing != 0 ? hit_of(batch_->scene, first_.thing, first_.crossing, *asked_) : kNothing; }

 private:
  struct Take {
    FirstCrossing* first;
    void operator()(std::uint32_t index, const Crossing& crossing, Segment& s) const {
      first->take(index, crossing, s);
    }
  };
  void take(const Mesh& mesh, std::uint32_t index, std::uint32_t triangle, std::optional<Crossing> crossing,
            Segment& inside) {
    if (!crossing) return;
    crossing->primitive = mesh.number(triangle);
    first_.take(index, *crossing, segment_);
    inside.reach = segment_.reach;
  }
  [[nodiscard]] Look<false, Take> look() { return {batch_->scene, *asked_, batch_->filter, {&first_}}; }

  const Batch* batch_;
  const SceneSegment* asked_;
  SceneHit* into_;
  Segment segment_;
  FirstCrossing first_;
};

void cast_together(const Batch& batch, std::size_t begin, std::size_t end) {
  CastCrowd<FirstHit> crowd;
  crowd.cast([&](FirstHit& question) {
    for (; begin < end; ++begin) {
      if (question.put(batch, begin)) return ++begin, true;
      batch.into[begin] = kNothing;
    }
    return false;
  });
}

void cast_one_by_one(const Batch& batch, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t at = batch.taken(i);
    first_hit(batch.scene, batch.segments[at], batch.filter, batch.into[at]);
  }
}

bool is_field_alone(const SceneContent& scene, const SceneFilter& filter) {
  return is_field_alone(scene) && scene.instances[scene.fields[0]].is_asked(filter);
}

void cast_into_field_alone(const Batch& batch, std::size_t begin, std::size_t end) {
  const std::uint32_t field = batch.scene.fields[0];
  for (; begin < end; begin += kFieldSegments) {
    const std::size_t here = std::min(kFieldSegments, end - begin);
    const auto segments = batch.segments.subspan(begin, here);
    const auto into = batch.into.subspan(begin, here);
    std::ranges::fill(into, kNothing);
    cast_into_field(batch.scene, field, segments, [&](std::uint32_t number, const FirstCrossing& first) {
      into[number] = hit_of(batch.scene, field, first.crossing, segments[number]);
    });
  }
}

void run(void* self, std::size_t task) {
  const IeeeMode mode;
  const Batch& batch = *static_cast<const Batch*>(self);
  const std::size_t begin = task * kTask, end = std::min(batch.segments.size(), begin + kTask);
  const bool is_plain = batch.scene.one_ways == 0 || !batch.filter.from_front;
  if (!is_plain)
    cast_one_by_one(batch, begin, end);
  else if (is_field_alone(batch.scene, batch.filter))
    cast_into_field_alone(batch, begin, end);
  else if (batch.scene.meshes > 0 && end - begin >= kFew)
    cast_together(batch, begin, end);
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
  // From here on it pays to look for neighbours: what they look at is read once, but they lie all over the memory.
  // Those that go through meshes together need not wait for it.
  constexpr std::size_t kMany = 2048, kCached = 1 << 20;
  const std::size_t count = segments.size();
  PHYSIM_ASSERT(count == into.size());
  Batch batch{scene, segments, into, filter, {}};
  const bool sortable = count >= kMany && count <= std::numeric_limits<std::uint32_t>::max();
  if (sortable && bytes >= kCached && scene.meshes == 0 && !is_field_alone(scene, filter)) batch.sort();
  const std::size_t tasks = (count + kTask - 1) / kTask;
  if (runner && tasks > 1)
    runner->run(tasks, run, &batch);
  else
    for (std::size_t task = 0; task < tasks; ++task) run(&batch, task);
}

}  // namespace physim::collide
