#include "collide/cast_batch.hpp"

#include <limits>

#include "base/ieee_mode.hpp"
#include "collide/cast.hpp"
#include "collide/order.hpp"

namespace physim::collide {
namespace {

constexpr std::size_t kTask = 256;  // segments
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
  static void run(void* self, std::size_t task) {
    const IeeeMode mode;
    const Batch& batch = *static_cast<const Batch*>(self);
    const std::size_t begin = task * kTask, end = std::min(batch.segments.size(), begin + kTask);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t at = batch.taken(i);
      first_hit(batch.scene, batch.segments[at], batch.filter, batch.into[at]);
    }
  }

 private:
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
  /// A segment and the place of its hit are on their way from where they lie in memory. Inlined, as g++ leaves out
  /// calls of what does nothing else.
  PHYSIM_INLINE void prefetch(std::size_t number) const {
    const auto* segment = reinterpret_cast<const char*>(&segments[number]);
    const auto* hit = reinterpret_cast<const char*>(&into[number]);
    constexpr std::size_t kLine = 64;
    static_assert(sizeof(SceneSegment) <= 2 * kLine && sizeof(SceneHit) <= 2 * kLine);
    __builtin_prefetch(segment);
    __builtin_prefetch(segment + sizeof(SceneSegment) - 1);
    __builtin_prefetch(hit, 1);
    __builtin_prefetch(hit + kLine, 1);
    __builtin_prefetch(hit + sizeof(SceneHit) - 1, 1);
  }
};

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
  constexpr std::size_t kMany = 2048, kCached = 1 << 20;
  const std::size_t count = segments.size();
  PHYSIM_ASSERT(count == into.size());
  Batch batch{scene, segments, into, filter, {}};
  if (count >= kMany && count <= std::numeric_limits<std::uint32_t>::max() && bytes >= kCached) batch.sort();
  const std::size_t tasks = (count + kTask - 1) / kTask;
  if (runner && tasks > 1)
    runner->run(tasks, Batch::run, &batch);
  else
    for (std::size_t task = 0; task < tasks; ++task) Batch::run(&batch, task);
}

}  // namespace physim::collide
