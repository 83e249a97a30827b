// Flights over a round Earth as files that globes and maps read: KML, CZML and GeoJSON.
#pragma once

#include "report/trajectory.hpp"

namespace physim::report {

/// An error where a shot flew over a flat Earth, which has no latitudes.
[[nodiscard]] Status check_round(const FlownScenario& flown);

/// KML 2.2 (OGC 07-147r2): a folder per shot with its path and its events. Heights are those above the ellipsoid.
[[nodiscard]] Content globe_kml(const Flights& flights);
/// CZML 1.0: each shot as a point that moves, launched at noon of 1 January 2000 (UTC).
[[nodiscard]] Content globe_czml(const Flights& flights);
/// GeoJSON (RFC 7946): paths, cut where they cross the antimeridian, and events.
[[nodiscard]] Content globe_geojson(const Flights& flights);

}  // namespace physim::report
