// A frame: the step of one pack (or one row) of a world from now to the next moment.
//
// Closed forms and fixed-step integrators take it as one step, the same as in a Flight. Adaptive integrators try it as
// one step too and divide it where their error estimate asks for it; nothing is remembered from frame to frame.
#pragma once

#include "solve/lanes.hpp"

namespace physim {

/// Parts that an adaptive integrator may divide a frame into before it is given up.
inline constexpr int kMaxSubsteps = 1000;

}  // namespace physim

PHYSIM_ISA_BEGIN

/// The first slope of a frame: what the last one left (the original loop), or the acceleration where it stands.
template <class R, class S>
PHYSIM_INLINE void first_slope(const Conditions<S>& c, const Body<R>& b, const Rotor<R>& rotor, const Vec3<R>& carried,
                               Step<R>& s) {
  if (c.fidelity.motion == Motion::closed_form) return;
  if (c.fidelity.integrator == Integrator::classic) {
    s.slope[0] = {s.start.v, carried};
    return;
  }
  set_slope(c, b, rotor, 0, s);
}

/// Divides a frame of an adaptive integrator. `accept(step, lanes)` is told of every part accepted, by the lanes in
/// which it was, and says whether to stop there. Returns the lanes that did not get through. s.start is the end of the
/// frame then.
template <class R, class S, class Accept>
PHYSIM_INLINE MaskOf<R> divide_frame(const Course<S>& course, const Body<R>& b, const Rotor<R>& rotor,
                                     const MaskOf<R>& lanes, Step<R>& s, const Accept& accept) {
  const Conditions<S>& c = *course.conditions;
  const R zero(S(0));
  const R t0 = s.t;
  const R frame = s.h;
  const R t_end = s.t_end;
  StepControl<R> control{zero, frame};
  R passed = zero;
  MaskOf<R> under_way = lanes;
  set_slope(c, b, rotor, 0, s);
  for (int tries = 0; tries < kMaxSubsteps && any(under_way); ++tries) {
    const R left = frame - passed;
    const auto reaches = control.h >= left;
    s.h = select(reaches, left, control.h);
    s.t_end = select(reaches, t_end, t0 + (passed + s.h));
    take_step(c, b, rotor, course.plan.relative, course.plan.absolute, s);
    const MaskOf<R> accepted = under_way & (s.error <= R(S(1)));
    control.h = next_step(c.fidelity.integrator, s.h, s.error, accepted, control);
    if (any(accepted) && accept(s, accepted)) return under_way;
    passed = select(accepted, select(reaches, frame, passed + s.h), passed);
    s.t = select(accepted, s.t_end, s.t);
    s.start = select(accepted, s.end, s.start);
    s.slope[0] = select(accepted, s.slope[end_slope(c.fidelity.integrator)], s.slope[0]);
    if (turns(c.fidelity)) {
      s.turn->start = select(accepted, s.turn->end, s.turn->start);
      s.turn->slope[0] = select(accepted, s.turn->slope[end_slope(c.fidelity.integrator)], s.turn->slope[0]);
    }
    under_way = under_way & !(accepted & reaches);
  }
  return under_way;
}

/// Takes a frame; s.start, s.t, s.h and s.t_end are given, s.end is where it ends. Returns lanes that did not get
/// there.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> take_frame(const Course<S>& course, const Body<R>& b, const Rotor<R>& rotor,
                                   const Vec3<R>& carried, const MaskOf<R>& lanes, Step<R>& s) {
  const Conditions<S>& c = *course.conditions;
  if (!is_adaptive(c.fidelity.integrator) || c.fidelity.motion == Motion::closed_form) {
    first_slope(c, b, rotor, carried, s);
    reach_end(c, b, rotor, s);
    return R(S(0)) != R(S(0));
  }
  const State<R> start = s.start;
  Unset<Turn<R>> turn;
  if (turns(c.fidelity)) *turn = s.turn->start;
  const MaskOf<R> lost =
      divide_frame(course, b, rotor, lanes, s, [](const Step<R>&, const MaskOf<R>&) { return false; });
  s.end = s.start;
  s.start = start;
  if (turns(c.fidelity)) s.turn->end = s.turn->start, s.turn->start = *turn;
  return lost;
}

PHYSIM_ISA_END
