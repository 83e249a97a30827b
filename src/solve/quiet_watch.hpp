// Watching one lane that flies alone, in as little work as possible.
#pragma once

#include <limits>

#include "solve/watch.hpp"

PHYSIM_ISA_BEGIN

/// Whether the steps of a lane that flies alone cross nothing that is watched, for sure: heights, ranges and times stay
/// strictly between what is waited for, and what may turn keeps its way. Steps of which that is not sure need a closer
/// look.
template <class S>
class QuietWatch {
 public:
  /// From the start of a step that has not been taken yet. Conditions and list must stay as long as this.
  PHYSIM_INLINE QuietWatch(const Conditions<S>& all, const WatchList& watch, const Flyer<S>& l)
      : all_(all), watch_(watch), climb_(climb_rate(all, l.step.start)), advance_(range_rate(l.body, l.step.start.v)) {
    PHYSIM_ASSERT(watch.count >= 0 && watch.count <= kMaxWatched);
    const State<S>& s = l.step.start;
    const S high = height(all, s.x), far = range(l.body, s.x);
    for (int i = 0; i < watch.count; ++i) {
      const EventSpec& spec = watch.item[i].spec;
      const Watch kind = row_of(spec.kind).watch;
      if (kind == Watch::height)
        height_.add(i, spec, high);
      else if (kind == Watch::range)
        range_.add(i, spec, far);
      else if (kind == Watch::time)
        time_.add(i, spec, l.step.t);
      else if (kind == Watch::climb_rate)
        climbs_ |= WatchedSet(1) << i;
      else
        others_ |= WatchedSet(1) << i, at_[i] = numbers(l.body, spec, l.step.t, s, l.step.slope[0].v);
    }
  }

  /// What a step from where the last one ended, to a state at t_end with the acceleration a, may have crossed. If that
  /// is something, this watch is over. `c` is what the compiler knows about the conditions.
  PHYSIM_INLINE WatchedSet may_cross(const Conditions<S>& c, const Body<S>& b, const S& t_end, const State<S>& end,
                                     const Vec3<S>& a) {
    WatchedSet some = time_.holds(t_end) ? 0 : time_.items;
    const bool turned = !(climb_rate(c, end) * climb_ > S(0));
    if (turned || !height_.holds(height(c, end.x))) some |= height_.items;
    if (turned) some |= climbs_;
    if (range_.items != 0 && !(range_.holds(range(b, end.x)) && range_rate(b, end.v) * advance_ > S(0)))
      some |= range_.items;
    if (others_ != 0) some |= look_at_others(b, t_end, end, a);
    return some;
  }

 private:
  /// What a quantity stays strictly between, of which some items wait for a value. A comparison says what the sign of a
  /// difference says, to the bit.
  struct Bounds {
    S low = -std::numeric_limits<S>::infinity(), high = std::numeric_limits<S>::infinity();
    WatchedSet items = 0;

    PHYSIM_INLINE void add(int item, const EventSpec& spec, const S& now) {
      const S awaited = static_cast<S>(spec.value);
      items |= WatchedSet(1) << item;
      if (!(awaited > now)) low = max(low, awaited);
      if (!(awaited < now)) high = min(high, awaited);
    }
    [[nodiscard]] PHYSIM_INLINE bool holds(const S& x) const { return low < x && x < high; }
  };
  struct Numbers {
    S value;
    S rate;  // 1 of what may not turn
  };

  [[nodiscard]] Numbers numbers(const Body<S>& b, const EventSpec& spec, const S& t, const State<S>& s,
                                const Vec3<S>& a) const {
    const bool turns = may_turn(row_of(spec.kind).watch);
    return {watched_value(all_, b, spec, t, s), turns ? watched_rate(all_, b, spec, s, a) : S(1)};
  }

  /// Which of the quantities that few flights watch may have been crossed since the last look.
  [[gnu::noinline]] WatchedSet look_at_others(const Body<S>& b, const S& t, const State<S>& s, const Vec3<S>& a) {
    WatchedSet some = 0;
    for (int i = 0; i < watch_.count; ++i) {
      if (!contains(others_, i)) continue;
      const Numbers there = numbers(b, watch_.item[i].spec, t, s, a);
      const bool quiet = at_[i].value * there.value > S(0) && at_[i].rate * there.rate > S(0);
      if (!quiet) some |= WatchedSet(1) << i;
      at_[i] = there;
    }
    return some;
  }

  const Conditions<S>& all_;
  const WatchList& watch_;
  Bounds height_, range_, time_;
  WatchedSet climbs_ = 0, others_ = 0;
  S climb_, advance_;        // rates of height and range where the watch began
  Numbers at_[kMaxWatched];  // of the others, where the last step ended
};

PHYSIM_ISA_END
