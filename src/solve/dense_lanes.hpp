// The dense output of lanes' last steps, in double whatever the flight's own precision.
#pragma once

#include <algorithm>

#include "base/assert.hpp"
#include "base/unset.hpp"
#include "solve/lanes.hpp"

PHYSIM_ISA_BEGIN

/// The dense output of a rotation.
template <class W>
struct DenseTurn {
  Rotor<W> rotor;
  TurnNodeOf<W> n0;
  TurnNodeOf<W> n1;
  Turn<W> coefficient[kMaxDenseCoefficients];
};

template <class R>
struct DenseLanes {
  using S = ScalarOf<R>;
  using W = Cast<double, R>;

  const Conditions<S>* conditions;
  const Conditions<double>* conditions_double;
  const Lanes<R>* lanes;      // must outlive this
  const NumberRuns* numbers;  // of their bodies
  Body<W> body;               // what watched values read of it; whole_body() has all
  NodeOf<W> n0;
  NodeOf<W> n1;
  State<W> coefficient[kMaxDenseCoefficients];
  Unset<DenseTurn<W>> turn;  // of rungs that turn

  PHYSIM_INLINE State<W> operator()(const W& theta) const {
    const Fidelity& f = conditions->fidelity;
    if (f.motion != Motion::closed_form) return dense_state(f.integrator, n0, n1, coefficient, theta);
    const State<R> s = closed_form(*conditions, lanes->body, cast<S>(time(theta)));
    State<W> wide;
    cast_numbers(s, wide);
    return wide;
  }
  PHYSIM_INLINE W time(const W& theta) const { return n0.t + theta * (n1.t - n0.t); }
  /// Flight::at() knows a time only: going through it gives events and ends the bits that it gives.
  PHYSIM_INLINE State<W> at_time(const W& t) const { return (*this)(place_between(n0, n1, t)); }

  /// With the velocity at which it moves towards a surface of a normal and a velocity, which contacts read. What comes
  /// slower than some steps let it fall lies soon, or was laid there, and keeps the velocity that it has.
  PHYSIM_INLINE State<W> moving_at_time(const W& t, const Vec3<W>& normal, const Vec3<W>& surface = {}) const {
    State<W> s = at_time(t);
    const double part = stagger(conditions->fidelity);
    const W theta = place_between(n0, n1, t);
    if (part != 0) move_on(ahead(part, n0, n1, theta), normal, s.v - surface, theta, s);
    return s;
  }

  /// The velocity of the way itself, which that of the state may be behind or ahead of.
  PHYSIM_INLINE Vec3<W> velocity_of_way(const W& t) const {
    const Vec3<W> v = at_time(t).v;
    const double part = stagger(conditions->fidelity);
    return part == 0 ? v : v + ahead(part, n0, n1, place_between(n0, n1, t));
  }

  /// The Turn, of rungs that turn.
  PHYSIM_INLINE Turn<W> turn_at(const W& theta) const {
    return dense_turn(conditions->fidelity, turn->n0, turn->n1, turn->coefficient, theta);
  }
  PHYSIM_INLINE Turn<W> turn_at_time(const W& t) const { return turn_at(place_between(n0, n1, t)); }
  PHYSIM_INLINE Body<W> whole_body() const {
    Body<W> b;
    cast_numbers(lanes->body, b, *numbers);
    return b;
  }
  PHYSIM_INLINE Vec3<W> acceleration(const W& theta, const State<W>& s) const {
    if (!turns(conditions->fidelity)) return evaluated(*conditions_double, whole_body(), time(theta), s);
    Turn<W> slope;
    return evaluated(*conditions_double, whole_body(), turn->rotor, time(theta), s, turn_at(theta), slope);
  }

  /// A watched value at the ends of the step in the flight's own precision: the end of one step is the start of the
  /// next one to the bit, so that no crossing falls between them.
  PHYSIM_INLINE W watched_at_start(const EventSpec& spec) const {
    return cast<double>(watched_value(*conditions, lanes->body, spec, lanes->step.t, lanes->step.start));
  }
  PHYSIM_INLINE W watched_at_end(const EventSpec& spec) const {
    return cast<double>(watched_value(*conditions, lanes->body, spec, lanes->step.t_end, lanes->step.end));
  }
};

/// The dense output of the rotation; `s` is the rest of the steps.
template <class R, class S>
void dense_turns(const Course<S>& course, const Lanes<R>& l, Step<Cast<double, R>>& s, DenseLanes<R>& out) {
  using W = Cast<double, R>;
  const Fidelity& fidelity = course.conditions->fidelity;
  const int last = last_slope(fidelity);
  const TurnStep<R>& from = *l.step.turn;
  TurnStep<W>& turn = *s.turn;
  cast_numbers(from.start, turn.start);
  cast_numbers(from.end, turn.end);
  for_dense_slopes(fidelity.integrator, last, [&](int i) { cast_numbers(from.slope[i], turn.slope[i]); });
  DenseTurn<W>& to = *out.turn;
  cast_numbers(*l.rotor, to.rotor);
  to.n0 = {out.n0.t, turn.start, turn.slope[0]};
  to.n1 = {out.n1.t, turn.end, turn.slope[last]};
  const auto f = [&](const W& t, const State<W>& y, const Turn<W>& at, Turn<W>& slope) {
    return evaluated(*course.conditions_double, out.whole_body(), to.rotor, t, y, at, slope);
  };
  add_dense_slopes<true>(fidelity.integrator, s, f);
  dense_sums(fidelity.integrator, s, s.h, out.coefficient);
  dense_sums(fidelity.integrator, turn, s.h, to.coefficient);
}

/// The coefficients of interpolants that have some.
template <class R, class S>
void add_coefficients(const Course<S>& course, const Lanes<R>& l, DenseLanes<R>& out) {
  using W = Cast<double, R>;
  const Fidelity& fidelity = course.conditions->fidelity;
  Unset<Step<W>> wide;
  Step<W>& s = *wide;
  s.t = out.n0.t;
  s.h = cast<double>(l.step.h);
  s.start = out.n0.y;
  s.end = out.n1.y;
  for_dense_slopes(fidelity.integrator, last_slope(fidelity),
                   [&](int i) { cast_numbers(l.step.slope[i], s.slope[i]); });
  if (turns(fidelity)) return dense_turns(course, l, s, out);
  const auto f = [&](const W& t, const State<W>& y) {
    return evaluated(*course.conditions_double, out.whole_body(), t, y);
  };
  dense_coefficients(fidelity.integrator, s, f, out.coefficient);
}

/// Without what the additional slopes of dop853 give: for steps in which models did not give them all.
template <class R>
void drop_higher_terms(DenseLanes<R>& at) {
  const Fidelity& f = at.conditions->fidelity;
  if (f.integrator != Integrator::dop853) return;
  const auto drop = [](auto& part) {
    std::fill(part.coefficient + 3, part.coefficient + 7, std::remove_reference_t<decltype(part.coefficient[0])>{});
  };
  for_parts(f, drop, at);
}

/// The dense output of steps just taken but for its coefficients.
template <class R, class S>
void dense_ends(const Course<S>& course, const Lanes<R>& l, DenseLanes<R>& out) {
  const Conditions<S>& c = *course.conditions;
  out.conditions = course.conditions;
  out.conditions_double = course.conditions_double;
  out.lanes = &l;
  constexpr PartSet kStops = kLaunchParts | PartSet::of<MotorPart, RailPart>();
  constexpr NumberRuns kWatched = kLaunchParts.runs(), kWatchedWithStops = kStops.runs();
  out.numbers = &course.body;
  cast_numbers(l.body, out.body, has_stops(c) ? kWatchedWithStops : kWatched);
  constexpr NumberRuns kBirth = PartSet::of<BirthPart>().runs(), kWeather = kWeatherParts.runs();
  const bool reads_weather = (c.has_own_wind || c.has_own_air) && !course.watch.without_air;
  if (c.has_wind_function) cast_numbers(l.body, out.body, kBirth);  // Mach numbers need the wind ...
  if (reads_weather) cast_numbers(l.body, out.body, kWeather);      // ... and the air
  out.n0.t = cast<double>(l.step.t);
  out.n1.t = cast<double>(l.step.t_end);
  PHYSIM_ASSERT(!any(out.n1.t < out.n0.t));
  cast_numbers(l.step.start, out.n0.y);
  cast_numbers(l.step.end, out.n1.y);
  cast_numbers(l.step.slope[0].v, out.n0.a);
  cast_numbers(l.step.slope[last_slope(c.fidelity)].v, out.n1.a);
}

/// The dense output of steps just taken.
template <class R, class S>
void dense_lanes(const Course<S>& course, const Lanes<R>& l, DenseLanes<R>& out) {
  const Conditions<S>& c = *course.conditions;
  dense_ends(course, l, out);
  if (c.fidelity.motion == Motion::closed_form) return;
  if (turns(c.fidelity) || dense_coefficient_count(c.fidelity.integrator) > 0) add_coefficients(course, l, out);
}

PHYSIM_ISA_END
