// Which questions to a scene make sense.
#pragma once

#include <cmath>

#include "collide/segment.hpp"
#include "physim/scene.hpp"

namespace physim::collide {

inline constexpr double kLatest = 1e9;  // times beyond are not asked about [s]

/// Where something may stand: lengths from there are numbers.
[[nodiscard]] inline bool is_near(const Vec3d& p) { return dot(p, p) <= kFarthest * kFarthest; }
[[nodiscard]] inline bool is_soon(double time) { return std::abs(time) <= kLatest; }

[[nodiscard]] inline bool is_sound(const SceneSegment& s) {
  return is_near(s.from) && is_near(s.to) && s.radius >= 0 && s.radius <= kFarthest && is_soon(s.time) &&
         s.duration >= 0 && s.duration <= kLatest;
}

}  // namespace physim::collide
