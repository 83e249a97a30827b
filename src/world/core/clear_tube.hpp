// Clear tubes: what lies about the way that a row takes if nothing turns it, and in which nothing stands.
//
// What it models: whether a step stays inside of a tube, so that it can meet nothing that rests where it did when the
//   tube was found clear. A tube is the set of points that are nearer to an axis than its room; it is
//   convex, so a chord between two points of it lies in it, and the path of a step lies in it where the room is larger
//   by as much as the path may be beside its chord.
// Symbols: x0, x1 the ends of a step, v0, v1 the velocities there [m, m/s], h the step [s], u = (x1 - x0) / h.
// Equations: the cubic of x0, v0, x1, v1 is nowhere farther from its chord than 4/27 h (|v0 - u| + |v1 - u|); twice as
//   much is allowed for. An axis of n steps from x0 to x0 + v t + a t^2 / 2, t = n h, is left by a steady acceleration
//   by a t^2 / 8, the sag of a parabola.
// Source: G. Farin, Curves and Surfaces for CAGD (2002), 5.1 (Bernstein polynomials: 4/27 is the largest value of those
//   that the velocities are weighted with).
#pragma once

#include "math/numbers.hpp"
#include "math/vec3.hpp"

PHYSIM_ISA_BEGIN

/// A tube as a row stores it. All zero: no tube.
template <class R>
struct ClearTube {
  Vec3<R> from;          // where its axis begins [m]
  Vec3<R> along;         // to where it ends [m]
  R per_square_along{};  // [1/m^2]
  R room{};              // how far from the axis a projectile may be [m]
};

/// Twice as far as the path of a step may be from its chord [m].
template <class R, class S>
PHYSIM_INLINE R beside_chord(const Vec3<R>& x0, const Vec3<R>& v0, const Vec3<R>& x1, const Vec3<R>& v1, S h) {
  const Vec3<R> mean = (x1 - x0) * R(S(1) / h);
  return (length(v0 - mean) + length(v1 - mean)) * R(S(8.0 / 27) * h);
}

/// Twice as far as the path of a step at a steady acceleration may be from its chord [m].
PHYSIM_INLINE double beside_chord(double h, const Vec3d& acceleration) {
  return 8.0 / 27 * h * h * length(acceleration);
}

/// How far a point is from the axis of a tube [m].
template <class R>
PHYSIM_INLINE R distance_from(const ClearTube<R>& tube, const Vec3<R>& x) {
  using S = ScalarOf<R>;
  const Vec3<R> off = x - tube.from;
  const R part = min(max(dot(off, tube.along) * tube.per_square_along, R(S(0))), R(S(1)));
  return length(off - tube.along * part);
}

/// Whether a step stays inside of a tube; false if the step has a NaN.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> stays_inside(const ClearTube<R>& tube, const Vec3<R>& x0, const Vec3<R>& v0, const Vec3<R>& x1,
                                     const Vec3<R>& v1, S h) {
  const R beside = beside_chord(x0, v0, x1, v1, h);
  const MaskOf<R> starts = distance_from(tube, x0) + beside < tube.room;
  const MaskOf<R> ends = distance_from(tube, x1) + beside < tube.room;
  return starts & ends;
}

PHYSIM_ISA_END
