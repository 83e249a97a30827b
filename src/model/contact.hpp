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
//   [m/s^2]; g_n = -a . n.
// Equations: v_n' = -e v_n;  v_t' = v_t max(0, 1 - mu (1 + e) |v_n| / |v_t|).
//   On the ground: dv_t/dt = a_t - c g_n v_t / |v_t|, and nothing moves while it is at rest and |a_t| <= c g_n. Where
//   a_t turns it around it stops, and goes on from rest.
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
/// An acceleration by everything but a surface [m/s^2]: over a time in which something moves on it, and what is left of
/// it if that comes to rest, where drag ends.
struct Pull {
  Vec3d moving;
  Vec3d at_rest;

  Pull(const Vec3d& always) : moving(always), at_rest(always) {}  // NOLINT: nothing depends on the motion
  Pull(const Vec3d& one, const Vec3d& other) : moving(one), at_rest(other) {}
};
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
