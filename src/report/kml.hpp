// Parts that all files of KML 2.2 (OGC 07-147r2) are made of.
#pragma once

#include <string>
#include <vector>

namespace physim::report {

/// A text without what XML would read as its own, and without control characters.
[[nodiscard]] std::string xml(const std::string& text);
/// "longitude,latitude,height", in degrees and metres.
[[nodiscard]] std::string kml_coordinates(double longitude, double latitude, double height);
/// A place on a map [deg].
struct MapPoint {
  double longitude, latitude;
};
using Ring = std::vector<MapPoint>;
/// A ring, cut at the antimeridian into rings on one side of it; each ends where it begins, as the whole does. A ring
/// about a pole runs along the edges of the map.
[[nodiscard]] std::vector<Ring> cut_at_antimeridian(Ring ring);

/// The document up to its first style, and its end.
[[nodiscard]] std::string kml_begin(const std::string& name, const std::string& description);
[[nodiscard]] std::string kml_end();

}  // namespace physim::report
