// Lanes: flights under way, one per lane, each with its own time and step. R is a number (one flight) or a pack.
//
// fly() runs one lane, fly_batch() runs packs; both through these functions, so a shot's numbers are the same.
#pragma once

#include <limits>

#include "flight/watch.hpp"
#include "solve/step_control.hpp"

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
  StepPlan<S> plan;
  WatchList watch;
  bool corners;  // steps must end at corners of piecewise data
};

template <class R>
struct Lanes {
  Body<R> body;
  Step<R> step;
  StepControl<R> control;
  Regime<R> regime;  // at the start of the step
  R count;           // steps accepted
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

/// Prepares lanes whose `body` is set for their first step.
template <class R, class S>
PHYSIM_INLINE void begin(const Course<S>& course, Lanes<R>& l) {
  const Conditions<S>& c = *course.conditions;
  const R zero(S(0));
  l.step.t = zero;
  l.step.start = l.body.launch;
  Vec3<R> a;
  evaluate(c, l.body, zero, l.step.start, a);
  const bool classic = c.fidelity.motion != Motion::closed_form && c.fidelity.integrator == Integrator::classic;
  if (classic) a = {zero, zero, zero};
  l.step.slope[0] = {l.step.start.v, a};
  l.control.log_previous = zero;
  if (course.plan.step > S(0)) {
    l.control.h = R(course.plan.step);
  } else if (c.fidelity.motion == Motion::closed_form) {
    l.control.h = closed_form_step(c, l.body);
  } else {
    l.control.h = min(first_step(c.fidelity.integrator, l.step.start, a, course.plan.relative, course.plan.absolute),
                      R(course.plan.max_step));
  }
  if (course.corners) l.regime = regime(c, l.body, zero, l.step.start);
  l.count = l.tries = l.cut = zero;
}

template <class To, class From>
PHYSIM_INLINE void cast_fields(const From* from, To* to, unsigned count) {
  for (unsigned i = 0; i < count; ++i) to[i] = static_cast<To>(from[i]);
}

/// The dense output of one lane's last step, in double.
template <class S>
struct LaneStep {
  const Conditions<S>* conditions;
  Body<double> body;
  Node n0;
  Node n1;
  State<double> coefficient[kMaxDenseCoefficients];

  State<double> operator()(double theta) const {
    const Fidelity& f = conditions->fidelity;
    if (f.motion != Motion::closed_form) return dense_state(f.integrator, n0, n1, coefficient, theta);
    return closed_form_state(time(theta));
  }
  [[nodiscard]] double time(double theta) const { return n0.t + theta * (n1.t - n0.t); }
  /// A watched value at an end of the step in the flight's own precision: the end of one step is the start of the next
  /// one to the bit, so that no crossing falls between them.
  [[nodiscard]] double watched_at(const EventSpec& spec, const Node& n) const {
    const State<S> s{vec_cast<S>(n.y.x), vec_cast<S>(n.y.v)};
    if constexpr (sizeof(S) == sizeof(double)) {
      return watched_value(*conditions, body, spec, n.t, s);
    } else {
      return watched_value(*conditions, own_body(), spec, static_cast<S>(n.t), s);
    }
  }
  /// Flight::at() knows a time only: going through it gives events and ends the bits that it gives.
  [[nodiscard]] State<double> at_time(double t) const { return (*this)(place_between(n0, n1, t)); }

 private:
  /// In the flight's own precision, as the steps were.
  [[nodiscard]] Body<S> own_body() const {
    Body<S> own;
    cast_fields(reinterpret_cast<const double*>(&body), reinterpret_cast<S*>(&own), kBodyFields<S>);
    return own;
  }
  [[nodiscard]] State<double> closed_form_state(double t) const {
    const State<S> s = closed_form(*conditions, own_body(), static_cast<S>(t));
    return {vec_cast<double>(s.x), vec_cast<double>(s.v)};
  }
};

/// Reads lane `lane` of a structure of R's as doubles.
template <template <class> class Struct, class R>
PHYSIM_INLINE void get_lane_as_double(const Struct<R>& from, int lane, Struct<double>& into) {
  using S = ScalarOf<R>;
  const auto* source = reinterpret_cast<const S*>(&from) + lane;
  auto* to = reinterpret_cast<double*>(&into);
  for (unsigned i = 0; i < sizeof(Struct<R>) / sizeof(R); ++i)
    to[i] = static_cast<double>(source[i * unsigned(kLanes<R>)]);
}

template <class R, class S>
void lane_step(const Course<S>& course, const Lanes<R>& l, int lane, LaneStep<S>& out) {
  const Fidelity& fidelity = course.conditions->fidelity;
  const bool closed = fidelity.motion == Motion::closed_form;
  const int last = closed ? 1 : end_slope(fidelity.integrator);
  Step<double> s;
  s.t = static_cast<double>(lane_of(l.step.t, lane));
  s.h = static_cast<double>(lane_of(l.step.h, lane));
  get_lane_as_double(l.step.start, lane, s.start);
  get_lane_as_double(l.step.end, lane, s.end);
  for (int i = 0; i <= last; ++i) get_lane_as_double(l.step.slope[i], lane, s.slope[i]);
  get_lane_as_double(l.body, lane, out.body);
  out.conditions = course.conditions;
  out.n0 = {s.t, s.start, s.slope[0].v};
  out.n1 = {static_cast<double>(lane_of(l.step.t_end, lane)), s.end, s.slope[last].v};
  if (closed) return;
  const auto f = [&](double t, const State<double>& y) {
    return acceleration(*course.conditions_double, out.body, t, y);
  };
  dense_coefficients(fidelity.integrator, s, f, out.coefficient);
}

/// The common case: layers of the air are the only corners, and no lane leaves the first one.
template <class R, class S>
PHYSIM_INLINE bool only_below_first_layer(const Conditions<S>& c, const Lanes<R>& l) {
  if (drag_has_corners(c) || c.fidelity.wind == WindModel::profile || c.has_applied) return false;
  // Geopotential height is never above geometric height.
  return all((altitude(c, l.step.end.x) < R(c.air.base[1])) & (l.regime.air_layer == R(S(0))) & (l.cut == R(S(0))));
}

/// Cuts the steps of lanes that would cross a corner; returns lanes whose step stands.
template <class R, class S>
MaskOf<R> respect_corners(const Course<S>& course, Lanes<R>& l, const MaskOf<R>& accepted) {
  const R one(S(1));
  const R zero(S(0));
  if (only_below_first_layer(*course.conditions, l)) return accepted;
  const Regime<R> next = regime(*course.conditions, l.body, l.step.t_end, l.step.end);
  const MaskOf<R> crossing = accepted & (l.cut == zero) & differ(l.regime, next);
  R cut = zero;
  if (any(crossing)) {
    for (int lane = 0; lane < kLanes<R>; ++lane) {
      if (!lane_of(crossing, lane)) continue;
      LaneStep<S> at;
      lane_step(course, l, lane, at);
      const double h = at.n1.t - at.n0.t;
      const double part = first_corner(*course.conditions_double, at.body, at.n0.t, h, at);
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

/// Tries one step in every lane; returns the lanes in which it was accepted. control.h is then the next step to try.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> try_step(const Course<S>& course, Lanes<R>& l) {
  const Conditions<S>& c = *course.conditions;
  const R one(S(1));
  l.step.h = l.control.h;
  // Fixed steps count, so that time does not gather rounding errors.
  l.step.t_end = steps_itself(c.fidelity) ? l.step.t + l.step.h : (l.count + one) * l.step.h;
  take_step(c, l.body, course.plan.relative, course.plan.absolute, l.step);
  l.tries += one;
  if (c.fidelity.motion == Motion::closed_form || !is_adaptive(c.fidelity.integrator)) return l.tries > R(S(0));
  const MaskOf<R> accepted = l.step.error <= one;
  l.control.h =
      min(next_step(c.fidelity.integrator, l.step.h, l.step.error, accepted, l.control), R(course.plan.max_step));
  return course.corners ? respect_corners(course, l, accepted) : accepted;
}

/// Moves accepted lanes to the end of their step.
template <class R, class S>
PHYSIM_INLINE void accept(const Course<S>& course, Lanes<R>& l, const MaskOf<R>& accepted) {
  const Fidelity& f = course.conditions->fidelity;
  const bool closed = f.motion == Motion::closed_form;
  const int last = closed ? 1 : end_slope(f.integrator);
  l.count = select(accepted, l.count + R(S(1)), l.count);
  l.step.t = select(accepted, l.step.t_end, l.step.t);
  l.step.start = select(accepted, l.step.end, l.step.start);
  l.step.slope[0] = select(accepted, l.step.slope[last], l.step.slope[0]);
  if (closed) l.control.h = min(l.control.h * S(2), longest_closed_form_step(*course.conditions, l.body));
}

template <class R>
PHYSIM_INLINE MaskOf<R> is_finite(const State<R>& s) {
  return is_finite(((s.x.x + s.x.y) + (s.x.z + s.v.x)) + (s.v.y + s.v.z));
}

/// Accepted lanes that cannot just go on because of an event or a bad number; and lanes out of steps.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> needs_attention(const Course<S>& course, const Lanes<R>& l, const MaskOf<R>& accepted) {
  const Conditions<S>& c = *course.conditions;
  const int last = c.fidelity.motion == Motion::closed_form ? 1 : end_slope(c.fidelity.integrator);
  const MaskOf<R> special =
      detect(c, l.body, course.watch, l.step, l.step.slope[0].v, l.step.slope[last].v) | !is_finite(l.step.end);
  return (special & accepted) | (l.tries >= R(course.plan.max_tries)) | (l.step.t_end <= l.step.t) |
         !(l.step.h > R(S(0)));
}

/// What a lane's last step means for its flight.
struct Verdict {
  bool ended;
  Outcome outcome;
  double theta;  // place in the last step where the flight ends
  int found;     // crossings to report
};

/// Judges one lane after a step that needed attention. Fills `at` where the step was accepted and finite.
template <class R, class S>
Verdict judge(const Course<S>& course, const Lanes<R>& l, int lane, bool accepted, LaneStep<S>& at, Found* found) {
  const Conditions<double>& c = *course.conditions_double;
  State<S> end;
  get_lane(l.step.end, lane, end);
  const bool stands_still = !(lane_of(l.step.h, lane) > S(0)) || lane_of(l.step.t_end, lane) <= lane_of(l.step.t, lane);
  const bool out_of_tries = lane_of(l.tries, lane) >= course.plan.max_tries;
  if (accepted && !is_finite(end)) return {true, Outcome::non_finite, 0, 0};
  if (accepted) {
    lane_step(course, l, lane, at);
    const int count = find_crossings(c, at.body, course.watch, at, found);
    if (count > 0) {
      const Watched& last = course.watch.item[found[count - 1].index];
      if (last.spec.terminal) return {true, last.outcome, found[count - 1].theta, count};
    }
    if (out_of_tries) return {true, Outcome::step_limit, 1, count};
    if (stands_still) return {true, Outcome::stalled, 1, count};
    return {false, Outcome::step_limit, 1, count};
  }
  if (stands_still)
    return {true, is_finite(lane_of(l.step.error, lane)) ? Outcome::stalled : Outcome::non_finite, 0, 0};
  return {out_of_tries, Outcome::step_limit, 0, 0};
}

PHYSIM_ISA_END
