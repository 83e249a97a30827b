// A bracketing root finder, for one number or for the lanes of a pack.
//
// A few steps of the secant method come first: most functions here are nearly straight inside a bracket, and each step
// costs one division. Then Chandrupatla's method: inverse quadratic interpolation where the three points make it safe,
// bisection elsewhere. The bracket is kept all the time, no derivative is needed, and the end comes after at most a few
// times the steps of bisection. Lanes that have their root wait for the others; what they compute meanwhile is dropped.
// Source: T. R. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function
// without using derivatives", Advances in Engineering Software 28 (1997) 145-149.
#pragma once

#include "base/assert.hpp"
#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// Where a search stands. The root lies between a and b: f(a) and f(b) differ in sign.
template <class R>
struct RootSearch {
  R a, fa;
  R b, fb;
  MaskOf<R> open;  // lanes still searching
  R root;          // of the others

  PHYSIM_INLINE void finish(const MaskOf<R>& found, const R& x) {
    root = select(open & found, x, root);
    open = open & !found;
  }
};

/// Whether two numbers lie on the same side: below zero, or not.
template <class R>
PHYSIM_INLINE MaskOf<R> same_side(const R& x, const R& y) {
  const R zero(ScalarOf<R>(0));
  const MaskOf<R> x_below = x < zero, y_below = y < zero;
  return (x_below & y_below) | !(x_below | y_below);
}

/// Secant steps while they stay inside the bracket.
template <class R, class F>
PHYSIM_INLINE void secant_phase(const F& f, RootSearch<R>& s, double tolerance, const R& noise) {
  R before = s.a, f_before = s.fa;
  R last = s.b, f_last = s.fb;
  const R small = constant<R>(1e-3) * min(abs(s.fa), abs(s.fb));
  MaskOf<R> inside = s.open;
  for (int i = 0; i < 5; ++i) {
    const R x = last - f_last * ((last - before) / (f_last - f_before));
    inside = inside & s.open & (((x > s.a) & (x < s.b)) | ((x < s.a) & (x > s.b)));
    // A small step may also mean a lopsided bracket; only far below both of its ends is it a sign of the root.
    s.finish(inside & (abs(x - last) <= constant<R>(tolerance)) & (abs(f_last) <= small), x);
    inside = inside & s.open;
    if (!any(inside)) return;
    const R fx = f(x);
    s.finish(inside & (abs(fx) <= noise), x);
    const MaskOf<R> below = same_side(fx, s.fa);  // the end that has the sign of f(x) moves to x
    s.a = select(inside & below, x, s.a), s.fa = select(inside & below, fx, s.fa);
    s.b = select(inside & !below, x, s.b), s.fb = select(inside & !below, fx, s.fb);
    before = select(inside, last, before), f_before = select(inside, f_last, f_before);
    last = select(inside, x, last), f_last = select(inside, fx, f_last);
  }
}

/// Chandrupatla's method: a is the newest point, b brackets the root with it, c is the point that was given up.
template <class R, class F>
PHYSIM_INLINE void chandrupatla_phase(const F& f, RootSearch<R>& s, double tolerance, const R& noise) {
  const R one = constant<R>(1), half = constant<R>(0.5);
  R c = s.a, fc = s.fa, step = half;
  for (int i = 0; i < 200 && any(s.open); ++i) {
    const R x = s.a + step * (s.b - s.a);
    const R fx = f(x);
    s.finish(abs(fx) <= noise, x);
    const MaskOf<R> same = same_side(fx, s.fa);
    c = select(same, s.a, s.b), fc = select(same, s.fa, s.fb);
    s.b = select(same, s.b, s.a), s.fb = select(same, s.fb, s.fa);
    s.a = x, s.fa = fx;
    const R best = select(abs(s.fa) < abs(s.fb), s.a, s.b);
    const R spacing = max(constant<R>(2 * 2.220446049250313e-16) * abs(best), constant<R>(0.5 * tolerance));
    const R limit = spacing / max(abs(s.b - s.a), constant<R>(1e-300));
    s.finish((limit > half) | !(abs(s.fa) + abs(s.fb) < constant<R>(1e300)), best);
    const R xi = (s.a - s.b) / (c - s.b);
    const R phi = (s.fa - s.fb) / (fc - s.fb);
    const R inverse_quadratic =
        s.fa / (s.fb - s.fa) * fc / (s.fb - fc) + (c - s.a) / (s.b - s.a) * s.fa / (fc - s.fa) * s.fb / (fc - s.fb);
    const MaskOf<R> safe = (phi * phi < xi) & ((one - phi) * (one - phi) < one - xi);
    step = clamp(select(safe, inverse_quadratic, half), limit, one - limit);
  }
  s.finish(s.open, select(abs(s.fa) < abs(s.fb), s.a, s.b));
}

/// A root of f between a and b in every lane asked for, where fa = f(a) and fb = f(b) differ in sign (or one is zero):
/// to within `tolerance` [unit of a], the spacing of numbers, or until |f| is below `noise`, the rounding of f. A
/// bracket without a change of sign gives the end with the smaller |f|.
template <class R, class F>
R find_roots(const F& f, const R& a, const R& fa, const R& b, const R& fb, double tolerance, const R& noise,
             const MaskOf<R>& asked) {
  PHYSIM_ASSERT(tolerance >= 0);
  const R zero(ScalarOf<R>(0));
  const MaskOf<R> at_end = (fa == zero) | (fb == zero) | same_side(fa, fb);
  const MaskOf<R> open = asked & !at_end;
  const MaskOf<R> nearer = (abs(fa) < abs(fb)) | (fa == zero);
  RootSearch<R> s{a, fa, b, fb, open, select(nearer, a, b)};
  if (any(s.open)) secant_phase(f, s, tolerance, noise);
  if (any(s.open)) chandrupatla_phase(f, s, tolerance, noise);
  PHYSIM_ASSERT(!any(asked & (((s.root < a) & (s.root < b)) | ((s.root > a) & (s.root > b)))));
  return s.root;
}
double find_root(const auto& f, double a, double fa, double b, double fb, double tolerance, double noise = 0) {
  return find_roots<double>(f, a, fa, b, fb, tolerance, noise, true);
}

PHYSIM_ISA_END
