// Steps stage by stage: for projectiles that push each other, which must all be in the same stage at a time. The
// arithmetic is that of a step taken at once; a step has end_slope() stages.
#pragma once

#include "base/assert.hpp"
#include "solve/take_step.hpp"

PHYSIM_ISA_BEGIN

/// Where a stage lies in its step, 0..1 [-].
PHYSIM_INLINE double stage_place(Integrator integrator, int stage) {
  PHYSIM_ASSERT(stage >= 0 && stage < end_slope(integrator));
  return with_method(integrator, [&](auto method) PHYSIM_INLINE_LAMBDA { return double(method.c[stage]); });
}

/// The state of a stage after the first, from the slopes before it; with all slopes there, the end of the step. `s` is
/// a Step or its TurnStep. Methods without a tableau have no such stage.
template <class AnyStep, class R>
PHYSIM_INLINE auto next_stage(Integrator integrator, int stage, const AnyStep& s, const R& h) {
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

/// Ends a step whose slopes are there.
template <class R>
PHYSIM_INLINE void finish_stages(Integrator integrator, Step<R>& s) {
  PHYSIM_ASSERT(integrator != Integrator::classic);  // a frame ends itself
  if (integrator == Integrator::semi_implicit_euler) return semi_implicit_end(s);
  s.end = next_stage(integrator, end_slope(integrator), s, s.h);
}
/// Ends a rotation's step whose slopes are there.
template <class R, class S>
PHYSIM_INLINE void finish_turn_stages(const Conditions<S>& c, const Rotor<R>& rotor, Step<R>& s) {
  const Integrator integrator = c.fidelity.integrator;
  if (integrator == Integrator::semi_implicit_euler)
    semi_implicit_turn(c, rotor, s);
  else
    s.turn->end = next_stage(integrator, end_slope(integrator), *s.turn, s.h);
  s.turn->end = on_unit_length(c.fidelity, s.turn->end);
}

PHYSIM_ISA_END
