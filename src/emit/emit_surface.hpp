// EmitSurface: where on a mesh or a terrain a particle comes out, and in which direction.
//
// Symbols: a, b, c corners of a triangle; u, v numbers between 0 and 1; n normals, of length one; A angle of a
//   triangle at a corner.
// Equations: a triangle is chosen by its area, an edge by its length, a vertex like any other; the place in a triangle
//   is (1 - s) a + s (1 - v) b + s v c with s^2 = u. The normal of a vertex is that of the sum of A n of the triangles
//   about it; that of an edge of the sum of n of those beside it; if that is zero, the first one's. Smooth: the
//   normals of the corners, mixed like the corners. Heights: the normal of a point lies along (-dh/dx, 1, -dh/dz), by
//   the points beside it. Cells that the edge of a rectangle cuts are chosen by the area that is left of them.
// Source: L. Devroye, Non-Uniform Random Variate Generation (1986), ch. XI.2.5 (triangles); G. Thuermer,
//   C. A. Wuethrich, "Computing vertex normals from polygonal facets", J. Graphics Tools 3 (1998) 43-46;
//   I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping", Comm. ACM 17 (1974) 32-42.
#pragma once

#include <array>
#include <vector>

#include "collide/shared_shape.hpp"
#include "emit/emit_shape.hpp"
#include "emit/weighted_choice.hpp"

namespace physim {

/// Where a particle comes out of a shape of triangles.
class SurfaceOutlets {
 public:
  virtual ~SurfaceOutlets() = default;
  [[nodiscard]] virtual Outlet at(ParticleChance& chance) const = 0;
};

/// Those of a definition; null where its shape has no triangles.
[[nodiscard]] std::shared_ptr<const SurfaceOutlets> surface_outlets(const EmitFrom& from);

/// A rectangle of a height field, of x and z.
struct EmitPatch {
  double low_x, high_x, low_z, high_z;
};
/// The part of a height field that a definition covers; its low sides are not below its high ones if it is empty.
[[nodiscard]] EmitPatch patch_of(const EmitSurface& surface, const collide::HeightField& field);

}  // namespace physim
