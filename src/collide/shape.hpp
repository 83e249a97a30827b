// Shapes ready to be met, and where they stand.
#pragma once

#include <memory>
#include <variant>

#include "collide/convex_hull.hpp"
#include "collide/height_field.hpp"
#include "collide/mesh.hpp"
#include "math/quat.hpp"

namespace physim::collide {

/// A Transform, ready to compute.
class Placement {
 public:
  Placement() = default;
  explicit Placement(const Transform& t);

  [[nodiscard]] Vec3d turned(const Vec3d& v) const { return x_ * v.x + y_ * v.y + z_ * v.z; }
  [[nodiscard]] Vec3d turned_back(const Vec3d& v) const { return {dot(x_, v), dot(y_, v), dot(z_, v)}; }
  [[nodiscard]] Vec3d inside(const Vec3d& p) const { return turned_back(p - position_) * per_scale_; }
  [[nodiscard]] Vec3d outside(const Vec3d& p) const { return turned(p * scale_) + position_; }
  /// As seen from the shape.
  [[nodiscard]] PHYSIM_INLINE Segment inside(const Segment& s) const {
    const double seam = std::max(s.seam, seam_at(std::max(s.extent(), extent_)));
    return {inside(s.from), turned_back(s.along) * per_scale_, s.radius * per_scale_, s.reach, seam * per_scale_};
  }
  /// A box about what a box becomes, with what is rounded on the way.
  [[nodiscard]] Bounds outside(const Bounds& box) const;
  [[nodiscard]] double scale() const { return scale_; }
  /// Writes down what inside() computes with.
  template <class Job>
  void put_axes(Job& job) const {
    job.x = x_, job.y = y_, job.z = z_, job.position = position_, job.per_scale = per_scale_;
  }
  [[nodiscard]] const Vec3d& position() const { return position_; }

 private:
  Vec3d x_{1, 0, 0}, y_{0, 1, 0}, z_{0, 0, 1};  // its axes outside
  Vec3d position_;
  double scale_ = 1, per_scale_ = 1;
  double extent_ = 0;  // of its position
};

struct Compound;
using Shape = std::variant<HalfSpace, Sphere, Box, Capsule, Cylinder, Mesh, HeightField, Compound, ConvexHull>;

struct Compound {
  struct Part {
    CompoundShape::Part definition;
    Placement placement;
    Bounds bounds;  // in the compound's frame
    std::shared_ptr<const Shape> shape;
  };
  std::vector<Part> parts;

  [[nodiscard]] CompoundShape definition() const;
  [[nodiscard]] Bounds bounds() const;
};

/// What a shape was made of.
[[nodiscard]] ShapeDef definition_of(const Shape& shape);
/// The material that it has of its own at a place that a Crossing or a NearPlace tells; none: that of whatever has the
/// shape.
[[nodiscard]] std::optional<MaterialId> material_of(const Shape& shape, std::uint32_t primitive,
                                                    std::uint32_t triangle);
/// Empty of half-spaces, which have none.
[[nodiscard]] Bounds bounds_of(const Shape& shape);

namespace detail {
/// A shape that is no compound.
template <bool kExits, class Take>
void cross_simple(const Shape& shape, Segment& s, const Take& take) {
  std::visit(
      [&](const auto& one) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(one)>, Compound>) {
          PHYSIM_ASSERT(false);
        } else if constexpr (requires { one.crossings(s, take); }) {
          one.crossings(s, take);
        } else {
          const Passage p = passage(s, one, kExits);
          if (p.some) take(p.in, s);
          if (kExits && p.some && p.out.t <= s.reach) take(p.out, s);
        }
      },
      shape);
}
}  // namespace detail

/// Calls take(crossing, segment) where a segment meets a shape. `kExits`: where it leaves convex shapes, too.
template <bool kExits, class Take>
void cross(const Shape& shape, Segment& s, const Take& take) {
  const Compound* compound = std::get_if<Compound>(&shape);
  if (!compound) return detail::cross_simple<kExits>(shape, s, take);
  for (std::uint32_t i = 0; i < compound->parts.size(); ++i) {
    const Compound::Part& part = compound->parts[i];
    if (!(BoxTest(s).enters(part.bounds, s.reach) <= s.reach)) continue;
    Segment inside = part.placement.inside(s);
    detail::cross_simple<kExits>(*part.shape, inside, [&](Crossing crossing, Segment& within) {
      crossing.normal = part.placement.turned(crossing.normal);
      crossing.triangle = crossing.primitive;
      crossing.primitive = i;
      take(crossing, s);
      within.reach = s.reach;
    });
  }
}

/// A part of a segment up to which the spheres about its points touch nothing of a shape: its reach, or less; 0 where
/// it begins at a surface or inside of one.
[[nodiscard]] double clear_part_of(const Shape& shape, const Segment& s);

/// The point of a surface that is nearest to p, where one is not farther than `within`, which is shortened to its
/// distance; p itself inside of a solid.
[[nodiscard]] std::optional<NearPlace> nearest_of(const Shape& shape, const Vec3d& p, double& within);

/// Between the distance of p from a shape and half of it, but for rounding; cheap.
[[nodiscard]] double clearance_of(const Shape& shape, const Vec3d& p);

}  // namespace physim::collide
