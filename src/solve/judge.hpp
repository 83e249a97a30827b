// What a step means for its flight: does it go on, what has it crossed, where does it end?
#pragma once

#include "solve/march.hpp"

namespace physim {

/// What a lane's last step means for its flight.
struct Verdict {
  bool ended;
  Outcome outcome;
  double theta;  // place in the last step where the flight ends
};

}  // namespace physim

PHYSIM_ISA_BEGIN

template <class R>
PHYSIM_INLINE MaskOf<R> is_finite(const State<R>& s) {
  return is_finite(((s.x.x + s.x.y) + (s.x.z + s.v.x)) + (s.v.y + s.v.z));
}

template <class R>
PHYSIM_INLINE MaskOf<R> is_finite(const Turn<R>& t) {
  return is_finite((t.w + t.u.x) + (t.u.y + t.u.z) + ((t.h.x + t.h.y) + t.h.z));
}
/// The end of a step.
template <class R>
PHYSIM_INLINE MaskOf<R> ends_finite(const Fidelity& f, const Step<R>& s) {
  MaskOf<R> finite = R(ScalarOf<R>(0)) == R(ScalarOf<R>(0));
  for_parts(
      f, [&](const auto& part) { finite = finite & is_finite(part.end); }, s);
  return finite;
}

/// Lanes that cannot just go on, and what is sure about them before the crossings are found; in bits of lanes.
struct Attention {
  unsigned special;
  unsigned surely_ends;
  unsigned surely_goes_on;
};

/// Accepted lanes with an event or a bad number, and lanes out of steps; `found` is what detect() says of them.
template <class R, class S>
PHYSIM_INLINE Attention needs_attention(const Course<S>& course, const Lanes<R>& l, unsigned accepted,
                                        const Detected& found) {
  const unsigned finite = lane_bits(ends_finite(course.conditions->fidelity, l.step));
  const unsigned trouble = lanes_at_least(l.tries, R(course.plan.max_tries)) | lane_bits(stands_still(l));
  const unsigned sound = accepted & finite;
  Attention a;
  a.special = (accepted & (found.some | ~finite)) | trouble;
  a.surely_ends = sound & found.surely_terminal;
  a.surely_goes_on = sound & ~found.maybe_terminal & ~trouble;
  return a;
}
/// What needs attention, where `items` alone may have been crossed.
template <class R, class S>
PHYSIM_INLINE Attention needs_attention(const Course<S>& course, const Lanes<R>& l, const MaskOf<R>& accepted,
                                        WatchedSet items) {
  const Conditions<S>& c = *course.conditions;
  return needs_attention(
      course, l, lane_bits(accepted),
      detect(c, l.body, course.watch, l.step, l.step.slope[0].v, l.step.slope[last_slope(c.fidelity)].v, items));
}

/// The crossings in the last steps of lanes.
template <class R>
struct Judgement {
  DenseLanes<R> at;
  CrossingList crossings[kLanes<R>];
};

/// Finds what sound (accepted, finite) steps cross of some items; j.at is their dense output.
template <class R, class S>
void find_crossings(const Course<S>& course, const MaskOf<R>& sound, Judgement<R>& j, WatchedSet items = kAllWatched) {
  for (CrossingList& list : j.crossings) list.count = 0;
  if (!any(sound)) return;
  find_crossings<Cast<double, R>>(*course.conditions_double, course.watch, j.at, cast_mask<double, R>(sound),
                                  j.crossings, items);
}

/// What a verdict asks of steps, beside their crossings.
template <class R>
struct StepMarks {
  MaskOf<R> finite;  // at the end
  MaskOf<R> still;
};
template <class R, class S>
PHYSIM_INLINE StepMarks<R> step_marks(const Course<S>& course, const Lanes<R>& l) {
  return {ends_finite(course.conditions->fidelity, l.step), stands_still(l)};
}

/// Judges one lane once its crossings are found.
template <class R, class S>
Verdict verdict_on(const Course<S>& course, const Lanes<R>& l, const StepMarks<R>& marks, int lane, bool accepted,
                   const CrossingList& crossings) {
  const bool still = lane_of(marks.still, lane);
  const bool out_of_tries = lane_of(l.tries, lane) >= course.plan.max_tries;
  if (accepted && !lane_of(marks.finite, lane)) return {true, Outcome::non_finite, 0};
  if (accepted) {
    if (crossings.count > 0) {
      const Found& last = crossings.found[crossings.count - 1];
      PHYSIM_ASSERT(last.index >= 0 && last.index < course.watch.count && last.theta >= 0 && last.theta <= 1);
      const Watched& watched = course.watch.item[last.index];
      if (watched.spec.terminal) return {true, watched.outcome, last.theta};
    }
    if (out_of_tries) return {true, Outcome::step_limit, 1};
    if (still) return {true, Outcome::stalled, 1};
    return {false, Outcome::step_limit, 1};
  }
  if (still) return {true, is_finite(lane_of(l.step.error, lane)) ? Outcome::stalled : Outcome::non_finite, 0};
  return {out_of_tries, Outcome::step_limit, 0};
}

PHYSIM_ISA_END
