// Contact with the ground: bounces, and rolling to rest.
//
// What it models: a point mass against a hard surface: restitution along the normal, Coulomb friction along the
//   surface during the bounce, and what resists while it lies there. A point that has a rolling resistance rolls; one
//   that has none slides against friction, as bodies that cannot turn do.
// When to use it: shells, balls, sparks and debris of games.
// When it is wrong: spin is left out, so a ball does not turn sliding into rolling (5/7 of its speed would stay); the
//   surface neither gives way nor varies; restitution of real balls falls with speed.
// Symbols: n unit normal, upwards; v velocity before and v' after [m/s]; v_n = v . n, v_t = v - v_n n; e restitution
//   [-]; mu friction [-]; c rolling resistance, or mu where that is 0 [-]; a acceleration by everything but the ground
//   [m/s^2], a_0 what it is for v_t = 0, where drag along the surface ends; k rate of that drag [1/s]; g_n = -a . n; t
//   time [s].
// Equations: v_n' = -e v_n;  v_t' = v_t max(0, 1 - mu (1 + e) |v_n| / |v_t|).
//   On the ground: dv_t/dt = a_t - c g_n v_t / |v_t|, and nothing moves while it is at rest and |a_t| <= c g_n. Where
//   a_t turns it around it stops, and goes on from rest, by a_0.
//   With drag a_t m / (1 + k t) stands for a_t over a time t, k = (a_0 - a) . v_t / |v_t|^2: v_t' = v_t / (1 + k t)
//   where drag is all that acts, m = 1. That is exact for drag by the square of the speed, and turns no motion around.
//   What friction slows to the part c of that speed feels m = (1 + c + c^2) / 3, the mean of the square.
// Source: W. J. Stronge, Impact Mechanics (2000), sec. 1.2 and 3.2 (restitution; impulse of dry friction while sliding
//   continues); I. Millington, Game Physics Engine Development (2010), ch. 7 (resting contact).
#pragma once

#include "base/assert.hpp"
#include "math/pack.hpp"
#include "math/vec3.hpp"

namespace physim {

/// W is double, or a pack of them: each lane touches its own surface.
template <class W>
struct SurfaceOf {
  W restitution;         // [-]
  W friction;            // [-]
  W rolling_resistance;  // [-]
};
using Surface = SurfaceOf<double>;

/// Velocity after a bounce.
template <class W>
PHYSIM_INLINE Vec3<W> bounced(const Vec3<W>& v, const Vec3<W>& normal, const SurfaceOf<W>& surface) {
  PHYSIM_ASSERT(!any(abs(length_squared(normal) - W(1.0)) > W(1e-6)));
  const W v_n = dot(v, normal);
  const Vec3<W> v_t = v - normal * v_n;
  const W slide = length(v_t);
  const W impulse = surface.friction * (W(1.0) + surface.restitution) * abs(v_n);
  const W kept = select(slide > impulse, W(1.0) - impulse / slide, W(0.0));
  return v_t * kept - normal * (surface.restitution * v_n);
}

/// Along the normal: a bounce that would be over within `frame` does not lift it any more.
template <class W>
[[nodiscard]] PHYSIM_INLINE MaskOf<W> lifts_off(const W& speed, const W& acceleration, double frame) {
  return speed > -acceleration * W(0.5 * frame);
}

/// Where a projectile that lies on the ground is after a time, and how fast.
struct Rolled {
  Vec3d way;
  Vec3d velocity;
};
/// Acceleration by everything but a surface, of what moves along it.
struct Pull {
  Vec3d moving;   // a [m/s^2]
  Vec3d at_rest;  // a_0 [m/s^2]

  Pull(const Vec3d& always) : moving(always), at_rest(always) {}  // NOLINT: no drag
  Pull(const Vec3d& a, const Vec3d& a_0) : moving(a), at_rest(a_0) {}
  [[nodiscard]] bool has_drag() const { return moving != at_rest; }
};
/// The pull over a time on what moves with `v_t` along a surface. `pull_t` is the part of `a` along it that drag acts
/// against, all but that of a frame which moves with the surface; `ending` is a_0 - a; `kept`: the part of v_t that is
/// left at the end.
inline Pull braked(const Vec3d& a, const Vec3d& pull_t, const Vec3d& ending, const Vec3d& v_t, double time,
                   double kept) {
  PHYSIM_ASSERT(time >= 0);
  const double square = length_squared(v_t), rate = square > 0 ? dot(ending, v_t) / square : 0;
  if (!(rate > 0)) return a;
  const double c = min(max(kept * (1 + rate * time), 0.0), 1.0), mean = (1 + c + c * c) * (1.0 / 3);
  return {a - pull_t * ((rate * time + (1 - mean)) / (1 + rate * time)), a + ending};
}
inline Rolled rolled(const Vec3d& v, const Pull& by, const Vec3d& normal, const Surface& surface, double time) {
  PHYSIM_ASSERT(time >= 0 && surface.rolling_resistance >= 0 && surface.friction >= 0);
  const Vec3d& a = by.moving;
  const Vec3d v_t = v - normal * dot(v, normal);
  const double a_n = dot(a, normal);
  const Vec3d a_t = a - normal * a_n;
  const bool rolls = surface.rolling_resistance > 0;
  const double resistance = (rolls ? surface.rolling_resistance : surface.friction) * max(-a_n, 0.0);
  const Vec3d pushed = v_t + a_t * time;
  const double speed = length(pushed);
  const double lost = resistance * time;
  const double v_0 = length(v_t), pull = length(a_t);
  const double against = v_0 > 0 ? -dot(a_t, v_t) / v_0 : 0;
  const bool turns_around = dot(pushed, v_t) < 0 && against >= pull * (1 - 1e-12);
  if (speed <= lost || turns_around) {  // comes to rest on the way
    const double ends = resistance + against;
    const double stop = v_0 > 0 && ends > 0 ? min(v_0 / ends, time) : 0.0;
    const Vec3d then = by.at_rest - normal * dot(by.at_rest, normal);
    const double pulls = length(then);
    const double left = time - stop, rate = pulls > resistance ? (pulls - resistance) / pulls : 0;
    return {v_t * (0.5 * stop) + then * (0.5 * rate * left * left), then * (rate * left)};
  }
  const Vec3d after = pushed * (1 - lost / speed);
  return {(v_t + after) * (0.5 * time), after};
}

}  // namespace physim
