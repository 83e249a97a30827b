// Equations, symbols and Source: model/sight.hpp.
#include "model/sight.hpp"

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "math/vec3.hpp"

namespace physim {
namespace {

/// The azimuth of the plane of fire: as given, or that of a given velocity.
double azimuth_of(const Launch& launch) {
  if (!launch.velocity) return launch.azimuth;
  const Vec3d& v = *launch.velocity;
  return v.x == 0 && v.z == 0 ? launch.azimuth : atan2(v.z, v.x);
}

}  // namespace

SightFrame sight_frame(const Launch& launch) {
  const Sight& sight = launch.sight;
  return {sincos_of(azimuth_of(launch)), sincos_of(sight.look_angle), sincos_of(sight.cant), launch.position,
          sight.height};
}

Vec3d launch_direction(const Launch& launch, const SightFrame& sight, double elevation) {
  const double speed = launch.velocity ? length(*launch.velocity) : 0;
  if (speed > 0) return *launch.velocity * (1 / speed);
  return sight.bore(sincos_of(elevation - launch.sight.look_angle));
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
