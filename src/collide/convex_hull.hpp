// Convex hulls of points: their corners, the planes of their faces, and triangles in which these lie.
//
// What it models: the smallest convex body that holds some points.
// Equation: points are moved to a grid of up to 2^40 steps from their middle, so that on which side of a plane through
// three of
//   them a fourth one lies is told by whole numbers of 126 bits, exactly: points in one plane, on one line and in one
//   place need no tolerance, and each triangle has an area. Corners stay where the points are, so that hulls that touch
//   have no gap; planes of slanting faces are within 1e-12 of the hull's size of where the points put them.
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls", ACM Transactions on
//   Mathematical Software 22 (1996) 469-483.
#pragma once

#include <array>
#include <vector>

#include "collide/bvh.hpp"
#include "collide/triangle.hpp"
#include "physim/scene.hpp"

namespace physim::collide {

class ConvexHull {
 public:
  /// An error where a coordinate is none, or the points lie in one plane.
  [[nodiscard]] static Result<ConvexHull> make(const ConvexHullShape& shape);

  [[nodiscard]] double margin() const { return 0; }
  [[nodiscard]] Nearest nearest(const Vec3d& p) const;
  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] ShapeInfo info() const;
  [[nodiscard]] ConvexHullShape definition() const { return {points_}; }
  [[nodiscard]] const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
  [[nodiscard]] const std::vector<Vec3d>& corners() const { return corners_; }

  /// Clips by each of its planes.
  void clip(Clipped& clipped) const {
    for (const Face& face : faces_) clipped.by_plane(face.normal, face.offset);
  }

 private:
  /// Triangles in one plane.
  struct Face {
    Vec3d normal;
    double offset;  // of the plane from the origin
    std::uint32_t first, count;
  };

  std::vector<Vec3d> points_;  // as they were given
  std::vector<Vec3d> corners_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;  // face by face
  std::vector<Face> faces_;
  Bounds bounds_;
};

[[nodiscard]] inline Passage passage_by_clipping(const Segment& s, const ConvexHull& hull) {
  Clipped clipped(s);
  hull.clip(clipped);
  return clipped.passage(s.reach);
}

}  // namespace physim::collide
