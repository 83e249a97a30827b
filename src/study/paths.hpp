// The numbers of a shot and its weather that may be uncertain: the one list of them.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "physim/flight_columns.hpp"
#include "physim/result.hpp"

namespace physim {

/// Wind by compass: along the ground, instead of its components.
enum class CompassWind { none, speed, from };

struct PathRow {
  std::string_view path, unit, about;                           // "N" in a path: which point of a list
  double& (*number)(Shot&) = nullptr;                           // of a shot
  std::span<const double> LaunchColumns::*launches = nullptr;   // ... that launches have as a column
  std::span<const double> Weather::*weather = nullptr;          // of the weather, ...
  double (*there)(const Environment&) = nullptr;                // ... and what there is without a column
  void (*scale)(Shot&, double factor) = nullptr;                // or a factor of several numbers of a shot
  bool above_zero = false;                                      // anything else cannot be
  CompassWind compass = CompassWind::none;                      // which part of a wind by compass it is
  double& (*place)(Environment&) = nullptr;                     // a number of the place, which each shot has then
  double* (*point)(Shot&, std::size_t) = nullptr;               // a point of a list, from 0; null: there is none
  double* (*place_point)(Environment&, std::size_t) = nullptr;  // ... of the place

  [[nodiscard]] bool is_of_place() const { return place || place_point; }
  [[nodiscard]] bool is_of_list() const { return point || place_point; }
};

/// What a path names: a row, and which point where it is one of a list.
struct FoundPath {
  const PathRow* row = nullptr;  // null where there is none
  std::size_t point = 0;         // counted from 1; 0 in a path is no point

  explicit operator bool() const { return row != nullptr; }
  bool operator==(const FoundPath&) const = default;
  /// The point of a list of the shot or its place; null where the list has no such point.
  [[nodiscard]] double* point_of(Shot& shot, Environment& place) const;
  /// How many points that list has.
  [[nodiscard]] std::size_t points(Shot& shot, Environment& place) const;
  /// What the number is where it is not drawn.
  [[nodiscard]] double there(Shot shot, Environment place) const;
  /// Puts a number of a shot, or of the place, where it belongs; others are left to columns and factors.
  void put(Shot& shot, double number) const;
  void put(Environment& place, double number) const;
};

[[nodiscard]] std::span<const PathRow> all_paths();
[[nodiscard]] FoundPath find_path(std::string_view path);
/// The row of a list, by its path with N in it; null where there is none.
[[nodiscard]] const PathRow* find_list(std::string_view path);
/// The row of where the points of a list stand, which may be its own; an error for what is no list, and for points that
/// no one number places.
[[nodiscard]] Result<const PathRow*> places_of_list(std::string_view path);

}  // namespace physim
