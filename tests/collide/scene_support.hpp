// Random places, turns and segments, and bodies of triangles.
#pragma once

#include <cmath>

#include "random_shots.hpp"

namespace physim::test {

/// A box about the origin, as a closed mesh.
inline MeshShape closed_box(const Vec3d& half) {
  MeshShape m;
  for (int i = 0; i < 8; ++i)
    m.vertices.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

inline Vec3d random_vector(Random& r, double size) { return {r.in(-size, size), r.in(-size, size), r.in(-size, size)}; }

inline Transform random_transform(Random& r, double far) {
  return {.position = random_vector(r, far),
          .rotation = {r.in(-1, 1), r.in(-1, 1), r.in(-1, 1), r.in(0.1, 1)},
          .scale = r.in(0.3, 3)};
}

/// Ends near a body, at it, in it and far away; some along an axis of W.
inline SceneSegment random_segment(Random& r, const Vec3d& about, double size) {
  SceneSegment s{.from = about + random_vector(r, r.one_in(4)   ? 0.3 * size
                                                  : r.one_in(4) ? 30 * size
                                                                : 3 * size),
                 .to = about + random_vector(r, r.one_in(3) ? 0.5 * size : 3 * size)};
  if (r.one_in(8)) s.to.x = s.from.x;
  if (r.one_in(8)) s.to.y = s.from.y;
  return s;
}

/// A ball of triangles, or a bumpy one.
inline MeshShape ball(int rings, double bumps) {
  MeshShape m;
  const int sides = 2 * rings;
  const auto at = [&](int ring, int side) {
    const double a = 3.14159265358979 * ring / rings, b = 2 * 3.14159265358979 * side / sides;
    const double radius = 1 + bumps * std::sin(5 * a) * std::cos(4 * b);
    return Vec3d{radius * std::sin(a) * std::cos(b), radius * std::cos(a), radius * std::sin(a) * std::sin(b)};
  };
  m.vertices.push_back({0, 1, 0});
  for (int ring = 1; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side) m.vertices.push_back(at(ring, side));
  m.vertices.push_back({0, -1, 0});
  const auto index = [&](int ring, int side) {
    if (ring == 0) return 0u;
    if (ring == rings) return static_cast<std::uint32_t>(m.vertices.size() - 1);
    return static_cast<std::uint32_t>(1 + (ring - 1) * sides + side % sides);
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int side = 0; side < sides; ++side) {
      const auto a = index(ring, side), b = index(ring, side + 1), c = index(ring + 1, side),
                 d = index(ring + 1, side + 1);
      if (ring > 0) m.triangles.push_back({a, b, c});
      if (ring + 1 < rings) m.triangles.push_back({b, d, c});
    }
  return m;
}

}  // namespace physim::test
