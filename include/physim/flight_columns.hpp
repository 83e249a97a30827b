// fly_columns(): batches whose launches come, and whose ends go, as columns of numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "physim/flight.hpp"

namespace physim {

/// Launches of one projectile: what differs from shot to shot is a column, and the rest stands in `common` once. All
/// columns that are given have one length, the number of shots. A shot whose number is impossible is refused alone.
struct LaunchColumns {
  Launch common{};                      ///< without a velocity: give a speed and angles [-]
  std::span<const double> x{};          ///< of Launch::position [m]
  std::span<const double> y{};          ///< upwards [m]
  std::span<const double> z{};          ///< [m]
  std::span<const double> speed{};      ///< [m/s]
  std::span<const double> elevation{};  ///< [rad]
  std::span<const double> azimuth{};    ///< [rad]
  /// In the place of DragDef::ballistic_coefficient, as rounds of one lot differ; above 0. Not read where the
  /// projectile has DragDef::bands, as fly() does not read it there [kg/m^2]
  std::span<const double> ballistic_coefficient{};
  /// In the place of DragDef::form_factor; above 0. Not read where there is a ballistic coefficient [-]
  std::span<const double> form_factor{};

  /// Number of shots: the length of the longest column; none are given: no shots.
  [[nodiscard]] std::size_t size() const {
    return std::max({x.size(), y.size(), z.size(), speed.size(), elevation.size(), azimuth.size(),
                     ballistic_coefficient.size(), form_factor.size()});
  }
  /// Whether shots differ in their projectiles' drag.
  [[nodiscard]] bool has_drag() const { return !ballistic_coefficient.empty() || !form_factor.empty(); }
  /// The launch of shot i < size().
  [[nodiscard]] Launch at(std::size_t i) const {
    Launch launch = common;
    if (!x.empty()) launch.position.x = x[i];
    if (!y.empty()) launch.position.y = y[i];
    if (!z.empty()) launch.position.z = z[i];
    if (!speed.empty()) launch.speed = speed[i];
    if (!elevation.empty()) launch.elevation = elevation[i];
    if (!azimuth.empty()) launch.azimuth = azimuth[i];
    return launch;
  }
  /// Writes the drag of shot i < size() over that of a projectile.
  void put(std::size_t i, ProjectileDef& own) const {
    if (!ballistic_coefficient.empty()) own.drag.ballistic_coefficient = ballistic_coefficient[i];
    if (!form_factor.empty()) own.drag.form_factor = form_factor[i];
  }
};

/// Where the ends of the flights go: columns as long as there are shots, in the caller's memory. Those left empty are
/// not wanted, and cost nothing. Of a shot that was refused all numbers are NaN. With Until::range a flight ends at a
/// range line, and these are drop, windage, time and speed there.
struct EndColumns {
  std::span<Outcome> outcome{};  ///< [-]
  std::span<double> time{};      ///< of flight [s]
  std::span<double> x{};         ///< of the end [m]
  std::span<double> y{};         ///< [m]
  std::span<double> z{};         ///< [m]
  std::span<double> vx{};        ///< velocity at the end [m/s]
  std::span<double> vy{};        ///< [m/s]
  std::span<double> vz{};        ///< [m/s]
  std::span<double> speed{};     ///< at the end [m/s]
  std::span<double> drop{};      ///< as Sample::drop: above the line of sight [m]
  std::span<double> windage{};   ///< as Sample::windage: right of the line of sight [m]
};

/// What fly_columns() tells beside the columns.
struct ColumnsResult {
  std::size_t refused = 0;          ///< shots [-]
  std::optional<Error> error{};     ///< the first of a shot refused, or of what all have in common [-]
  std::string kernel{};             ///< as BatchResult::kernel [-]
  FidelityInUse fidelity_in_use{};  ///< of the first shot that was not refused [-]
};

/// Flies launches of one projectile as fly_batch() does, with the same numbers, and writes what is asked for of how
/// they end. There are no events; watch them with fly_batch(). Columns of different lengths, or a velocity in
/// `launches.common`, refuse all; then nothing is written. Memory stays the same however many shots there are.
[[nodiscard]] ColumnsResult fly_columns(const ProjectileDef& projectile, const LaunchColumns& launches,
                                        const Environment& environment, const Fidelity& fidelity,
                                        const Tolerance& tolerance, const Until& until, const EndColumns& into,
                                        TaskRunner* runner = nullptr, const Weather& weather = {});

}  // namespace physim
