// One step of a flight: what an integrator is given, what it leaves, and what its dense output needs.
//
// What is flown has two parts: the state, and where the rotation is flown a Turn. Whatever is done to both alike is
// written once, with for_parts(); memory of a part that is not flown is neither set nor read.
#pragma once

#include "base/unset.hpp"
#include "math/vec3.hpp"
#include "model/body.hpp"
#include "model/rigid_body.hpp"

namespace physim {

/// Slopes that a step may keep: the stages of DOP853, the slope at its end, and three for its dense output.
inline constexpr int kMaxSlopes = 16;

/// What a step does to the rotation, where it is flown.
template <class R>
struct TurnStep {
  Turn<R> start;
  Turn<R> end;
  UnsetList<Turn<R>, kMaxSlopes> slope;  // as those of the Step
};

/// A step from time t over h to t_end. The derivative of a state (x, v) is a state (v, a).
template <class R>
struct Step {
  R t;             // start [s]
  R h;             // length [s]
  R t_end;         // start of the next step: t + h but for rounding, since fixed steps are counted [s]
  State<R> start;  // state at t
  State<R> end;    // state at t + h
  UnsetList<State<R>, kMaxSlopes> slope;  // slope[0] at the start; the last stage (see end_slope) at the end
  R error;                                // estimated error over tolerance [-]; adaptive integrators accept up to 1
  Unset<TurnStep<R>> turn;                // of rungs that turn
};

/// What others than its own models do to a projectile.
template <class R>
struct Pushed {
  Vec3<R> a;    // [m/s^2]
  R drag_rate;  // of the drag in it [1/s]

  PHYSIM_INLINE_ALWAYS Pushed operator+(const Pushed& b) const { return {a + b.a, drag_rate + b.drag_rate}; }
  PHYSIM_INLINE_ALWAYS Pushed operator-(const Pushed& b) const { return {a - b.a, drag_rate - b.drag_rate}; }
  PHYSIM_INLINE_ALWAYS Pushed operator*(const R& s) const { return {a * s, drag_rate * s}; }
};

/// What the models read of a projectile, and its step under way. R is a number, or a pack: one projectile per lane.
template <class R>
struct Flyer {
  PHYSIM_INLINE_ALWAYS Flyer() = default;  // a call would be code that kernels share

  Body<R> body;
  R drag_rate;            // of drag that generators give; read by rungs that drag brakes [1/s]
  Unset<Rotor<R>> rotor;  // of rungs that turn
  Step<R> step;
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Calls f with steps, and with what they do to the rotation where that is flown. `whole` are Steps, or what else has a
/// `turn` with members of the same names.
template <class F, class... Whole>
PHYSIM_INLINE_ALWAYS void for_parts(const Fidelity& granted, const F& f, Whole&... whole) {
  f(whole...);
  if (turns(granted)) f(*whole.turn...);
}
/// Calls f with the rotors of flyers, if rotation is flown.
template <class F, class... Flyers>
PHYSIM_INLINE_ALWAYS void for_rotors(const Fidelity& granted, const F& f, Flyers&... flyers) {
  if (turns(granted)) f(*flyers.rotor...);
}

template <class R>
PHYSIM_INLINE_ALWAYS State<R> operator+(const State<R>& a, const State<R>& b) {
  return {a.x + b.x, a.v + b.v};
}
template <class R>
PHYSIM_INLINE_ALWAYS State<R> operator-(const State<R>& a, const State<R>& b) {
  return {a.x - b.x, a.v - b.v};
}
template <class R>
PHYSIM_INLINE_ALWAYS State<R> operator*(const State<R>& a, const R& s) {
  return {a.x * s, a.v * s};
}
template <class R>
PHYSIM_INLINE_ALWAYS void add_scaled(State<R>& sum, const State<R>& a, const R& s) {
  add_scaled(sum.x, a.x, s);
  add_scaled(sum.v, a.v, s);
}
template <class R, class Mask>
PHYSIM_INLINE_ALWAYS Vec3<R> select(const Mask& mask, const Vec3<R>& a, const Vec3<R>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}
template <class R, class Mask>
PHYSIM_INLINE_ALWAYS State<R> select(const Mask& mask, const State<R>& a, const State<R>& b) {
  return {select(mask, a.x, b.x), select(mask, a.v, b.v)};
}
template <class R, class Mask>
PHYSIM_INLINE_ALWAYS Turn<R> select(const Mask& mask, const Turn<R>& a, const Turn<R>& b) {
  return {select(mask, a.w, b.w), select(mask, a.u, b.u), select(mask, a.h, b.h)};
}

PHYSIM_ISA_END
