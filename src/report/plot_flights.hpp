// The picture of flights: path and speed, then position, velocity and acceleration over time, axis by axis.
#pragma once

#include <span>
#include <string>

#include "report/picture.hpp"
#include "report/trajectory.hpp"

namespace physim::report {

/// At most this many shots are drawn into one picture; more could not be told apart.
inline constexpr std::size_t kMaxDrawnShots = 14;

[[nodiscard]] Picture shots_picture(const std::string& title, std::span<const FlownShot> shots);
[[nodiscard]] Content flights_picture(const Flights& flights);

}  // namespace physim::report
