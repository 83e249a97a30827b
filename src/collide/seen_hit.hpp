// How a surface sees what meets it: what a material does, and what tables, questions and studies tell of a hit, follows
// from that.
#pragma once

#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "physim/event.hpp"
#include "physim/scene.hpp"

namespace physim {

/// Between a way and the normal into a surface: 0 straight on, pi/2 along it, more away from it [rad].
[[nodiscard]] inline double obliquity_of(const Vec3d& way, const Vec3d& normal) {
  const double out = dot(way, normal);
  return atan2(length(way - normal * out), 0 - out);  // what stands still: 0, where -out would say pi
}

/// The velocity of the surface that an event is about, where it is touched [m/s]. `radius`: of a ball, the middle of
/// which the event tells; `time`: of the scene then. 0 where the thing is gone.
[[nodiscard]] inline Vec3d surface_velocity(const Scene& scene, const Event& event, double radius, double time) {
  const auto thing = scene.state(event.instance, time);
  return thing ? velocity_at(*thing, event.position - event.normal * radius) : Vec3d{};
}

}  // namespace physim
