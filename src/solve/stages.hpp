// Steps stage by stage: for projectiles that push each other, which must all be in the same stage at a time. The
// arithmetic is that of a step taken at once; a step has end_slope() stages.
#pragma once

#include "base/assert.hpp"
#include "solve/take_step.hpp"

PHYSIM_ISA_BEGIN

/// Where a stage lies in its step, 0..1 [-].
PHYSIM_INLINE_ALWAYS double stage_place(Integrator integrator, int stage) {
  PHYSIM_ASSERT(stage >= 0 && stage < end_slope(integrator));
  return with_method(integrator, [&](auto method) PHYSIM_INLINE_LAMBDA { return double(method.c[stage]); });
}

/// When a stage is [s].
template <class R>
PHYSIM_INLINE_ALWAYS R stage_time(Integrator integrator, int stage, const Step<R>& s) {
  return s.t + s.h * constant<R>(stage_place(integrator, stage));
}

/// The state of a stage after the first, from the slopes before it; with all slopes there, the end of the step. `s` is
/// a Step or its TurnStep. Methods without a tableau have no such stage.
template <class AnyStep, class R>
PHYSIM_INLINE_ALWAYS auto next_stage(Integrator integrator, int stage, const AnyStep& s, const R& h) {
  PHYSIM_ASSERT(stage >= 1 && stage <= end_slope(integrator));
  auto y = s.start;
  with_method(integrator, [&](auto method) PHYSIM_INLINE_LAMBDA {
    using Method = decltype(method);
    if constexpr (RungeKutta<Method>) {
      static_for<Method::kStages>([&](auto before) {
        constexpr int next = before + 1;
        if (next != stage) return;
        if constexpr (next == Method::kStages)
          y = end_state<Method>(s, h);
        else
          y = stage_state<Method, next>(s, h);
      });
    }
  });
  return y;
}

/// Continues from a stage to the next: the slope of the stage, then the state of the next one, or the end of the step.
/// The state of the stage is where the step starts, or step.end.
template <class R, class S>
PHYSIM_INLINE_ALWAYS void advance_stage(const Conditions<S>& c, int stage, Flyer<R>& l) {
  const Integrator integrator = c.fidelity.integrator;
  PHYSIM_ASSERT(stage >= 0 && stage < end_slope(integrator) && c.fidelity.motion != Motion::closed_form);
  Step<R>& s = l.step;
  if (is_classic(c.fidelity)) return classic_frame(c, l.body, s);
  set_slope(c, l, stage, stage_time(integrator, stage, s));
  if (integrator == Integrator::semi_implicit_euler)
    take_semi_implicit_step(c, l);
  else
    for_parts(
        c.fidelity, [&](auto& part) { part.end = next_stage(integrator, stage + 1, part, s.h); }, s);
  if (stage + 1 == end_slope(integrator)) set_unit_length(c.fidelity, s);
}

PHYSIM_ISA_END
