// Terrain files: heights over latitude and longitude out of GeoTIFF, SRTM (.hgt) and what else GDAL reads. Part of the
// library physim_scenario.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "physim/result.hpp"
#include "physim/terrain.hpp"

namespace physim {

/// What of a terrain file is read, and what its heights mean.
struct TerrainCut {
  double latitude = 0;                                     ///< of the place about which it is cut [rad]
  double longitude = 0;                                    ///< of that place, east positive [rad]
  double reach = std::numeric_limits<double>::infinity();  ///< so far north, south, east and west of it, above 0 [m]
  std::uint32_t every = 1;                                 ///< of its points along both directions, at least 1 [-]
  double geoid = 0;                 ///< of sea level above the ellipsoid there, added to all heights, within 200 m [m]
  std::optional<double> missing{};  ///< height of points that have none, above sea level; none: they are an error [m]
};

/// Whether this build reads terrain from files: it does where GDAL was there when it was built.
[[nodiscard]] bool reads_terrain_files();

/// The heights of the first band of a raster, in metres or feet as it says, brought to a grid of latitude and longitude
/// on WGS 84 where they lie in another projection. Points lie where the file has them, the middles of its cells. Up to
/// 2e7 points after the cut: a larger one is refused before it is read. The error's place is the file, or the member of
/// the cut that is wrong.
[[nodiscard]] Result<GeodeticGrid> read_terrain_file(const std::string& file, const TerrainCut& cut = {});

}  // namespace physim
