// Step control of adaptive integrators.
//
// Proportional-integral control, linear in logarithms: after a step of error e over tolerance
//
//   h_new = h (1 - alpha ln(e / aim) + beta ln(e_previous / aim)), alpha = 0.7 / q, beta = 0.4 / q, aim = 1/4
//
// where the estimate of a step's error falls as h^q, which is h (e / aim)^-alpha (e_previous / aim)^beta near the aim
// and grows slower far from it; after a rejected step h_new = 0.9 h e^(-1/q). The integral part keeps the step from
// oscillating where the drag curve bends.
//
// A flight waits for the length of its next step, so that few operations lead to it: the logarithm is what the bits of
// a number say (LogByBits), and of the sum all but that is there before.
//
// Sources: K. Gustafsson, "Control theoretic techniques for stepsize selection in explicit Runge-Kutta methods", ACM
// Trans. Math. Softw. 17 (1991) 533-554; E. Hairer, G. Wanner, Solving ODEs II (1996), sec. IV.2, eq. 2.43c.
#pragma once

#include "base/assert.hpp"
#include "math/rough_power.hpp"
#include "math/vec3.hpp"
#include "physim/fidelity.hpp"
#include "solve/explicit_runge_kutta.hpp"

PHYSIM_ISA_BEGIN

inline constexpr double kLogAim = -4;  // log2 of the error aimed at, squared

template <class R>
struct StepControl {
  R log_previous;  // log2 of the last accepted error, squared, roughly
  R h;             // next step to try [s]

  /// Before a first step.
  PHYSIM_INLINE static StepControl of(const R& first) { return {constant<R>(kLogAim), first}; }
};

/// As clamp(), of what mostly lies between: a number by itself passes without waiting for comparisons, which the
/// processor foresees.
template <class R>
PHYSIM_INLINE R seldom_clamped(const R& x, const R& low, const R& high) {
  if constexpr (std::is_floating_point_v<R>) {
    if (x > low && x < high) [[likely]]
      return x;
  }
  return clamp(x, low, high);
}

/// The step to try after an accepted one, between bounds; `n` are the bits of its error.
template <class R>
PHYSIM_INLINE R step_after(const R& h, const R& n, double q, const R& log_previous) {
  using Log = LogByBits<R>;
  constexpr double kLn2 = 0.69314718055994531;
  const double alpha = 0.35 * kLn2 / q, beta = 0.2 * kLn2 / q;  // errors are squared, hence halves
  const R rest = constant<R>(1 + (alpha - beta) * kLogAim + alpha / Log::octave * Log::one);
  const R factor_but_for_error = rest + constant<R>(beta) * log_previous;
  return h * factor_but_for_error - n * (h * constant<R>(alpha / Log::octave));
}

/// The step to try after one of length h with error squared `error`, at most `limit` long; `accepted` lanes use the
/// integral part too.
template <class R>
PHYSIM_INLINE R next_step(Integrator integrator, const R& h, const R& error, const MaskOf<R>& accepted, const R& limit,
                          StepControl<R>& control) {
  using Log = LogByBits<R>;
  PHYSIM_ASSERT(is_adaptive(integrator));
  const double q = order_of(integrator);
  const auto log_of = [](const R& n)
                          PHYSIM_INLINE_LAMBDA { return (n - constant<R>(Log::one)) * constant<R>(1 / Log::octave); };
  const auto after_rejection = [&](const R& e) PHYSIM_INLINE_LAMBDA {
    return h * (constant<R>(0.9) * exp2_roughly(constant<R>(-0.5 / q) * log_of(Log::of(e))));
  };
  // Steps much better than asked for, where next to nothing happens, are no reason to take shorter ones behind them.
  const auto remembered = [&](const R& n) PHYSIM_INLINE_LAMBDA { return max(log_of(n), constant<R>(-20)); };
  const R shortest = h * constant<R>(0.1), longest = min(h * constant<R>(5), limit);
  const R huge = constant<R>(1e16);  // so counts what is no number
  if constexpr (std::is_floating_point_v<R>) {
    if (!accepted) return clamp(after_rejection(min(error, huge)), shortest, longest);
    const R n = Log::of(error);
    const R next = step_after(h, n, q, control.log_previous);
    control.log_previous = remembered(n);
    return seldom_clamped(next, shortest, longest);
  } else {
    const R e = min(error, huge), n = Log::of(e);
    const R next = select(accepted, step_after(h, n, q, control.log_previous), after_rejection(e));
    control.log_previous = select(accepted, remembered(n), control.log_previous);
    return clamp(next, shortest, longest);
  }
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
