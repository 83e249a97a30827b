// Equations, symbols and Source: model/sight.hpp.
#include "model/sight.hpp"

#include "math/elementary.hpp"

namespace physim {
namespace {

/// The sight's own up, rolled by the cant.
Vec3d canted_up(const SightFrame& s, double cant) { return s.up * cos(cant) + s.right * sin(cant); }

/// The azimuth of the plane of fire: as given, or that of a given velocity.
double azimuth_of(const Launch& launch) {
  if (!launch.velocity) return launch.azimuth;
  const Vec3d& v = *launch.velocity;
  return v.x == 0 && v.z == 0 ? launch.azimuth : atan2(v.z, v.x);
}

}  // namespace

SightFrame sight_frame(const Launch& launch) {
  const double azimuth = azimuth_of(launch);
  const double look = launch.sight.look_angle;
  SightFrame s;
  s.muzzle = launch.position;
  s.forward = {cos(look) * cos(azimuth), sin(look), cos(look) * sin(azimuth)};
  s.right = {-sin(azimuth), 0.0, cos(azimuth)};
  s.up = cross(s.right, s.forward);
  s.start = s.muzzle + canted_up(s, launch.sight.cant) * launch.sight.height;
  return s;
}

Vec3d launch_velocity(const Launch& launch, double elevation) {
  if (launch.velocity) return *launch.velocity;
  const SightFrame s = sight_frame(launch);
  const double above = elevation - launch.sight.look_angle;
  return (s.forward * cos(above) + canted_up(s, launch.sight.cant) * sin(above)) * launch.speed;
}

}  // namespace physim
