// The acceleration of a projectile: the sum of all effects, each on its granted rung.
//
// What it models: D'Alembert's principle: the resultant of gravity, air, thrust and applied forces, and the Coriolis
//   and centrifugal forces of a frame that turns with the Earth, divided by the mass, less what constraints take up
//   (model/constraint.hpp). sum_effects() is the one list of effects: kernels add them up, Flight and World also give
//   them one by one (model/ledger.hpp). A new effect is one row there and one member of Accelerations.
// Symbols: t time [s]; x position, v velocity in W; r from the Earth's centre; a acceleration [m/s^2].
// Equation: a = gravity(x) + drag(x, v) - 2 Omega x v - Omega x (Omega x r) + F / m. Where a motor burns, m falls and
//   drag and F are taken from the mass at launch to the mass that is left (model/motor.hpp).
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), eq. 8.27 (point mass with Coriolis).
#pragma once

#include <limits>

#include "math/vec3.hpp"
#include "model/aero.hpp"
#include "model/drag.hpp"
#include "model/field_function.hpp"
#include "model/gravity.hpp"
#include "model/ledger.hpp"
#include "model/magnus.hpp"
#include "model/modified_point_mass.hpp"
#include "model/motor.hpp"
#include "model/rigid_body.hpp"

PHYSIM_ISA_BEGIN

/// Constant applied acceleration until its time is over; the original's one-shot force never is. Where its end is a
/// stop of steps, a body has it in the whole of a step or not at all.
template <class R, class S>
PHYSIM_INLINE Vec3<R> applied(const Conditions<S>& c, const Body<R>& b, const R& t) {
  if (c.fidelity.original_one_shot_forces || c.has_force_end) return b.applied;
  const R zero(S(0));
  const auto on = t < b.applied_until;
  return {select(on, b.applied.x, zero), select(on, b.applied.y, zero), select(on, b.applied.z, zero)};
}

/// The mass at launch over what is left of it.
template <class R, class S>
PHYSIM_INLINE R lighter(const Conditions<S>& c, const Body<R>& b, const R& t) {
  return c.has_motor ? b.mass / mass_at(b, t) : R(S(1));
}

/// From when to when a step, or the rest of one, goes; where both are one, a moment [s].
template <class R>
struct StepSpan {
  R from;
  R to;
};

/// The own force in a step that its end does not cut: over the whole of it the part of the step in which it acts, so
/// that its impulse is exact.
template <class R, class S>
PHYSIM_INLINE Vec3<R> applied_over(const Conditions<S>& c, const Body<R>& b, const StepSpan<R>& step) {
  if (!c.has_force_end) return applied(c, b, step.from);
  const R zero(S(0)), one(S(1));
  const R left = b.applied_until - step.from, length = step.to - step.from;
  return b.applied * select(left <= zero, zero, select(left >= length, one, left / length));
}

/// Lets a body feel an acceleration over the whole of a step, whatever its clock shows.
template <class R>
PHYSIM_INLINE void hold_push(const Vec3<R>& push, Body<R>& b) {
  b.applied = push;
  b.applied_until = constant<R>(std::numeric_limits<double>::infinity());
}

/// Lets a body feel what force generators give per mass at a time of a step: with its own force, where it has one, it
/// stands in the place of that. Generators know the mass at the start of the frame; applied_now() takes what stands
/// here from the mass at launch to that left.
template <class R, class S>
PHYSIM_INLINE void add_push(const Conditions<S>& c, const StepSpan<R>& step, const R& t, const Vec3<R>& push,
                            bool own_force, Body<R>& b) {
  PHYSIM_ASSERT(c.has_applied);
  Vec3<R> sum = c.has_motor ? push * (mass_at(b, t) / b.mass) : push;
  if (own_force) sum += applied_over(c, b, step);
  hold_push(sum, b);
}

/// The original frame loop: its slope[0].v is not that of the state but what its last frame left.
PHYSIM_INLINE constexpr bool is_classic(const Fidelity& granted) {
  return granted.motion != Motion::closed_form && granted.integrator == Integrator::classic;
}

/// Whether balls feel their spin.
PHYSIM_INLINE constexpr bool spins(const Fidelity& f) { return f.rotation == RotationModel::magnus; }

/// Drag `d` of the mass at launch over the mass that is left. Damping acts on the velocity whatever the mass.
template <class R, class S>
PHYSIM_INLINE Vec3<R> drag_now(const Conditions<S>& c, const Body<R>& b, const R& t, const Vec3<R>& d) {
  if (!c.has_motor || c.fidelity.drag == DragModel::damping) return d;
  return d * (lighter(c, b, t) * b.burn.drag_factor);
}
/// Drag in air of known state, of the mass that is left.
template <class R, class S>
PHYSIM_INLINE Vec3<R> drag_now_in(const Conditions<S>& c, const Body<R>& b, const R& t, const AirState<R>& air,
                                  const Vec3<R>& u) {
  const bool equation = c.fidelity.drag == DragModel::equation;
  return drag_now(c, b, t, equation ? drag_equation(c, b, air, u) : simple_drag(c, b, u));
}
/// Acceleration by the applied force, over the mass that is left.
template <class R, class S>
PHYSIM_INLINE Vec3<R> applied_now(const Conditions<S>& c, const Body<R>& b, const R& t) {
  return c.has_motor ? applied(c, b, t) * lighter(c, b, t) : applied(c, b, t);
}

/// Acceleration by a force function; as a one-shot force it is that at the launch.
template <class R, class S>
PHYSIM_INLINE Vec3<R> pushed(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  const bool at_launch = c.fidelity.original_one_shot_forces;
  Vec3<R> a;
  push_by_function(c, b, at_launch ? R(S(0)) : t, at_launch ? b.launch : s, a);
  return a;
}

/// Acceleration by the motor, towards where the nose points.
template <class R>
PHYSIM_INLINE Vec3<R> thrust(const Body<R>& b, const R& t, const Vec3<R>& nose) {
  return nose * (thrust_at(b, t) / mass_at(b, t));
}

// ------------------------------------------------------------------------------------------- what the air does
// How a projectile stands in the air decides what the air does to it and where its nose, and with it the thrust,
// points. One of these gives the air to sums of effects.

/// A point mass: drag along its path; of a ball that spins, lift too.
struct PointInAir {
  template <class R, class S, class AnySum>
  PHYSIM_INLINE void add_air(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                             AnySum& sum) const {
    if (c.fidelity.drag == DragModel::off) return;
    const Vec3<R> u = air_velocity(c, b, t, s);
    if (!spins(c.fidelity)) {
      const Vec3<R> d = drag_now(c, b, t, drag_at(c, b, s.x, u));
      sum.note_drag(u, d);
      return sum.add(&Accelerations::drag, d);
    }
    SpinningAir<R> air;
    spinning_air(c, b, t, s, air);
    sum.note_drag(u, drag_now(c, b, t, air.drag));
    sum.add(&Accelerations::drag, drag_now(c, b, t, air.drag + air.lift));
    sum.tell_apart(&Accelerations::drag, &Accelerations::lift, drag_now(c, b, t, air.lift));
  }
  template <class R, class S>
  PHYSIM_INLINE Vec3<R> nose(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) const {
    return nose_in_air(b, air_velocity(c, b, t, s));
  }
};

/// A point mass under the drag equation, with its air and its way through it known already.
template <class R>
struct PointInKnownAir : PointInAir {
  AirState<R> air;
  Vec3<R> u;  // through the air [m/s]
  R speed;    // [m/s]

  template <class S, class AnySum>
  PHYSIM_INLINE void add_air(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>&, AnySum& sum) const {
    PHYSIM_ASSERT(c.fidelity.drag == DragModel::equation && !spins(c.fidelity));
    sum.add(&Accelerations::drag, drag_now(c, b, t, drag_equation(c, b, air, u, speed)));
  }
};

/// A point mass that the air does nothing to.
struct PointInVacuum : PointInAir {
  template <class... Given>
  PHYSIM_INLINE void add_air(const Given&...) const {}
};

/// The original loop's: damping acts directly on its velocity, and one-shot forces are those at the launch.
struct OriginalInAir : PointInAir {
  template <class R, class S, class AnySum>
  PHYSIM_INLINE void add_air(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                             AnySum& sum) const {
    if (c.fidelity.drag == DragModel::off) return;
    if (c.fidelity.drag == DragModel::damping) return sum.tell(&Accelerations::drag, drag(c, b, t, s));
    if (c.fidelity.original_one_shot_forces) return sum.add(&Accelerations::drag, drag(c, b, R(S(0)), b.launch));
    sum.add(&Accelerations::drag, drag(c, b, t, s));
  }
};

/// A shell but for its yaw of repose, which follows from the sum of all effects.
template <class R>
struct ShellInAir {
  Vec3<R> u;  // through the air [m/s]
  AirState<R> air;

  template <class S, class AnySum>
  PHYSIM_INLINE void add_air(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s, AnySum& sum) {
    u = air_velocity(c, b, t, s);
    air = air_state(c, b, s.x);
    const Vec3<R> d = drag_now_in(c, b, t, air, u);
    sum.note_drag(u, d);
    sum.add(&Accelerations::drag, d);
  }
  template <class S>
  PHYSIM_INLINE Vec3<R> nose(const Conditions<S>&, const Body<R>& b, const R&, const State<R>&) const {
    return nose_in_air(b, u);
  }
};

/// A rigid body: what its attitude does to force and moment.
template <class R>
struct BodyInAir {
  const Rotor<R>& rotor;
  const Turn<R>& turn;
  Vec3<R> moment;  // [N m]

  template <class S, class AnySum>
  PHYSIM_INLINE void add_air(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s, AnySum& sum) {
    if (!c.has_aero && c.fidelity.drag == DragModel::off) return;
    const Vec3<R> u = air_velocity(c, b, t, s);
    const AirState<R> air = air_state(c, b, s.x);  // simple drag does not need it, and is not worth a copy of all this
    const Vec3<R> d = drag_now_in(c, b, t, air, u);
    sum.note_drag(u, d);
    sum.add(&Accelerations::drag, d);
    if (!c.has_aero) return;
    const AeroLoad<R> load = body_aero(c, rotor, air, u, turn);
    sum.add(&Accelerations::body, c.has_motor ? load.acceleration * lighter(c, b, t) : load.acceleration);
    moment = load.moment;
  }
  template <class S>
  PHYSIM_INLINE Vec3<R> nose(const Conditions<S>& c, const Body<R>&, const R&, const State<R>&) const {
    return forward(c.fidelity, turn);
  }
};

// ------------------------------------------------------------------------------------------- the sum
/// Every effect, once. The switches are uniform over all lanes: one predictable branch per effect for a whole pack.
template <class R, class S, class InAir, class AnySum>
PHYSIM_INLINE void sum_effects(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s, InAir&& in_air,
                               AnySum& sum) {
  sum.begin(&Accelerations::gravity, weight_per_mass(c, b, s.x));
  in_air.add_air(c, b, t, s, sum);
  if (c.has_motor) sum.add(&Accelerations::thrust, thrust(b, t, in_air.nose(c, b, t, s)));
  if (is_turning(c.fidelity.earth)) sum.add(&Accelerations::coriolis, coriolis(c, s.v));
  if (throws_out(c.fidelity)) sum.add(&Accelerations::centrifugal, centrifugal(c, s.x));
  if (c.has_applied) sum.add(&Accelerations::applied, applied_now(c, b, t));
  if (c.has_force_function) sum.add(&Accelerations::applied, pushed(c, b, t, s));
  sum.constrain(c, b);
}

/// The effects on a shell in its yaw of repose, which is returned.
template <class R, class S, class AnySum>
PHYSIM_INLINE Repose<R> sum_reposed(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                    const State<R>& s, const R& spin, AnySum& sum) {
  ShellInAir<R> shell;
  sum_effects(c, b, t, s, shell, sum);
  const Vec3<R>& u = shell.u;
  Vec3<R> turning = sum.total;
  if (is_turning(c.fidelity.earth)) turning += cross(Vec3<R>{R(c.omega.x), R(c.omega.y), R(c.omega.z)}, u);
  const R thrust_per_mass = c.has_motor ? thrust_at(b, t) / mass_at(b, t) : R(S(0));
  const Repose<R> r = repose(c, rotor, shell.air, u, spin, turning, lighter(c, b, t), thrust_per_mass);
  if (!c.has_motor) return sum.add_constrained(c, b, &Accelerations::body, r.acceleration), r;
  const Vec3<R> along = nose_in_air(b, u);
  const Vec3<R> push = thrust(b, t, yawed_axis(along, r.yaw) - along);
  sum.add_constrained(c, b, &Accelerations::body, r.acceleration + push);
  sum.tell_apart(&Accelerations::body, &Accelerations::thrust, push);
  return r;
}

/// The effects on what turns, with the slope of its Turn.
template <class R, class S, class AnySum>
PHYSIM_INLINE void sum_effects(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                               const State<R>& s, const Turn<R>& turn, Turn<R>& slope, AnySum& sum) {
  const R zero(S(0));
  if (is_in_repose(c.fidelity)) {
    const Repose<R> r = sum_reposed(c, b, rotor, t, s, turn.h.x, sum);
    slope = {turn.h.x, {zero, zero, zero}, {r.spin_slope, zero, zero}};
    return;
  }
  BodyInAir<R> body{rotor, turn, {zero, zero, zero}};
  sum_effects(c, b, t, s, body, sum);
  slope = turn_slope(c, rotor, turn, body.moment);
  if (c.has_rail) slope = slope * free_to_turn(c, b);
}

// ------------------------------------------------------------------------------------------- what is asked for
template <class S>
PHYSIM_INLINE bool is_first_order(const Conditions<S>& c) {
  const Integrator i = c.fidelity.integrator;
  return i == Integrator::explicit_euler || i == Integrator::semi_implicit_euler;
}
/// Whether drag, its own or that of generators, may brake the steps of what flies (BrakedSum): those that do not choose
/// their length, but the original loop's.
template <class S>
PHYSIM_INLINE bool is_braked(const Conditions<S>& c) {
  const Fidelity& f = c.fidelity;
  const bool is_fixed = is_first_order(c) || f.integrator == Integrator::heun || f.integrator == Integrator::rk4;
  return is_fixed && f.motion != Motion::closed_form && (f.drag != DragModel::off || c.has_applied);
}

/// How long a step is that an acceleration is asked for, and the rate of drag that generators give beside it.
template <class R>
struct StepAsked {
  R h;     // 0: no step [s]
  R rate;  // [1/s]
};
/// No step: the acceleration itself.
template <class R>
PHYSIM_INLINE StepAsked<R> no_step() {
  return {R(ScalarOf<R>(0)), R(ScalarOf<R>(0))};
}

/// What of the acceleration is left over a step.
template <class R, class S>
PHYSIM_INLINE Vec3<R> left_over(const Conditions<S>& c, const BrakedSum<R>& sum, const StepAsked<R>& step) {
  if (!is_braked(c)) return sum.total;
  return is_first_order(c) ? sum.over(step.h, step.rate) : sum.limited(step.h, step.rate);
}

/// The acceleration of a point mass.
template <class R, class S>
PHYSIM_INLINE Vec3<R> acceleration(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  Sum<R> sum;
  sum_effects(c, b, t, s, PointInAir{}, sum);
  return sum.total;
}

/// The acceleration at a point in known air.
template <class R, class S>
PHYSIM_INLINE Vec3<R> acceleration(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                                   const PointInKnownAir<R>& in_air) {
  Sum<R> sum;
  sum_effects(c, b, t, s, in_air, sum);
  return sum.total;
}

/// The acceleration of a point mass over a step: of rungs that drag brakes, what of it is left.
template <class R, class S>
PHYSIM_INLINE Vec3<R> acceleration_over(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                                        const StepAsked<R>& step) {
  BrakedSum<R> sum;
  sum_effects(c, b, t, s, PointInAir{}, sum);
  return left_over(c, sum, step);
}

/// As acceleration_over(), behind one call, so that twelve stages do not become twelve copies of all models.
template <class R, class S>
PHYSIM_FLAT PHYSIM_NOINLINE void evaluate(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                                          const StepAsked<R>& step, Vec3<R>& a) {
  a = acceleration_over(c, b, t, s, step);
}
/// The acceleration itself.
template <class R, class S>
PHYSIM_INLINE_ALWAYS Vec3<R> evaluated(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  Vec3<R> a;
  evaluate(c, b, t, s, no_step<R>(), a);
  return a;
}

/// The acceleration of what turns, behind one call.
template <class R, class S>
PHYSIM_FLAT PHYSIM_NOINLINE void evaluate(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                          const State<R>& s, const Turn<R>& turn, const StepAsked<R>& step, Vec3<R>& a,
                                          Turn<R>& slope) {
  BrakedSum<R> sum;
  sum_effects(c, b, rotor, t, s, turn, slope, sum);
  a = left_over(c, sum, step);
}

/// The slopes at a time and state of what turns: that of its Turn, and the acceleration by value.
template <class R, class S>
PHYSIM_INLINE_ALWAYS Vec3<R> evaluated(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const R& t,
                                       const State<R>& y, const Turn<R>& turn, Turn<R>& slope) {
  Vec3<R> a;
  evaluate(c, b, rotor, t, y, turn, no_step<R>(), a, slope);
  return a;
}

/// The acceleration that the original loop's next frame begins with.
template <class R, class S>
PHYSIM_INLINE Vec3<R> evaluated_original(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s) {
  Sum<R> sum;
  sum_effects(c, b, t, s, OriginalInAir{}, sum);
  return sum.total;
}

PHYSIM_ISA_END

namespace physim {

/// The effects on a projectile on any rung, one by one; `rotor` and `turn` are read by rungs that turn.
[[nodiscard]] Accelerations accelerations_of(const Conditions<double>& c, const Body<double>& b,
                                             const Rotor<double>& rotor, double t, const State<double>& s,
                                             const Turn<double>& turn);

/// Where the nose of any body points, a unit vector in W [-].
[[nodiscard]] Vec3d nose_of(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& rotor, double t,
                            const State<double>& s, const Turn<double>& turn);

}  // namespace physim
