// Takes one step with any integrator, chosen at run time: one switch per step, uniform over all lanes.
#pragma once

#include <type_traits>

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "model/acceleration.hpp"
#include "model/closed_form.hpp"
#include "solve/explicit_runge_kutta.hpp"

PHYSIM_ISA_BEGIN

/// Closed forms and adaptive integrators choose their steps; the others need one given.
PHYSIM_INLINE_ALWAYS bool steps_itself(const Fidelity& granted) {
  return granted.motion == Motion::closed_form || is_adaptive(granted.integrator);
}

/// The original's frame, in its order: position, then velocity, both from the old state; then damping; then the
/// acceleration for the next frame from the forces of this one. slope[].v is the acceleration register: zero at launch.
/// With `original_one_shot_forces`, forces are felt once, added to the register and never taken out of it again.
template <class R, class S>
PHYSIM_NOINLINE void classic_frame(const Conditions<S>& c, const Body<R>& b, Step<R>& s) {
  s.end.x = s.start.x + s.start.v * s.h;
  s.end.v = s.start.v + s.slope[0].v * s.h;
  if (c.fidelity.drag == DragModel::damping) s.end.v *= exp(-(b.damping_rate * s.h));
  s.slope[1] = {s.end.v, evaluated_original(c, b, s.t, s.start)};
}

/// Steps of order one move straight, with the velocity at one of their ends: the path through their places has another
/// velocity, by this part of what a step changes theirs [-]. A velocity v of steps of length h moves with v + part a h.
/// The original loop's are taken as they are.
template <class Method>
inline constexpr double stagger_of = std::is_same_v<Method, SemiImplicitEuler> ? 0.5
                                     : std::is_same_v<Method, ExplicitEuler>   ? -0.5
                                                                               : 0;
PHYSIM_INLINE double stagger(const Fidelity& granted) {
  if (granted.motion == Motion::closed_form) return 0;
  return with_method(granted.integrator, [](auto method) PHYSIM_INLINE_LAMBDA { return stagger_of<decltype(method)>; });
}

/// By how much a motion is faster than its velocity of steps of length h: `slope` is that of such a step, `part` that
/// of stagger().
template <class R>
PHYSIM_INLINE_ALWAYS Vec3<R> lead(const Vec3<R>& slope, const R& h, double part) {
  return slope * h * constant<R>(part);
}

/// Semi-implicit Euler: positions move with the new velocity.
template <class R>
PHYSIM_INLINE_ALWAYS State<R> semi_implicit_end(const State<R>& start, const Vec3<R>& acceleration, const R& h) {
  State<R> end;
  end.v = start.v + acceleration * h;
  end.x = start.x + end.v * h;
  return end;
}
template <class R>
PHYSIM_INLINE_ALWAYS void semi_implicit_end(Step<R>& s) {
  s.end = semi_implicit_end(s.start, s.slope[0].v, s.h);
}

/// State after a time t under a constant acceleration: x + v t + a t^2/2, v + a t.
template <class R>
PHYSIM_INLINE State<R> moved_steadily(const State<R>& s, const Vec3<R>& a, const R& t) {
  return {s.x + (s.v * t + a * (constant<R>(0.5) * t * t)), s.v + a * t};
}

/// Semi-implicit Euler of a rotation: what points is turned by the new rates.
template <class R, class S>
PHYSIM_INLINE_ALWAYS void semi_implicit_turn(const Conditions<S>& c, const Rotor<R>& rotor, Step<R>& s) {
  TurnStep<R>& t = *s.turn;
  t.end = t.start + t.slope[0] * s.h;
  if (is_in_repose(c.fidelity)) return;
  const R zero(S(0));
  const Turn<R> pointing =
      turn_slope(c, rotor, Turn<R>{t.start.w, t.start.u, t.end.h}, Vec3<R>{zero, zero, zero}) * s.h;
  t.end.w = t.start.w + pointing.w;
  t.end.u = t.start.u + pointing.u;
}

/// A semi-implicit Euler step of all that is flown, but for the length of what points.
template <class R, class S>
PHYSIM_INLINE_ALWAYS void take_semi_implicit_step(const Conditions<S>& c, Flyer<R>& l) {
  semi_implicit_end(l.step);
  if (turns(c.fidelity)) semi_implicit_turn(c, *l.rotor, l.step);
}

/// The error comes last, behind the last slope: what it is measured by is known before, and is divided by then.
template <class R, class S>
PHYSIM_INLINE_ALWAYS R squared_ratio(const Vec3<R>& error, const Vec3<R>& value, S relative, S absolute) {
  return length_squared(error) * (S(1) / (absolute * absolute + relative * relative * length_squared(value)));
}

/// The squares of two errors over tolerance. The lengths of vectors are compared, not their components, so that turning
/// the axes changes nothing.
template <class R>
struct ErrorPair {
  R first;
  R second;
};
template <class R, class S>
PHYSIM_INLINE_ALWAYS ErrorPair<R> squared_errors(const State<R>& e, const State<R>& end, S relative, S absolute) {
  return {squared_ratio(e.x, end.x, relative, absolute), squared_ratio(e.v, end.v, relative, absolute)};
}
/// The errors of what points, a unit vector or quaternion, and of what turns. The roll of the axis form is only shown.
template <class R, class S>
PHYSIM_INLINE_ALWAYS ErrorPair<R> squared_errors(const Turn<R>& e, const Turn<R>& end, S relative, S absolute) {
  return {squared_ratio(e.u, end.u, relative, absolute), squared_ratio(e.h, end.h, relative, absolute)};
}

/// The larger of two errors; one that is not a number, with which no step is accepted, is the worst of all.
template <class R>
PHYSIM_INLINE_ALWAYS R worse(const R& a, const R& b) {
  return select((a > b) | (a != a), a, b);
}

/// Error over tolerance, squared: the worse of position and velocity, or of direction and rate; `s` is a Step or its
/// TurnStep.
template <class Tableau, class AnyStep, class R, class S>
PHYSIM_NOINLINE R embedded_error_squared(const AnyStep& s, const R& h, S relative, S absolute) {
  constexpr int kSlopes = Tableau::kStages + 1;
  const auto e =
      squared_errors(step_sum<Weights<Tableau::kError>, kSlopes>(s.slope.item, h), s.end, relative, absolute);
  return worse(e.first, e.second);
}

/// The estimates of orders 5 and 3 combined: e5^2 / sqrt(e5^2 + 0.01 e3^2) (Hairer, Norsett and Wanner, sec. II.10).
template <class R>
PHYSIM_INLINE_ALWAYS R combined_error_squared(const R& e5, const R& e3) {
  using S = ScalarOf<R>;
  const R sum = e5 + S(0.01) * e3;
  return select(sum > R(S(0)), e5 * e5 / max(sum, R(S(1e-37))), sum);
}

template <class Tableau, class AnyStep, class R, class S>
PHYSIM_NOINLINE R two_errors_squared(const AnyStep& s, const R& h, S relative, S absolute) {
  constexpr int kSlopes = Tableau::kStages;
  const auto e5 =
      squared_errors(step_sum<Weights<Tableau::kError5>, kSlopes>(s.slope.item, h), s.end, relative, absolute);
  const auto e3 =
      squared_errors(step_sum<Weights<Tableau::kError3>, kSlopes>(s.slope.item, h), s.end, relative, absolute);
  return worse(combined_error_squared(e5.first, e3.first), combined_error_squared(e5.second, e3.second));
}

/// The estimated error of an adaptive integrator's step over tolerance, squared; zero of the others.
template <class AnyStep, class R, class S>
PHYSIM_INLINE_ALWAYS R error_squared(Integrator integrator, const AnyStep& s, const R& h, S relative, S absolute) {
  return with_method(integrator, [&](auto method) PHYSIM_INLINE_LAMBDA -> R {
    using Method = decltype(method);
    if constexpr (HasErrorWeights<Method>) return embedded_error_squared<Method>(s, h, relative, absolute);
    if constexpr (HasTwoErrors<Method>) return two_errors_squared<Method>(s, h, relative, absolute);
    if constexpr (!Adaptive<Method>) return R(S(0));
  });
}

/// Flyers with steps taken side by side; more at a time hide no more latency.
inline constexpr int kMostSets = 4;
template <class R>
struct FlyerSet {
  Flyer<R>* flyer[kMostSets];
  Step<R>* steps[kMostSets];
  int count;

  PHYSIM_INLINE_ALWAYS explicit FlyerSet(Flyer<R>& alone) : count(0) { add(alone); }
  PHYSIM_INLINE_ALWAYS FlyerSet() : count(0) {}
  PHYSIM_INLINE_ALWAYS void add(Flyer<R>& f) {
    PHYSIM_ASSERT(count >= 0 && count < kMostSets);
    flyer[count] = &f;
    steps[count++] = &f.step;
  }
};

/// What the accelerations of its step are asked for.
template <class R, class S>
PHYSIM_INLINE_ALWAYS StepAsked<R> step_asked(const Conditions<S>& c, const Flyer<R>& l) {
  return is_braked(c) ? StepAsked<R>{l.step.h, l.drag_rate} : no_step<R>();
}

/// Sets what points at the end of a step back to length one, where the rotation is flown.
template <class R>
PHYSIM_INLINE_ALWAYS void set_unit_length(const Fidelity& f, Step<R>& s) {
  if (turns(f)) s.turn->end = on_unit_length(f, s.turn->end);
}

/// Reaches the ends of steps that turn; see reach_ends().
template <class R, class S>
PHYSIM_NOINLINE void reach_turning_ends(const Conditions<S>& c, const FlyerSet<R>& w) {
  PHYSIM_ASSERT(c.fidelity.motion == Motion::force && w.count > 0);
  const auto f = [&](int i, const R& t, const State<R>& y, const Turn<R>& turn, Vec3<R>& a, Turn<R>& slope) {
    evaluate(c, w.flyer[i]->body, *w.flyer[i]->rotor, t, y, turn, step_asked(c, *w.flyer[i]), a, slope);
  };
  with_method(c.fidelity.integrator, [&](auto method) PHYSIM_INLINE_LAMBDA {
    using Method = decltype(method);
    if constexpr (RungeKutta<Method>) {
      runge_kutta_ends<Method, true>(w.steps, w.count, f);
    } else if constexpr (std::is_same_v<Method, SemiImplicitEuler>) {
      for (int i = 0; i < w.count; ++i) take_semi_implicit_step(c, *w.flyer[i]);
    } else {
      static_assert(std::is_same_v<Method, ClassicLoop>);  // is not granted with a rotation
      PHYSIM_UNREACHABLE();
    }
  });
  for (int i = 0; i < w.count; ++i) set_unit_length(c.fidelity, *w.steps[i]);
}

/// Takes some steps of a cohort side by side, each from its start at t to its end at t_end = t + h, without the slopes
/// there; slope[0] is given.
template <class R, class S>
PHYSIM_INLINE_ALWAYS void reach_ends(const Conditions<S>& c, const FlyerSet<R>& w) {
  if (turns(c.fidelity)) return reach_turning_ends(c, w);
  if (c.fidelity.motion == Motion::closed_form) {
    for (int i = 0; i < w.count; ++i) w.steps[i]->end = closed_form(c, w.flyer[i]->body, w.steps[i]->t_end);
    return;
  }
  const auto f = [&](int i, const R& t, const State<R>& y, Vec3<R>& a) {
    evaluate(c, w.flyer[i]->body, t, y, step_asked(c, *w.flyer[i]), a);
  };
  with_method(c.fidelity.integrator, [&](auto method) PHYSIM_INLINE_LAMBDA {
    using Method = decltype(method);
    if constexpr (RungeKutta<Method>) {
      runge_kutta_ends<Method, false>(w.steps, w.count, f);
    } else if constexpr (std::is_same_v<Method, SemiImplicitEuler>) {
      for (int i = 0; i < w.count; ++i) semi_implicit_end(*w.steps[i]);
    } else {
      static_assert(std::is_same_v<Method, ClassicLoop>);
      for (int i = 0; i < w.count; ++i) classic_frame(c, w.flyer[i]->body, *w.steps[i]);
    }
  });
}

/// The slope at a time, as slope[place]: place 0 where the step starts, else at the state that it has reached. Rungs
/// that drag brakes ask for the length of the step first.
template <class R, class S>
PHYSIM_INLINE_ALWAYS void set_slope(const Conditions<S>& c, Flyer<R>& l, int place, const R& t) {
  PHYSIM_ASSERT(place >= 0 && place < kMaxSlopes);
  Step<R>& s = l.step;
  const State<R>& y = place == 0 ? s.start : s.end;
  s.slope[place].x = y.v;
  const StepAsked<R> step = step_asked(c, l);
  if (turns(c.fidelity)) {
    const Turn<R>& turn = place == 0 ? s.turn->start : s.turn->end;
    evaluate(c, l.body, *l.rotor, t, y, turn, step, s.slope[place].v, s.turn->slope[place]);
  } else {
    evaluate(c, l.body, t, y, step, s.slope[place].v);
  }
}
template <class R, class S>
PHYSIM_INLINE_ALWAYS void set_slope(const Conditions<S>& c, Flyer<R>& l, int place) {
  set_slope(c, l, place, place == 0 ? l.step.t : l.step.t_end);
}

/// As reach_ends(), with the slope at the end; adaptive integrators also leave the error, squared.
template <class R, class S>
PHYSIM_INLINE_ALWAYS void take_steps(const Conditions<S>& c, const FlyerSet<R>& w, S relative, S absolute) {
  reach_ends(c, w);
  const bool closed = c.fidelity.motion == Motion::closed_form;
  const Integrator integrator = c.fidelity.integrator;
  if (is_classic(c.fidelity)) return;  // a frame leaves its own
  const int last = closed ? 1 : end_slope(integrator);
  for (int i = 0; i < w.count; ++i) {
    Step<R>& s = *w.steps[i];
    set_slope(c, *w.flyer[i], last);
    if (closed || !is_adaptive(integrator)) continue;
    s.error = error_squared(integrator, s, s.h, relative, absolute);
    if (turns(c.fidelity)) s.error = worse(s.error, error_squared(integrator, *s.turn, s.h, relative, absolute));
  }
}

/// Takes one step; see take_steps().
template <class R, class S>
PHYSIM_INLINE_ALWAYS void take_step(const Conditions<S>& c, Flyer<R>& flyer, S relative, S absolute) {
  take_steps(c, FlyerSet<R>(flyer), relative, absolute);
}

PHYSIM_ISA_END
