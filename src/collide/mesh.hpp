// Meshes of triangles, in a tree of boxes.
#pragma once

#include "base/prefetch.hpp"
#include "collide/bvh.hpp"
#include "collide/triangle.hpp"
#include "physim/scene.hpp"

namespace physim::collide {

class Mesh {
 public:
  /// Triangles without area are left out. An error where a number is none, an index names no vertex, or the triangles
  /// close a body that is inside out.
  [[nodiscard]] static Result<Mesh> make(const MeshShape& shape, std::size_t materials);

  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  [[nodiscard]] ShapeInfo info() const;
  /// What it was made of; triangles without area come back as such, vertices in the order in which it keeps them.
  [[nodiscard]] MeshShape definition() const;
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(triangles_.size()); }
  [[nodiscard]] Triangle triangle(std::uint32_t i) const {
    PHYSIM_ASSERT(i < triangles_.size());
    const auto& corners = triangles_[i];
    return {vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]};
  }
  [[nodiscard]] const Vec3d* vertices() const { return vertices_.data(); }
  /// Its vertices; triangles name the first ones, all of them.
  [[nodiscard]] const std::array<std::uint32_t, 3>& corners(std::uint32_t i) const {
    PHYSIM_ASSERT(i < triangles_.size());
    return triangles_[i];
  }
  /// The number of a triangle as it was given.
  [[nodiscard]] std::uint32_t number(std::uint32_t i) const { return numbers_[i]; }
  /// Those without are left out.
  [[nodiscard]] static bool has_area(const Triangle& triangle) { return length(triangle.normal()) > 0.5; }
  /// The material of a triangle, by its number as it was given.
  [[nodiscard]] std::optional<MaterialId> material(std::uint32_t triangle) const {
    PHYSIM_ASSERT(materials_.empty() || triangle < materials_.size());
    return materials_.empty() ? std::nullopt : std::optional(materials_[triangle]);
  }

  /// Its triangles lie in the order of the places of its tree.
  [[nodiscard]] const Bvh& tree() const { return tree_; }
  /// Have what belongs to triangles from `first` on brought from memory; then their corners.
  void prefetch_triangles(std::uint32_t first, std::uint32_t end) const {
    prefetch_at(&triangles_[first]);
    prefetch_at(&triangles_[end - 1]);
  }
  void prefetch_corners(std::uint32_t first, std::uint32_t end) const {
    for (std::uint32_t i = first; i < end; ++i)
      for (const std::uint32_t corner : triangles_[i]) prefetch_at(&vertices_[corner]);
  }
  /// Calls take(crossing, segment) for each triangle met.
  template <class Take>
  void crossings(Segment& segment, const Take& take) const {
    std::optional<Shear> shear;  // most segments come to no triangle
    const auto visit = [&](std::uint32_t i, Segment& s) {
      if (!shear) shear.emplace(segment);
      auto crossing = meets(s, *shear, triangle(i));
      if (!crossing) return;
      crossing->primitive = number(i);
      take(*crossing, s);
    };
    tree_.along(segment, visit);
  }
  /// Calls visit(triangle, number) for those that a segment may meet, which shortens its reach.
  template <class Visit>
  void triangles_along(Segment& segment, const Visit& visit) const {
    tree_.along(segment, [&](std::uint32_t i, Segment&) { visit(triangle(i), number(i)); });
  }
  /// A part of a segment up to which spheres about its points touch nothing: its reach, or less.
  [[nodiscard]] double clear_part(Segment segment) const {
    tree_.along(segment, [&](std::uint32_t i, Segment& s) {
      if (const auto part = collide::clear_part(s, triangle(i))) s.reach = std::min(s.reach, *part);
    });
    return segment.reach;
  }
  /// The point of the surface nearest to p, where one is nearer than `within`, which is shortened to its distance.
  [[nodiscard]] std::optional<NearPlace> nearest(const Vec3d& p, double& within) const;
  /// Between the distance of p and half of it.
  [[nodiscard]] double clearance(const Vec3d& p) const;

 private:
  void put_vertices_in_order();
  [[nodiscard]] bool is_closed() const;
  [[nodiscard]] double volume() const;

  std::vector<Vec3d> vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;  // leaf by leaf of the tree
  std::vector<std::uint32_t> numbers_;                   // as they were given
  std::vector<MaterialId> materials_;                    // by number
  Bvh tree_;
  Bounds bounds_;
  std::size_t degenerate_ = 0;
  bool closed_ = false;
};

}  // namespace physim::collide
