#include "collide/convex_hull.hpp"

#include <algorithm>
#include <string>

#include "base/checker.hpp"
#include "collide/quickhull.hpp"

namespace physim::collide {
namespace {

/// The grid that points are moved to.
struct Grid {
  Vec3d middle;
  double step = 1;

  explicit Grid(const Bounds& box) {
    const Vec3d half = (box.high - box.low) * 0.5;
    const double most = std::max({half.x, half.y, half.z});
    // A power of two, so that points on a coarser grid about the origin stay where they are.
    step = std::ldexp(1.0, std::ilogb(most) + 1 - kGridBits);
    middle = box.middle();
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (std::abs(middle[axis] / step) < 0x1p51) middle[axis] = std::floor(middle[axis] / step + 0.5) * step;
  }
  [[nodiscard]] GridPoint at(const Vec3d& p) const {
    GridPoint point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double steps = std::floor((p[axis] - middle[axis]) / step + 0.5);
      PHYSIM_ASSERT(std::abs(steps) <= static_cast<double>((std::int64_t{1} << kGridBits) + 1));
      point[axis] = static_cast<std::int64_t>(steps);
    }
    return point;
  }
};

/// The triangles of each plane: those that are joined by edges that are none.
std::vector<std::vector<std::uint32_t>> faces_of(const std::vector<HullTriangle>& triangles,
                                                 const std::vector<GridPoint>& points) {
  std::vector<std::vector<std::uint32_t>> faces;
  std::vector<bool> taken(triangles.size(), false);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (taken[i]) continue;
    taken[i] = true;
    std::vector<std::uint32_t> face{i};
    for (std::size_t k = 0; k < face.size(); ++k)
      for (const std::uint32_t neighbour : triangles[face[k]].neighbour) {
        if (taken[neighbour]) continue;
        const auto& corners = triangles[neighbour].corner;
        if (!std::ranges::all_of(
                corners, [&](std::uint32_t corner) { return height_above(triangles[i], points, points[corner]) == 0; }))
          continue;
        taken[neighbour] = true;
        face.push_back(neighbour);
      }
    faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace

Result<ConvexHull> ConvexHull::make(const ConvexHullShape& shape) {
  ConvexHull hull;
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    const Vec3d& p = shape.points[i];
    if (!finite(p) || !(length(p) <= kFarthest))
      return Error{"must have three components within 1e15 m", "shape.points[" + std::to_string(i) + "]", ""};
    hull.bounds_.take(p);
  }
  const Error flat{"lie in one plane", "shape.points", "four at least that span a body"};
  if (shape.points.size() < 4 || !(length(hull.bounds_.high - hull.bounds_.low) >= 1e-9)) return flat;
  const Grid grid(hull.bounds_);
  std::vector<GridPoint> points;
  for (const Vec3d& p : shape.points) points.push_back(grid.at(p));
  const auto triangles = quickhull(points);
  if (!triangles) return flat;
  hull.points_ = shape.points;
  hull.bounds_ = {};
  std::vector<std::uint32_t> corner_of(points.size(), 0);  // 0: no corner yet, else its number from 1
  for (const auto& list : faces_of(*triangles, points)) {
    const auto& normal = (*triangles)[list.front()].normal;
    Face face{normalized(Vec3d{static_cast<double>(normal[0]), static_cast<double>(normal[1]),
                               static_cast<double>(normal[2])}),
              -kInfinity, static_cast<std::uint32_t>(hull.triangles_.size()), static_cast<std::uint32_t>(list.size())};
    for (const std::uint32_t triangle : list) {
      auto& corners = hull.triangles_.emplace_back((*triangles)[triangle].corner);
      for (std::uint32_t& corner : corners) {
        if (corner_of[corner] == 0) {
          hull.corners_.push_back(shape.points[corner]);
          hull.bounds_.take(hull.corners_.back());
          corner_of[corner] = static_cast<std::uint32_t>(hull.corners_.size());
        }
        corner = corner_of[corner] - 1;
        face.offset = std::max(face.offset, dot(face.normal, hull.corners_[corner]));
      }
    }
    hull.faces_.push_back(face);
  }
  return hull;
}

ShapeInfo ConvexHull::info() const {
  return {.triangles = triangles_.size(),
          .closed = true,
          .bytes = (points_.capacity() + corners_.capacity()) * sizeof(Vec3d) +
                   triangles_.capacity() * sizeof(triangles_[0]) + faces_.capacity() * sizeof(Face)};
}

/// By the triangles of those planes that it lies above.
Nearest ConvexHull::nearest(const Vec3d& p) const {
  double least = kInfinity;
  Nearest nearest;
  for (const Face& face : faces_) {
    const double above = dot(face.normal, p) - face.offset;
    if (!(above > 0) || above >= least) continue;
    for (std::uint32_t i = face.first; i < face.first + face.count; ++i) {
      const auto& corners = triangles_[i];
      const Nearest one = nearest_to({corners_[corners[0]], corners_[corners[1]], corners_[corners[2]]}, p);
      if (one.distance < least) least = one.distance, nearest = one;
    }
  }
  return nearest;
}

}  // namespace physim::collide
