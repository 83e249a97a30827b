// What segments meet first: one alone, or many at once.
#pragma once

#include <span>

#include "collide/content.hpp"
#include "physim/result.hpp"

namespace physim::collide {

/// Where it meets nothing, `into` stays as it is.
void first_hit(const SceneContent& scene, const SceneSegment& asked, const SceneFilter& filter, SceneHit& into);

/// What each of many segments meets first, as if it were cast alone. `into` is as long as they are many; `bytes` is
/// what the scene takes.
void first_hits(const SceneContent& scene, std::size_t bytes, std::span<const SceneSegment> segments,
                std::span<SceneHit> into, const SceneFilter& filter, TaskRunner* runner);

}  // namespace physim::collide
