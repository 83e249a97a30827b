// The numbers of a shot and its weather that may be uncertain: the rows of src/settings that say so, each component of
// a vector and each number of an item separately, and a wind by compass, which is no setting.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "physim/result.hpp"
#include "settings/row.hpp"

namespace physim {

/// Wind by compass: along the ground, instead of its components.
enum class CompassWind { none, speed, from };

/// One number that may be uncertain.
struct PathRow {
  std::string path;  // "N" in it: which point of a list
  std::string about;
  std::string_view unit;  // in SI, "-": none
  /// Where it is, in a shot or its place. Null where a list has no such point, counted from 0, and where the model
  /// alone knows the number. A number of a shot reads no place, and one of a place no shot.
  double* (*find)(Shot*, Environment*, std::size_t point) = nullptr;
  void (*scale)(Shot&, double factor) = nullptr;  // of a factor: multiplies all points of a list
  LaunchColumn launches = nullptr;                // the column of launches that has it
  WeatherColumn weather = nullptr;                // the column of the weather that has it
  CompassWind compass = CompassWind::none;        // which part of a wind by compass it is
  bool is_of_environment = false;                 // and not of a shot
  bool is_wind = false;
  bool above_zero = false;  // anything else cannot be
  bool is_place = false;    // where a point of a list stands
  std::size_t list = 0;     // which list it is a point of, counted from 1; 0: of none

  [[nodiscard]] bool is_of_list() const { return list > 0; }
  /// A number that all shots of a batch have in common, unless each flies in its own place.
  [[nodiscard]] bool is_of_place() const { return is_of_environment && !weather && compass == CompassWind::none; }
};

/// What a path names: a row, and which point where it is one of a list.
struct FoundPath {
  const PathRow* row = nullptr;  // null: not found
  std::size_t point = 0;         // counted from 1; 0 in a path is no point

  explicit operator bool() const { return row != nullptr; }
  bool operator==(const FoundPath&) const = default;
  /// The point of a list of the shot or its place; null where the list has no such point.
  [[nodiscard]] double* point_of(Shot& shot, Environment& place) const;
  /// How many points that list has.
  [[nodiscard]] std::size_t points(Shot& shot, Environment& place) const;
  /// Whether it is a number of a place, and which.
  [[nodiscard]] bool is(Environment& place, const double& number) const;
  /// What the number is where it is not drawn.
  [[nodiscard]] double there(Shot shot, Environment place) const;
  /// Puts a number of a shot, or of the place, where it belongs; others are left to columns and factors.
  void put(Shot& shot, double number) const;
  void put(Environment& place, double number) const;
};

[[nodiscard]] std::span<const PathRow> all_paths();
[[nodiscard]] FoundPath find_path(std::string_view path);
/// The row of a list, by its path with N in it; null if not found.
[[nodiscard]] const PathRow* find_list(std::string_view path);
/// The row of where the points of a list stand, which may be its own; an error for what is no list, and for points that
/// no one number places.
[[nodiscard]] Result<const PathRow*> places_of_list(std::string_view path);

}  // namespace physim
