// Places on and above the Earth: the ellipsoid WGS-84, its coordinates and its gravity.
//
// Frames: E is Earth-fixed and right-handed, with its origin at the Earth's centre, x towards latitude 0 and longitude
// 0, z towards the north pole. I is inertial and coincides with E at time 0. L is local: x east, y north, z up along
// the normal of the ellipsoid. How the world frame W of a flight lies in them says physim/frames.hpp.
#pragma once

#include "physim/vec3.hpp"

namespace physim {

/// World Geodetic System 1984 (NIMA TR8350.2, third edition, tables 3.1 to 3.4).
namespace wgs84 {
inline constexpr double kEquatorialRadius = 6378137.0;                             ///< a [m]
inline constexpr double kFlattening = 1 / 298.257223563;                           ///< f [-]
inline constexpr double kPolarRadius = kEquatorialRadius * (1 - kFlattening);      ///< b = a (1 - f) [m]
inline constexpr double kEccentricitySquared = kFlattening * (2 - kFlattening);    ///< e^2 [-]
inline constexpr double kMeanRadius = (2 * kEquatorialRadius + kPolarRadius) / 3;  ///< R1 = (2a + b) / 3 [m]
inline constexpr double kGM = 3.986004418e14;                                      ///< with the air's mass [m^3/s^2]
inline constexpr double kRotationRate = 7.292115e-5;                               ///< [rad/s]
inline constexpr double kJ2 = 1.08262982e-3;  ///< dynamical form factor that belongs to a, f, GM and the rate [-]
}  // namespace wgs84

/// A place by its coordinates on the ellipsoid. Over a spherical Earth: on the sphere.
struct Geodetic {
  double latitude = 0;   ///< of the vertical, north positive [rad]
  double longitude = 0;  ///< east positive, -pi to pi [rad]
  double height = 0;     ///< above the ellipsoid, along its normal [m]

  bool operator==(const Geodetic&) const = default;
};

/// The place in E [m].
[[nodiscard]] Vec3d earth_fixed_from_geodetic(const Geodetic& place);
/// The coordinates of a place in E [m], to rounding, from 5 km below the ellipsoid to 1e9 m above it; poles and equator
/// are places like others. On the Earth's axis the longitude is 0.
[[nodiscard]] Geodetic geodetic_from_earth_fixed(const Vec3d& position_E);

/// A vector in I from its components in E, after the Earth has turned by an angle [rad]; and back.
[[nodiscard]] Vec3d inertial_from_earth_fixed(const Vec3d& v_E, double angle);
[[nodiscard]] Vec3d earth_fixed_from_inertial(const Vec3d& v_I, double angle);

/// A vector in L (east, north, up) at a place, from its components in E; and back.
[[nodiscard]] Vec3d local_from_earth_fixed(const Vec3d& v_E, const Geodetic& place);
[[nodiscard]] Vec3d earth_fixed_from_local(const Vec3d& v_L, const Geodetic& place);

/// Normal gravity of WGS-84 in L at a place [m/s^2]: gravitation and the centrifugal acceleration of the turning Earth,
/// in closed form at every height.
[[nodiscard]] Vec3d normal_gravity(const Geodetic& place);

}  // namespace physim
