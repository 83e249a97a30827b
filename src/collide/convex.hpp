// Convex shapes: sphere, capsule, box, cylinder and half-space, met by points and by spheres.
//
// What it models: where a point or a sphere that moves along a straight line touches a convex body.
// Symbols: p(t) = o + t d a point of the segment; dist(p) distance from the body, 0 inside; r radius of the sphere.
// Equation: f(t) = dist(p(t)) - r. The distance from a convex set is a convex function, and so is f along a line; where
//   f > 0 and f' < 0, the tangent's zero t - f / f' lies before the first zero of f. Newton's method from outside
//   therefore never passes the surface, converges to its first touch, and a slope that is not negative says that there
//   is none. What is nearest stays in front: where it lies behind, rounding took the sphere through the surface. A
//   body is a core with a margin about it: a sphere is a point, a capsule a line, with theirs.
//   Points meet flat faces exactly, by clipping the segment.
// Source: S. Boyd, L. Vandenberghe, Convex Optimization (2004), sec. 3.1.3 (tangents below convex functions) and 3.2.5
//   (the distance from a convex set is convex); clipping: M. Cyrus, J. Beck, "Generalized two- and three-dimensional
//   clipping", Computers & Graphics 3 (1978) 23-28.
#pragma once

#include <limits>
#include <optional>

#include "collide/box.hpp"
#include "collide/segment.hpp"
#include "physim/math.hpp"
#include "physim/scene.hpp"

namespace physim::collide {

/// The point of a core that is nearest to another one: how far, and the unit vector from it.
struct Nearest {
  double distance = 0;
  Vec3d away;  // zero where the point lies in the core
};

/// From the difference between a point and what is nearest to it.
[[nodiscard]] inline Nearest nearest_by(const Vec3d& difference) {
  const double distance = length(difference);
  if (distance > 1e-140) return {distance, difference * (1 / distance)};
  const double most = std::max({std::abs(difference.x), std::abs(difference.y), std::abs(difference.z)});
  if (most < 1e-300) return {};
  const Nearest enlarged = nearest_by(difference * (1 / most));  // squares of less are no numbers any more
  return {most * enlarged.distance, enlarged.away};
}

// ------------------------------------------------------------------------------------------- the shapes
[[nodiscard]] inline Bounds bounds_about(const Vec3d& half) {
  Bounds box;
  box.take(half);
  box.take(-half);
  return box;
}

struct Sphere {
  double radius;

  [[nodiscard]] SphereShape definition() const { return {radius}; }
  [[nodiscard]] Bounds bounds() const { return bounds_about({radius, radius, radius}); }
  [[nodiscard]] double margin() const { return radius; }
  [[nodiscard]] Nearest nearest(const Vec3d& p) const { return nearest_by(p); }
};

/// About the y axis, with its round ends beyond `half_height`.
struct Capsule {
  double radius, half_height;

  [[nodiscard]] CapsuleShape definition() const { return {radius, half_height}; }
  [[nodiscard]] Bounds bounds() const { return bounds_about({radius, half_height + radius, radius}); }
  [[nodiscard]] double margin() const { return radius; }
  [[nodiscard]] Nearest nearest(const Vec3d& p) const {
    return nearest_by({p.x, p.y - std::clamp(p.y, -half_height, half_height), p.z});
  }
};

struct Box {
  Vec3d half;

  [[nodiscard]] BoxShape definition() const { return {half}; }
  [[nodiscard]] Bounds bounds() const { return bounds_about(half); }
  [[nodiscard]] double margin() const { return 0; }
  [[nodiscard]] Nearest nearest(const Vec3d& p) const {
    return nearest_by({p.x - std::clamp(p.x, -half.x, half.x), p.y - std::clamp(p.y, -half.y, half.y),
                       p.z - std::clamp(p.z, -half.z, half.z)});
  }
};

/// About the y axis.
struct Cylinder {
  double radius, half_height;

  [[nodiscard]] CylinderShape definition() const { return {radius, half_height}; }
  [[nodiscard]] Bounds bounds() const { return bounds_about({radius, half_height, radius}); }
  [[nodiscard]] double margin() const { return 0; }
  [[nodiscard]] Nearest nearest(const Vec3d& p) const {
    const double across = std::sqrt(p.x * p.x + p.z * p.z);
    const double beyond = across > radius ? (across - radius) / across : 0;  // of the way to the axis
    return nearest_by({p.x * beyond, p.y - std::clamp(p.y, -half_height, half_height), p.z * beyond});
  }
};

/// Below the plane y = 0.
struct HalfSpace {
  [[nodiscard]] PlaneShape definition() const { return {}; }
  [[nodiscard]] Bounds bounds() const { return {}; }
  [[nodiscard]] double margin() const { return 0; }
  [[nodiscard]] Nearest nearest(const Vec3d& p) const { return p.y > 0 ? Nearest{p.y, {0, 1, 0}} : Nearest{}; }
};

// ------------------------------------------------------------------------------------------- by Newton's method
/// The first touch of a sphere about the segment's points with what lies within `margin` of a core, whose nearest point
/// `nearest(p)` gives. Both together are not zero.
template <class NearestTo>
[[nodiscard]] std::optional<Crossing> first_touch(const Segment& s, double margin, const NearestTo& nearest) {
  const double reach = margin + s.radius;
  PHYSIM_ASSERT(reach > 0);
  // Places are rounded to this.
  const double touch = 4 * std::numeric_limits<double>::epsilon() * (s.extent() + margin);
  if (s.reach < 0) return std::nullopt;
  double t = 0;
  Vec3d ahead;                // `away` of the place before
  constexpr int kMost = 200;  // a sphere that grazes comes nearer by halves
  for (int i = 0; i < kMost; ++i) {
    const Nearest near = nearest(s.at(t));
    const double gap = near.distance - reach;
    const double slope = dot(near.away, s.along);
    PHYSIM_ASSERT(t >= 0 && t <= s.reach && (near.distance == 0 || std::abs(length(near.away) - 1) < 1e-6));
    if (dot(near.away, ahead) < -0.5) return Crossing{t, ahead};  // where it turns by less, it may be far
    if (gap <= touch) {
      if (i > 0) return Crossing{t, near.away};
      if (gap < -touch) return Crossing{0, normalized(-s.along), 0, true, true};
      // It starts at the surface: it hits where it goes inwards.
      return slope < 0 ? std::optional(Crossing{0, near.away}) : std::nullopt;
    }
    if (slope >= 0) return std::nullopt;
    const double next = t - gap / slope;
    if (next > s.reach) return std::nullopt;
    if (next == t) return Crossing{t, near.away};
    t = next;
    ahead = near.away;
  }
  return std::nullopt;
}

/// A segment walked the other way.
[[nodiscard]] inline Segment reversed(const Segment& s) {
  PHYSIM_ASSERT(s.reach >= 0 && s.reach <= 1);
  return {s.at(s.reach), s.along * -s.reach, s.radius, 1};
}

/// Where a segment is inside of a core or its margin.
template <class Convex>
[[nodiscard]] Passage passage_by_distance(const Segment& s, const Convex& shape, bool with_exit) {
  const auto nearest = [&shape](const Vec3d& p) { return shape.nearest(p); };
  const auto in = first_touch(s, shape.margin(), nearest);
  if (!in) return {};
  Passage passage{*in, *in, true};
  passage.out.entering = false;
  passage.out.t = kInfinity;
  if (!with_exit) return passage;
  passage.out.t = in->t;
  if (const auto out = first_touch(reversed(s), shape.margin(), nearest)) {  // else it touches and goes
    passage.out.normal = out->normal;
    passage.out.t = out->starts_inside ? kInfinity : std::max(in->t, s.reach * (1 - out->t));
  }
  return passage;
}

// ------------------------------------------------------------------------------------------- by clipping
/// The part of a segment inside of a convex body, clipped by one surface after the other. The body is closed: a segment
/// along a surface is inside, and so is one beside it by no more than the segment's seam. So a segment meets at least
/// one of two bodies that touch. A segment that begins at a surface and does not go inwards meets nothing.
class Clipped {
 public:
  explicit Clipped(const Segment& s) : from_(s.from), along_(s.along), seam_(s.seam) {}

  /// Inside are points p with dot(normal, p) <= offset.
  void by_plane(const Vec3d& normal, double offset) {
    const double above = dot(normal, from_) - offset, rate = dot(normal, along_);
    if (rate < 0) return enter(-above / rate, (seam_ - above) / rate, normal);
    begins_outside_ = begins_outside_ || above >= 0;
    if (rate > 0) return leave(-above / rate, (seam_ - above) / rate, normal);
    if (above > seam_) leave(-kInfinity, -kInfinity, normal);
  }
  /// Inside of the cylinder of a radius about the y axis.
  void by_cylinder(double radius) {
    const double a = along_.x * along_.x + along_.z * along_.z;
    const double b = from_.x * along_.x + from_.z * along_.z;
    const double off = std::sqrt(from_.x * from_.x + from_.z * from_.z), wide = radius + seam_;
    if (a == 0) {
      begins_outside_ = begins_outside_ || off >= radius;
      if (off > wide) leave(-kInfinity, -kInfinity, {1, 0, 0});
      return;
    }
    // By the distance of the line from the axis: the discriminant cancels less than b^2 - a c, and normals have
    // length 1.
    const double size = std::sqrt(a), dx = along_.x / size, dz = along_.z / size;
    const double beside = from_.x * dz - from_.z * dx;
    if (std::abs(beside) > wide) return leave(-kInfinity, -kInfinity, {1, 0, 0});
    const double half = std::sqrt(std::max((radius - beside) * (radius + beside), 0.0)), middle = -b / a;
    const double half_wide = std::sqrt((wide - beside) * (wide + beside));
    const double outwards = std::max(radius, std::abs(beside));
    const auto normal_at = [&](double way) {
      return Vec3d{(dz * beside + dx * way) / outwards, 0, (dz * way - dx * beside) / outwards};
    };
    enter(middle - half / size, middle - half_wide / size, normal_at(-half));
    leave(middle + half / size, middle + half_wide / size, normal_at(half));
  }

  [[nodiscard]] Passage passage(double reach) const {
    if (out_.at <= 0 || out_.with_seam < 0) return {};  // what leaves from the surface meets nothing
    if (in_.at < 0 && begins_outside_) return {};       // nor does what goes along it
    if (in_.with_seam > out_.with_seam || in_.at > out_.with_seam || in_.at > reach) return {};
    PHYSIM_ASSERT(in_.at == -kInfinity || std::abs(length(in_.normal) - 1) < 1e-6);
    PHYSIM_ASSERT(out_.at == kInfinity || std::abs(length(out_.normal) - 1) < 1e-6);
    Passage passage{{in_.at, in_.normal}, {std::max(in_.at, out_.at), out_.normal, 0, false}, true};
    if (in_.at < 0) passage.in = {0, normalized(-along_), 0, true, true};
    if (out_.at > reach) passage.out.t = kInfinity;  // it ends inside
    return passage;
  }

 private:
  /// The parameters of the segment at a surface, and at the same surface one seam farther out.
  struct Side {
    double at, with_seam;
    Vec3d normal;
  };
  /// The surface that the segment comes to last is kept, with its seam: the edge of a gap is none.
  void enter(double at, double with_seam, const Vec3d& normal) {
    const bool ahead = at >= 0, other_ahead = in_.at >= 0;
    if (ahead != other_ahead ? ahead : with_seam > in_.with_seam) in_ = {at, with_seam, normal};
  }
  void leave(double at, double with_seam, const Vec3d& normal) {
    if (with_seam < out_.with_seam) out_ = {at, with_seam, normal};
  }

  Vec3d from_, along_;
  double seam_;
  Side in_{-kInfinity, -kInfinity, {}}, out_{kInfinity, kInfinity, {}};
  bool begins_outside_ = false;
};

[[nodiscard]] inline Passage passage_by_clipping(const Segment& s, const Box& box) {
  Clipped clipped(s);
  const double half[3] = {box.half.x, box.half.y, box.half.z};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vec3d normal;
      normal[axis] = side;
      clipped.by_plane(normal, half[axis]);
    }
  return clipped.passage(s.reach);
}
[[nodiscard]] inline Passage passage_by_clipping(const Segment& s, const Cylinder& cylinder) {
  Clipped clipped(s);
  clipped.by_plane({0, 1, 0}, cylinder.half_height);
  clipped.by_plane({0, -1, 0}, cylinder.half_height);
  clipped.by_cylinder(cylinder.radius);
  return clipped.passage(s.reach);
}
[[nodiscard]] inline Passage passage_by_clipping(const Segment& s, const HalfSpace&) {
  Clipped clipped(s);
  clipped.by_plane({0, 1, 0}, 0);
  return clipped.passage(s.reach);
}

/// Where a segment, or the spheres about its points, is inside of a shape; its exit only where it is asked for.
template <class Convex>
[[nodiscard]] Passage passage(const Segment& s, const Convex& shape, bool with_exit) {
  if constexpr (requires { passage_by_clipping(s, shape); }) {
    if (s.radius == 0) return passage_by_clipping(s, shape);
  }
  return passage_by_distance(s, shape, with_exit);
}

}  // namespace physim::collide
