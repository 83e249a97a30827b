// Where emitters are and which way they point, between the ends of a step.
#pragma once

#include <algorithm>
#include <cmath>

#include "math/elementary.hpp"
#include "math/quat.hpp"
#include "physim/world_projectile.hpp"

namespace physim {

/// Where an emitter is at a moment, and how it moves.
struct Pose {
  Vec3d position;
  Quatd rotation;
  Vec3d velocity;
};

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

/// On the cubic that has the places and velocities of both ends.
[[nodiscard]] inline BodyState between(const Followed& f, double time) {
  const double span = f.to - f.from;
  if (!(span > 0)) return f.end;
  const double u = std::clamp((time - f.from) / span, 0.0, 1.0);
  const Vec3d way = f.end.position - f.begin.position, v0 = f.begin.velocity * span, v1 = f.end.velocity * span;
  const Vec3d c2 = way * 3 - v0 * 2 - v1, c3 = v0 + v1 - way * 2;
  return {f.begin.position + (v0 + (c2 + c3 * u) * u) * u, (v0 + (c2 * 2 + c3 * (3 * u)) * u) * (1 / span)};
}

/// Steadily, by the shorter way.
[[nodiscard]] inline Quatd turned(const Quatd& from, const Quatd& to, double u) {
  const double side = from.w * to.w + from.x * to.x + from.y * to.y + from.z * to.z;
  if (from == to) return from;
  const Quatd near = side < 0 ? Quatd{-to.w, -to.x, -to.y, -to.z} : to;
  const Quatd way = near * conjugate(from);
  const Vec3d axis{way.x, way.y, way.z};
  const double sine = length(axis);
  if (!(sine > 0)) return from;
  return normalized(quat_from_axis_angle(axis * (1 / sine), 2 * atan2(sine, way.w) * u) * from);
}

}  // namespace physim
