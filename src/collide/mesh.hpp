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

  /// Whether its tree leaves the fast caches little room: a walk through it waits for the memory.
  [[nodiscard]] bool is_large() const { return tree_.bytes() >= kLarge; }
  class Walk;
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
  static constexpr std::size_t kLarge = 1 << 18;

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

/// Where a segment is on its way through a mesh: one that waits for the memory gives way to others.
class Mesh::Walk {
 public:
  /// False where the segment passes the mesh.
  PHYSIM_INLINE bool begin(const Mesh& mesh, const Segment& segment) {
    mesh_ = &mesh;
    segment_ = segment;
    sheared_ = corners_asked_ = false;
    return boxes_.begin(mesh.tree_, segment_, BoxTest(segment_));
  }
  /// Looks at what it has come to, a node or triangles, and asks for what comes next to be brought; calls
  /// take(crossing, segment) for triangles that are met. False where nothing is left.
  template <class Take>
  PHYSIM_INLINE bool step(const Take& take) {
    return step_by([&] { meet(take); });
  }
  /// Likewise, but shortens its reach to where the spheres about its points may touch a triangle.
  PHYSIM_INLINE bool step_clear() {
    return step_by([&] {
      for (std::uint32_t i = boxes_.first(); i < boxes_.end(); ++i)
        if (const auto part = collide::clear_part(segment_, mesh_->triangle(i)))
          segment_.reach = std::min(segment_.reach, *part);
    });
  }
  [[nodiscard]] double reach() const { return segment_.reach; }

 private:
  /// look_at_triangles() looks at those that it has come to.
  template <class Look>
  PHYSIM_INLINE bool step_by(const Look& look_at_triangles) {
    bool on;
    if (!boxes_.is_at_items()) {
      on = boxes_.look(mesh_->tree_);
    } else if (!corners_asked_) {
      ask_for_corners();
      return true;
    } else {
      look_at_triangles();
      on = boxes_.next(segment_);
      corners_asked_ = false;
    }
    if (!boxes_.is_at_items())
      boxes_.prefetch(mesh_->tree_);
    else
      prefetch_triangles();
    return on;
  }
  void prefetch_triangles() const {
    prefetch_at(&mesh_->triangles_[boxes_.first()]);
    prefetch_at(&mesh_->triangles_[boxes_.end() - 1]);
    prefetch_at(&mesh_->numbers_[boxes_.first()]);
  }
  void ask_for_corners() {
    corners_asked_ = true;
    for (std::uint32_t i = boxes_.first(); i < boxes_.end(); ++i)
      for (const std::uint32_t corner : mesh_->triangles_[i]) prefetch_at(&mesh_->vertices_[corner]);
  }
  template <class Take>
  void meet(const Take& take) {
    if (!sheared_) shear_ = Shear(segment_);
    sheared_ = true;
    for (std::uint32_t i = boxes_.first(); i < boxes_.end(); ++i) {
      auto crossing = meets(segment_, shear_, mesh_->triangle(i));
      if (!crossing) continue;
      crossing->primitive = mesh_->number(i);
      take(*crossing, segment_);
    }
  }

  const Mesh* mesh_;
  Segment segment_;  // in its frame
  Shear shear_;      // of the segment, once it has come to a triangle
  bool sheared_;
  bool corners_asked_;  // of the triangles that it is at
  Bvh::Walk boxes_;
};

}  // namespace physim::collide
