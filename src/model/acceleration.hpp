// The acceleration of a projectile: the sum of all effects, each on its granted rung.
//
// What it models: D'Alembert's principle for a point mass: the resultant of gravity, drag and applied forces, and the
//   Coriolis and centrifugal forces of a frame that turns with the Earth, divided by the mass.
// Symbols: t time [s]; x position, v velocity in W; r from the Earth's centre; a acceleration [m/s^2].
// Equation: a = gravity(x) + drag(x, v) - 2 Omega x v - Omega x (Omega x r) + F / m. Where a motor burns, m falls and
//   drag and F are taken from the mass at launch to the mass that is left (model/motor.hpp).
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), eq. 8.27 (point mass with Coriolis).
#pragma once

#include "model/aero.hpp"
#include "model/drag.hpp"
#include "model/gravity.hpp"
#include "model/magnus.hpp"
#include "model/modified_point_mass.hpp"
#include "model/motor.hpp"
#include "model/rigid_body.hpp"

PHYSIM_ISA_BEGIN

/// Constant applied acceleration until its time is over.
template <class R, class S>
PHYSIM_INLINE Vec3<R> applied(const Conditions<S>&, const Body<R>& b, const R& t) {
  const R zero(S(0));
  const auto on = t < b.applied_until;
  return {select(on, b.applied.x, zero), select(on, b.applied.y, zero), select(on, b.applied.z, zero)};
}

/// The mass at launch over what is left of it.
template <class R, class S>
PHYSIM_INLINE R lighter(const Conditions<S>& c, const Body<R>& b, const R& t) {
  return c.has_motor ? b.mass / mass_at(b, t) : R(S(1));
}

/// Whether balls feel their spin.
PHYSIM_INLINE constexpr bool spins(const Fidelity& f) { return f.rotation == RotationModel::magnus; }

/// Acceleration by drag and lift.
template <class R, class S>
PHYSIM_INLINE Vec3<R> air_force(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  if (!spins(c.fidelity)) return drag(c, b, s);
  SpinningAir<R> air;
  spinning_air(c, b, t, s, air);
  return air.drag + air.lift;
}

/// Drag `d` of the mass at launch over the mass that is left. Damping acts on the velocity whatever the mass.
template <class R, class S>
PHYSIM_INLINE Vec3<R> drag_now(const Conditions<S>& c, const Body<R>& b, const R& t, const Vec3<R>& d) {
  if (!c.has_motor || c.fidelity.drag == DragModel::damping) return d;
  return d * (lighter(c, b, t) * b.burn.drag_factor);
}
/// The same in air whose state is known, without spin.
template <class R, class S>
PHYSIM_INLINE Vec3<R> drag_now_in(const Conditions<S>& c, const Body<R>& b, const R& t, const AirState<R>& air,
                                  const Vec3<R>& u) {
  const bool equation = c.fidelity.drag == DragModel::equation;
  return drag_now(c, b, t, equation ? drag_equation(c, b, air, u) : simple_drag(c, b, u));
}
template <class R, class S>
PHYSIM_INLINE Vec3<R> air_now(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  return drag_now(c, b, t, air_force(c, b, t, s));
}

/// Acceleration by the applied force, over the mass that is left.
template <class R, class S>
PHYSIM_INLINE Vec3<R> applied_now(const Conditions<S>& c, const Body<R>& b, const R& t) {
  return c.has_motor ? applied(c, b, t) * lighter(c, b, t) : applied(c, b, t);
}

/// Acceleration by the motor, towards where the nose points.
template <class R>
PHYSIM_INLINE Vec3<R> thrust(const Body<R>& b, const R& t, const Vec3<R>& nose) {
  return nose * (thrust_at(b, t) / mass_at(b, t));
}

/// What comes on top of weight, air and thrust. The switches are uniform over all lanes: one predictable branch per
/// effect for a whole pack.
template <class R, class S>
PHYSIM_INLINE Vec3<R> with_other_effects(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                                         Vec3<R> a) {
  if (is_turning(c.fidelity.earth)) a += coriolis(c, s.v);
  if (throws_out(c.fidelity)) a += centrifugal(c, s.x);
  if (c.has_applied) a += applied_now(c, b, t);
  if (c.fidelity.planar) a -= b.plane * dot(b.plane, a);
  if (c.has_frozen) a = component_product(a, b.free);
  if (c.has_rail) a = on_rail(b, a);
  return a;
}

/// Of a point mass.
template <class R, class S>
PHYSIM_INLINE Vec3<R> acceleration(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  Vec3<R> a = weight_per_mass(c, b, s.x);
  if (c.fidelity.drag != DragModel::off) a += air_now(c, b, t, s);
  if (c.has_motor) a += thrust(b, t, nose_in_air(b, air_velocity(c, s)));
  return with_other_effects(c, b, t, s, a);
}

/// The same behind one call, so that twelve stages do not become twelve copies of all models.
template <class R, class S>
[[gnu::noinline]] void evaluate(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s, Vec3<R>& a) {
  a = acceleration(c, b, t, s);
}
template <class R, class S>
PHYSIM_INLINE Vec3<R> evaluated(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  Vec3<R> a;
  evaluate(c, b, t, s, a);
  return a;
}

/// A shell and its yaw of repose.
template <class R>
struct ReposedShell {
  Vec3<R> through_air;  // u [m/s]
  Vec3<R> without_yaw;  // what accelerates it but the yaw [m/s^2]
  Repose<R> repose;
};
template <class R, class S>
PHYSIM_INLINE ReposedShell<R> reposed_shell(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                            const State<R>& s, const R& spin) {
  const Vec3<R> u = air_velocity(c, s);
  const AirState<R> air = air_state(c, s.x);
  Vec3<R> a = weight_per_mass(c, b, s.x) + drag_now_in(c, b, t, air, u);
  if (c.has_motor) a += thrust(b, t, nose_in_air(b, u));
  a = with_other_effects(c, b, t, s, a);
  Vec3<R> turning = a;
  if (is_turning(c.fidelity.earth)) turning += cross(Vec3<R>{R(c.omega.x), R(c.omega.y), R(c.omega.z)}, u);
  const R thrust_per_mass = c.has_motor ? thrust_at(b, t) / mass_at(b, t) : R(S(0));
  return {u, a, repose(c, rotor, air, u, spin, turning, lighter(c, b, t), thrust_per_mass)};
}

/// Of a shell in its yaw of repose, with the slope of its Turn.
template <class R, class S>
[[gnu::noinline]] Vec3<R> reposed_acceleration(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor,
                                               const R& t, const State<R>& s, const Turn<R>& turn, Turn<R>& slope) {
  const R zero(S(0));
  const ReposedShell<R> shell = reposed_shell(c, b, rotor, t, s, turn.h.x);
  const Repose<R>& r = shell.repose;
  Vec3<R> a = r.acceleration;
  if (c.has_motor) {
    const Vec3<R> along = nose_in_air(b, shell.through_air);
    a += thrust(b, t, yawed_axis(along, r.yaw) - along);
  }
  if (c.has_frozen) a = component_product(a, b.free);
  if (c.has_rail) a = on_rail(b, a);
  slope = {turn.h.x, {zero, zero, zero}, {r.spin_slope, zero, zero}};
  return shell.without_yaw + a;
}

/// Of what turns, with the slope of its Turn.
template <class R, class S>
PHYSIM_INLINE Vec3<R> turning_acceleration(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                           const State<R>& s, const Turn<R>& turn, Turn<R>& slope) {
  if (is_in_repose(c.fidelity)) return reposed_acceleration(c, b, rotor, t, s, turn, slope);
  const R zero(S(0));
  Vec3<R> a = weight_per_mass(c, b, s.x);
  Vec3<R> moment{zero, zero, zero};
  if (c.has_aero || c.fidelity.drag != DragModel::off) {
    const Vec3<R> u = air_velocity(c, s);
    const AirState<R> air = air_state(c, s.x);  // simple drag does not need it, and is not worth a copy of all this
    a += drag_now_in(c, b, t, air, u);
    if (c.has_aero) {
      const AeroLoad<R> load = body_aero(c, rotor, air, u, turn);
      a += c.has_motor ? load.acceleration * lighter(c, b, t) : load.acceleration;
      moment = load.moment;
    }
  }
  if (c.has_motor) a += thrust(b, t, forward(c.fidelity, turn));
  slope = turn_slope(c, rotor, turn, moment);
  if (c.has_rail) slope = slope * select(b.rail_phase < R(S(kOffRail)), zero, R(S(1)));  // it holds the body straight
  return with_other_effects(c, b, t, s, a);
}

/// The same behind one call.
template <class R, class S>
[[gnu::noinline]] void evaluate(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                const State<R>& s, const Turn<R>& turn, Vec3<R>& a, Turn<R>& slope) {
  a = turning_acceleration(c, b, rotor, t, s, turn, slope);
}

/// The slopes at a time and state of what turns: that of its Turn, and the acceleration by value.
template <class R, class S>
PHYSIM_INLINE Vec3<R> evaluated(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                const State<R>& y, const Turn<R>& turn, Turn<R>& slope) {
  Vec3<R> a;
  evaluate(c, b, rotor, t, y, turn, a, slope);
  return a;
}

/// The part of the acceleration that comes with the attitude: aerodynamics beyond drag at zero yaw.
template <class R, class S>
PHYSIM_INLINE Vec3<R> attitude_force(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                     const State<R>& s, const Turn<R>& turn) {
  if (is_in_repose(c.fidelity)) return reposed_shell(c, b, rotor, t, s, turn.h.x).repose.acceleration;
  return body_aero(c, rotor, air_state(c, s.x), air_velocity(c, s), turn).acceleration * lighter(c, b, t);
}

/// Where the nose of any body points, a unit vector in W [-].
template <class R, class S>
PHYSIM_INLINE Vec3<R> nose(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                           const State<R>& s, const Turn<R>& turn) {
  if (turns(c.fidelity) && !is_in_repose(c.fidelity)) return forward(c.fidelity, turn);
  const Vec3<R> along = nose_in_air(b, air_velocity(c, s));
  if (!turns(c.fidelity)) return along;
  return yawed_axis(along, reposed_shell(c, b, rotor, t, s, turn.h.x).repose.yaw);
}

PHYSIM_ISA_END
