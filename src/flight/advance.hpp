// Moving lanes on: trying a step, controlling its length, cutting it at corners, accepting it.
#pragma once

#include "flight/dense_lanes.hpp"
#include "solve/step_control.hpp"

PHYSIM_ISA_BEGIN

/// The common case: layers of the air are the only corners, and no lane leaves the first one.
template <class R, class S>
PHYSIM_INLINE bool only_below_first_layer(const Conditions<S>& c, const Lanes<R>& l) {
  if (drag_has_corners(c) || c.fidelity.wind == WindModel::profile || c.has_applied || c.has_aero_tables) return false;
  // Geopotential height is never above geometric height.
  return all((altitude(c, l.step.end.x) < R(c.air.base[1])) & (l.regime.air_layer == R(S(0))) & (l.cut == R(S(0))));
}

/// Cuts the steps of lanes that would cross a corner; returns lanes whose step stands.
template <class R, class S>
MaskOf<R> respect_corners(const Course<S>& course, Lanes<R>& l, const MaskOf<R>& accepted) {
  const R one(S(1));
  const R zero(S(0));
  if (only_below_first_layer(*course.conditions, l)) return accepted;
  const Regime<R> next = regime(*course.conditions, l.body, *l.rotor, l.step.t_end, l.step.end);
  const MaskOf<R> crossing = accepted & (l.cut == zero) & differ(l.regime, next);
  R cut = zero;
  if (any(crossing)) {
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      if (!lane_of(crossing, lane)) continue;
      Lanes<S> alone{};
      copy_step(*course.conditions, l, lane, alone, 0);
      DenseLanes<S> at;
      dense_lanes(course, alone, at);
      const double h = at.n1.t - at.n0.t;
      const double part = first_corner(*course.conditions_double, at.body, at.turn->rotor, at.n0.t, h, at);
      // A corner within some roundings of the clock is as good as passed: a cut to it would stand still.
      if (part >= 1 || part * h <= 64.0 * std::numeric_limits<S>::epsilon() * at.n0.t) continue;
      set_lane(l.control.h, lane, static_cast<S>(part * h));
      set_lane(cut, lane, S(1));
    }
  }
  const MaskOf<R> stands = accepted & (cut == zero);
  l.cut = select(stands, zero, select(cut == one, one, l.cut));
  l.regime = select(stands, next, l.regime);
  return stands;
}

/// Judges a step taken: returns the lanes in which it is accepted, and sets control.h to the next step to try.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> control_step(const Course<S>& course, Lanes<R>& l) {
  const Fidelity& f = course.conditions->fidelity;
  l.tries += R(S(1));
  if (f.motion == Motion::closed_form || !is_adaptive(f.integrator)) return l.tries > R(S(0));
  const MaskOf<R> accepted = l.step.error <= R(S(1));
  l.control.h = min(next_step(f.integrator, l.step.h, l.step.error, accepted, l.control), R(course.plan.max_step));
  return course.corners ? respect_corners(course, l, accepted) : accepted;
}

/// Sets of lanes that step side by side: more hide no more latency.
inline constexpr int kMostSets = 4;

/// Tries one step in every lane of up to kMostSets sets of lanes; says in which lanes of each it was accepted.
template <class R, class S>
PHYSIM_INLINE void try_steps(const Course<S>& course, Lanes<R>* const* lanes, int count, MaskOf<R>* accepted) {
  const Conditions<S>& c = *course.conditions;
  const Body<R>* bodies[kMostSets];
  const Rotor<R>* rotors[kMostSets];
  Step<R>* steps[kMostSets];
  for (int i = 0; i < count; ++i) {
    Lanes<R>& l = *lanes[i];
    bodies[i] = &l.body;
    rotors[i] = &*l.rotor;
    steps[i] = &l.step;
    l.step.h = l.control.h;
    // Fixed steps count, so that time does not gather rounding errors.
    l.step.t_end = steps_itself(c.fidelity) ? l.step.t + l.step.h : (l.count + R(S(1))) * l.step.h;
  }
  take_steps(c, Walkers<R>{bodies, rotors, steps, count}, course.plan.relative, course.plan.absolute);
  for (int i = 0; i < count; ++i) accepted[i] = control_step(course, *lanes[i]);
}
template <class R, class S>
PHYSIM_INLINE MaskOf<R> try_step(const Course<S>& course, Lanes<R>& l) {
  MaskOf<R> accepted;
  Lanes<R>* lanes = &l;
  try_steps(course, &lanes, 1, &accepted);
  return accepted;
}

/// Moves accepted lanes to the end of their step.
template <class R, class S>
PHYSIM_INLINE void accept(const Course<S>& course, Lanes<R>& l, const MaskOf<R>& accepted) {
  const Fidelity& f = course.conditions->fidelity;
  const bool closed = f.motion == Motion::closed_form;
  l.count = select(accepted, l.count + R(S(1)), l.count);
  l.step.t = select(accepted, l.step.t_end, l.step.t);
  l.step.start = select(accepted, l.step.end, l.step.start);
  l.step.slope[0] = select(accepted, l.step.slope[last_slope(f)], l.step.slope[0]);
  if (turns(f)) {
    TurnStep<R>& turn = *l.step.turn;
    turn.start = select(accepted, turn.end, turn.start);
    turn.slope[0] = select(accepted, turn.slope[last_slope(f)], turn.slope[0]);
  }
  if (closed) l.control.h = min(l.control.h * S(2), longest_closed_form_step(*course.conditions, l.body));
}

PHYSIM_ISA_END
