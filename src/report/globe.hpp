// Flights and worlds over a round Earth as files that globes and maps read: KML, CZML and GeoJSON.
#pragma once

#include "report/trajectory.hpp"
#include "report/world_log.hpp"

namespace physim::report {

/// An error where a shot flies over a flat Earth, which has no latitudes.
[[nodiscard]] Status check_round(EarthModel earth, const std::string& shot, const Scenario& scenario);
[[nodiscard]] Status check_round(const FlownScenario& flown);
/// As check_round(), before a world runs.
[[nodiscard]] Status check_round_world(const Scenario& scenario);

/// KML 2.2 (OGC 07-147r2): a folder per shot with its path and its events. Heights are those above the ellipsoid.
[[nodiscard]] Content globe_kml(const Flights& flights);
/// ... a folder for each projectile of a world, at times of the world.
[[nodiscard]] Content globe_kml(const WorldLog& log);
/// CZML 1.0: each shot as a point that moves, launched at noon of 1 January 2000 (UTC).
[[nodiscard]] Content globe_czml(const Flights& flights);
[[nodiscard]] Content globe_czml(const WorldLog& log);
/// GeoJSON (RFC 7946): paths, cut where they cross the antimeridian, and events.
[[nodiscard]] Content globe_geojson(const Flights& flights);
[[nodiscard]] Content globe_geojson(const WorldLog& log);

}  // namespace physim::report
