// The shape and rotation of the Earth as a flight feels them: heights, the vertical, and the Coriolis acceleration.
//
// What it models: `flat`: height is y. `flat_coriolis`: also the Coriolis acceleration of the turning Earth.
//   `sphere`: heights are above a sphere whose centre lies (R + h0) below the origin; it does not rotate.
// When to use it: flat below 5 km of range, flat_coriolis to some 50 km, sphere beyond.
// When it is wrong: flat_coriolis leaves out the centrifugal acceleration (it is part of g) and the curvature, which
//   lowers the ground by x^2 / 2R: 8 m at 10 km. sphere leaves out rotation and flattening.
// Symbols: R radius of sea level [m]; h0 altitude of the origin [m]; r vector from the Earth's centre [m];
//   Omega angular velocity of the Earth in W [rad/s]; v velocity [m/s]; phi latitude, A compass azimuth of x [rad].
// Equations: a = -2 Omega x v, Omega = |Omega| (cos phi cos A, sin phi, -cos phi sin A) in W (x downrange, y up, z
// right).
//   Height above the sphere: h = (|r|^2 - R^2) / (|r| + R), with the difference expanded so that nothing cancels.
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), ch. 8, eq. 8.28-8.30 (Coriolis); the rest is geometry.
#pragma once

#include "math/pack.hpp"
#include "model/body.hpp"
#include "model/conditions.hpp"

PHYSIM_ISA_BEGIN

/// Vector from the Earth's centre [m].
template <class R, class S>
PHYSIM_INLINE Vec3<R> from_centre(const Conditions<S>& c, const Vec3<R>& x) {
  return {x.x, x.y + (c.radius + c.altitude), x.z};
}

/// Altitude above sea level [m].
template <class R, class S>
PHYSIM_INLINE R altitude(const Conditions<S>& c, const Vec3<R>& x) {
  const R up = x.y + c.altitude;
  if (c.fidelity.earth != EarthModel::sphere) return up;
  const R difference = x.x * x.x + x.z * x.z + up * (up + S(2) * c.radius);  // |r|^2 - R^2
  return difference / (length(from_centre(c, x)) + c.radius);
}

/// Height above the origin of W [m]; events and the ground use it.
template <class R, class S>
PHYSIM_INLINE R height(const Conditions<S>& c, const Vec3<R>& x) {
  return c.fidelity.earth == EarthModel::sphere ? altitude(c, x) - c.altitude : x.y;
}

/// Rate of climb [m/s].
template <class R, class S>
PHYSIM_INLINE R climb_rate(const Conditions<S>& c, const State<R>& s) {
  if (c.fidelity.earth != EarthModel::sphere) return s.v.y;
  const Vec3<R> r = from_centre(c, s.x);
  return dot(r, s.v) / length(r);
}

/// -2 Omega x v [m/s^2].
template <class R, class S>
PHYSIM_INLINE Vec3<R> coriolis(const Conditions<S>& c, const Vec3<R>& v) {
  const S two = 2;
  const Vec3<R> twice_omega{R(two * c.omega.x), R(two * c.omega.y), R(two * c.omega.z)};
  return cross(v, twice_omega);
}

PHYSIM_ISA_END
