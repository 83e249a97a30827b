// The acceleration of a projectile: the sum of all effects, each on its granted rung.
//
// What it models: D'Alembert's principle for a point mass: the resultant of gravity, drag and applied forces, and the
//   Coriolis and centrifugal forces of a frame that turns with the Earth, divided by the mass.
// Symbols: t time [s]; x position, v velocity in W; r from the Earth's centre; a acceleration [m/s^2].
// Equation: a = gravity(x) + drag(x, v) - 2 Omega x v - Omega x (Omega x r) + F / m. Where a motor burns, m falls and
//   drag and F are taken from the mass at launch to the mass that is left (model/motor.hpp).
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), eq. 8.27 (point mass with Coriolis).
#pragma once

#include "model/drag.hpp"
#include "model/gravity.hpp"
#include "model/motor.hpp"

PHYSIM_ISA_BEGIN

/// Constant applied acceleration until its time is over.
template <class R, class S>
PHYSIM_INLINE Vec3<R> applied(const Conditions<S>&, const Body<R>& b, const R& t) {
  const R zero(S(0));
  const auto on = t < b.applied_until;
  return {select(on, b.applied.x, zero), select(on, b.applied.y, zero), select(on, b.applied.z, zero)};
}

/// Acceleration by drag over the mass that is left; `lighter` is the mass at launch over it. Damping acts on the
/// velocity whatever the mass.
template <class R, class S>
PHYSIM_INLINE Vec3<R> burning_drag(const Conditions<S>& c, const Body<R>& b, const R& lighter, const State<R>& s) {
  const Vec3<R> d = drag(c, b, s);
  return c.fidelity.drag == DragModel::damping ? d : d * (lighter * b.burn.drag_factor);
}

/// Acceleration by the motor.
template <class R, class S>
PHYSIM_INLINE Vec3<R> thrust(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  return nose(b, air_velocity(c, s)) * (thrust_at(b, t) / mass_at(b, t));
}

/// The switches are uniform over all lanes: one predictable branch per effect for a whole pack.
template <class R, class S>
PHYSIM_INLINE Vec3<R> acceleration(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  Vec3<R> a = weight_per_mass(c, b, s.x);
  const R lighter = c.has_motor ? b.mass / mass_at(b, t) : R(S(1));
  if (c.fidelity.drag != DragModel::off) a += c.has_motor ? burning_drag(c, b, lighter, s) : drag(c, b, s);
  if (is_turning(c.fidelity.earth)) a += coriolis(c, s.v);
  if (throws_out(c.fidelity)) a += centrifugal(c, s.x);
  if (c.has_applied) a += c.has_motor ? applied(c, b, t) * lighter : applied(c, b, t);
  if (c.has_motor) a += thrust(c, b, t, s);
  if (c.fidelity.planar) a -= b.plane * dot(b.plane, a);
  if (c.has_frozen) a = component_product(a, b.free);
  if (c.has_rail) a = on_rail(b, a);
  return a;
}

PHYSIM_ISA_END
