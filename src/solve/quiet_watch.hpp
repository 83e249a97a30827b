// Watching one lane that flies alone, in as little work as possible.
#pragma once

#include "solve/watch.hpp"

PHYSIM_ISA_BEGIN

/// What a lane that flies alone is watched for, as numbers: a step after which all of them lie strictly on their sides
/// crosses nothing, and needs no closer look.
template <class S>
class QuietWatch {
 public:
  /// At a step that has not been taken yet.
  PHYSIM_INLINE void begin(const Conditions<S>& c, const WatchList& watch, const Flyer<S>& l) {
    for (int i = 0; i < watch.count; ++i)
      at_[i] = numbers(c, l.body, watch.item[i].spec, l.step.t, l.step.start, l.step.slope[0].v);
  }
  /// What a step from where begin() or the last step left off, to a state at t_end with the acceleration a, may have
  /// crossed. Where that is something, begin() has to come before the next one.
  PHYSIM_INLINE WatchedSet may_cross(const Conditions<S>& c, const WatchList& watch, const Body<S>& body,
                                     const S& t_end, const State<S>& end, const Vec3<S>& a) {
    PHYSIM_ASSERT(watch.count >= 0 && watch.count <= kMaxWatched);
    WatchedSet some = 0;
    for (int i = 0; i < watch.count; ++i) {
      const Numbers there = numbers(c, body, watch.item[i].spec, t_end, end, a);
      const bool quiet = at_[i].value * there.value > S(0) && at_[i].rate * there.rate > S(0);
      some |= WatchedSet(!quiet) << i;
      at_[i] = there;
    }
    return some;
  }

 private:
  struct Numbers {
    S value;
    S rate;  // 1 of what may not turn
  };
  PHYSIM_INLINE static Numbers numbers(const Conditions<S>& c, const Body<S>& b, const EventSpec& spec, const S& t,
                                       const State<S>& s, const Vec3<S>& a) {
    const bool turns = may_turn(row_of(spec.kind).watch);
    return {watched_value(c, b, spec, t, s), turns ? watched_rate(c, b, spec, s, a) : S(1)};
  }

  Numbers at_[kMaxWatched];
};

PHYSIM_ISA_END
