// The subject of a picture: places of what a scenario is about, its things, launches and flights.
#pragma once

#include <optional>
#include <vector>

#include "scenario/scenario.hpp"
#include "simclient/core/scenery.hpp"
#include "simclient/core/track.hpp"

namespace physim::client {

/// Where the projectiles of a scenario with a world are in the course of its run, as far as some 200 000 steps of
/// projectiles go. Empty where it fires nothing by itself.
[[nodiscard]] std::vector<Vec3d> places_of_run(const Scenario& scenario);

/// A scenario sets the end of its flight, or the ground is reached.
[[nodiscard]] bool has_end(const Flight& whole, const Until& until);

/// The direction along the ground in which places reach twice as far as across, from x towards z [rad]; nothing where
/// there is none.
[[nodiscard]] std::optional<double> long_side_of(const std::vector<Vec3d>& places);

/// A predicted flight.
struct Foreseen {
  std::vector<TrackSample> path;
  bool is_cut = false;  // nothing ends it
};
/// Places of a shot, as it was foreseen, and of the other shots of its scenario where they fly one by one: to their
/// ends, or for ten seconds where none is in sight.
[[nodiscard]] std::vector<Vec3d> places_of_flight(const Scenario& scenario, const ScenarioShot& shot,
                                                  const Foreseen& foreseen);

/// All places together with the things: without the few that lie far from most, and without flights that lead far away
/// from things or back.
[[nodiscard]] std::vector<Vec3d> subject_of(std::vector<Vec3d> places, const Scenery& things,
                                            std::optional<double> ground);

/// How high places lie one above the other, in parts of how far they lie apart along the ground; 0 for none.
[[nodiscard]] double height_over_length(const std::vector<Vec3d>& places);

}  // namespace physim::client
