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

/// Each effect alone, and the sum.
struct Ledger : Accelerations {
  void begin(Effect effect, const Vec3d& a) { this->*effect = total = a; }
  void add(Effect effect, const Vec3d& a) { this->*effect += a, total += a; }
  void tell_apart(Effect whole, Effect part, const Vec3d& a) { this->*whole -= a, this->*part += a; }
  void tell(Effect effect, const Vec3d& a) { add(effect, a); }
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
