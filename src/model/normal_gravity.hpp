// Gravitation of the Earth as a flattened body: J2, and the field of the WGS-84 ellipsoid.
//
// What it models: `j2`: a point mass and the second zonal harmonic. `wgs84`: the gravitation of the ellipsoid with a
//   surface that is level as it turns: exact at every height outside it.
// When to use it: orbits and ranges beyond 100 km; j2 where other programs are to be compared that know no more.
// When it is wrong: j2 differs from normal gravity by up to 5e-5 m/s^2 at the ground; the true field from both by some
//   5e-4 m/s^2 (mountains and density). Below ground both go on as if all mass lay deeper.
// Symbols: r place from the centre, k unit vector of the axis, z = r.k, p distance from the axis [m]; GM [m^3/s^2];
//   a equatorial radius, E = sqrt(a^2 - b^2) linear eccentricity [m]; omega rate that belongs to the ellipsoid [rad/s];
//   u half axis of the confocal ellipsoid through r [m], v^2 = u^2 + E^2, sin(beta) = z / u; t = E / u [-].
// Equations: j2: a = -GM / r^3 (r (1 - c (5 s^2 - 1)) + 2 c z k), c = 3/2 J2 (a / r)^2, s = z / r.
//   wgs84: D = sqrt((r^2 - E^2)^2 + 4 E^2 z^2), u^2 = (r^2 - E^2 + D) / 2,
//   K = GM + omega^2 a^2 E (q' / q0) (sin^2(beta) / 2 - 1/6),
//   a_p = -(p / D) (u K / v^2 + omega^2 a^2 (q / q0) sin^2(beta)),
//   a_z = -(z / D) (K / u - omega^2 a^2 (q / q0) cos^2(beta)):
//   the components along u and beta of the source without their centrifugal parts, turned back to p and z.
//   q = ((1 + 3 / t^2) atan(t) - 3 / t) / 2 = t^3 sum_n (-1)^n 2 (n + 1) t^2n / ((2n + 3) (2n + 5)),
//   q' = 3 (1 + 1 / t^2) (1 - atan(t) / t) - 1 = t^2 sum_n (-1)^n 6 t^2n / ((2n + 3) (2n + 5)): in the closed forms
//   nearly all digits cancel, in the sums none; t^2 < 0.0068 outside the ellipsoid.
// Source: W. A. Heiskanen, H. Moritz, Physical Geodesy (1967), eq. 2-56 to 2-59, 2-66, 2-67; NIMA TR8350.2, World
//   Geodetic System 1984 (2000), ch. 4, eq. 4-5 to 4-19; J2: D. A. Vallado, Fundamentals of Astrodynamics and
//   Applications (2007), eq. 8-25 to 8-27.
#pragma once

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "model/geodesy.hpp"
#include "physim/fidelity.hpp"

PHYSIM_ISA_BEGIN

/// sum_n (-1)^n factor(n) x^n / ((2n + 3) (2n + 5)), n = 0..8.
template <class R, class Factor>
PHYSIM_INLINE R confocal_sum(const R& x, const Factor& factor) {
  constexpr int kLast = 8;
  R sum(ScalarOf<R>(0));
  for (int n = kLast; n >= 0; --n)
    sum = constant<R>((n % 2 == 0 ? 1.0 : -1.0) * factor(n) / ((2 * n + 3) * (2 * n + 5))) + x * sum;
  return sum;
}
template <class R>
PHYSIM_INLINE R confocal_q(const R& t_squared) {  // q / t^3
  return confocal_sum(t_squared, [](int n) { return 2.0 * (n + 1); });
}
template <class R>
PHYSIM_INLINE R confocal_q_slope(const R& t_squared) {  // q' / t^2
  return confocal_sum(t_squared, [](int) { return 6.0; });
}

/// Gravitation of a point mass with J2 [m/s^2].
template <class R, class S>
PHYSIM_INLINE Vec3<R> j2_gravitation(const Vec3<S>& axis, const Vec3<R>& r) {
  const R z = r.x * axis.x + r.y * axis.y + r.z * axis.z;
  const R per_r2 = S(1) / dot(r, r);
  const R c = constant<R>(1.5 * wgs84::kJ2 * wgs84::kEquatorialRadius * wgs84::kEquatorialRadius) * per_r2;
  const R pull = constant<R>(wgs84::kGM) * per_r2 * sqrt(per_r2);
  const R radial = pull * (c * (S(5) * (z * z * per_r2) - S(1)) - S(1));
  const R axial = S(-2) * pull * c * z;
  return {r.x * radial + axial * axis.x, r.y * radial + axial * axis.y, r.z * radial + axial * axis.z};
}

/// Gravitation of the WGS-84 ellipsoid [m/s^2].
template <class R, class S>
PHYSIM_INLINE Vec3<R> ellipsoid_gravitation(const Vec3<S>& axis, const Vec3<R>& r) {
  constexpr double a2 = wgs84::kEquatorialRadius * wgs84::kEquatorialRadius;
  constexpr double e2 = wgs84::kEccentricitySquared * a2;  // E^2
  constexpr double b2 = a2 - e2;
  constexpr double turning = wgs84::kRotationRate * wgs84::kRotationRate * a2;  // omega^2 a^2
  // q / q0 = (b / u)^3 Q(t^2) / Q(E^2 / b^2) and E q' / q0 = (b^3 / u^2) Q'(t^2) / Q(E^2 / b^2).
  const double q0 = confocal_q(e2 / b2);
  const R z = r.x * axis.x + r.y * axis.y + r.z * axis.z;
  const R z2 = z * z;
  const R s = dot(r, r) - constant<R>(e2);
  const R big_d = sqrt(s * s + constant<R>(4 * e2) * z2);
  const R u2 = (s + big_d) * constant<R>(0.5);
  const R u = sqrt(u2);
  const R per_u2 = S(1) / u2;
  const R t2 = constant<R>(e2) * per_u2;
  const R sine2 = z2 * per_u2;
  const R b3_per_u2 = constant<R>(turning * b2 * wgs84::kPolarRadius / q0) * per_u2;
  const R k = constant<R>(wgs84::kGM) + b3_per_u2 * confocal_q_slope(t2) * (sine2 * S(0.5) - constant<R>(1.0 / 6));
  const R q = b3_per_u2 / u * confocal_q(t2);  // omega^2 a^2 q / q0
  const R per_d = S(1) / big_d;
  const R across = -(per_d * (u * k / (u2 + constant<R>(e2)) + q * sine2));
  const R axial = (-(per_d * (k / u - q * (S(1) - sine2))) - across) * z;
  return {r.x * across + axial * axis.x, r.y * across + axial * axis.y, r.z * across + axial * axis.z};
}

/// The models with the field GravityField::flattened.
template <class R, class S>
PHYSIM_INLINE Vec3<R> flattened_gravitation(GravityModel model, const Vec3<S>& axis, const Vec3<R>& r) {
  switch (model) {
    case GravityModel::j2: return j2_gravitation(axis, r);
    case GravityModel::wgs84: return ellipsoid_gravitation(axis, r);
    case GravityModel::off:
    case GravityModel::constant:
    case GravityModel::inverse_square: break;
  }
  PHYSIM_UNREACHABLE();
}

PHYSIM_ISA_END
