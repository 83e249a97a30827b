// A scene of ours as somebody else's: it answers as engines do.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "physim/scene.hpp"

namespace physim::test {

/// What a segment meets first of a scene; not the solid in which it starts.
inline SceneHit first_from_outside(const Scene& scene, const SceneSegment& segment, const SceneFilter& filter) {
  const SceneHit hit = scene.first_hit(segment, filter);
  if (!hit.starts_inside) return hit;
  if (segment.radius > 0) return {};
  for (const SceneHit& each : scene.all_hits(segment, filter))
    if (!each.starts_inside && each.entering) return each;
  return {};
}

/// A query that only says what it must and may. Materials have the numbers of the scene that answers.
inline EngineQuery answers_of(std::shared_ptr<const Scene> scene) {
  return [scene = std::move(scene)](const EngineBatch& batch) {
    for (std::size_t i = 0; i < batch.segments.size(); ++i) {
      const SceneHit hit = first_from_outside(*scene, batch.segments[i], {.layers = batch.layers, .sensors = false});
      if (!hit) continue;
      batch.hits[i].part = hit.part;
      batch.hits[i].normal = hit.normal * 3.0;  // of any length
      batch.hits[i].velocity = hit.velocity;
      batch.hits[i].instance.index = hit.instance.index;
      batch.hits[i].primitive = hit.primitive;
      batch.hits[i].material = hit.material;
      batch.hits[i].entering = hit.entering;
    }
  };
}

/// A scene with nothing of its own but the materials of another one, which answers.
inline Scene answered_by(const Scene& scene, std::uint32_t materials, double skin = 1e-6) {
  Scene asking;
  for (std::uint32_t i = 1; i <= materials; ++i) static_cast<void>(asking.add_material(scene.material({i})));
  EXPECT_TRUE(asking.set_engine({answers_of(std::make_shared<const Scene>(scene)), skin}));
  return asking;
}

}  // namespace physim::test
