// Stops: times and places at which steps of every integrator end, because the acceleration bends or jumps there: the
// points of a motor's table, the end of an applied force, and where a launch rail releases the projectile or ends.
//
// A step belongs to one piece of the table and one phase on the rail, and has the force or not; the body holds them.
// All stages use them, the last one too, so that each step is smooth up to its very end. Then the body passes on, and
// the next step begins with its own slope. When a piece or a force ends is known before, so steps are made to end
// there; where a phase ends is found as corners are (solve/regime.hpp).
#pragma once

#include <limits>

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "model/motor_table.hpp"
#include "solve/take_step.hpp"

PHYSIM_ISA_BEGIN

/// Whether steps may end early at all.
template <class S>
PHYSIM_INLINE bool has_stops(const Conditions<S>& c) {
  return c.has_motor || c.has_rail || c.has_force_end;
}

/// The next stop that is known by its time [s].
template <class R, class S>
PHYSIM_INLINE R next_stop(const Conditions<S>& c, const Body<R>& b) {
  R stop = constant<R>(std::numeric_limits<double>::infinity());
  if (c.has_motor) stop = b.burn.end;
  if (c.has_force_end) stop = min(stop, b.applied_until);
  return stop;
}

/// The phase on the rail at a time and state, for a body that was in another one before.
template <class R, class S>
PHYSIM_NOINLINE void rail_phase(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s, R& phase) {
  const R zero(S(0));
  PHYSIM_ASSERT(c.has_rail);
  const R off = constant<R>(kOffRail);
  phase = off;
  const auto on = (b.rail_phase < off) & (dot(s.x, b.rail) < b.rail_end);
  if (!any(on)) return;
  Body<R> sliding = b;
  sliding.rail_phase = constant<R>(kSliding);
  const auto moves = (dot(s.v, b.rail) > zero) | (dot(evaluated(c, sliding, t, s), b.rail) > zero);
  phase = select(on, select(moves, constant<R>(kSliding), constant<R>(kHeld)), off);
}

/// Gives one lane's body a piece of its motor's table.
template <class R>
PHYSIM_INLINE void put_piece(const MotorPiece* pieces, int piece, Body<R>& b, int lane) {
  PHYSIM_ASSERT(pieces != nullptr && piece >= 0);
  const MotorPiece& p = pieces[piece];
  put_lane(p.burn, b.burn, lane);
  put_lane(p.curve, static_cast<CurvePart<R>&>(b), lane);
  set_lane(b.burn_piece, lane, static_cast<ScalarOf<R>>(piece));
}

/// Passes on to the piece that a time is in; returns the lanes in which that is another one.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> pass_pieces(const Conditions<S>& c, const R& t, const MaskOf<R>& lanes, Body<R>& b) {
  const MaskOf<R> over = lanes & (t >= b.burn.end);
  if (!any(over)) return over;
  PHYSIM_ASSERT(c.has_motor);
  for (int lane = 0; lane < kLanes<R>; ++lane)
    while (lane_of(over, lane) && lane_of(t, lane) >= lane_of(b.burn.end, lane))
      put_piece(c.motor_pieces, static_cast<int>(lane_of(b.burn_piece, lane)) + 1, b, lane);
  return over;
}

/// Takes the force from lanes in which its time is over; returns them.
template <class R>
PHYSIM_INLINE MaskOf<R> pass_force(const R& t, const MaskOf<R>& lanes, Body<R>& b) {
  const R zero(ScalarOf<R>(0));
  const MaskOf<R> over = lanes & (t >= b.applied_until);
  b.applied = select(over, Vec3<R>{zero, zero, zero}, b.applied);
  b.applied_until = select(over, constant<R>(std::numeric_limits<double>::infinity()), b.applied_until);
  return over;
}

/// Passes on to the piece and the phase at the start of the next step; returns the lanes in which something is new, so
/// that their acceleration is another one. A body that comes to rest on the rail stands still.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> pass_stops(const Conditions<S>& c, const R& t, const MaskOf<R>& lanes, State<R>& s,
                                   Body<R>& b) {
  const R zero(S(0));
  MaskOf<R> changed = zero != zero;
  if (c.has_motor) changed = pass_pieces(c, t, lanes, b);
  if (c.has_force_end) changed = changed | pass_force(t, lanes, b);
  if (!c.has_rail || !any(b.rail_phase < constant<R>(kOffRail))) return changed;
  R phase;
  rail_phase(c, b, t, s, phase);
  const auto turned = lanes & (phase != b.rail_phase);
  b.rail_phase = select(turned, phase, b.rail_phase);
  const Vec3<R> rest{zero, zero, zero};
  s.v = select(lanes & (b.rail_phase == constant<R>(kHeld)), rest, s.v);
  return changed | turned;
}

PHYSIM_ISA_END
