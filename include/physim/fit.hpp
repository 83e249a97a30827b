// Fitting: the drag of a projectile, and its muzzle speed, from what was measured of its flight.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physim/flight.hpp"

namespace physim {

/// What was measured of a flight at one range; at least one figure of it.
struct Measurement {
  double range = 0;               ///< along the line of sight [m]
  std::optional<double> speed{};  ///< [m/s]
  std::optional<double> drop{};   ///< above the line of sight, below it negative [m]
  std::optional<double> time{};   ///< of flight [s]
};

/// What is fitted, and how far measurements are trusted: figures count by how many times their error they are off.
struct FitOptions {
  bool muzzle_speed = false;  ///< fits launch.speed, too [-]
  double speed_error = 1;     ///< of measured speeds [m/s]
  double drop_error = 0.01;   ///< of measured drops [m]
  double time_error = 1e-3;   ///< of measured times [s]
};

/// One figure as measured and as computed by what was fitted.
struct FitResidual {
  std::size_t measurement = 0;  ///< its index [-]
  std::string quantity{};       ///< "speed", "drop" or "time" [-]
  double measured = 0;          ///< [m/s, m or s]
  double computed = 0;          ///< [m/s, m or s]
};

/// A fitted projectile.
struct Fit {
  ProjectileDef projectile{};            ///< as given, its drag scaled [-]
  Launch launch{};                       ///< as given, with the muzzle speed fitted [-]
  double scale = 1;                      ///< drag of the fitted projectile over that of the given one [-]
  double scale_error = 0;                ///< standard error; 0 without more figures than unknowns [-]
  double muzzle_speed_error = 0;         ///< standard error, likewise; 0 where it is not fitted [m/s]
  double rms = 0;                        ///< of the residuals over their errors; about 1 where the errors are right [-]
  std::vector<FitResidual> residuals{};  ///< in the order of the measurements [-]
  std::int64_t flights = 0;              ///< trajectories flown [-]
};

/// Finds by how much the drag of a projectile must be scaled for its flight to come nearest to measurements, in the
/// sense of least squares. What is scaled is what the projectile has: its ballistic coefficients (by 1 / scale),
/// without them the form factor (a scale on its drag curve); k1 and k2; the exponent of its damping. An error where the
/// measurements make no sense, are too few, do not depend on drag, or ask for a drag beyond 1/1000 to 1000 times the
/// given one, or where all flights together take more than five million steps or 20 million
/// evaluations of forces.
[[nodiscard]] Result<Fit> fit_drag(const ProjectileDef& projectile, const Launch& launch,
                                   const Environment& environment, const Fidelity& fidelity,
                                   std::span<const Measurement> measurements, const FitOptions& options = {});

}  // namespace physim
