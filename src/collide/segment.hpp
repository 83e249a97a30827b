// A segment that is cast into a scene, and what a shape says of it. Everything here is in the shape's own frame.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/assert.hpp"
#include "math/vec3.hpp"

namespace physim::collide {

/// Farther away nothing stands: squares of lengths are numbers, and floats hold lengths [m].
inline constexpr double kFarthest = 1e15;

/// The widest gap that rounding of positions and of a segment may make between two bodies that touch [m]. `extent`: the
/// largest of the coordinates [m].
[[nodiscard]] inline double seam_at(double extent) { return 8 * std::numeric_limits<double>::epsilon() * extent; }

/// The points from + t along, 0 <= t <= reach <= 1; with a radius, the spheres about them. Whoever finds a nearer hit
/// shortens the reach; below 0, nothing is wanted any more.
struct Segment {
  Vec3d from;
  Vec3d along;
  double radius = 0;
  double reach = 1;
  double seam = 0;  // that of the places in W that it was made of, see seam_at()

  [[nodiscard]] Vec3d at(double t) const { return from + along * t; }
  /// The largest of its coordinates, which what is below it is rounded to.
  [[nodiscard]] double extent() const {
    const auto most = [](const Vec3d& v) { return std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z))); };
    return most(from) + most(along) + radius;
  }
};

/// Where a segment crosses a surface.
struct Crossing {
  double t = 0;
  Vec3d normal;                 // outwards, of length one; where the segment starts inside, against its way
  std::uint32_t primitive = 0;  // triangle of a mesh, child of a compound
  bool entering = true;         // from outside, against the normal
  bool starts_inside = false;   // it is inside at t = 0, which is then the place
  std::uint32_t triangle = 0;   // of a child that is a mesh
};

/// What of a surface is nearest to a point.
struct NearPlace {
  Vec3d position;               // the point itself inside of a solid
  Vec3d away;                   // unit vector from there to the point; the normal on a triangle; zero in a solid
  std::uint32_t primitive = 0;  // as of a Crossing
  std::uint32_t triangle = 0;
};

/// Where a segment is inside of a convex shape: from `in` to `out`.
struct Passage {
  Crossing in, out;
  bool some = false;
};

/// Finite, so that a difference of zero stays zero.
[[nodiscard]] inline double finite_inverse(double x) {
  return 1 / (std::abs(x) < 1e-290 ? std::copysign(1e-290, x) : x);
}

/// The largest float that is not above a number of a size that float has.
[[nodiscard]] inline float float_below(double x) {
  const auto f = static_cast<float>(x);
  if (!(static_cast<double>(f) > x)) return f;
  const auto bits = std::bit_cast<std::uint32_t>(f);
  if (f == 0) return -std::numeric_limits<float>::denorm_min();
  return std::bit_cast<float>(f > 0 ? bits - 1 : bits + 1);
}
/// The smallest float that is not below it.
[[nodiscard]] inline float float_above(double x) { return -float_below(-x); }

}  // namespace physim::collide
