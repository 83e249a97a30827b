// Step control of adaptive integrators.
//
// Proportional-integral control: h_new = h * safety * e^-alpha * e_previous^beta with e the error over tolerance,
// alpha = 0.7 / q and beta = 0.4 / q where the estimate of a step's error falls as h^q; after a rejected step h_new =
// h * safety * e^(-1/q).
// The integral part keeps the step from oscillating where the drag curve bends. Powers are rough
// (math/rough_power.hpp): the next step waits for them, and need not be known better than an error is estimated. With
// safety = 0.87 a step with an error that requires neither a longer nor a shorter one stays where exact powers with 0.9
// would leave it.
//
// Sources: K. Gustafsson, "Control theoretic techniques for stepsize selection in explicit Runge-Kutta methods", ACM
// Trans. Math. Softw. 17 (1991) 533-554; E. Hairer, G. Wanner, Solving ODEs II (1996), sec. IV.2, eq. 2.43c.
#pragma once

#include "base/assert.hpp"
#include "math/rough_power.hpp"
#include "math/vec3.hpp"
#include "physim/fidelity.hpp"
#include "solve/explicit_runge_kutta.hpp"

namespace physim {

inline constexpr double kSafety = 0.87;  // of the step that the error allows [-]

template <class R>
struct StepControl {
  R log_previous;  // log2 of the last accepted error, squared
  R h;             // next step to try [s]
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// As clamp(), of what mostly lies between: a single number passes without waiting for comparisons, which the processor
/// foresees.
template <class R>
PHYSIM_INLINE R seldom_clamped(const R& x, const R& low, const R& high) {
  if constexpr (std::is_floating_point_v<R>) {
    if (x > low && x < high) [[likely]]
      return x;
  }
  return clamp(x, low, high);
}

/// The step to try after one of length h with error squared `error`; `accepted` lanes use the integral part too.
template <class R>
PHYSIM_INLINE R next_step(Integrator integrator, const R& h, const R& error, const MaskOf<R>& accepted,
                          StepControl<R>& control) {
  PHYSIM_ASSERT(is_adaptive(integrator));
  const double q = order_of(integrator);
  // Errors are squared, hence the factor 1/2. An error that is not a number counts as huge.
  const R huge = constant<R>(1e16);
  const R e = log2_roughly(seldom_clamped(select(error < huge, error, huge), constant<R>(1e-16), huge));
  const R with_memory = constant<R>(-0.35 / q) * e + constant<R>(0.2 / q) * control.log_previous;
  const R after_rejection = constant<R>(-0.5 / q) * e;
  // The bounds are those of h, not of a factor: only one product waits for the error.
  const R next = (constant<R>(kSafety) * h) * exp2_roughly(select(accepted, with_memory, after_rejection));
  control.log_previous = select(accepted, e, control.log_previous);
  return seldom_clamped(next, constant<R>(0.1) * h, constant<R>(5) * h);
}

/// Judges steps of length h by their error squared: returns those of the lanes asked for in which it is accepted, and
/// sets control.h to the next step to try.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> judge_error(Integrator integrator, const R& h, const R& error, const MaskOf<R>& asked,
                                    S max_step, StepControl<R>& control) {
  const MaskOf<R> accepted = asked & (error <= R(S(1)));
  control.h = min(next_step(integrator, h, error, accepted, control), R(max_step));
  return accepted;
}

/// Steps so short that they do not move the clock, or of no length.
template <class R>
PHYSIM_INLINE MaskOf<R> stands_still(const R& t, const R& h, const R& t_end) {
  return (t_end <= t) | !(h > R(ScalarOf<R>(0)));
}

/// First step: the time in which the velocity would change by a few times the root of the tolerance, of the estimate's
/// order.
template <class R, class S>
PHYSIM_INLINE R first_step(Integrator integrator, const State<R>& start, const Vec3<R>& a, S relative, S absolute) {
  PHYSIM_ASSERT(is_adaptive(integrator) && relative >= S(0) && absolute >= S(0));
  const R tiny = constant<R>(1e-30);
  const R speed = length(start.v);
  const R tolerance = relative + absolute / max(speed, constant<R>(1e-3));
  const R reach =
      exp2_roughly(log2_roughly(max(tolerance, constant<R>(1e-16))) * constant<R>(1.0 / order_of(integrator)));
  const R h = reach * max(speed, constant<R>(1e-3)) / max(length(a), tiny);
  return min(max(h, constant<R>(1e-6)), R(S(1)));
}

/// First step of a rotation: a small part of the time of one turn.
template <class R>
PHYSIM_INLINE R first_turn_step(Integrator integrator, const TurnStep<R>& s) {
  const R rate = length(s.slope[0].u);
  const R part = constant<R>(order_of(integrator) >= 8 ? 0.1 : 0.03);
  return max(part / max(rate, constant<R>(1e-6)), constant<R>(1e-6));
}

PHYSIM_ISA_END
