// Where emitters are and which way they point, between the ends of a step.
#pragma once

#include <cmath>

#include "math/quat.hpp"
#include "physim/math.hpp"

namespace physim {

/// Where an emitter is at a moment, and how it moves.
struct Pose {
  Vec3d position;
  Quatd rotation;
  Vec3d velocity;
};

/// Takes x to a direction, by the shorter way; y stays upwards as far as it can.
[[nodiscard]] inline Quatd looking_along(const Vec3d& direction) {
  const Vec3d x = normalized(direction);
  const Vec3d across = std::abs(x.y) < 0.999999 ? Vec3d{0, 1, 0} : Vec3d{-1, 0, 0};
  const Vec3d z = normalized(cross(x, across)), y = cross(z, x);
  // The columns of a rotation are its axes; the largest part of the quaternion is taken from the trace.
  const double trace = x.x + y.y + z.z;
  if (trace > 0) return normalized(Quatd{1 + trace, y.z - z.y, z.x - x.z, x.y - y.x});
  if (x.x > y.y && x.x > z.z) return normalized(Quatd{y.z - z.y, 1 + x.x - y.y - z.z, y.x + x.y, z.x + x.z});
  if (y.y > z.z) return normalized(Quatd{z.x - x.z, y.x + x.y, 1 + y.y - x.x - z.z, z.y + y.z});
  return normalized(Quatd{x.y - y.x, z.x + x.z, z.y + y.z, 1 + z.z - x.x - y.y});
}

}  // namespace physim
