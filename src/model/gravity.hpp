// Gravity.
//
// What it models: `constant`: the same g everywhere, downwards (along the vertical of a round Earth).
//   `inverse_square`: Newton's law; over a flat Earth its size changes with height, over a round one its direction too.
//   `j2`, `wgs84`: the flattened Earth's field, over the ellipsoid (model/normal_gravity.hpp). Over a flat Earth they
//   are the weight at the origin's latitude, falling with height as in Newton's law (model/earth.cpp).
// When to use it: constant below a few kilometres of height: g falls by 0.03 % per kilometre; wgs84 where g should
//   belong to the latitude (0.5 % from equator to pole), and on the ellipsoid.
// When it is wrong: none knows mountains and density (up to 0.05 % of g); constant and inverse_square know no latitude.
// What turns: `constant` gravity is weight, with the centrifugal acceleration in it. Over a rotating round Earth all
//   others are gravitation alone and the centrifugal acceleration is added (model/earth.hpp): none is counted twice.
// Symbols: g at sea level [m/s^2]; R radius of sea level [m]; h altitude [m]; r vector from the Earth's centre [m]; u
//   unit vertical [-]; GM [m^3/s^2].
// Equation: flat: a = -g (R / (R + h))^2 y; sphere: a = -g R^2 r / |r|^3; ellipsoid: a = -GM r / |r|^3, or -g u. With g
//   the standard 9.80665 m/s^2 and R = 6356766 m the first two are the field of the standard atmosphere, which includes
//   the centrifugal part at 45 degrees.
// Source: U.S. Standard Atmosphere, 1976 (NOAA-S/T 76-1562), eq. 17 and p. 8.
#pragma once

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "model/earth.hpp"
#include "model/normal_gravity.hpp"

PHYSIM_ISA_BEGIN

/// Out of line, so that flights over a flat Earth or a sphere do not carry its code.
template <class R, class S>
PHYSIM_NOINLINE void ellipsoid_gravity(const Conditions<S>& c, const Vec3<R>& x, Vec3<R>& a) {
  PHYSIM_ASSERT(c.fidelity.earth == EarthModel::ellipsoid);
  const Vec3<R> r = from_centre(c, x);
  switch (column<&GravityRow::field>(c.fidelity.gravity)) {
    case GravityField::none: break;  // gravity() has answered
    case GravityField::uniform: a = vertical_at(c, x) * R(-c.gravity); return;
    case GravityField::central: {
      const R inverse = S(1) / length(r);
      a = r * -(c.globe.gm * inverse * inverse * inverse);
      return;
    }
    case GravityField::flattened: a = flattened_gravitation(c.fidelity.gravity, c.globe.axis, r); return;
  }
  PHYSIM_UNREACHABLE();
}

template <class R, class S>
PHYSIM_INLINE Vec3<R> gravity(const Conditions<S>& c, const Vec3<R>& x) {
  const R zero(S(0));
  const bool newton = falls(c.fidelity.gravity);
  if (c.fidelity.gravity == GravityModel::off) return {zero, zero, zero};
  if (is_sphere(c.fidelity.earth)) {
    const Vec3<R> r = from_centre(c, x);
    const R inverse = S(1) / length(r);
    const R ratio = c.radius * inverse;
    return r * (newton ? -(c.gravity * ratio * ratio * inverse) : -(c.gravity * inverse));
  }
  if (c.fidelity.earth == EarthModel::ellipsoid) {
    Vec3<R> a;
    ellipsoid_gravity(c, x, a);
    return a;
  }
  if (!newton) return {zero, R(-c.gravity), zero};
  const R ratio = c.radius / (x.y + (c.altitude + c.radius));
  return {zero, -(c.gravity * (ratio * ratio)), zero};
}

/// As a projectile feels it: games give some of them a part of gravity, or more than all of it.
template <class R, class S>
PHYSIM_INLINE Vec3<R> weight_per_mass(const Conditions<S>& c, const Body<R>& b, const Vec3<R>& x) {
  const Vec3<R> g = gravity(c, x);
  return c.has_gravity_scale ? g * b.gravity_scale : g;
}

PHYSIM_ISA_END
