// Lanes: flights under way, one per lane, each with its own time and step. R is a number (one flight) or a pack.
//
// fly() runs one lane, fly_batch() runs packs; both through the same functions, so a shot's numbers are the same:
// begin() here, try_steps() and accept() in solve/advance.hpp, judge() in solve/judge.hpp.
#pragma once

#include <cstdint>
#include <limits>

#include "solve/step_control.hpp"
#include "solve/stops.hpp"
#include "solve/watch.hpp"

namespace physim {

/// How a cohort steps through time.
template <class S>
struct StepPlan {
  S relative;   // error per step [-]
  S absolute;   // [m], [m/s]
  S step;       // fixed step [s]; 0: adaptive or closed form
  S max_step;   // [s]
  S max_tries;  // steps tried before Outcome::step_limit
};

/// Everything that the flights of a batch share.
template <class S>
struct Course {
  const Conditions<S>* conditions;
  const Conditions<double>* conditions_double;  // for dense output and events
  NumberRuns body;                              // the numbers of a Body that lanes hold
  StepPlan<S> plan;
  WatchList watch;
  bool corners;  // steps must end at corners of piecewise data
};

template <class R>
struct Lanes {
  Body<R> body;
  Unset<Rotor<R>> rotor;  // of rungs that turn
  Step<R> step;
  StepControl<R> control;
  Regime<R> regime;  // at the start of the step
  R count;           // steps accepted; of fixed steps, whole ones
  R parts;           // parts of fixed steps accepted beside them
  R tries;           // steps tried
  R cut;             // 1: this step was cut to end behind a corner
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Closed forms need steps only to look for events in: the first a part of the time to the apex, each twice the last,
/// so that a few cover flights of any length; with drag short enough that nothing turns twice in one.
template <class R, class S>
PHYSIM_INLINE R longest_closed_form_step(const Conditions<S>& c, const Body<R>& b) {
  const R sixty(S(60));
  return c.fidelity.drag == DragModel::off ? sixty : min(S(0.5) / max(b.damping_rate, R(S(1e-6))), sixty);
}
template <class R, class S>
PHYSIM_INLINE R closed_form_step(const Conditions<S>& c, const Body<R>& b) {
  const R speed = length(b.launch.v);
  const R rise = speed / max(R(c.gravity), R(S(1e-3)));  // time to the apex of a shot straight up
  const R first = select(speed > R(S(0)), clamp(rise * S(0.5), R(S(1e-12)), R(S(10))), R(S(1e-3)));
  return min(first, longest_closed_form_step(c, b));
}

/// Prepares lanes whose `body`, and `rotor` where they turn, is set for their first step.
template <class R, class S>
PHYSIM_INLINE void begin(const Course<S>& course, Lanes<R>& l) {
  const Conditions<S>& c = *course.conditions;
  const R zero(S(0));
  l.step.t = zero;
  l.step.start = l.body.launch;
  if (has_stops(c)) pass_stops(c, zero, zero == zero, l.step.start, l.body);
  if (turns(c.fidelity)) l.step.turn->start = l.rotor->launch;
  set_slope(c, l.body, *l.rotor, 0, l.step);
  Vec3<R>& a = l.step.slope[0].v;
  const bool classic = c.fidelity.motion != Motion::closed_form && c.fidelity.integrator == Integrator::classic;
  if (classic) a = {zero, zero, zero};
  l.control.log_previous = zero;
  if (course.plan.step > S(0)) {
    l.control.h = R(course.plan.step);
  } else if (c.fidelity.motion == Motion::closed_form) {
    l.control.h = closed_form_step(c, l.body);
  } else {
    l.control.h = min(first_step(c.fidelity.integrator, l.step.start, a, course.plan.relative, course.plan.absolute),
                      R(course.plan.max_step));
    if (turns(c.fidelity)) l.control.h = min(l.control.h, first_turn_step(c.fidelity.integrator, *l.step.turn));
  }
  if (course.corners) l.regime = regime(c, l.body, *l.rotor, zero, l.step.start);
  l.count = l.parts = l.tries = l.cut = zero;
}

/// Where a lane has been let go by its rail, its regime is another one. Without rails the regime knows none.
template <class R, class S>
PHYSIM_INLINE void note_rail(const Conditions<S>& c, Lanes<R>& l) {
  if (c.has_rail) l.regime.rail = l.body.rail_phase;
}

/// Number of the last slope that a step leaves.
PHYSIM_INLINE int last_slope(const Fidelity& f) {
  return f.motion == Motion::closed_form ? 1 : end_slope(f.integrator);
}

/// Evaluations of the acceleration that a number of tried steps took, the one at launch included.
PHYSIM_INLINE std::int64_t evaluations(const Fidelity& granted, std::int64_t tries) {
  return 1 + tries * last_slope(granted);
}

/// Copies the finished step of one lane with all that judging it takes, and some numbers of its body.
template <class R, class Into, class S>
PHYSIM_INLINE void copy_step(const Conditions<S>& c, const Lanes<R>& from, int from_lane, Lanes<Into>& into, int lane,
                             const NumberRuns& body) {
  const Integrator integrator = c.fidelity.integrator;
  copy_lane(from.body, from_lane, into.body, lane, body);
  copy_lane(from.step.start, from_lane, into.step.start, lane);
  copy_lane(from.step.end, from_lane, into.step.end, lane);
  for_dense_slopes(integrator, last_slope(c.fidelity),
                   [&](int i) { copy_lane(from.step.slope[i], from_lane, into.step.slope[i], lane); });
  copy_lane(from.step.t, from_lane, into.step.t, lane);
  copy_lane(from.step.h, from_lane, into.step.h, lane);
  copy_lane(from.step.t_end, from_lane, into.step.t_end, lane);
  copy_lane(from.step.error, from_lane, into.step.error, lane);
  copy_lane(from.count, from_lane, into.count, lane);
  copy_lane(from.parts, from_lane, into.parts, lane);
  copy_lane(from.tries, from_lane, into.tries, lane);
  if (!turns(c.fidelity)) return;
  copy_lane(*from.rotor, from_lane, *into.rotor, lane);
  copy_lane(from.step.turn->start, from_lane, into.step.turn->start, lane);
  copy_lane(from.step.turn->end, from_lane, into.step.turn->end, lane);
  for_dense_slopes(integrator, last_slope(c.fidelity),
                   [&](int i) { copy_lane(from.step.turn->slope[i], from_lane, into.step.turn->slope[i], lane); });
}

PHYSIM_ISA_END
