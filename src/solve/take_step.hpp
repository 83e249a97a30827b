// Takes one step with any integrator, chosen at run time: one switch per step, uniform over all lanes.
#pragma once

#include "model/acceleration.hpp"
#include "model/closed_form.hpp"
#include "solve/explicit_runge_kutta.hpp"

PHYSIM_ISA_BEGIN

/// Number of the slope at the end of a step, which is the first slope of the next one.
PHYSIM_INLINE int end_slope(Integrator integrator) {
  switch (integrator) {
    case Integrator::heun:
      return Heun::kStages;
    case Integrator::rk4:
      return Rk4::kStages;
    case Integrator::tsit5:
      return Tsit5::kStages;
    case Integrator::dop853:
      return Dop853::kStages;
    default:
      return 1;
  }
}

PHYSIM_INLINE bool is_adaptive(Integrator integrator) {
  return integrator == Integrator::tsit5 || integrator == Integrator::dop853;
}

/// Closed forms and adaptive integrators choose their steps; the others need one given.
PHYSIM_INLINE bool steps_itself(const Fidelity& granted) {
  return granted.motion == Motion::closed_form || is_adaptive(granted.integrator);
}

#ifndef EVALATTR
#define EVALATTR [[gnu::noinline]]
#endif
/// The acceleration behind one call, so that twelve stages do not become twelve copies of all models.
template <class R, class S>
EVALATTR void evaluate(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s, Vec3<R>& a) {
  a = acceleration(c, b, t, s);
}

/// The original's frame, in its order: position, then velocity, both from the old state; then damping; then the
/// acceleration for the next frame from the forces of this one. slope[].v is the acceleration register: zero at launch.
/// With `original_one_shot_forces`, forces are felt once, added to the register and never taken out of it again.
template <class R, class S>
PHYSIM_INLINE void classic_frame(const Conditions<S>& c, const Body<R>& b, Step<R>& s) {
  s.end.x = s.start.x + s.start.v * s.h;
  s.end.v = s.start.v + s.slope[0].v * s.h;
  if (c.fidelity.drag == DragModel::damping) s.end.v *= exp(-(b.damping_rate * s.h));
  Vec3<R> a = weight_per_mass(c, b, s.start.x);
  if (c.fidelity.motion == Motion::force) {
    const State<R>& felt = c.fidelity.original_one_shot_forces ? b.launch : s.start;
    if (c.fidelity.drag == DragModel::linear_quadratic || c.fidelity.drag == DragModel::equation) a += drag(c, b, felt);
    if (c.has_applied) a += c.fidelity.original_one_shot_forces ? b.applied : applied(c, b, s.t);
  }
  if (c.fidelity.planar) a -= b.plane * dot(b.plane, a);
  if (c.has_frozen) a = component_product(a, b.free);
  s.slope[1] = {s.end.v, a};
}

/// Euler's methods: with the old velocity, or with the new one.
template <class R>
PHYSIM_INLINE void euler_end(Integrator integrator, Step<R>& s) {
  s.end.v = s.start.v + s.slope[0].v * s.h;
  s.end.x = s.start.x + (integrator == Integrator::explicit_euler ? s.slope[0].x : s.end.v) * s.h;
}

template <class R, class S>
PHYSIM_INLINE R squared_ratio(const Vec3<R>& error, const Vec3<R>& value, S relative, S absolute) {
  const R scale = absolute + relative * length(value);
  return length_squared(error) / (scale * scale);
}

template <class Tableau, int Which>
struct ErrorWeights {
  static constexpr double at(int j) {
    if constexpr (Which == 5) return Tableau::kError5[j];
    if constexpr (Which == 3) return Tableau::kError3[j];
    if constexpr (Which == 0) return Tableau::kError[j];
  }
};

/// Error over tolerance, squared: the worse of position and velocity. Their lengths are compared, not their
/// components, so that turning the axes changes nothing.
template <class R, class S>
PHYSIM_INLINE R tsit5_error_squared(const Step<R>& s, S relative, S absolute) {
  const State<R> e = weighted_sum<ErrorWeights<Tsit5, 0>, 7>(s.slope) * s.h;
  return max(squared_ratio(e.x, s.end.x, relative, absolute), squared_ratio(e.v, s.end.v, relative, absolute));
}

/// The estimates of orders 5 and 3 combined: e5^2 / sqrt(e5^2 + 0.01 e3^2) (Hairer, Norsett and Wanner, sec. II.10).
template <class R>
PHYSIM_INLINE R combined_error_squared(const R& e5, const R& e3) {
  using S = ScalarOf<R>;
  const R sum = e5 + S(0.01) * e3;
  return select(sum > R(S(0)), e5 * e5 / max(sum, R(S(1e-37))), R(S(0)));
}

template <class R, class S>
PHYSIM_INLINE R dop853_error_squared(const Step<R>& s, S relative, S absolute) {
  const State<R> e5 = weighted_sum<ErrorWeights<Dop853, 5>, 12>(s.slope) * s.h;
  const State<R> e3 = weighted_sum<ErrorWeights<Dop853, 3>, 12>(s.slope) * s.h;
  const R position = combined_error_squared(squared_ratio(e5.x, s.end.x, relative, absolute),
                                            squared_ratio(e3.x, s.end.x, relative, absolute));
  const R velocity = combined_error_squared(squared_ratio(e5.v, s.end.v, relative, absolute),
                                            squared_ratio(e3.v, s.end.v, relative, absolute));
  return max(position, velocity);
}

/// The acceleration at a time and state, by value.
template <class R, class S>
PHYSIM_INLINE Vec3<R> evaluated(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& y) {
  Vec3<R> a;
  evaluate(c, b, t, y, a);
  return a;
}

/// Takes some steps of a cohort side by side, each from its start at t to its end at t_end = t + h, without the slopes
/// there; slope[0] is given.
template <class R, class S>
PHYSIM_INLINE void reach_ends(const Conditions<S>& c, const Body<R>* const* bodies, Step<R>* const* steps, int count) {
  const auto f = [&](int i, const R& t, const State<R>& y) { return evaluated(c, *bodies[i], t, y); };
  const Integrator integrator = c.fidelity.integrator;
  if (c.fidelity.motion == Motion::closed_form) {
    for (int i = 0; i < count; ++i) steps[i]->end = closed_form(c, *bodies[i], steps[i]->t_end);
  } else if (integrator == Integrator::classic) {
    for (int i = 0; i < count; ++i) classic_frame(c, *bodies[i], *steps[i]);
  } else if (integrator < Integrator::heun) {
    for (int i = 0; i < count; ++i) euler_end(integrator, *steps[i]);
  } else if (integrator == Integrator::heun) {
    runge_kutta_ends<Heun>(steps, count, f);
  } else if (integrator == Integrator::rk4) {
    runge_kutta_ends<Rk4>(steps, count, f);
  } else if (integrator == Integrator::tsit5) {
    runge_kutta_ends<Tsit5>(steps, count, f);
  } else {
    runge_kutta_ends<Dop853>(steps, count, f);
  }
}
template <class R, class S>
PHYSIM_INLINE void reach_end(const Conditions<S>& c, const Body<R>& b, Step<R>& s) {
  const Body<R>* body = &b;
  Step<R>* step = &s;
  reach_ends(c, &body, &step, 1);
}

/// The same with the slope at the end; adaptive integrators also leave the error, squared.
template <class R, class S>
PHYSIM_INLINE void take_steps(const Conditions<S>& c, const Body<R>* const* bodies, S relative, S absolute,
                              Step<R>* const* steps, int count) {
  reach_ends(c, bodies, steps, count);
  const bool closed = c.fidelity.motion == Motion::closed_form;
  const Integrator integrator = c.fidelity.integrator;
  if (!closed && integrator == Integrator::classic) return;  // a frame leaves its own
  const int last = closed ? 1 : end_slope(integrator);
  for (int i = 0; i < count; ++i) {
    Step<R>& s = *steps[i];
    s.slope[last] = {s.end.v, evaluated(c, *bodies[i], s.t_end, s.end)};
    if (closed) continue;
    if (integrator == Integrator::tsit5) s.error = tsit5_error_squared(s, relative, absolute);
    if (integrator == Integrator::dop853) s.error = dop853_error_squared(s, relative, absolute);
  }
}

/// Takes one step; see take_steps().
template <class R, class S>
PHYSIM_INLINE void take_step(const Conditions<S>& c, const Body<R>& b, S relative, S absolute, Step<R>& s) {
  const Body<R>* body = &b;
  Step<R>* step = &s;
  take_steps(c, &body, relative, absolute, &step, 1);
}

PHYSIM_ISA_END
