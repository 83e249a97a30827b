// The axes of a plane across a direction.
#pragma once

#include <cmath>

#include "math/vec3.hpp"

namespace physim::client {

/// Directions of length one; `right` is level if the plane stands upright or leans.
struct PlaneAxes {
  Vec3d right, up;
};

/// `direction`: of length one, away from the eye.
[[nodiscard]] inline PlaneAxes axes_across(const Vec3d& direction) {
  const Vec3d above = std::abs(direction.y) < 0.999 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
  const Vec3d right = normalized(cross(direction, above));
  return {right, cross(right, direction)};
}

}  // namespace physim::client
