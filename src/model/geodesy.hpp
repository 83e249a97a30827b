// The ellipsoid: its normal through a place, and the height along it.
//
// What it models: heights above an ellipsoid of revolution and the direction of its vertical, for numbers and packs,
//   without sines, cosines or angles: poles, equator and axis are places like others.
// When to use it: whenever heights matter to better than the flattening of the Earth, 21 km from pole to equator.
// When it is wrong: heights are above the ellipsoid, not above mean sea level: the geoid lies up to 100 m off it.
//   Deeper than some 5000 km below ground the iteration does not settle.
// Symbols: a equatorial radius, f flattening, e^2 = f (2 - f); r place from the centre, z along the axis k [m]; u unit
//   normal (0 at the origin of W); N radius of curvature in the prime vertical [m]; h height [m]; x place in W [m];
//   kappa = e^2 N sin(phi): how far below the centre the normal meets the axis [m], so that r + kappa k = (N + h) u.
// Equations: kappa = e^2 a m / sqrt(|r|^2 - z^2 + (1 - e^2) m^2) with m = z + kappa: repeated, its error falls by e^2
//   each time; the start m = z / (1 - e^2) is exact on the ellipsoid.
//   h = u.r - s(u), s(u) = a |l(u)|, l(v) = v - f k (k.v): the distance of two planes normal to u, one through the
//   place and one touching the ellipsoid. It is largest for the true u, so an error of u enters squared only.
//   From the origin, with d = u - u0 and Lagrange's identity, so that nothing cancels:
//   h - h0 = u.x - a |l(d) x l(u0)|^2 / (|l(u0)|^2 (q + |l(u)|)) - h0 |d|^2 / 2, q = l(u).l(u0) / |l(u0)|.
// Source: W. A. Heiskanen, H. Moritz, Physical Geodesy (1967), sec. 5-3 (N, kappa, iteration); NIMA TR8350.2, World
//   Geodetic System 1984 (2000), table 3.1; the support function s of an ellipsoid is geometry.
#pragma once

#include "base/assert.hpp"
#include "math/pack.hpp"
#include "math/vec3.hpp"
#include "model/conditions.hpp"
#include "physim/environment.hpp"

PHYSIM_ISA_BEGIN

/// Rounds of the iteration in a flight: they leave 1e-10 rad of the normal at any height above ground and nothing of
/// the height. As many as leave but rounding of both.
inline constexpr int kFlightRounds = 3;
inline constexpr int kAllRounds = 8;

/// kappa of a place with |r|^2 and z.
template <class R>
PHYSIM_INLINE R axis_offset(const R& r_squared, const R& z, int rounds) {
  PHYSIM_ASSERT(rounds > 0 && rounds <= kAllRounds);
  const R e2 = constant<R>(wgs84::kEccentricitySquared);
  const R e2a = constant<R>(wgs84::kEccentricitySquared * wgs84::kEquatorialRadius);
  const R p_squared = r_squared - z * z;
  R m = z * constant<R>(1 / (1 - wgs84::kEccentricitySquared));
  R kappa(ScalarOf<R>(0));
  for (int i = 0; i < rounds; ++i) {
    kappa = e2a * m / sqrt(p_squared + (m * m - e2 * m * m));
    m = z + kappa;
  }
  return kappa;
}

/// l(v): what turns the ellipsoid into a sphere.
template <class R, class S>
PHYSIM_INLINE Vec3<R> squeezed(const Vec3<S>& axis, const Vec3<R>& v) {
  const R along = constant<R>(wgs84::kFlattening) * (v.x * axis.x + v.y * axis.y + v.z * axis.z);
  return {v.x - along * axis.x, v.y - along * axis.y, v.z - along * axis.z};
}

/// The vertical at a place.
template <class R>
struct Vertical {
  Vec3<R> up;  // u [-]
  R height;    // h - h0: above the origin of W [m]
};

/// The vertical of the ellipsoid at a place x in W; the y axis of W is the vertical at its origin.
template <class R, class S>
PHYSIM_NOINLINE void ellipsoid_vertical(const Globe<S>& g, const S& origin_height, const Vec3<R>& x, Vertical<R>& out,
                                        int rounds = kFlightRounds) {
  const Vec3<R> r{x.x + g.origin.x, x.y + g.origin.y, x.z + g.origin.z};
  const R z = r.x * g.axis.x + r.y * g.axis.y + r.z * g.axis.z;
  const R lift = axis_offset(dot(r, r), z, rounds) - g.axis_offset;
  const Vec3<R> w{x.x + lift * g.axis.x, x.y + lift * g.axis.y, x.z + lift * g.axis.z};
  const Vec3<R> m{w.x, w.y + g.to_axis, w.z};  // (N + h) u
  const R size = length(m);
  const R growth = (S(2) * g.to_axis * w.y + dot(w, w)) / (size + g.to_axis);  // |m| - |m0|
  const R per_size = S(1) / size;
  const Vec3<R> d{w.x * per_size, (w.y - growth) * per_size, w.z * per_size};
  out.up = m * per_size;
  const Vec3<R> l0{R(g.squeezed_up.x), R(g.squeezed_up.y), R(g.squeezed_up.z)};
  const Vec3<R> l = squeezed(g.axis, out.up);
  const Vec3<R> crossed = cross(squeezed(g.axis, d), l0) * R(g.per_squeezed_up);
  const R support = length(l);
  const R q = dot(l, l0) * g.per_squeezed_up;
  const R zero(S(0));
  const R sag = select(q > zero, dot(crossed, crossed) / (max(q, zero) + support), support - q);
  out.height = dot(out.up, x) - constant<R>(wgs84::kEquatorialRadius) * sag - origin_height * S(0.5) * dot(d, d);
}

PHYSIM_ISA_END

namespace physim {

/// Unit vectors east, north and up at a place.
struct LocalAxes {
  Vec3d east, north, up;
};

}  // namespace physim
