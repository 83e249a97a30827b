// Turning: the orientation of a projectile that turns freely, shown and felt by nothing.
//
// What it models: an angular velocity of fixed axis that dies away.
// When to use it: tumbling debris, thrown axes and spinning balls of games, where no rotation model is asked for.
// When it is wrong: a body of unequal moments of inertia precesses and tumbles; air turns and damps it by its shape;
//   and what turns is pushed aside (Magnus). Here nothing of that happens.
// Symbols: q orientation, body axes into W [-]; omega angular velocity in W [rad/s]; k angular drag [1/s]; t time [s].
// Equations: d omega / dt = -k omega, so omega(t) = omega_0 e^(-k t); the axis stays, so the turn is by the angle
//   |omega_0| (1 - e^(-k t)) / k about it, |omega_0| t where k = 0.
// Source: I. Millington, Game Physics Engine Development (2010), sec. 10.3-10.4 (angular damping; quaternions), solved
//   exactly over the step.
#pragma once

#include "base/assert.hpp"
#include "math/elementary.hpp"
#include "math/quat.hpp"
#include "math/vec3.hpp"

namespace physim {

struct Turning {
  Quatd orientation;
  Vec3d angular_velocity;
};

inline Turning turned(const Turning& from, double angular_drag, double time) {
  PHYSIM_ASSERT(time >= 0 && angular_drag >= 0);
  const double speed = length(from.angular_velocity);
  if (speed == 0) return from;
  const double kept = exp(-angular_drag * time);
  const double angle = speed * (angular_drag > 0 ? (1 - kept) / angular_drag : time);
  const auto half = sincos(0.5 * angle);
  const Vec3d axis = from.angular_velocity * (half.sin / speed);
  const Quatd turn{half.cos, axis.x, axis.y, axis.z};
  return {normalized(turn * from.orientation), from.angular_velocity * kept};
}

}  // namespace physim
