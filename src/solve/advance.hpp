// Moving lanes on: trying a step, controlling its length, cutting it at corners, accepting it.
#pragma once

#include <optional>

#include "solve/dense_lanes.hpp"
#include "solve/step_control.hpp"

PHYSIM_ISA_BEGIN

/// The common case: layers of the air are the only corners, and no lane leaves the first one.
template <class R, class S>
PHYSIM_INLINE bool only_below_first_layer(const Conditions<S>& c, const Lanes<R>& l) {
  if (drag_has_corners(c) || c.fidelity.wind == WindModel::profile || c.has_applied || c.has_rail || c.has_aero_tables)
    return false;
  // Geopotential height is never above geometric height.
  return all((altitude(c, l.step.end.x) < R(c.air.base[1])) & (l.regime.air_layer == R(S(0))) & (l.cut == R(S(0))));
}

/// How long the step of one lane may be to end behind its first corner [s]; nothing where it stands.
template <class R, class S>
std::optional<double> cut_at_corner(const Course<S>& course, const Lanes<R>& l, int lane, bool by_rail) {
  const Conditions<double>& c = *course.conditions_double;
  Lanes<S> alone{};
  copy_step(*course.conditions, l, lane, alone, 0, course.body);
  DenseLanes<S> at;
  dense_lanes(course, alone, at);
  const Body<double> whole_body = at.whole_body();
  const auto rates = [&](double theta) {
    const State<double> s = at(theta);
    return edge_rates(c, whole_body, s, at.acceleration(theta, s));
  };
  const double h = at.n1.t - at.n0.t;
  // A corner in the first millionth of a step is the one that the last step was cut at. A rail is never left late.
  const double before = by_rail ? 0 : 1e-6;
  double cut_h = h * first_corner(c, whole_body, at.turn->rotor, at.n0.t, h, before, at, rates);
  // A corner within some roundings of the clock is as good as passed: a cut to it would stand still.
  const double shortest = 64.0 * std::numeric_limits<S>::epsilon() * at.n0.t;
  if (by_rail) cut_h = max(cut_h, 2 * shortest);
  if (cut_h >= h || cut_h <= shortest) return std::nullopt;
  return cut_h;
}

/// Cuts the steps of lanes that would cross a corner; returns lanes whose step stands.
template <class R, class S>
MaskOf<R> respect_corners(const Course<S>& course, Lanes<R>& l, const MaskOf<R>& accepted) {
  const R one(S(1));
  const R zero(S(0));
  const Conditions<S>& c = *course.conditions;
  if (only_below_first_layer(c, l)) return accepted;
  const Regime<R> next = regime(c, l.body, *l.rotor, l.step.t_end, l.step.end);
  const MaskOf<R> turning = turns_back(edge_rates(c, l.body, l.step.start, l.step.slope[0].v),
                                       edge_rates(c, l.body, l.step.end, l.step.slope[last_slope(c.fidelity)].v));
  const MaskOf<R> crossing = accepted & (l.cut == zero) & (differ(l.regime, next) | turning);
  R cut = zero;
  for (unsigned left = lane_bits(crossing); left != 0; left &= left - 1) {
    const int lane = __builtin_ctz(left);
    const bool by_rail = lane_of(l.regime.rail, lane) != lane_of(next.rail, lane);
    const std::optional<double> cut_h = cut_at_corner(course, l, lane, by_rail);
    if (!cut_h) continue;
    set_lane(l.control.h, lane, static_cast<S>(*cut_h));
    set_lane(cut, lane, S(1));
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
  MaskOf<R> accepted = l.tries > R(S(0));
  if (!steps_itself(f)) return course.corners ? respect_corners(course, l, accepted) : accepted;
  if (f.motion == Motion::closed_form) return accepted;
  accepted = l.step.error <= R(S(1));
  const R proposed = l.control.h;
  l.control.h = min(next_step(f.integrator, l.step.h, l.step.error, accepted, l.control), R(course.plan.max_step));
  // A step that had to end at a stop says nothing against the longer one that it would have been.
  if (has_stops(*course.conditions))
    l.control.h = select(accepted & (l.step.h < proposed), max(l.control.h, proposed), l.control.h);
  return course.corners ? respect_corners(course, l, accepted) : accepted;
}

/// Ends the coming step where its piece of a motor's table ends. What is left of a fixed step is the next one; a step
/// that was cut at a corner is as long as it was cut.
template <class R>
PHYSIM_INLINE void end_at_stop(const R& whole_end, const R& whole_step, const MaskOf<R>& counted, Lanes<R>& l) {
  const auto is_cut = l.cut != R(ScalarOf<R>(0));
  const auto whole = counted & !is_cut;
  l.step.t_end = select(whole, whole_end, l.step.t + l.control.h);
  l.step.h = select(whole, whole_step, l.control.h);
  const auto stops = l.body.burn.end < l.step.t_end;
  l.step.t_end = select(stops, l.body.burn.end, l.step.t_end);
  l.step.h = select(stops, l.step.t_end - l.step.t, l.step.h);
}

/// The same for the lanes of a flight.
template <class R, class S>
PHYSIM_INLINE void set_stopped_step(const Course<S>& course, Lanes<R>& l) {
  const R one(S(1));
  const bool fixed = !steps_itself(course.conditions->fidelity);
  const R end = (l.count + one) * course.plan.step;
  const auto at_whole = l.step.t == l.count * course.plan.step;
  const R left = select(at_whole, R(course.plan.step), end - l.step.t);
  end_at_stop(end, left, fixed ? one == one : one != one, l);
}

/// Counts what was accepted, and passes on behind its end: the first slope there is another one where something stops.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> pass_on(const Course<S>& course, Lanes<R>& l, const MaskOf<R>& accepted) {
  const Conditions<S>& c = *course.conditions;
  const R one(S(1));
  MaskOf<R> whole = accepted;
  if (!steps_itself(c.fidelity)) whole = accepted & (l.step.t >= (l.count + one) * course.plan.step);
  l.parts += select(accepted & !whole, one, R(S(0)));
  const MaskOf<R> changed = pass_stops(c, l.step.t, accepted, l.step.start, l.body);
  if (!any(changed)) return whole;
  const State<R> slope = l.step.slope[0];
  if (turns(c.fidelity)) {
    Turn<R>& first = l.step.turn->slope[0];
    const Turn<R> turn_slope = first;
    set_slope(c, l.body, *l.rotor, 0, l.step);
    first = select(changed, first, turn_slope);
  } else {
    set_slope(c, l.body, *l.rotor, 0, l.step);
  }
  l.step.slope[0] = select(changed, l.step.slope[0], slope);
  note_rail(c, l);
  return whole;
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
    if (has_stops(c)) {
      set_stopped_step(course, l);
      continue;
    }
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
  l.step.t = select(accepted, l.step.t_end, l.step.t);
  l.step.start = select(accepted, l.step.end, l.step.start);
  l.step.slope[0] = select(accepted, l.step.slope[last_slope(f)], l.step.slope[0]);
  if (turns(f)) {
    TurnStep<R>& turn = *l.step.turn;
    turn.start = select(accepted, turn.end, turn.start);
    turn.slope[0] = select(accepted, turn.slope[last_slope(f)], turn.slope[0]);
  }
  const MaskOf<R> whole = has_stops(*course.conditions) ? pass_on(course, l, accepted) : accepted;
  l.count = select(whole, l.count + R(S(1)), l.count);
  if (closed) l.control.h = min(l.control.h * S(2), longest_closed_form_step(*course.conditions, l.body));
}

PHYSIM_ISA_END
