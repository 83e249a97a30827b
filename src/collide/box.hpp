// Boxes along the axes, and segments that are compared with them.
#pragma once

#include <limits>

#include "collide/segment.hpp"
#include "math/pack.hpp"
#include "physim/math.hpp"

namespace physim::collide {

/// An axis-aligned box; empty where low > high.
struct Bounds {
  Vec3d low{kInfinity, kInfinity, kInfinity};
  Vec3d high{-kInfinity, -kInfinity, -kInfinity};

  void take(const Vec3d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void take(const Bounds& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
  }
  /// Moves all sides out.
  void widen(double by) {
    low -= Vec3d{by, by, by};
    high += Vec3d{by, by, by};
  }
  /// Leaves what lies in another one, too.
  void meet(const Bounds& other) {
    low = {std::max(low.x, other.low.x), std::max(low.y, other.low.y), std::max(low.z, other.low.z)};
    high = {std::min(high.x, other.high.x), std::min(high.y, other.high.y), std::min(high.z, other.high.z)};
  }
  /// The largest coordinate.
  [[nodiscard]] double extent() const {
    double most = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) most = std::max({most, std::abs(low[axis]), std::abs(high[axis])});
    return most;
  }
  [[nodiscard]] bool meets(const Bounds& other) const {
    return low.x <= other.high.x && low.y <= other.high.y && low.z <= other.high.z && other.low.x <= high.x &&
           other.low.y <= high.y && other.low.z <= high.z;
  }
  /// Not more than the distance of p.
  [[nodiscard]] double least_distance(const Vec3d& p) const {
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double beyond = std::max({low[axis] - p[axis], p[axis] - high[axis], 0.0});
      square += beyond * beyond;
    }
    return std::sqrt(square) * (1 - 8 * std::numeric_limits<double>::epsilon());
  }
  [[nodiscard]] Vec3d middle() const { return (low + high) * 0.5; }
  /// Half of its surface.
  [[nodiscard]] double area() const {
    const Vec3d d = high - low;
    return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

/// A segment, ready to be compared with boxes.
class BoxTest {
 public:
  /// What coordinates are rounded to is added to the radius, so that what goes along a side of a box meets it.
  PHYSIM_INLINE explicit BoxTest(const Segment& s)
      : from_(s.from),
        per_along_{finite_inverse(s.along.x), finite_inverse(s.along.y), finite_inverse(s.along.z)},
        radius_(s.radius + std::max(seam_at(s.extent()), s.seam)) {}

  /// One over its way along each axis, finite along axes without any.
  [[nodiscard]] const Vec3d& per_along() const { return per_along_; }
  /// Where the segment enters a box; infinite where it passes it, or beyond `reach`.
  PHYSIM_INLINE double enters(const Bounds& box, double reach) const { return enters(box.low, box.high, reach); }
  /// That of one box or a pack of them, from corner to corner.
  template <class R>
  PHYSIM_INLINE R enters(const Vec3<R>& low, const Vec3<R>& high, double reach) const {
    R in(0.0), out(reach);
    cut(low.x, high.x, from_.x, per_along_.x, in, out);
    cut(low.y, high.y, from_.y, per_along_.y, in, out);
    cut(low.z, high.z, from_.z, per_along_.z, in, out);
    return select(in <= out, in, R(kInfinity));
  }

 private:
  /// Three roundings on each side: the far one is moved out by more than they are.
  template <class R>
  PHYSIM_INLINE void cut(const R& low, const R& high, double from, double per_along, R& in, R& out) const {
    const R one = (low - R(from) - R(radius_)) * R(per_along), other = (high - R(from) + R(radius_)) * R(per_along);
    in = max(min(other, one), in);
    out = min(max(other, one) * R(1 + 8 * std::numeric_limits<double>::epsilon()), out);
  }

  Vec3d from_, per_along_;
  double radius_;
};

}  // namespace physim::collide
