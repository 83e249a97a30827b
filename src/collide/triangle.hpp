// Triangles, met by points and by spheres.
//
// What it models: where a point that moves along a straight line passes a triangle, such that a line through a closed
//   mesh never slips between two triangles that share an edge or a vertex; and the point of a triangle nearest to
//   another one.
// Equations: the axes are permuted and sheared so that the line runs along z from the origin; it passes where the
//   edge functions U = Cx By - Cy Bx, V, W of the sheared corners have one sign, at t = (U Az + V Bz + W Cz) / (U + V +
//   W). The function of an edge is that of the neighbour with the other sign, bit for bit, as it is rounded from the
//   same two products; zero counts as inside of both.
// Source: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", Journal of Computer Graphics Techniques
//   2 (2013) 65-82; nearest point: C. Ericson, Real-Time Collision Detection (2005), sec. 5.1.5.
#pragma once

#include <array>
#include <optional>

#include "collide/box.hpp"
#include "collide/convex.hpp"
#include "math/pack.hpp"

namespace physim::collide {

/// A pack of four numbers, in registers from the first on: a wide load would wait for stores of single ones.
template <class R>
[[nodiscard]] PHYSIM_INLINE R four(double a, double b, double c, double d) {
  R pack;
  if constexpr (R::kRegisters == 1)
    pack.r[0] = typename R::Register{a, b, c, d};
  else if constexpr (R::kRegisters == 2)
    pack.r[0] = typename R::Register{a, b}, pack.r[1] = typename R::Register{c, d};
  else
    pack.set(0, a), pack.set(1, b), pack.set(2, c), pack.set(3, d);
  return pack;
}

struct Triangle {
  Vec3d a, b, c;  // counterclockwise as seen from outside

  [[nodiscard]] Vec3d normal() const { return normalized(cross(b - a, c - a)); }
};

/// A segment in the axes in which it runs along z.
class Shear {
 public:
  Shear() = default;
  PHYSIM_INLINE explicit Shear(const Segment& s) {
    const Components from = components(s.from), along = components(s.along);
    const double x = std::abs(along[0]), y = std::abs(along[1]), z = std::abs(along[2]);
    z_ = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    constexpr std::size_t kNext[] = {1, 2, 0, 1};  // axes behind each axis
    const bool backwards = along[z_] < 0;          // x and y change places, so that triangles keep their winding
    x_ = kNext[z_ + (backwards ? 1 : 0)];
    y_ = kNext[z_ + (backwards ? 0 : 1)];
    from_ = {from[x_], from[y_], from[z_]};
    seam_ = s.seam;
    if (along[z_] == 0) return;  // no way at all: it passes nothing
    along_x_ = along[x_] / along[z_];
    along_y_ = along[y_] / along[z_];
    per_z_ = 1 / along[z_];
  }

  /// Whether it goes anywhere; else it passes nothing.
  [[nodiscard]] PHYSIM_INLINE bool is_some() const { return per_z_ != 0; }
  /// Which of three numbers are those along its own axes.
  template <class R>
  [[nodiscard]] PHYSIM_INLINE Vec3<R> turned(const std::array<R, 3>& p) const {
    return {p[x_], p[y_], p[z_]};  // in memory, where an axis is an address: no selections
  }
  /// Whether the line through the segment passes triangles, one or a pack of them, with corners along its axes, and
  /// where.
  template <class R>
  PHYSIM_INLINE MaskOf<R> passes(const Vec3<R>& corner_a, const Vec3<R>& corner_b, const Vec3<R>& corner_c,
                                 R& t) const {
    PHYSIM_ASSERT(x_ != y_ && y_ != z_ && z_ != x_ && std::abs(along_x_) <= 1 && std::abs(along_y_) <= 1);
    const Vec3<R> a = sheared(corner_a), b = sheared(corner_b), c = sheared(corner_c);
    const R u = c.x * b.y - c.y * b.x;
    const R v = a.x * c.y - a.y * c.x;
    const R w = b.x * a.y - b.y * a.x;
    const R sum = u + v + w, zero(0.0);
    t = (u * a.z + v * b.z + w * c.z) / sum;
    // `most` is at least the longest edge. A sum of 0 is a triangle seen from its edge.
    const R most = (abs(a.x) + abs(a.y)) + (abs(b.x) + abs(b.y)) + (abs(c.x) + abs(c.y));
    const R wide = R(seam_) * most, beside = select(abs(sum) > R(16.0) * wide, wide, zero);
    const MaskOf<R> front = (u >= -beside) & (v >= -beside) & (w >= -beside);
    const MaskOf<R> back = (u <= beside) & (v <= beside) & (w <= beside);
    return (front | back) & (sum != zero);
  }
  /// Where the line through the segment passes a triangle.
  [[nodiscard]] PHYSIM_INLINE std::optional<double> passes(const Triangle& triangle) const {
    const auto turned_one = [this](const Vec3d& p) { return turned(Components{p.x, p.y, p.z}); };
    double t;
    if (!is_some() || !passes(turned_one(triangle.a), turned_one(triangle.b), turned_one(triangle.c), t))
      return std::nullopt;
    return t;
  }

 private:
  using Components = std::array<double, 3>;

  [[nodiscard]] PHYSIM_INLINE static Components components(const Vec3d& v) { return {v.x, v.y, v.z}; }
  /// With z counted along the segment.
  template <class R>
  [[nodiscard]] PHYSIM_INLINE Vec3<R> sheared(const Vec3<R>& p) const {
    const R z = p.z - from_.z;
    return {p.x - from_.x - along_x_ * z, p.y - from_.y - along_y_ * z, z * per_z_};
  }

  Vec3d from_;  // its axes permuted
  std::size_t x_, y_, z_;
  double along_x_ = 0, along_y_ = 0, per_z_ = 0;
  double seam_ = 0;
};

/// The point of a triangle nearest to p, and whether it lies within its edges.
[[nodiscard]] inline Vec3d nearest_point(const Triangle& t, const Vec3d& p, bool& over_face) {
  over_face = false;
  const Vec3d ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return t.a;
  const Vec3d bp = p - t.b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t.b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t.a + ab * (d1 / (d1 - d3));
  const Vec3d cp = p - t.c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t.c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t.a + ac * (d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return t.b + (t.c - t.b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const double per_sum = 1 / (va + vb + vc);
  over_face = true;
  return t.a + ab * (vb * per_sum) + ac * (vc * per_sum);
}
[[nodiscard]] inline Vec3d nearest_point(const Triangle& t, const Vec3d& p) {
  bool over_face = false;
  return nearest_point(t, p, over_face);
}

[[nodiscard]] inline double size_of(const Vec3d& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

/// The distance of p from a triangle. Over its face, or over its edge but for rounding, the way there is along the
/// normal: the difference of two places has the rounding of both in it, which turns it by a part of a hundred where p
/// is a tenth of a nanometre off and a kilometre from the origin, and what slides along the face would seem to leave
/// it.
[[nodiscard]] inline Nearest nearest_to(const Triangle& t, const Vec3d& p) {
  constexpr double kNarrow = 1e-5;  // what is narrower has a normal that rounding turns, too
  bool over_face = false;
  Nearest near = nearest_by(p - nearest_point(t, p, over_face));
  if (!(near.distance > 0)) return near;
  const Vec3d ab = t.b - t.a, ac = t.c - t.a, across = cross(ab, ac);
  const double size = dot(across, across);
  if (!over_face) {
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * (size_of(p) + size_of(t.a));
    const double part = rounding / near.distance;
    if (!(length_squared(cross(near.away, across)) <= part * part * size)) return near;
  }
  if (!(size > kNarrow * kNarrow * dot(ab, ab) * dot(ac, ac))) return near;
  const double per_length = 1 / std::sqrt(size);
  near.away = across * (dot(across, near.away) < 0 ? -per_length : per_length);
  return near;
}

/// Whether p is not below a plane through a, but for what the difference of their coordinates is rounded to.
[[nodiscard]] inline bool leaves_from(const Vec3d& a, const Vec3d& normal, const Vec3d& p) {
  double above = 0, size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    above += normal[axis] * (p[axis] - a[axis]);
    size += std::abs(normal[axis]) * std::max(std::abs(p[axis]), std::abs(a[axis]));
  }
  return above >= -std::numeric_limits<double>::epsilon() * size;
}

/// What a segment that passes a triangle at t crosses. Points enter where they come against the normal; what begins at
/// the surface and leaves along the normal does not meet it.
[[nodiscard]] PHYSIM_INLINE std::optional<Crossing> crossing_at(double t, const Segment& s, const Triangle& triangle) {
  if (t < 0 || t > s.reach) return std::nullopt;
  const Vec3d normal = triangle.normal();
  const bool enters = dot(normal, s.along) < 0;
  if (!enters && leaves_from(triangle.a, normal, s.from)) return std::nullopt;
  return Crossing{t, normal, 0, enters};
}

/// Where a segment, or a sphere about its points, meets a triangle from either side. A sphere always enters.
[[nodiscard]] PHYSIM_INLINE std::optional<Crossing> meets(const Segment& s, const Shear& shear,
                                                          const Triangle& triangle) {
  if (s.radius > 0) return first_touch(s, 0, [&](const Vec3d& p) { return nearest_to(triangle, p); });
  const auto t = shear.passes(triangle);
  return t ? crossing_at(*t, s, triangle) : std::nullopt;
}

/// Whether spheres about a segment may touch triangles, one or a pack of them, and up to which part of the segment none
/// does: below the true one by little where one touches a face. The sphere is taken for all that is as near to the
/// plane as its radius and not farther beyond any edge, nor beyond the box of the triangle, which costs no iteration.
template <class R>
[[nodiscard]] PHYSIM_INLINE MaskOf<R> may_touch(const Segment& s, const Vec3<R>& a, const Vec3<R>& b, const Vec3<R>& c,
                                                R& part) {
  const auto pack = [](const Vec3d& v) PHYSIM_INLINE_LAMBDA { return Vec3<R>{R(v.x), R(v.y), R(v.z)}; };
  const auto size = [](const Vec3<R>& v) PHYSIM_INLINE_LAMBDA { return abs(v.x) + abs(v.y) + abs(v.z); };
  const Vec3<R> from = pack(s.from), way = pack(s.along);
  const Vec3<R> ab = b - a, bc = c - b, ca = a - c, normal = cross(ab, -ca);
  const R rounding(32 * std::numeric_limits<double>::epsilon()), zero(0.0);
  const R edge = max(size(ab), max(size(bc), size(ca)));
  const R far = size(from - a) + size(way) + edge;  // from the triangle
  const R wide = R(s.radius) + rounding * (R(s.extent()) + edge);
  R in = zero, out(s.reach);
  // Leaves what is below a plane through p, as far as `most`; direction and most may be of any size.
  const auto below = [&](const Vec3<R>& direction, const Vec3<R>& p, const R& most) PHYSIM_INLINE_LAMBDA {
    const R above = dot(direction, from - p) - most, rate = dot(direction, way), at = (zero - above) / rate;
    in = select(rate < zero, max(at, in), in);
    out = select(rate > zero, min(at, out), out);
    out = select((rate == zero) & (above > zero), R(-1.0), out);
  };
  const R face = length(normal) * wide + rounding * edge * edge * far;
  below(normal, a, face);
  below(-normal, a, face);
  if (!any(in <= out)) return in <= out;
  const R beyond = rounding * edge * edge * edge * far;
  const auto beside = [&](const Vec3<R>& along, const Vec3<R>& p) PHYSIM_INLINE_LAMBDA {
    const Vec3<R> outwards = cross(along, normal);
    below(outwards, p, length(outwards) * wide + beyond);
  };
  beside(ab, a);
  beside(bc, b);
  beside(ca, c);
  if (!any(in <= out)) return in <= out;
  const auto least = [](const R& x, const R& y, const R& z) PHYSIM_INLINE_LAMBDA { return min(x, min(y, z)); };
  const auto most = [](const R& x, const R& y, const R& z) PHYSIM_INLINE_LAMBDA { return max(x, max(y, z)); };
  const R enters = BoxTest(s).enters(Vec3<R>{least(a.x, b.x, c.x), least(a.y, b.y, c.y), least(a.z, b.z, c.z)},
                                     Vec3<R>{most(a.x, b.x, c.x), most(a.y, b.y, c.y), most(a.z, b.z, c.z)}, s.reach);
  part = max(in, enters) * (R(1.0) - rounding);
  return (in <= out) & (enters <= R(s.reach));
}

/// The part of a segment that is clear, where a triangle is in the way.
[[nodiscard]] inline std::optional<double> clear_part(const Segment& s, const Triangle& t) {
  double part = 0;
  if (!may_touch(s, t.a, t.b, t.c, part)) return std::nullopt;
  return part;
}

}  // namespace physim::collide
