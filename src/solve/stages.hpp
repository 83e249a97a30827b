// Steps stage by stage: for projectiles that push each other, which must all be in the same stage at a time. The
// arithmetic is that of a step taken at once; a step has end_slope() stages.
#pragma once

#include "solve/take_step.hpp"

PHYSIM_ISA_BEGIN

/// Calls f with the tableau of an integrator; the others have no stage but the start.
template <class F>
PHYSIM_INLINE void with_tableau(Integrator integrator, const F& f) {
  if (integrator == Integrator::heun) f(Heun{});
  if (integrator == Integrator::rk4) f(Rk4{});
  if (integrator == Integrator::rk43) f(Rk43{});
  if (integrator == Integrator::tsit5) f(Tsit5{});
  if (integrator == Integrator::dop853) f(Dop853{});
}

/// Where a stage lies in its step, 0..1 [-].
PHYSIM_INLINE double stage_place(Integrator integrator, int stage) {
  double place = 0;
  with_tableau(integrator, [&](auto tableau) { place = decltype(tableau)::c[stage]; });
  return place;
}

/// The state of a stage after the first, from the slopes before it; with all slopes there, the end of the step. `s` is
/// a Step or its TurnStep.
template <class AnyStep, class R>
PHYSIM_INLINE auto next_stage(Integrator integrator, int stage, const AnyStep& s, const R& h) {
  auto y = s.start;
  with_tableau(integrator, [&](auto tableau) {
    using Tableau = decltype(tableau);
    static_for<Tableau::kStages>([&](auto before) {
      constexpr int next = before + 1;
      if (next != stage) return;
      if constexpr (next == Tableau::kStages)
        y = end_state<Tableau>(s, h);
      else
        y = stage_state<Tableau, next>(s, h);
    });
  });
  return y;
}

/// Ends a step whose slopes are there.
template <class R>
PHYSIM_INLINE void finish_stages(Integrator integrator, Step<R>& s) {
  if (end_slope(integrator) == 1) return euler_end(integrator, s);
  s.end = next_stage(integrator, end_slope(integrator), s, s.h);
}
/// The same for the rotation.
template <class R, class S>
PHYSIM_INLINE void finish_turn_stages(const Conditions<S>& c, const Rotor<R>& rotor, Step<R>& s) {
  const Integrator integrator = c.fidelity.integrator;
  if (end_slope(integrator) == 1)
    euler_turn(c, rotor, s);
  else
    s.turn->end = next_stage(integrator, end_slope(integrator), *s.turn, s.h);
  s.turn->end = on_unit_length(c.fidelity, s.turn->end);
}

PHYSIM_ISA_END
