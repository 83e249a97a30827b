// Terrain on the ellipsoid: heights over latitude and longitude, as a mesh of a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "physim/frames.hpp"
#include "physim/result.hpp"
#include "physim/scene.hpp"

namespace physim {

/// Heights over a grid of latitude and longitude, from its south-west corner on.
struct GeodeticGrid {
  double latitude = 0;            ///< of the first point, north positive [rad]
  double longitude = 0;           ///< of the first point, east positive [rad]
  double latitude_step = 0;       ///< from row to row northwards; the last one not beyond the pole [rad]
  double longitude_step = 0;      ///< from column to column eastwards; all within once round [rad]
  std::uint32_t columns = 0;      ///< points along a parallel, at least 2 [-]
  std::uint32_t rows = 0;         ///< points along a meridian, at least 2 [-]
  std::vector<double> heights{};  ///< above the ellipsoid, within 1e5 m: heights[row * columns + column] [m]
};

/// Two triangles to each cell of a grid, in W as the frames of an environment have it: on a round Earth the terrain
/// falls away with it, 785 m below the tangent plane 100 km away. Errors name the member that is wrong.
[[nodiscard]] Result<MeshShape> terrain_mesh(const GeodeticGrid& grid, const EarthFrames& frames);

}  // namespace physim
