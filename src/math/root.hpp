// A bracketing root finder.
//
// A few steps of the secant method come first: most functions here are nearly straight inside a bracket, and each step
// costs one division. Then Chandrupatla's method: inverse quadratic interpolation where the three points make it safe,
// bisection elsewhere. The bracket is kept all the time, no derivative is needed, and the end comes after at most a few
// times the steps of bisection.
// Source: T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function
// without using derivatives", Advances in Engineering Software 28 (1997) 145-149.
#pragma once

#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// A bracket: f(a) and f(b) differ in sign.
struct Bracket {
  double a, fa;
  double b, fb;

  /// Moves the end that has the sign of f(x) to x.
  PHYSIM_INLINE void narrow(double x, double fx) {
    if ((fx < 0) == (fa < 0)) {
      a = x, fa = fx;
    } else {
      b = x, fb = fx;
    }
  }
};

/// Secant steps while they stay inside the bracket; true when one has found the root `x`.
template <class F>
PHYSIM_INLINE bool secant_phase(const F& f, Bracket& bracket, double tolerance, double noise, double& x) {
  double before = bracket.a, f_before = bracket.fa;
  double last = bracket.b, f_last = bracket.fb;
  const double small = 1e-3 * min(abs(bracket.fa), abs(bracket.fb));
  for (int i = 0; i < 5; ++i) {
    x = last - f_last * ((last - before) / (f_last - f_before));
    const bool inside = (x > bracket.a && x < bracket.b) || (x < bracket.a && x > bracket.b);
    if (!inside) return false;
    // A small step may also mean a lopsided bracket; only far below both of its ends is it a sign of the root.
    if (abs(x - last) <= tolerance && abs(f_last) <= small) return true;
    const double fx = f(x);
    if (abs(fx) <= noise) return true;
    bracket.narrow(x, fx);
    before = last, f_before = f_last;
    last = x, f_last = fx;
  }
  return false;
}

/// A root of f between a and b, where fa = f(a) and fb = f(b) differ in sign (or one is zero); to within `tolerance`
/// [unit of a], the spacing of numbers, or until |f| is below `noise`, the rounding of f. A bracket without a change of
/// sign gives the end with the smaller |f|.
template <class F>
double find_root(const F& f, double a, double fa, double b, double fb, double tolerance, double noise = 0) {
  if (fa == 0) return a;
  if (fb == 0) return b;
  if ((fa < 0) == (fb < 0)) return abs(fa) < abs(fb) ? a : b;
  Bracket k{a, fa, b, fb};
  double x = a;
  if (secant_phase(f, k, tolerance, noise, x)) return x;
  // Chandrupatla: a is the newest point, b brackets the root with it, c is the point that was given up.
  double c = k.a;
  double fc = k.fa;
  double step = 0.5;
  for (int i = 0; i < 200; ++i) {
    x = k.a + step * (k.b - k.a);
    const double fx = f(x);
    if (abs(fx) <= noise) return x;
    if ((fx < 0) == (k.fa < 0)) {
      c = k.a, fc = k.fa;
    } else {
      c = k.b, fc = k.fb, k.b = k.a, k.fb = k.fa;
    }
    k.a = x, k.fa = fx;
    const double best = abs(k.fa) < abs(k.fb) ? k.a : k.b;
    const double spacing = max(2 * 2.220446049250313e-16 * abs(best), 0.5 * tolerance);
    const double limit = spacing / max(abs(k.b - k.a), 1e-300);
    if (limit > 0.5 || !(abs(k.fa) + abs(k.fb) < 1e300)) return best;
    const double xi = (k.a - k.b) / (c - k.b);
    const double phi = (k.fa - k.fb) / (fc - k.fb);
    step = 0.5;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
      step =
          k.fa / (k.fb - k.fa) * fc / (k.fb - fc) + (c - k.a) / (k.b - k.a) * k.fa / (fc - k.fa) * k.fb / (fc - k.fb);
    step = clamp(step, limit, 1 - limit);
  }
  return abs(k.fa) < abs(k.fb) ? k.a : k.b;
}

PHYSIM_ISA_END
