// Segments cast into a height field, many at once: first all of them are compared with the cells below them, without a
// branch that could be guessed wrong; then triangles are looked at where something may be met.
#pragma once

#include <span>

#include "collide/cast.hpp"
#include "collide/field_job.hpp"

namespace physim::collide {

/// Whether all that a scene holds is a height field at rest.
[[nodiscard]] inline bool is_field_alone(const SceneContent& scene) {
  return scene.alive == 1 && scene.fields.size() == 1;
}

/// Calls take(number, first) for each of some segments that meets a height field at rest, with what it meets first.
template <class Take>
void cast_into_field(const SceneContent& scene, std::uint32_t index, std::span<const SceneSegment> segments,
                     const Take& take) {
  const SceneContent::InstanceSlot& slot = scene.instances[index];
  const HeightField& field = std::get<HeightField>(*slot.shape);
  PHYSIM_ASSERT(!slot.path && segments.size() <= kFieldSegments);
  std::uint32_t numbers[kFieldSegments];
  FieldNear near[kFieldSegments + 1];
  FieldJob job{.grid = field.grid(), .segments = segments.data(), .numbers = numbers, .count = 0, .near = near};
  slot.placement.put_axes(job);
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    numbers[job.count] = i;
    job.count += is_sound(segments[i]) ? 1 : 0;
  }
  field_kernel().find_cells(job);
  PHYSIM_ASSERT(job.found <= job.count);
  for (std::size_t i = 0; i < job.found; ++i) {
    constexpr std::size_t kAhead = 6;
    if (i + kAhead < job.found) field.prefetch(near[i + kAhead].cells);
    const FieldNear& each = near[i];
    const SceneSegment& asked = segments[each.number];
    Segment s = slot.placement.inside(Segment{asked.from, asked.to - asked.from, asked.radius, 1});
    FirstCrossing first;
    field.crossings_in(s, each.cells,
                       [&](const Crossing& crossing, Segment& within) { first.take(index, crossing, within); });
    if (first.thing != 0) take(each.number, first);
  }
}

}  // namespace physim::collide
