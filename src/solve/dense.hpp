// Dense output: the state anywhere inside a step, from what the step left behind.
//
// The classic loop: straight lines. Methods with an interpolant in their tableau: that one. The others: the quintic
// through position, velocity and acceleration at both ends, and the cubic through velocity and acceleration: no less
// accurate than the methods themselves. Positions of steps of order one move with another velocity than theirs
// (stagger() in solve/take_step.hpp): that one is interpolated. Computed in double at every precision, so that fly()
// and fly_batch() share it; there, packs of steps at once.
//
// Sources: see solve/explicit_runge_kutta.hpp; the form of DOP853's is Hairer, Norsett and Wanner (1993), sec. II.6.
#pragma once

#include <iterator>

#include "solve/take_step.hpp"

namespace physim {

/// A state and its acceleration at a time: what lies at both ends of a step. W is double, or a pack of them.
template <class W>
struct NodeOf {
  W t;
  State<W> y;
  Vec3<W> a;
};
using Node = NodeOf<double>;

/// A Turn and its slope at a time, at both ends of a step.
template <class W>
struct TurnNodeOf {
  W t;
  Turn<W> y;
  Turn<W> slope;
};
using TurnNode = TurnNodeOf<double>;

}  // namespace physim

PHYSIM_ISA_BEGIN

inline constexpr int kMaxDenseCoefficients = 7;

template <class Method>
constexpr int dense_coefficients_of() {
  if constexpr (HasDenseStages<Method>) return 3 + int(std::size(Method::kDense));
  if constexpr (HasDensePolynomials<Method>) return int(std::size(Method::kDense[0]));
  return 0;
}

/// How many states a step's interpolant needs beside both ends.
PHYSIM_INLINE int dense_coefficient_count(Integrator integrator) {
  return with_method(integrator,
                     [](auto method) PHYSIM_INLINE_LAMBDA { return dense_coefficients_of<decltype(method)>(); });
}

/// Calls f with the number of each slope of a step that its interpolant reads; `last` is that of the slope at the end.
PHYSIM_INLINE void for_dense_slopes(Integrator integrator, int last, const auto& f) {
  PHYSIM_ASSERT(last >= 1 && last < kMaxSlopes);
  for (int i = 0; i <= last; i += dense_coefficient_count(integrator) > 0 ? 1 : last) f(i);
}

/// Where a time lies between two nodes, 0..1; a step that stands still counts as taken.
template <class W>
PHYSIM_INLINE W place_between(const NodeOf<W>& n0, const NodeOf<W>& n1, const W& t) {
  return select(n1.t > n0.t, (t - n0.t) / (n1.t - n0.t), W(1.0));
}

/// The weights of a power of theta, of an interpolant made of polynomials.
template <class Tableau, int Power>
struct PolynomialWeights {
  static constexpr double at(int j) { return Tableau::kDense[j][Power]; }
};

/// Adds the slopes that the interpolant needs beside those of the step; `f` is the acceleration, or where it turns
/// gives the slope of the Turn too.
template <bool kTurns, class W, class F>
PHYSIM_INLINE void add_dense_slopes(Integrator integrator, Step<W>& s, const F& f) {
  with_method(integrator, [&](auto method) PHYSIM_INLINE_LAMBDA {
    using Method = decltype(method);
    if constexpr (HasDenseStages<Method>) {
      constexpr int kOwn = Method::kStages + 1;
      static_assert(Method::kDenseStages <= kMaxSlopes);
      static_for<Method::kDenseStages - kOwn>([&](auto i) {
        constexpr int stage = kOwn + i;
        const State<W> y = stage_state<Method, stage>(s, s.h);
        const W t = s.t + s.h * Method::c[stage];
        if constexpr (kTurns)
          s.slope[stage] = {y.v, f(t, y, stage_state<Method, stage>(*s.turn, s.h), s.turn->slope[stage])};
        else
          s.slope[stage] = {y.v, f(t, y)};
      });
    }
  });
}

/// Fills the interpolant's coefficients of a finished step with all its slopes; `s` is a Step or its TurnStep.
template <class AnyStep, class W, template <class> class Y>
PHYSIM_INLINE void dense_sums(Integrator integrator, const AnyStep& s, const W& h, Y<W>* out) {
  with_method(integrator, [&](auto method) PHYSIM_INLINE_LAMBDA {
    using Method = decltype(method);
    static_assert(dense_coefficients_of<Method>() <= kMaxDenseCoefficients);
    if constexpr (HasDensePolynomials<Method>) {
      static_for<dense_coefficients_of<Method>()>([&](auto power) {
        out[power] = weighted_sum<PolynomialWeights<Method, power>, Method::kStages + 1>(s.slope.item) * h;
      });
    } else if constexpr (HasDenseStages<Method>) {
      const Y<W> change = s.end - s.start;
      out[0] = change;
      out[1] = s.slope[0] * h - change;
      out[2] = change - s.slope[Method::kStages] * h - out[1];
      static_for<dense_coefficients_of<Method>() - 3>([&](auto row) {
        out[3 + row] = weighted_sum<RowWeights<Method::kDense, row>, Method::kDenseStages>(s.slope.item) * h;
      });
    }
  });
}

/// Adds the slopes that the interpolant needs, and fills its coefficients.
template <class W, class F>
PHYSIM_INLINE void dense_coefficients(Integrator integrator, Step<W>& s, const F& f, State<W>* out) {
  add_dense_slopes<false>(integrator, s, f);
  dense_sums(integrator, s, s.h, out);
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

/// Cubic Hermite interpolation.
template <class W>
PHYSIM_INLINE Turn<W> hermite(const TurnNodeOf<W>& n0, const TurnNodeOf<W>& n1, const W& theta) {
  const W h = n1.t - n0.t;
  const W u = 1 - theta;
  const W t2 = theta * theta;
  return n0.y + (n1.y - n0.y) * (t2 * (3 - 2 * theta)) + n0.slope * (h * theta * (u * u)) - n1.slope * (h * t2 * u);
}

/// By how much what moves in a step of order one is faster than its velocity says.
template <class W>
PHYSIM_INLINE Vec3<W> ahead(double stagger, const NodeOf<W>& n0, const NodeOf<W>& n1, const W& theta) {
  return (n0.a + (n1.a - n0.a) * theta) * ((n1.t - n0.t) * W(stagger));
}
/// Gives a state that meets a surface the velocity of its motion, if it comes fast beside what `ahead` changes, or if
/// its own velocity leaves the surface, which its way does not, and is the faster one. Else it keeps its velocity
/// towards the surface; along the surface it has the slower of the two, but where a step starts: it was laid there. The
/// faster one would make energy at each contact. `u`: its velocity against the surface's; `theta`: part of the step,
/// 0..1.
template <class W>
PHYSIM_NOINLINE void move_on(const Vec3<W>& ahead, const Vec3<W>& normal, const Vec3<W>& u, const W& theta,
                             State<W>& s) {
  constexpr double kStart = 0.01;  // a fall from 1e-7 m takes longer
  const W rate = dot(u, normal), across = dot(ahead, normal);
  const Vec3<W> along = ahead - normal * across;
  const W change = abs(across);
  const MaskOf<W> leaves = rate > change * W(1e-3);  // rounding is less
  const MaskOf<W> is_faster = dot(ahead, u + u + ahead) < W(0.0);
  const MaskOf<W> is_faster_along = dot(along, u + u + along) < W(0.0);
  const MaskOf<W> moves = (rate < change * W(-4.0)) | (leaves & is_faster);
  s.v = select(moves, s.v + ahead, select(is_faster_along & (theta > W(kStart)), s.v + along, s.v));
}
/// Hermite interpolation of a step of order one: between places, with the velocities that they move with.
template <class W>
PHYSIM_INLINE State<W> staggered_hermite(double stagger, const NodeOf<W>& n0, const NodeOf<W>& n1, const W& theta) {
  NodeOf<W> m0 = n0, m1 = n1;
  m0.y.v += ahead(stagger, n0, n1, W(0.0));
  m1.y.v += ahead(stagger, n0, n1, W(1.0));
  State<W> s = hermite(m0, m1, theta);
  s.v -= ahead(stagger, n0, n1, theta);
  return s;
}
template <class W>
PHYSIM_INLINE Turn<W> staggered_hermite(double, const TurnNodeOf<W>& n0, const TurnNodeOf<W>& n1, const W& theta) {
  return hermite(n0, n1, theta);
}

/// The state or the Turn inside a step, 0 < theta < 1.
template <template <class> class AnyNode, template <class> class Y, class W>
PHYSIM_INLINE Y<W> state_inside(Integrator integrator, const AnyNode<W>& n0, const AnyNode<W>& n1, const Y<W>* c,
                                const W& theta) {
  return with_method(integrator, [&](auto method) PHYSIM_INLINE_LAMBDA -> Y<W> {
    using Method = decltype(method);
    if constexpr (HasDensePolynomials<Method>) {
      constexpr int kCount = dense_coefficients_of<Method>();
      Y<W> sum = c[kCount - 1];
      static_for<kCount - 1>([&](auto below) { sum = c[kCount - 2 - below] + sum * theta; });
      return n0.y + sum * theta;
    } else if constexpr (HasDenseStages<Method>) {
      const W u = 1 - theta;
      return n0.y +
             (c[0] + (c[1] + (c[2] + (c[3] + (c[4] + (c[5] + c[6] * theta) * u) * theta) * u) * theta) * u) * theta;
    } else if constexpr (std::is_same_v<Method, ClassicLoop>) {
      return n0.y + (n1.y - n0.y) * theta;  // it knew frames only, and its damping is no slope
    } else if constexpr (stagger_of<Method> != 0) {
      return staggered_hermite(stagger_of<Method>, n0, n1, theta);
    } else {
      return hermite(n0, n1, theta);
    }
  });
}

/// The state at t = n0.t + theta h, 0 <= theta <= 1; at both ends the nodes themselves, to the bit.
template <class W>
PHYSIM_INLINE State<W> dense_state(Integrator integrator, const NodeOf<W>& n0, const NodeOf<W>& n1, const State<W>* c,
                                   const W& theta) {
  const State<W> inside = state_inside(integrator, n0, n1, c, theta);
  return select(theta == 0.0, n0.y, select(theta == 1.0, n1.y, inside));
}

/// The Turn at t = n0.t + theta h, with what points at length one; at both ends the nodes themselves, to the bit.
template <class W>
PHYSIM_INLINE Turn<W> dense_turn(const Fidelity& f, const TurnNodeOf<W>& n0, const TurnNodeOf<W>& n1, const Turn<W>* c,
                                 const W& theta) {
  const Turn<W> inside = on_unit_length(f, state_inside(f.integrator, n0, n1, c, theta));
  return select(theta == 0.0, n0.y, select(theta == 1.0, n1.y, inside));
}

PHYSIM_ISA_END
