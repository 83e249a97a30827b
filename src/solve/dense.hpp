// Dense output: the state anywhere inside a step, from what the step left behind.
//
// The classic loop: straight lines. Other fixed-step integrators: the quintic through position, velocity and
// acceleration at both ends, and the cubic through velocity and acceleration: no less accurate than the methods
// themselves. Tsit5 and DOP853: their own interpolants. Computed in double at every precision, so that fly() and
// fly_batch() share it; there, packs of steps at once.
//
// Sources: see solve/explicit_runge_kutta.hpp; the form of DOP853's is Hairer, Norsett and Wanner (1993), sec. II.6.
#pragma once

#include "solve/take_step.hpp"

PHYSIM_ISA_BEGIN

inline constexpr int kMaxDenseCoefficients = 7;

/// How many states a step's interpolant needs beside both ends.
PHYSIM_INLINE int dense_coefficient_count(Integrator integrator) {
  return integrator == Integrator::tsit5 ? 4 : integrator == Integrator::dop853 ? 7 : 0;
}

/// A state and its acceleration at a time: what lies at both ends of a step. W is double, or a pack of them.
template <class W>
struct NodeOf {
  W t;
  State<W> y;
  Vec3<W> a;
};
using Node = NodeOf<double>;

/// Where a time lies between two nodes, 0..1; a step that stands still counts as taken.
template <class W>
PHYSIM_INLINE W place_between(const NodeOf<W>& n0, const NodeOf<W>& n1, const W& t) {
  return select(n1.t > n0.t, (t - n0.t) / (n1.t - n0.t), W(1.0));
}

template <int Power>
struct Tsit5DenseWeights {
  static constexpr double at(int j) { return Tsit5::kDense[j][Power]; }
};
template <int Row>
struct Dop853DenseWeights {
  static constexpr double at(int j) { return Dop853::kDense[Row][j]; }
};

template <class W>
PHYSIM_INLINE void tsit5_dense(const Step<W>& s, State<W>* out) {
  static_for<4>([&](auto power) { out[power] = weighted_sum<Tsit5DenseWeights<power>, 7>(s.slope) * s.h; });
}

/// Three more slopes, then differences; `f` is the acceleration.
template <class W, class F>
PHYSIM_INLINE void dop853_dense(Step<W>& s, const F& f, State<W>* out) {
  static_for<3>([&](auto i) {
    constexpr int stage = 13 + i;
    const State<W> y = advanced(s.start, weighted_sum<StageWeights<Dop853, stage>, stage>(s.slope), s.h);
    s.slope[stage] = {y.v, f(s.t + s.h * Dop853::c[stage], y)};
  });
  const State<W> change = s.end - s.start;
  out[0] = change;
  out[1] = s.slope[0] * s.h - change;
  out[2] = change - s.slope[12] * s.h - out[1];
  static_for<4>([&](auto row) { out[3 + row] = weighted_sum<Dop853DenseWeights<row>, 16>(s.slope) * s.h; });
}

/// Fills the interpolant's coefficients of a finished step.
template <class W, class F>
PHYSIM_INLINE void dense_coefficients(Integrator integrator, Step<W>& s, const F& f, State<W>* out) {
  if (integrator == Integrator::tsit5) tsit5_dense(s, out);
  if (integrator == Integrator::dop853) dop853_dense(s, f, out);
}

/// Quintic Hermite interpolation of positions, cubic of velocities.
template <class W>
PHYSIM_INLINE State<W> hermite(const NodeOf<W>& n0, const NodeOf<W>& n1, const W& theta) {
  const W h = n1.t - n0.t;
  const W u = 1 - theta;
  const W t2 = theta * theta;
  const W t3 = t2 * theta;
  const W u2 = u * u;
  const W u3 = u2 * u;
  const Vec3<W> rise = n1.y.x - n0.y.x;
  State<W> y;
  // x0 + rise * t^3 (1 + 3u + 6u^2) + h v0 t u^3 (1 + 3t) - h v1 t^3 u (1 + 3u) + h^2/2 (a0 t^2 u^3 + a1 t^3 u^2)
  y.x = n0.y.x + rise * (t3 * (1 + 3 * u + 6 * u2)) + n0.y.v * (h * theta * u3 * (1 + 3 * theta)) -
        n1.y.v * (h * t3 * u * (1 + 3 * u)) + (n0.a * (t2 * u3) + n1.a * (t3 * u2)) * (0.5 * h * h);
  y.v = n0.y.v + (n1.y.v - n0.y.v) * (t2 * (3 - 2 * theta)) + n0.a * (h * theta * u2) - n1.a * (h * t2 * u);
  return y;
}

/// The state inside a step, 0 < theta < 1.
template <class W>
PHYSIM_INLINE State<W> state_inside(Integrator integrator, const NodeOf<W>& n0, const NodeOf<W>& n1, const State<W>* c,
                                    const W& theta) {
  if (integrator == Integrator::tsit5) return n0.y + (c[0] + (c[1] + (c[2] + c[3] * theta) * theta) * theta) * theta;
  if (integrator == Integrator::dop853) {
    const W u = 1 - theta;
    return n0.y +
           (c[0] + (c[1] + (c[2] + (c[3] + (c[4] + (c[5] + c[6] * theta) * u) * theta) * u) * theta) * u) * theta;
  }
  // The original knew frames only, and its damping is no slope: straight lines between them.
  if (integrator == Integrator::classic) return n0.y + (n1.y - n0.y) * theta;
  return hermite(n0, n1, theta);
}

/// The state at t = n0.t + theta h, 0 <= theta <= 1; at both ends the nodes themselves, to the bit.
template <class W>
PHYSIM_INLINE State<W> dense_state(Integrator integrator, const NodeOf<W>& n0, const NodeOf<W>& n1, const State<W>* c,
                                   const W& theta) {
  const State<W> inside = state_inside(integrator, n0, n1, c, theta);
  return select(theta == 0.0, n0.y, select(theta == 1.0, n1.y, inside));
}

PHYSIM_ISA_END
