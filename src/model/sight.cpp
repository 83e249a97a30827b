// Equations, symbols and Source: model/sight.hpp.
#include "model/sight.hpp"

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

/// Most launches look straight ahead: the sine and cosine of zero need no computing.
SinCos<double> sincos_of(double angle) { return angle == 0 ? SinCos<double>{0, 1} : sincos(angle); }

/// The azimuth of the plane of fire: as given, or that of a given velocity.
double azimuth_of(const Launch& launch) {
  if (!launch.velocity) return launch.azimuth;
  const Vec3d& v = *launch.velocity;
  return v.x == 0 && v.z == 0 ? launch.azimuth : atan2(v.z, v.x);
}

}  // namespace

SightFrame sight_frame(const Launch& launch) {
  const auto azimuth = sincos_of(azimuth_of(launch));
  const auto look = sincos_of(launch.sight.look_angle);
  const auto cant = sincos_of(launch.sight.cant);
  SightFrame s;
  s.muzzle = launch.position;
  s.forward = {look.cos * azimuth.cos, look.sin, look.cos * azimuth.sin};
  s.right = {-azimuth.sin, 0.0, azimuth.cos};
  s.up = cross(s.right, s.forward);
  s.canted = s.up * cant.cos + s.right * cant.sin;
  s.start = s.muzzle + s.canted * launch.sight.height;
  return s;
}

Vec3d launch_direction(const Launch& launch, const SightFrame& sight, double elevation) {
  const double speed = launch.velocity ? length(*launch.velocity) : 0;
  if (speed > 0) return *launch.velocity * (1 / speed);
  const auto above = sincos_of(elevation - launch.sight.look_angle);
  return sight.forward * above.cos + sight.canted * above.sin;
}

double launch_speed(const Launch& launch) { return launch.velocity ? length(*launch.velocity) : launch.speed; }

Vec3d velocity_along(const Launch& launch, const Vec3d& bore) {
  PHYSIM_ASSERT(launch.velocity || !(abs(length_squared(bore) - 1) > 1e-9));
  return launch.velocity ? *launch.velocity : bore * launch.speed;
}

Vec3d launch_velocity(const Launch& launch, const SightFrame& sight, double elevation) {
  return velocity_along(launch, launch_direction(launch, sight, elevation));
}

}  // namespace physim
