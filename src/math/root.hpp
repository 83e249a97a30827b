// A bracketing root finder, for one number or for the lanes of a pack.
//
// Where the rates of change at both ends are known, the inverse of the function is a cubic through both, and the search
// begins where that is zero: two looks at the function are mostly enough. A few steps of the secant method follow: most
// functions here are nearly straight inside a bracket, and each step costs one division. Then Chandrupatla's method:
// inverse quadratic interpolation where the three points make it safe, bisection elsewhere. The bracket is kept all the
// time, no rate needs to be known or right, and the end comes after at most a few times the steps of bisection. Lanes
// that have their root wait for the others; what they compute meanwhile is dropped. Source: T. R. Chandrupatla, "A new
// hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function without using derivatives",
// Advances in Engineering Software 28 (1997) 145-149.
#pragma once

#include "base/assert.hpp"
#include "math/pack.hpp"

PHYSIM_ISA_BEGIN

/// Where a search stands. The root lies between a and b: f(a) and f(b) differ in sign.
template <class R>
struct RootSearch {
  R a, fa;
  R b, fb;
  MaskOf<R> open;      // lanes still searching
  R root;              // of the others
  R before, f_before;  // the last two points looked at
  R last, f_last;

  PHYSIM_INLINE void finish(const MaskOf<R>& found, const R& x) {
    root = select(open & found, x, root);
    open = open & !found;
  }
  PHYSIM_INLINE MaskOf<R> is_inside(const R& x) const { return ((x > a) & (x < b)) | ((x < a) & (x > b)); }
};

/// How fast f changes at both ends of a bracket; zero where unknown.
template <class R>
struct EndRates {
  R at_a, at_b;
};

/// Whether two numbers lie on the same side: below zero, or not.
template <class R>
PHYSIM_INLINE MaskOf<R> same_side(const R& x, const R& y) {
  const R zero(ScalarOf<R>(0));
  const MaskOf<R> x_below = x < zero, y_below = y < zero;
  return (x_below & y_below) | !(x_below | y_below);
}

/// Evaluates f(x) in some lanes; each x lies inside its bracket.
template <class R, class F>
PHYSIM_INLINE void look_at(const F& f, RootSearch<R>& s, const R& x, const MaskOf<R>& lanes, const R& noise) {
  const R fx = f(x);
  s.finish(lanes & (abs(fx) <= noise), x);
  const MaskOf<R> below = same_side(fx, s.fa);  // the end that has the sign of f(x) moves to x
  s.a = select(lanes & below, x, s.a), s.fa = select(lanes & below, fx, s.fa);
  s.b = select(lanes & !below, x, s.b), s.fb = select(lanes & !below, fx, s.fb);
  s.before = select(lanes, s.last, s.before), s.f_before = select(lanes, s.f_last, s.f_before);
  s.last = select(lanes, x, s.last), s.f_last = select(lanes, fx, s.f_last);
}

/// Two points of lanes in which f changes in one direction at both ends: where the inverse cubic through them is zero,
/// and one step from there by its slope.
template <class R, class F>
PHYSIM_INLINE void inverse_cubic_phase(const F& f, const EndRates<R>& rates, RootSearch<R>& s, const R& noise) {
  const R zero(ScalarOf<R>(0)), two = constant<R>(2);
  const R rise = s.fb - s.fa, width = s.b - s.a;
  const R per_rise = constant<R>(1) / rise;
  const R from_a = rise / rates.at_a, from_b = rise / rates.at_b;  // dx/dp
  const R p = -s.fa * per_rise, q = constant<R>(1) - p;            // zero's place between fa and fb
  const R x = s.a + width * (p * p * (constant<R>(3) - two * p)) + (from_a * q - from_b * p) * (p * q);
  const R slope =
      (constant<R>(6) * width * (p * q) + from_a * (q * (q - two * p)) - from_b * (p * (two * q - p))) * per_rise;
  MaskOf<R> lanes = s.open & (rates.at_a * width * rise > zero) & (rates.at_b * width * rise > zero) & s.is_inside(x);
  if (!any(lanes)) return;
  look_at(f, s, x, lanes, noise);
  const R next = x - s.f_last * slope;
  lanes = lanes & s.open & s.is_inside(next);
  if (any(lanes)) look_at(f, s, next, lanes, noise);
}

/// Secant steps while they stay inside the bracket.
template <class R, class F>
PHYSIM_INLINE void secant_phase(const F& f, RootSearch<R>& s, double tolerance, const R& noise, const R& small) {
  MaskOf<R> inside = s.open;
  for (int i = 0; i < 5; ++i) {
    const R x = s.last - s.f_last * ((s.last - s.before) / (s.f_last - s.f_before));
    inside = inside & s.open & s.is_inside(x);
    // A small step may also mean a lopsided bracket; only far below both of its ends is it a sign of the root.
    s.finish(inside & (abs(x - s.last) <= constant<R>(tolerance)) & (abs(s.f_last) <= small), x);
    inside = inside & s.open;
    if (!any(inside)) return;
    look_at(f, s, x, inside, noise);
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
/// bracket without a change of sign gives the end with the smaller |f|. Rates that are wrong cost time and nothing
/// else.
template <class R, class F>
R find_roots(const F& f, const R& a, const R& fa, const R& b, const R& fb, double tolerance, const R& noise,
             const MaskOf<R>& asked, const EndRates<R>* rates = nullptr) {
  PHYSIM_ASSERT(tolerance >= 0);
  const R zero(ScalarOf<R>(0));
  const MaskOf<R> at_end = (fa == zero) | (fb == zero) | same_side(fa, fb);
  const MaskOf<R> open = asked & !at_end;
  const MaskOf<R> nearer = (abs(fa) < abs(fb)) | (fa == zero);
  RootSearch<R> s{a, fa, b, fb, open, select(nearer, a, b), a, fa, b, fb};
  const R small = constant<R>(1e-3) * min(abs(fa), abs(fb));
  if (rates != nullptr && any(s.open)) inverse_cubic_phase(f, *rates, s, noise);
  if (any(s.open)) secant_phase(f, s, tolerance, noise, small);
  if (any(s.open)) chandrupatla_phase(f, s, tolerance, noise);
  PHYSIM_ASSERT(!any(asked & (((s.root < a) & (s.root < b)) | ((s.root > a) & (s.root > b)))));
  return s.root;
}
double find_root(const auto& f, double a, double fa, double b, double fb, double tolerance, double noise = 0) {
  return find_roots<double>(f, a, fa, b, fb, tolerance, noise, true);
}

PHYSIM_ISA_END
