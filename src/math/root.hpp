// A bracketing root finder.
//
// Chandrupatla's method: inverse quadratic interpolation where the three points make it safe, bisection elsewhere. It
// keeps the bracket, needs no derivative, and ends after at most a few times the bisections.
// Source: T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function
// without using derivatives", Advances in Engineering Software 28 (1997) 145-149.
#pragma once

#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// A root of f between a and b, where fa = f(a) and fb = f(b) differ in sign (or one is zero); to within `tolerance`
/// [unit of a] or the spacing of numbers. A bracket without a change of sign gives the end with the smaller |f|.
template <class F>
double find_root(const F& f, double a, double fa, double b, double fb, double tolerance) {
  if (fa == 0) return a;
  if (fb == 0) return b;
  if ((fa < 0) == (fb < 0)) return abs(fa) < abs(fb) ? a : b;
  double c = a;
  double fc = fa;
  double step = clamp(fa / (fa - fb), 0.01, 0.99);  // most functions here are nearly straight
  for (int i = 0; i < 200; ++i) {
    const double x = a + step * (b - a);
    const double fx = f(x);
    if ((fx < 0) == (fa < 0)) {
      c = a, fc = fa;
    } else {
      c = b, fc = fb, b = a, fb = fa;
    }
    a = x, fa = fx;
    const double best = abs(fa) < abs(fb) ? a : b;
    const double limit = max(2 * 2.220446049250313e-16 * abs(best), 0.5 * tolerance) / max(abs(b - a), 1e-300);
    if (limit > 0.5 || fa == 0 || !(abs(fa) + abs(fb) < 1e300)) return best;
    const double xi = (a - b) / (c - b);
    const double phi = (fa - fb) / (fc - fb);
    step = 0.5;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
      step = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    step = clamp(step, limit, 1 - limit);
  }
  return abs(fa) < abs(fb) ? a : b;
}

PHYSIM_ISA_END
