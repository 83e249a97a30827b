// The shape and rotation of the Earth as a flight feels them: heights, the vertical, and what turning does.
//
// What it models: `flat`: height is y. `flat_coriolis`: also the Coriolis acceleration of the turning Earth.
//   `sphere`: heights are above a sphere with its centre (R + h0) below the origin; it does not rotate.
//   `sphere_rotating`: a sphere, and W turns with it. `ellipsoid`: heights are above WGS-84, and W turns with it.
// When to use it: flat below 5 km of range, flat_coriolis to some 50 km, ellipsoid beyond; the spheres to meet the
//   figures of others.
// When it is wrong: flat_coriolis leaves out the centrifugal acceleration (it is part of g) and the curvature, which
//   lowers the ground by x^2 / 2R: 8 m at 10 km. The spheres leave out the flattening: 21 km from equator to pole.
// Frames: W is the tangent frame at the origin. On a rotating Earth it is Earth-fixed: still air is air that turns with
//   the Earth, and velocities are those seen from the ground. On one that does not rotate W is inertial.
// Symbols: R radius of sea level [m]; h0 altitude of the origin [m]; r vector from the Earth's centre [m]; k unit
//   vector of its axis; Omega = |Omega| k angular velocity of the Earth in W [rad/s]; v velocity [m/s]; phi latitude,
//   A compass azimuth of x [rad]; u unit vertical at the projectile, y at the origin; w wind at the origin [m/s].
// Equations: a = -2 Omega x v - Omega x (Omega x r), k = (cos phi cos A, sin phi, -cos phi sin A) in W (x downrange, y
//   up, z right); the second term only where gravity does not contain it: `constant` gravity is weight and does.
//   Height above the sphere: h = (|r|^2 - R^2) / (|r| + R), with the difference expanded so that nothing cancels; above
//   the ellipsoid: model/geodesy.hpp.
//   Wind turns with the vertical, so that level wind stays level: by the shortest turn that takes y to u,
//   w' = w - (y + u) ((y + u).w) / (1 + y.u) + 2 u (y.w). Along a great circle from the origin it keeps its direction.
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), ch. 8, eq. 8.28-8.30 (Coriolis); the rest is geometry.
#pragma once

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "model/body.hpp"
#include "model/geodesy.hpp"
#include "model/ladder.hpp"

namespace physim {

/// Heights are above a curved surface.
PHYSIM_INLINE constexpr bool is_round(EarthModel earth) { return column<&EarthRow::shape>(earth) != EarthShape::flat; }
PHYSIM_INLINE constexpr bool is_sphere(EarthModel earth) {
  return column<&EarthRow::shape>(earth) == EarthShape::sphere;
}
/// W turns with the Earth.
PHYSIM_INLINE constexpr bool is_turning(EarthModel earth) { return column<&EarthRow::turning>(earth); }
/// Gravity falls with height.
PHYSIM_INLINE constexpr bool falls(GravityModel gravity) {
  const GravityField field = column<&GravityRow::field>(gravity);
  return field == GravityField::central || field == GravityField::flattened;
}

/// W turns, and the centrifugal acceleration is no part of gravity.
PHYSIM_INLINE constexpr bool throws_out(const Fidelity& f) {
  return is_turning(f.earth) && is_round(f.earth) && column<&GravityRow::field>(f.gravity) != GravityField::uniform;
}

/// The environment gives its own gravity, which only `constant` and `inverse_square` can have.
[[nodiscard]] bool has_own_gravity(const Environment& environment);
/// Fills gravity, radius, altitude, omega and globe for the granted rungs.
void prepare_earth(const Environment& environment, const Fidelity& granted, Conditions<double>& conditions);
[[nodiscard]] Globe<float> to_float(const Globe<double>& globe);

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Vector from the Earth's centre [m].
template <class R, class S>
PHYSIM_INLINE Vec3<R> from_centre(const Conditions<S>& c, const Vec3<R>& x) {
  if (c.fidelity.earth == EarthModel::ellipsoid)
    return {x.x + c.globe.origin.x, x.y + c.globe.origin.y, x.z + c.globe.origin.z};
  return {x.x, x.y + (c.radius + c.altitude), x.z};
}

/// The vertical of the ellipsoid at a place, and the height above the origin.
template <class R, class S>
PHYSIM_INLINE Vertical<R> ellipsoid_vertical_at(const Conditions<S>& c, const Vec3<R>& x) {
  PHYSIM_ASSERT(c.globe.to_axis > S(0));
  Vertical<R> vertical;
  ellipsoid_vertical(c.globe, c.altitude, x, vertical);
  return vertical;
}

/// Altitude above a spherical sea level [m].
template <class R, class S>
PHYSIM_INLINE R sphere_altitude(const Conditions<S>& c, const Vec3<R>& x) {
  const R up = x.y + c.altitude;
  const R difference = x.x * x.x + x.z * x.z + up * (up + S(2) * c.radius);  // |r|^2 - R^2
  return difference / (length(from_centre(c, x)) + c.radius);
}

/// Altitude above sea level [m].
template <class R, class S>
PHYSIM_INLINE R altitude(const Conditions<S>& c, const Vec3<R>& x) {
  switch (column<&EarthRow::shape>(c.fidelity.earth)) {
    case EarthShape::flat: return x.y + c.altitude;
    case EarthShape::sphere: return sphere_altitude(c, x);
    case EarthShape::ellipsoid: return ellipsoid_vertical_at(c, x).height + c.altitude;
  }
  PHYSIM_UNREACHABLE();
}

/// Height above the origin of W [m]; events and the ground use it.
template <class R, class S>
PHYSIM_INLINE R height(const Conditions<S>& c, const Vec3<R>& x) {
  switch (column<&EarthRow::shape>(c.fidelity.earth)) {
    case EarthShape::flat: return x.y;
    case EarthShape::sphere: return sphere_altitude(c, x) - c.altitude;
    case EarthShape::ellipsoid: return ellipsoid_vertical_at(c, x).height;
  }
  PHYSIM_UNREACHABLE();
}

/// The vertical at a place, a unit vector [-].
template <class R, class S>
PHYSIM_INLINE Vec3<R> vertical_at(const Conditions<S>& c, const Vec3<R>& x) {
  switch (column<&EarthRow::shape>(c.fidelity.earth)) {
    case EarthShape::flat: return {R(S(0)), R(S(1)), R(S(0))};
    case EarthShape::sphere: {
      const Vec3<R> r = from_centre(c, x);
      return r * (S(1) / length(r));
    }
    case EarthShape::ellipsoid: return ellipsoid_vertical_at(c, x).up;
  }
  PHYSIM_UNREACHABLE();
}

/// Rate of climb [m/s].
template <class R, class S>
PHYSIM_INLINE R climb_rate(const Conditions<S>& c, const State<R>& s) {
  switch (column<&EarthRow::shape>(c.fidelity.earth)) {
    case EarthShape::flat: return s.v.y;
    case EarthShape::sphere: {
      const Vec3<R> r = from_centre(c, s.x);
      return dot(r, s.v) / length(r);
    }
    case EarthShape::ellipsoid: return dot(vertical_at(c, s.x), s.v);
  }
  PHYSIM_UNREACHABLE();
}

/// A vector given at the origin of W, turned by the shortest way with the vertical.
template <class R, class S>
PHYSIM_NOINLINE void turn_with_vertical(const Conditions<S>& c, const Vec3<R>& x, Vec3<R>& w) {
  PHYSIM_ASSERT(is_round(c.fidelity.earth));
  const Vec3<R> u = vertical_at(c, x);
  const Vec3<R> sum{u.x, u.y + S(1), u.z};
  const R up = w.y;
  w -= sum * (dot(sum, w) / (u.y + S(1)));
  w += u * (S(2) * up);
}

/// -2 Omega x v [m/s^2].
template <class R, class S>
PHYSIM_INLINE Vec3<R> coriolis(const Conditions<S>& c, const Vec3<R>& v) {
  const S two = 2;
  const Vec3<R> twice_omega{R(two * c.omega.x), R(two * c.omega.y), R(two * c.omega.z)};
  return cross(v, twice_omega);
}

/// -Omega x (Omega x r) [m/s^2].
template <class R, class S>
PHYSIM_INLINE Vec3<R> centrifugal(const Conditions<S>& c, const Vec3<R>& x) {
  const Vec3<R> omega{R(c.omega.x), R(c.omega.y), R(c.omega.z)};
  return cross(omega, cross(from_centre(c, x), omega));
}

PHYSIM_ISA_END
