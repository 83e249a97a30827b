// The acceleration of a projectile: the sum of all effects, each on its granted rung.
//
// What it models: D'Alembert's principle for a point mass: the resultant of gravity, drag and applied forces, and the
//   Coriolis and centrifugal forces of a frame that turns with the Earth, divided by the mass.
// Symbols: t time [s]; x position, v velocity in W; r from the Earth's centre; a acceleration [m/s^2].
// Equation: a = gravity(x) + drag(x, v) - 2 Omega x v - Omega x (Omega x r) + F / m.
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), eq. 8.27 (point mass with Coriolis).
#pragma once

#include "model/aero.hpp"
#include "model/drag.hpp"
#include "model/gravity.hpp"
#include "model/rigid_body.hpp"

PHYSIM_ISA_BEGIN

/// Constant applied acceleration until its time is over.
template <class R, class S>
PHYSIM_INLINE Vec3<R> applied(const Conditions<S>&, const Body<R>& b, const R& t) {
  const R zero(S(0));
  const auto on = t < b.applied_until;
  return {select(on, b.applied.x, zero), select(on, b.applied.y, zero), select(on, b.applied.z, zero)};
}

/// What comes on top of weight and air. The switches are uniform over all lanes: one predictable branch per effect for
/// a whole pack.
template <class R, class S>
PHYSIM_INLINE Vec3<R> with_other_effects(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                                         Vec3<R> a) {
  if (is_turning(c.fidelity.earth)) a += coriolis(c, s.v);
  if (throws_out(c.fidelity)) a += centrifugal(c, s.x);
  if (c.has_applied) a += applied(c, b, t);
  if (c.fidelity.planar) a -= b.plane * dot(b.plane, a);
  if (c.has_frozen) a = component_product(a, b.free);
  return a;
}

/// Of a point mass.
template <class R, class S>
PHYSIM_INLINE Vec3<R> acceleration(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  Vec3<R> a = weight_per_mass(c, b, s.x);
  if (c.fidelity.drag != DragModel::off) a += drag(c, b, s);
  return with_other_effects(c, b, t, s, a);
}

/// Of what turns, with the slope of its Turn.
template <class R, class S>
PHYSIM_INLINE Vec3<R> turning_acceleration(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                           const State<R>& s, const Turn<R>& turn, Turn<R>& slope) {
  const R zero(S(0));
  Vec3<R> a = weight_per_mass(c, b, s.x);
  Vec3<R> moment{zero, zero, zero};
  if (!c.has_aero) {
    if (c.fidelity.drag != DragModel::off) a += drag(c, b, s);
  } else {
    const Vec3<R> u = air_velocity(c, s);
    const AirState<R> air = air_state(c, s.x);
    a += c.fidelity.drag == DragModel::equation ? drag_equation(c, b, air, u) : simple_drag(c, b, u);
    const AeroLoad<R> load = body_aero(c, rotor, air, u, turn);
    a += load.acceleration;
    moment = load.moment;
  }
  slope = turn_slope(c, rotor, turn, moment);
  return with_other_effects(c, b, t, s, a);
}

PHYSIM_ISA_END
