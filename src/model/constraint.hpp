// Constraints: planar flight, frozen axes, and the launch rail.
//
// What it models: a projectile that cannot move everywhere: it stays in the vertical plane of fire, at rest along some
//   axes of W, or on a straight rail along which it moves only forwards over the length of the rail.
//   What would push it elsewhere is taken up by the constraint: it does no work.
// When to use it: planar flight where the classic two-dimensional problem is asked for; frozen axes in games that are
//   played in a plane or on a line; the rail for rockets.
// When it is wrong: nothing rubs. A plane through the muzzle is not where crosswind and Coriolis acceleration let a
//   projectile fly. A body on the rail neither yaws nor rolls.
// Symbols: a acceleration by all effects [m/s^2]; n unit normal of the plane [-]; f 1 along free axes, 0 along frozen
//   ones [-]; d unit vector of the rail [-].
// Equations: plane: a - n (n . a); axes: a_i f_i; rail: d (d . a), and 0 while it is held at rest: as long as d . a is
//   not positive (solve/stops.hpp). Each is linear in a, so what an effect loses does not depend on the others.
// Source: H. Goldstein, Classical Mechanics, 2nd ed. (1980), sec. 1.3-1.4 (constraints; D'Alembert's principle).
#pragma once

#include "math/vec3.hpp"
#include "model/body.hpp"

namespace physim {

/// Where a projectile is on its rail: values of Body::rail_phase.
inline constexpr double kHeld = 0, kSliding = 1, kOffRail = 2;

}  // namespace physim

PHYSIM_ISA_BEGIN

/// What the rail leaves of an acceleration.
template <class R>
PHYSIM_INLINE Vec3<R> on_rail(const Body<R>& b, const Vec3<R>& a) {
  using S = ScalarOf<R>;
  const auto free = b.rail_phase >= R(S(kOffRail));
  const R along = select(b.rail_phase < R(S(kSliding)), R(S(0)), dot(a, b.rail));
  return {select(free, a.x, b.rail.x * along), select(free, a.y, b.rail.y * along),
          select(free, a.z, b.rail.z * along)};
}

/// What all constraints leave of an acceleration.
template <class R, class S>
PHYSIM_INLINE Vec3<R> constrained(const Conditions<S>& c, const Body<R>& b, Vec3<R> a) {
  if (c.fidelity.planar) a -= b.plane * dot(b.plane, a);
  if (c.has_frozen) a = component_product(a, b.free);
  if (c.has_rail) a = on_rail(b, a);
  return a;
}

/// The part of a rotation that the rail leaves: none, it holds the body straight [-].
template <class R, class S>
PHYSIM_INLINE R free_to_turn(const Conditions<S>& c, const Body<R>& b) {
  return c.has_rail ? select(b.rail_phase < R(S(kOffRail)), R(S(0)), R(S(1))) : R(S(1));
}

PHYSIM_ISA_END
