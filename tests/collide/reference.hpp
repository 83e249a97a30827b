// What segments and spheres meet, by other means: signed distances in long double, the least of them by golden section,
// the first touch by bisection. No tree, no Newton's method, no clipping.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "physim/scene.hpp"

namespace physim::test {

using Real = long double;
struct Point {
  Real x, y, z;
};
inline Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point operator*(const Point& a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
inline Real inner(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Real norm(const Point& a) { return std::sqrt(inner(a, a)); }
inline Point outer(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Point point(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// From W into the frame of a transform.
inline Point into_frame(const Transform& t, const Point& p) {
  const Real w = t.rotation.w, x = t.rotation.x, y = t.rotation.y, z = t.rotation.z;
  const Real n = w * w + x * x + y * y + z * z;
  const Point v = p - point(t.position);
  // The rows of the transposed rotation matrix.
  const Point right{(w * w + x * x - y * y - z * z) / n, 2 * (x * y + w * z) / n, 2 * (x * z - w * y) / n};
  const Point up{2 * (x * y - w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z + w * x) / n};
  const Point far{2 * (x * z + w * y) / n, 2 * (y * z - w * x) / n, (w * w - x * x - y * y + z * z) / n};
  return Point{inner(right, v), inner(up, v), inner(far, v)} * (1 / Real(t.scale));
}

/// Distance from the surface of a convex body, below zero inside.
using SignedDistance = std::function<Real(const Point&)>;

inline SignedDistance distance_of(const SphereShape& s) {
  return [s](const Point& p) { return norm(p) - s.radius; };
}
inline SignedDistance distance_of(const CapsuleShape& s) {
  return [s](const Point& p) {
    const Real h = s.half_height, y = p.y > h ? p.y - h : p.y < -h ? p.y + h : 0;
    return norm({p.x, y, p.z}) - s.radius;
  };
}
inline SignedDistance distance_of(const BoxShape& s) {
  return [s](const Point& p) {
    const Real x = std::fabs(p.x) - s.half.x, y = std::fabs(p.y) - s.half.y, z = std::fabs(p.z) - s.half.z;
    const Real most = std::max({x, y, z});
    return most <= 0 ? most : norm({std::max(x, Real(0)), std::max(y, Real(0)), std::max(z, Real(0))});
  };
}
inline SignedDistance distance_of(const CylinderShape& s) {
  return [s](const Point& p) {
    const Real across = std::sqrt(p.x * p.x + p.z * p.z) - s.radius, along = std::fabs(p.y) - s.half_height;
    const Real most = std::max(across, along);
    return most <= 0 ? most : norm({std::max(across, Real(0)), std::max(along, Real(0)), 0});
  };
}
inline SignedDistance distance_of(const PlaneShape&) {
  return [](const Point& p) { return p.y; };
}
/// Of a triangle, which has no inside: the least distance from its plane, where the foot lies in it, and its edges.
inline SignedDistance distance_of_triangle(const Point& a, const Point& b, const Point& c) {
  return [=](const Point& p) {
    const Point n = outer(b - a, c - a);
    const auto beside = [&](const Point& from, const Point& to) { return inner(outer(to - from, p - from), n) >= 0; };
    if (beside(a, b) && beside(b, c) && beside(c, a)) return std::fabs(inner(p - a, n)) / norm(n);
    const auto from_edge = [&](const Point& from, const Point& to) {
      const Point d = to - from;
      const Real t = std::clamp(inner(p - from, d) / inner(d, d), Real(0), Real(1));
      return norm(p - (from + d * t));
    };
    return std::min({from_edge(a, b), from_edge(b, c), from_edge(c, a)});
  };
}

/// What a sphere along a segment meets of a convex body.
struct Met {
  bool hit = false;
  Real part = 0;
  Real least = 0;  // gap to the surface along the segment [m]
  Real slope = 0;  // of the gap by the way, at the hit
};

/// `gap(t)` is convex.
inline Met first_zero(const std::function<Real(Real)>& gap, Real length) {
  const Real golden = (std::sqrt(Real(5)) - 1) / 2;
  Real low = 0, high = 1;
  Real one = high - golden * (high - low), other = low + golden * (high - low);
  Real at_one = gap(one), at_other = gap(other);
  for (int i = 0; i < 100; ++i) {
    if (at_one <= at_other) {
      high = other, other = one, at_other = at_one;
      one = high - golden * (high - low), at_one = gap(one);
    } else {
      low = one, one = other, at_one = at_other;
      other = low + golden * (high - low), at_other = gap(other);
    }
  }
  Real best = (low + high) / 2, least = gap(best);
  for (const Real end : {Real(0), Real(1)})
    if (gap(end) < least) best = end, least = gap(end);
  if (least > 0) return {false, best, least, 0};
  if (gap(0) <= 0) return {true, 0, gap(0), -1};
  Real outside = 0, inside = best;
  for (int i = 0; i < 90; ++i) (gap((outside + inside) / 2) > 0 ? outside : inside) = (outside + inside) / 2;
  const Real step = 1e-7L;
  const Real slope = (gap(outside) - gap(std::max(Real(0), outside - step))) / (step * length);
  return {true, inside, least, slope};
}

/// The largest coordinate of a segment's ends [m].
inline double largest(const SceneSegment& s) {
  double most = s.radius;
  for (const Vec3d& v : {s.from, s.to}) most = std::max({most, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return most;
}

/// In what a hit is unlike the reference: by hit or miss, and by place, beyond 1e-12 of the largest coordinate. Empty:
/// in nothing.
inline std::string unlike(const SceneHit& hit, const SceneSegment& s, const Met& met,
                          const std::function<Real(Real)>& gap) {
  const double bound = 1e-12 * (1 + largest(s));
  if (static_cast<bool>(hit) != met.hit) return std::fabs(met.least) < bound ? "" : met.hit ? "missed" : "hit nothing";
  if (!met.hit) return "";
  if (!(std::fabs(hit.starts_inside ? 0 : gap(hit.part)) < bound)) return "not at the surface";
  if (std::fabs(met.least) < bound) return "";  // grazes: it may touch anywhere along the graze
  const double slope = std::max(1e-9, std::fabs(static_cast<double>(met.slope)));
  const double off = std::fabs(static_cast<double>(met.part) - hit.part) * length(s.to - s.from);
  if (off < bound / slope + 1e-9 * bound) return "";
  // Past an edge that it touches, the way may run on beside the surface: any place from there on is as good.
  if (std::fabs(gap((met.part + Real(hit.part)) / 2)) < bound) return "";
  return "off by " + std::to_string(off / bound) + " times what may be";
}

}  // namespace physim::test
