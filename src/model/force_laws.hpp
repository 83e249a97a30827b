// The laws of the shipped force generators.
//
// What it models: pushes and pulls on point masses that are no property of the projectile: a given force or
//   acceleration, drag towards a wind, springs and elastic ropes, a liquid, an attracting point, a blast, thrust.
// When to use it: on single projectiles or groups in motion `force`, for as long as they last. Gravity, air and wind of
//   the whole world are rungs of the fidelity and cheaper there.
// When it is wrong: springs and ropes have no mass and no waves. A liquid has no waves and no added mass (that of a
//   sphere is half its liquid: it bobs too fast) and is left and entered without a splash. The blast is a game's: no
//   shock wave, no shadow; real overpressure falls faster than linearly. Thrust takes no mass off the projectile.
//   Borders of boxes and blasts and corners of tables are corners of the force: steps that do not end there make an
//   error of first order, as large as force times step.
// Symbols: x position [m], v velocity [m/s], m mass [kg], F force [N]; u = v - w velocity relative to air or liquid
//   [m/s]; d = x - anchor, or from the other end [m], n = d / |d|; k stiffness [N/m], l rest length [m], c damping
//   [kg/s]; k1 [kg/s], k2 [kg/m]; rho density of the liquid [kg/m^3], V volume [m^3], g gravity [m/s^2], y_s height of
//   the surface, b half height of the body [m], s part of the volume under the surface [-]; mu = G M strength
//   [m^3/s^2], e softening [m], r distance to a centre [m], R radius of a blast [m], F0 its force at the centre [N].
// Equations:
//   drag       F = -(k1 + k2 |u|) u
//   spring     F = -(k (|d| - l) + c v_rel.n) n;  at |d| = 0 no direction is known: F = 0
//   rope       the same where |d| > l and it pulls, else F = 0: elastic and damper side by side, and no push
//   liquid     F = rho V g s up - c s v,  q = clamp((y_s - y) / (2 b) + 1/2, 0, 1);
//              a sphere, b = D/2: s = q^2 (3 - 2 q), the cap pi h^2 (3 b - h) / 3 of height h = 2 b q over 4/3 pi b^3;
//              an upright cylinder or box of half height b: s = q
//   attractor  F = -m mu d / (r^2 + e^2)^(3/2)
//   blast      F = F0 (1 - r / R) n for r < R;  at the very centre no direction is known: F = 0
//   thrust     F(t) on straight lines between the points of its table, from the first until before the last
// Source: I. Millington, Game Physics Engine Development (2010), sec. 5.2 (drag) and 6.2 (spring, bungee, buoyancy,
// whose
//   linear law is that of the box); R. Hooke, De Potentia Restitutiva (1678); Archimedes, On Floating Bodies, I, prop.
//   5-7 (lift) and On the Sphere and Cylinder (cap); H. C. Plummer, MNRAS 71 (1911) 460 (softening). The blast is ours.
#pragma once

#include <algorithm>
#include <span>

#include "math/pack.hpp"
#include "model/body.hpp"
#include "physim/forces.hpp"

namespace physim {

/// [N]
[[nodiscard]] inline Vec3d drag_force(const LinearQuadraticDragForce& law, const Vec3d& v) {
  const Vec3d u = v - law.wind;
  return u * -(law.k1 + law.k2 * length(u));
}

/// Of a spring (any law with stiffness, rest_length and damping) on its end at d from the other, which moves at v_rel
/// relative to it [N].
template <class Law>
[[nodiscard]] Vec3d spring_force(const Law& law, const Vec3d& d, const Vec3d& v_rel) {
  const double now = length(d);
  if (now == 0) return {};
  const Vec3d n = d * (1 / now);
  return n * -(law.stiffness * (now - law.rest_length) + law.damping * dot(v_rel, n));
}

/// Of an elastic rope; as above [N]. Comparisons are such that what is no number stays so, for the world to see.
[[nodiscard]] inline Vec3d bungee_force(const Bungee& law, const Vec3d& d, const Vec3d& v_rel) {
  const double now = length(d);
  if (now <= law.rest_length || now == 0) return {};
  const Vec3d n = d * (1 / now);
  const double pull = law.stiffness * (now - law.rest_length) + law.damping * dot(v_rel, n);
  return pull < 0 ? Vec3d{} : n * -pull;
}

/// Part of a body under the surface of a liquid [-], with its centre `below` the surface [m].
[[nodiscard]] inline double submerged_box(double below, double half_height) {
  const double q = below / (2 * half_height) + 0.5;
  return q < 0 ? 0 : q > 1 ? 1 : q;
}
[[nodiscard]] inline double submerged_sphere(double below, double radius) {
  const double q = submerged_box(below, radius);
  return q * q * (3 - 2 * q);
}

/// On a projectile of a diameter [N].
[[nodiscard]] inline Vec3d buoyancy_force(const Buoyancy& law, double diameter, const State<double>& s) {
  constexpr double kSixthOfPi = 0.52359877559829887308;
  const double below = law.surface - s.x.y;
  const double part = law.depth > 0 ? submerged_box(below, law.depth) : submerged_sphere(below, diameter / 2);
  const double volume = law.volume > 0 ? law.volume : kSixthOfPi * diameter * diameter * diameter;
  return Vec3d{0, law.density * volume * law.gravity * part, 0} - s.v * (law.damping * part);
}

/// Without softening the very centre has no direction, and no force [N].
[[nodiscard]] inline Vec3d attractor_force(const PointAttractor& law, double mass, const Vec3d& x) {
  const Vec3d d = law.centre - x;
  const double square = length_squared(d) + law.softening * law.softening;
  if (square == 0) return {};
  return d * (1 / sqrt(square)) * (mass * (law.strength / square));
}

/// Borders belong to the box.
[[nodiscard]] inline bool is_inside(const WindZone& zone, const Vec3d& x) {
  return zone.low.x <= x.x && x.x <= zone.high.x && zone.low.y <= x.y && x.y <= zone.high.y && zone.low.z <= x.z &&
         x.z <= zone.high.z;
}

/// [N]
[[nodiscard]] inline Vec3d explosion_force(const Explosion& law, const Vec3d& x) {
  const Vec3d d = x - law.centre;
  const double r = length(d);
  if (r >= law.radius || r == 0) return {};
  return d * (law.force * (1 - r / law.radius) / r);
}

/// Thrust at a time [N]. The last point does not belong to the table: so an integrator that looks at the start of each
/// step gives a constant thrust for exactly its time.
[[nodiscard]] inline double thrust_at(std::span<const Thrust::Point> curve, double time) {
  const auto later = [](double t, const Thrust::Point& p) { return t < p.time; };
  const auto next = std::upper_bound(curve.begin(), curve.end(), time, later);
  if (next == curve.begin() || next == curve.end()) return 0;
  const Thrust::Point& from = *(next - 1);
  return from.force + (next->force - from.force) * ((time - from.time) / (next->time - from.time));
}

/// Unit vector that a thrust acts along [-]; none at rest where it follows the velocity.
[[nodiscard]] inline Vec3d thrust_direction(const Thrust& law, const Vec3d& v) {
  return normalized(law.direction == Vec3d{} ? v : law.direction);
}

}  // namespace physim
