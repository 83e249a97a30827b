// The numbers of a shot and its weather that may be uncertain: the one list of them.
#pragma once

#include <span>
#include <string_view>

#include "physim/flight_columns.hpp"

namespace physim {

/// Wind by compass: along the ground, instead of its components.
enum class CompassWind { none, speed, from };

struct PathRow {
  std::string_view path, unit, about;
  double& (*number)(Shot&) = nullptr;                                // of a shot
  std::span<const double> LaunchColumns::*launches = nullptr;        // ... that launches have as a column
  std::span<const double> Weather::*weather = nullptr;               // of the weather, ...
  double (*there)(const Environment&) = nullptr;                     // ... and what there is without a column
  void (*scale)(Shot&, const Shot& plain, double factor) = nullptr;  // or a factor of several numbers of a shot
  bool above_zero = false;                                           // anything else cannot be
  CompassWind compass = CompassWind::none;                           // which part of a wind by compass it is
  double& (*place)(Environment&) = nullptr;                          // a number of the place, which each shot has then
};

[[nodiscard]] std::span<const PathRow> all_paths();
/// Null where there is none.
[[nodiscard]] const PathRow* find_path(std::string_view path);

}  // namespace physim
