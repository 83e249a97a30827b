// Quickhull on a grid, in whole numbers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace physim::collide {

/// Whole numbers that hold the volume of a tetrahedron of grid points.
__extension__ typedef __int128 Wide;

/// Coordinates are within 2^40 + 1.
using GridPoint = std::array<std::int64_t, 3>;
inline constexpr int kGridBits = 40;

/// A triangle of a hull, counterclockwise as seen from outside.
struct HullTriangle {
  std::array<std::uint32_t, 3> corner;     // numbers of points
  std::array<std::uint32_t, 3> neighbour;  // the triangles beyond its edges; edge i goes from corner i to the next one
  std::array<Wide, 3> normal;              // twice its area long
};

/// How far p lies above the plane of a triangle, times twice its area.
[[nodiscard]] Wide height_above(const HullTriangle& triangle, std::span<const GridPoint> points, const GridPoint& p);

/// The triangles about some points; nothing where they lie in one plane. The same points in the same order give the
/// same triangles everywhere.
[[nodiscard]] std::optional<std::vector<HullTriangle>> quickhull(std::span<const GridPoint> points);

}  // namespace physim::collide
