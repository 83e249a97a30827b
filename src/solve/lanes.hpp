// Lanes: projectiles under way, one per lane, each with its own time and step. R is a number (one lane) or a pack.
//
// A March (solve/march.hpp) moves them on; solve/judge.hpp says what a step means for a flight.
#pragma once

#include <cstdint>

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
struct Lanes : Flyer<R> {
  PHYSIM_INLINE Lanes() = default;

  StepControl<R> control;
  Regime<R> regime;  // at the start of the step
  Vec3<R> jerk;      // of the last step, where corners are looked for [m/s^3]
  R count;           // steps accepted; of fixed steps, whole ones
  R parts;           // parts of fixed steps accepted beside them
  R tries;           // steps tried
  R cut;             // the step that the error allowed, where this one was cut to end behind a corner; else 0 [s]
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Number of the last slope that a step leaves.
PHYSIM_INLINE int last_slope(const Fidelity& f) {
  return f.motion == Motion::closed_form ? 1 : end_slope(f.integrator);
}

/// Evaluations of the acceleration that a number of tried steps took, the one at launch included.
PHYSIM_INLINE std::int64_t evaluations(const Fidelity& granted, std::int64_t tries) {
  PHYSIM_ASSERT(tries >= 0);
  return 1 + tries * last_slope(granted);
}

/// Copies the finished step of one lane with all that judging it takes, and some numbers of its body.
template <class R, class Into, class S>
PHYSIM_INLINE void copy_step(const Conditions<S>& c, const Lanes<R>& from, int from_lane, Lanes<Into>& into, int lane,
                             const NumberRuns& body) {
  const auto copy = [&](const auto& source, auto& to) { copy_lane(source, from_lane, to, lane); };
  copy_lane(from.body, from_lane, into.body, lane, body);
  for_rotors(c.fidelity, copy, from, into);
  const auto copy_ends = [&](const auto& source, auto& to) {
    copy(source.start, to.start);
    copy(source.end, to.end);
  };
  for_parts(c.fidelity, copy_ends, from.step, into.step);
  const bool by_slopes = dense_coefficient_count(c.fidelity.integrator) > 0 || turns(c.fidelity);
  const auto copy_slopes = [&](const auto& source, auto& to) {
    for_dense_slopes(c.fidelity.integrator, last_slope(c.fidelity), [&](int i) { copy(source.slope[i], to.slope[i]); });
  };
  if (by_slopes) {
    for_parts(c.fidelity, copy_slopes, from.step, into.step);
  } else {  // Hermite's interpolation has the velocities from both ends
    copy(from.step.slope[0].v, into.step.slope[0].v);
    copy(from.step.slope[last_slope(c.fidelity)].v, into.step.slope[last_slope(c.fidelity)].v);
  }
  copy(from.step.t, into.step.t);
  copy(from.step.h, into.step.h);
  copy(from.step.t_end, into.step.t_end);
  copy(from.step.error, into.step.error);
  copy(from.count, into.count);
  copy(from.parts, into.parts);
  copy(from.tries, into.tries);
}

/// Copies one lane that has not begun its first step yet; what is not set then is written before it is read.
template <class R, class S>
PHYSIM_INLINE void copy_start(const Course<S>& course, const Lanes<R>& from, int from_lane, Lanes<R>& into, int lane,
                              const NumberRuns& body) {
  const Fidelity& f = course.conditions->fidelity;
  const auto copy = [&](const auto& source, auto& to) { copy_lane(source, from_lane, to, lane); };
  copy_lane(from.body, from_lane, into.body, lane, body);
  for_rotors(f, copy, from, into);
  const auto copy_part = [&](const auto& source, auto& to) {
    copy(source.start, to.start);
    copy(source.slope[0], to.slope[0]);
  };
  for_parts(f, copy_part, from.step, into.step);
  copy(from.control, into.control);
  if (is_braked(*course.conditions)) copy(from.step.h, into.step.h);  // its slope is that of a step so long
  if (course.corners) {
    copy(from.regime, into.regime);
    copy(from.jerk, into.jerk);
  }
  set_lane(into.step.t, lane, S(0));
  set_lane(into.count, lane, S(0));
  set_lane(into.parts, lane, S(0));
  set_lane(into.tries, lane, S(0));
  set_lane(into.cut, lane, S(0));
}

PHYSIM_ISA_END
