// Gravity.
//
// What it models: `constant`: the same g everywhere, downwards (towards the centre over a sphere).
//   `inverse_square`: Newton's law; over a flat Earth its size changes with height, over a sphere its direction too.
// When to use it: constant below a few kilometres of height: g falls by 0.03 % per kilometre.
// When it is wrong: neither knows latitude, flattening or local anomalies (up to 0.3 % of g).
// Symbols: g at sea level [m/s^2]; R radius of sea level [m]; h altitude [m]; r vector from the Earth's centre [m].
// Equation: flat: a = -g (R / (R + h))^2 y; sphere: a = -g R^2 r / |r|^3. With g the standard 9.80665 m/s^2 and
//   R = 6356766 m this is the field of the standard atmosphere, which includes the centrifugal part at 45 degrees.
// Source: U.S. Standard Atmosphere, 1976 (NOAA-S/T 76-1562), eq. 17 and p. 8.
#pragma once

#include "model/earth.hpp"

PHYSIM_ISA_BEGIN

template <class R, class S>
PHYSIM_INLINE Vec3<R> gravity(const Conditions<S>& c, const Vec3<R>& x) {
  const R zero(S(0));
  const bool newton = c.fidelity.gravity == GravityModel::inverse_square;
  if (c.fidelity.gravity == GravityModel::off) return {zero, zero, zero};
  if (c.fidelity.earth == EarthModel::sphere) {
    const Vec3<R> r = from_centre(c, x);
    const R inverse = S(1) / length(r);
    const R ratio = c.radius * inverse;
    return r * (newton ? -(c.gravity * ratio * ratio * inverse) : -(c.gravity * inverse));
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
