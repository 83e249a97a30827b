// How far along many segments nothing that rests can be touched.
#pragma once

#include <cstdint>
#include <span>

#include "physim/scene.hpp"

namespace physim::collide {

struct SceneContent;

struct ClearQuery {
  SceneSegment segment;
  std::uint32_t layers = 0;
  double part = 0;  // as SceneByMotion::clear_part() says
};

/// Finds the part of each, in a scene without an engine: many go through its trees together.
void clear_parts(const SceneContent& scene, std::span<ClearQuery> queries);

}  // namespace physim::collide
