// Ledgers: where the effects on a projectile are added up. Kernels keep the sum alone; callers that need accelerations
// by effect keep each entry too. Both receive the same effects in the same order (model/acceleration.hpp).
//
// Source: none.
#pragma once

#include "model/constraint.hpp"
#include "physim/flight.hpp"

namespace physim {

/// An effect, by the member of Accelerations that holds it.
using Effect = Vec3d Accelerations::*;

}  // namespace physim

PHYSIM_ISA_BEGIN

/// The sum alone.
template <class R>
struct Sum {
  Vec3<R> total;

  /// The first entry.
  PHYSIM_INLINE void begin(Effect, const Vec3<R>& a) { total = a; }
  PHYSIM_INLINE void add(Effect, const Vec3<R>& a) { total += a; }
  /// Part of what was added as one effect is another one.
  PHYSIM_INLINE void tell_apart(Effect, Effect, const Vec3<R>&) {}
  /// An effect that a step brings about by other means than the sum.
  PHYSIM_INLINE void tell(Effect, const Vec3<R>&) {}
  /// Drag `d` on a velocity `u` through the air, which was added.
  PHYSIM_INLINE void note_drag(const Vec3<R>&, const Vec3<R>&) {}
  /// Ends the sum of what acts at once.
  template <class S>
  PHYSIM_INLINE void constrain(const Conditions<S>& c, const Body<R>& b) {
    total = constrained(c, b, total);
  }
  /// What follows from the sum of the effects before.
  template <class S>
  PHYSIM_INLINE void add_constrained(const Conditions<S>& c, const Body<R>& b, Effect, const Vec3<R>& a) {
    total += constrained(c, b, a);
  }
};

/// The sum alone, for steps of a given length, which drag may brake. A step of order one and of length h that takes
/// drag from where it starts turns a velocity u around where the rate k of the drag exceeds 1/h, and grows without end
/// where k exceeds 2/h. The step that takes drag from where it ends, at the same rate, does neither:
/// u' = (u + a h) / (1 + k h), with a all other accelerations. It is the first step with the sum of all accelerations
/// over 1 + k h; both rest at the same terminal velocity.
template <class R>
struct BrakedSum : Sum<R> {
  Vec3<R> through_air{}, drag{};

  PHYSIM_INLINE void note_drag(const Vec3<R>& u, const Vec3<R>& d) { through_air = u, drag = d; }
  /// The sum over 1 + (k + rate) h: `rate` is that of further drag, which others gave.
  PHYSIM_INLINE Vec3<R> over(const R& h, const R& rate) const {
    const R square = dot(through_air, through_air) + constant<R>(1e-30);  // at rest there is nothing to brake
    return this->total * (square / (square - h * dot(drag, through_air) + h * rate * square));
  }
  /// For the stages of steps of higher orders: the sum over max(1, (k + rate) h / z). Explicit Runge-Kutta steps turn
  /// a velocity around where k h exceeds 2 and grow without end soon behind; with k h held at z = 0.9 drag of v and of
  /// v^2 takes less than all of a velocity in each stage, and steps about the terminal velocity, where the slope of
  /// drag by v^2 is 2 k, are stable. The step is as it was, to the bit, where k h stays below z. What pulls against u
  /// pulls in full: else a rise would cost less than it gains.
  PHYSIM_INLINE Vec3<R> limited(const R& h, const R& rate) const {
    const R square = dot(through_air, through_air) + constant<R>(1e-30), whole = square * constant<R>(0.9);
    const R against_air = rate * square - dot(drag, through_air), braking = h * against_air;
    if (!any(braking > whole)) return this->total;
    const R part = whole / max(whole, braking), others = dot(this->total, through_air) + against_air;
    const R against = min(others, constant<R>(0)) / square * (constant<R>(1) - part);
    const auto along = [&](const R& sum, const R& u)
                           PHYSIM_INLINE_LAMBDA { return select(braking > whole, sum * part + u * against, sum); };
    return {along(this->total.x, through_air.x), along(this->total.y, through_air.y),
            along(this->total.z, through_air.z)};
  }
};

/// Each effect alone, and the sum.
struct Ledger : Accelerations {
  void begin(Effect effect, const Vec3d& a) { this->*effect = total = a; }
  void add(Effect effect, const Vec3d& a) { this->*effect += a, total += a; }
  void tell_apart(Effect whole, Effect part, const Vec3d& a) { this->*whole -= a, this->*part += a; }
  void tell(Effect effect, const Vec3d& a) { add(effect, a); }
  void note_drag(const Vec3d&, const Vec3d&) {}
  void constrain(const Conditions<double>& c, const Body<double>& b) {
    const Vec3d free = total;
    total = constrained(c, b, free);
    constraint += total - free;
  }
  void add_constrained(const Conditions<double>& c, const Body<double>& b, Effect effect, const Vec3d& a) {
    const Vec3d left = constrained(c, b, a);
    this->*effect += a, constraint += left - a, total += left;
  }
};

PHYSIM_ISA_END
