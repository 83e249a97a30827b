// Parts that all files of KML 2.2 (OGC 07-147r2) are made of.
#pragma once

#include <string>

namespace physim::report {

/// A text without what XML would read as its own, and without control characters.
[[nodiscard]] std::string xml(const std::string& text);
/// "longitude,latitude,height", in degrees and metres.
[[nodiscard]] std::string kml_coordinates(double longitude, double latitude, double height);
/// The document up to its first style, and its end.
[[nodiscard]] std::string kml_begin(const std::string& name, const std::string& description);
[[nodiscard]] std::string kml_end();

}  // namespace physim::report
