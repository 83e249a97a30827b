// Where emitters are and which way they point, between the ends of a step.
#pragma once

#include <algorithm>
#include <cmath>

#include "collide/path.hpp"
#include "math/quat.hpp"
#include "physim/world_projectile.hpp"

namespace physim {

/// Where an emitter is at a moment, and how it moves.
struct Pose {
  Vec3d position;
  Quatd rotation;
  Vec3d velocity;
};

/// Frames that are no longer are a moment: how fast something moved in them would be a matter of rounding [s].
constexpr double kShortestMove = 1e-9;

/// The projectile that an emitter follows, over the step at hand; a cubic joins both ends.
struct Followed {
  double from = 0, to = 0;  // it was there so long [s]
  BodyState begin, end;
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

/// On the cubic that has the places and velocities of both ends; at the later one where they are next to each other.
[[nodiscard]] inline MotionState between(const Followed& f, double time) {
  if (!(f.to - f.from > kShortestMove)) return {.position = f.end.position, .velocity = f.end.velocity};
  const MotionKey begin{.time = f.from, .position = f.begin.position, .velocity = f.begin.velocity};
  const MotionKey end{.time = f.to, .position = f.end.position, .velocity = f.end.velocity};
  return collide::between(begin, end, MotionCurve::smooth).at(std::clamp(time, f.from, f.to));
}

}  // namespace physim
