#include "physim/scene.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"

namespace physim {
namespace {

Status check(const GeodeticGrid& grid) {
  constexpr double kQuarter = 1.5707963267948966, kRounding = 1e-12;
  const std::size_t points = std::size_t{grid.columns} * grid.rows;
  Checker c;
  c.require(grid.columns >= 2, "grid.columns", "needs two at least", "a cell lies between four points");
  c.require(grid.rows >= 2, "grid.rows", "needs two at least", "a cell lies between four points");
  c.require(points <= std::numeric_limits<std::uint32_t>::max() / 2, "grid.columns", "makes more than 2^31 points",
            "cut it into several");
  c.positive(grid.latitude_step, "grid.latitude_step", "rows go northwards");
  c.positive(grid.longitude_step, "grid.longitude_step", "columns go eastwards");
  c.require(std::abs(grid.latitude) <= kQuarter + kRounding &&
                grid.latitude + grid.latitude_step * (grid.rows - 1.0) <= kQuarter + kRounding,
            "grid.latitude", "must lie between the poles, with all rows");
  c.require(std::abs(grid.longitude) <= 4 * kQuarter + kRounding, "grid.longitude", "must lie between -pi and pi");
  c.require(grid.longitude_step * (grid.columns - 1.0) <= 4 * kQuarter + kRounding, "grid.longitude_step",
            "goes more than once round");
  c.require(grid.heights.size() == points, "grid.heights", "must be columns times rows");
  for (std::size_t i = 0; i < grid.heights.size() && c.status_so_far(); ++i)
    if (!(std::abs(grid.heights[i]) <= 1e5))
      return Error{"must be a number within 1e5 m", "grid.heights[" + std::to_string(i) + "]", ""};
  return c.status();
}

}  // namespace

Result<MeshShape> terrain_mesh(const GeodeticGrid& grid, const EarthFrames& frames) {
  const IeeeMode mode;
  if (auto status = check(grid); !status) return status.error();
  MeshShape mesh;
  mesh.vertices.reserve(grid.heights.size());
  mesh.triangles.reserve(2 * grid.heights.size());
  for (std::uint32_t row = 0; row < grid.rows; ++row)
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const std::uint32_t corner = row * grid.columns + column;
      mesh.vertices.push_back(frames.position({grid.latitude + row * grid.latitude_step,
                                               grid.longitude + column * grid.longitude_step, grid.heights[corner]}));
      if (row + 1 == grid.rows || column + 1 == grid.columns) continue;
      const std::uint32_t east = corner + 1, north = corner + grid.columns;
      PHYSIM_ASSERT(north + 1 < grid.heights.size());
      mesh.triangles.push_back({corner, east, north});
      mesh.triangles.push_back({east, north + 1, north});
    }
  return mesh;
}

}  // namespace physim
