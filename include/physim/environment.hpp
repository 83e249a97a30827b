// Environment: where a projectile flies. It says what is there; Fidelity says how much of it is modelled,
// and the lower of the two is granted: an environment with constant gravity has no inverse-square law to offer.
#pragma once

#include <optional>
#include <vector>

#include "physim/fidelity.hpp"
#include "physim/field.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// The gravity field. acceleration and radius are those of `constant` and `inverse_square`; another planet has its own,
/// and no more than `inverse_square`. The defaults are those of the US Standard Atmosphere 1976, whose g contains the
/// centrifugal acceleration; where a rotating Earth adds that by itself, the defaults stand for the Earth's own
/// GM = 3.986004418e14 m^3/s^2 and, under a sphere, its mean radius, 6371008.77 m.
struct Gravity {
  GravityModel model = GravityModel::wgs84;  ///< the field there is [-]
  double acceleration = 9.80665;             ///< at mean sea level, downwards [m/s^2]
  double radius = 6356766;                   ///< distance of sea level from the Earth's centre [m]

  bool operator==(const Gravity&) const = default;
};

/// The air. Where temperature, pressure or humidity is given, density at the station follows CIPM-2007 and the standard
/// profile is shifted to it; where none is given the air is exactly the US Standard Atmosphere 1976.
struct Atmosphere {
  AirModel model = AirModel::isa;            ///< the profile there is [-]
  std::optional<double> temperature{};       ///< at the station [K]
  std::optional<double> pressure{};          ///< at the station, not reduced to sea level [Pa]
  std::optional<double> humidity{};          ///< relative, 0 to 1, at the station [-]
  std::optional<double> station_altitude{};  ///< of the station above sea level; default: the origin's [m]
  std::optional<double> density{};      ///< at the origin, overrides all else for constant and exponential air [kg/m^3]
  std::optional<double> sound_speed{};  ///< at the origin, overrides all else for constant and exponential air [m/s]
  double scale_height = 8500;           ///< of exponential air [m]

  bool operator==(const Atmosphere&) const = default;
};

/// What a wind profile is read by.
enum class WindAxis { height, range };
/// How a wind profile is read between its points.
enum class WindInterpolation {
  linear,
  step,  ///< each point holds from its place on
};

struct WindPoint {
  double at = 0;     ///< height above the origin, or downrange distance x [m]
  Vec3d velocity{};  ///< of the air [m/s]

  bool operator==(const WindPoint&) const = default;
};

/// Wind is the velocity of the air in the world frame: (0, 0, -4) blows from the right.
struct Wind {
  Vec3d velocity{};                                             ///< without a profile, everywhere [m/s]
  std::vector<WindPoint> profile{};                             ///< at rising places; held outside; at most 32 [m]
  WindAxis by = WindAxis::height;                               ///< what the profile is read by [-]
  WindInterpolation interpolation = WindInterpolation::linear;  ///< between points of the profile [-]
  /// By place and time, in the place of the profile: of fidelity `profile`; lower rungs know the others alone. It is
  /// the wind in W as it is there: over a round Earth nothing turns it with the vertical. [m/s]
  WindFunction field{};

  bool operator==(const Wind&) const = default;
};

/// Where on the Earth the origin of the world frame lies, how its x axis points, and how the Earth turns. A launch by
/// latitude, longitude, height, azimuth and elevation is one from the origin: latitude, longitude and azimuth are
/// these, height is Environment::altitude, elevation is Launch::elevation.
struct Earth {
  double latitude = 0;                 ///< of the vertical at the origin, north positive [rad]
  double longitude = 0;                ///< of the origin, east positive [rad]
  double azimuth = 0;                  ///< compass direction of the x axis, clockwise from north [rad]
  double rotation_rate = 7.292115e-5;  ///< [rad/s]

  bool operator==(const Earth&) const = default;
};

/// Where a projectile flies.
struct Environment {
  double altitude = 0;      ///< of the origin of the world frame above sea level, or above the ellipsoid [m]
  Gravity gravity{};        ///< [-]
  Atmosphere atmosphere{};  ///< [-]
  Wind wind{};              ///< [-]
  Earth earth{};            ///< [-]
  ForceFunction force{};    ///< on all that flies here in motion `force`, told as `applied` [N]

  bool operator==(const Environment&) const = default;
};

}  // namespace physim
