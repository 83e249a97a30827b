// The pictures of flights, of a world's run and of the ladder of fidelity.
#pragma once

#include "report/ladder.hpp"
#include "report/picture.hpp"
#include "report/trajectory.hpp"
#include "report/world_log.hpp"

namespace physim::report {

/// Path and speed, then position, velocity, acceleration and, where it is asked for, jerk over time, axis by axis; of
/// the first 14 shots, since more could not be distinguished.
/// `scene`: things that stand about; null: none. `expected`: figures of times, drawn as marks over the curves.
[[nodiscard]] Picture shots_picture(const std::string& title, std::span<const FlownShot> shots,
                                    const Scene* scene = nullptr, std::span<const Expectation> expected = {},
                                    bool with_jerk = false);
[[nodiscard]] Content flights_picture(const Flights& flights);
/// The paths of a world's run from the side and from above, and the wall.
[[nodiscard]] Content world_picture(const WorldLog& log);
/// The signature chart: error over cost of every rung.
[[nodiscard]] Content ladder_picture(const LadderOfShot& subject);

}  // namespace physim::report
