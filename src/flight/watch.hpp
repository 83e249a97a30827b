// Watching for events: detecting that a step crosses one, and finding where.
//
// Detection runs on packs, once per accepted step; finding runs on one lane in double, on the step's dense output. Both
// doors, fly() and fly_batch(), use the same two functions, so that their events agree bit for bit.
#pragma once

#include "math/root.hpp"
#include "physim/flight.hpp"
#include "solve/regime.hpp"

namespace physim {

inline constexpr int kMaxWatched = 32;

/// How closely the place of an event in its step is found [-]: a few roundings.
inline constexpr double kThetaTolerance = 1e-15;

/// An event to look for, with what it means when it ends the flight.
struct Watched {
  EventSpec spec;
  Outcome outcome;  // of terminal events
};

/// The events of a cohort.
struct WatchList {
  Watched item[kMaxWatched];
  int count;
};

/// A crossing inside a step.
struct Found {
  double theta;  // place in the step, 0..1
  int index;     // in the watch list
  bool rising;
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// The quantity that an event watches, less the value it waits for.
template <class R, class S>
PHYSIM_INLINE R watched_value(const Conditions<S>& c, const Body<R>& b, const EventSpec& spec, const R& t,
                              const State<R>& s) {
  const R value = constant<R>(spec.value);
  switch (spec.kind) {
    case EventKind::ground:
    case EventKind::height:
      return height(c, s.x) - value;
    case EventKind::apex:
      return climb_rate(c, s);
    case EventKind::range:
      return dot(s.x - b.launch.x, b.sight) - value;
    case EventKind::mach:
      return length(air_velocity(c, s)) * air_state(c, s.x).per_sound_speed - value;
    case EventKind::speed:
      return length(s.v) - value;
    case EventKind::time:
      break;
  }
  return t - value;
}

template <class R>
PHYSIM_INLINE MaskOf<R> crosses(Crossing direction, const R& from, const R& to) {
  using S = ScalarOf<R>;
  const R zero(S(0));
  const auto rising = (from < zero) & (to >= zero);
  const auto falling = (from > zero) & (to <= zero);
  if (direction == Crossing::rising) return rising;
  if (direction == Crossing::falling) return falling;
  return rising | falling;
}

/// The sign of this is the sign of the rate at which the watched quantity changes; zero for quantities whose turning
/// points are not looked for (Mach number) or that have none (time).
template <class R, class S>
PHYSIM_INLINE R watched_rate(const Conditions<S>& c, const Body<R>& b, const EventSpec& spec, const State<R>& s,
                             const Vec3<R>& a) {
  switch (spec.kind) {
    case EventKind::ground:
    case EventKind::height:
      return climb_rate(c, s);
    case EventKind::range:
      return dot(s.v, b.sight);
    case EventKind::speed:
      return dot(s.v, a);
    default:
      return R(S(0));
  }
}

/// A step in which the quantity turns on the far side of the value: it may cross it twice and end where it began.
template <class R>
PHYSIM_INLINE MaskOf<R> may_cross_twice(const R& from, const R& to, const R& rate_from, const R& rate_to) {
  using S = ScalarOf<R>;
  const R zero(S(0));
  const auto peak = (from <= zero) & (to <= zero) & (rate_from > zero) & (rate_to <= zero);
  const auto dip = (from >= zero) & (to >= zero) & (rate_from < zero) & (rate_to >= zero);
  return peak | dip;
}

/// Lanes in which a step crosses something watched, or may cross it twice. `a_start` and `a_end` are the accelerations
/// at its ends.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> detect(const Conditions<S>& c, const Body<R>& b, const WatchList& watch, const Step<R>& s,
                               const Vec3<R>& a_start, const Vec3<R>& a_end) {
  MaskOf<R> found = R(S(0)) != R(S(0));
  for (int i = 0; i < watch.count; ++i) {
    const EventSpec& spec = watch.item[i].spec;
    const R from = watched_value(c, b, spec, s.t, s.start);
    const R to = watched_value(c, b, spec, s.t_end, s.end);
    found =
        found | crosses(spec.direction, from, to) |
        may_cross_twice(from, to, watched_rate(c, b, spec, s.start, a_start), watched_rate(c, b, spec, s.end, a_end));
  }
  return found;
}

/// Collects the crossings of one step.
struct CrossingList {
  Found* found;
  int count = 0;

  PHYSIM_INLINE void add(double theta, int index, bool rising) {
    if (count < 2 * kMaxWatched) found[count++] = {theta, index, rising};
  }
  /// Insertion sort: few, nearly sorted, and stable.
  void sort() {
    for (int i = 1; i < count; ++i)
      for (int j = i; j > 0 && found[j].theta < found[j - 1].theta; --j) {
        const Found swap = found[j];
        found[j] = found[j - 1];
        found[j - 1] = swap;
      }
  }
};

/// Finds the crossings of one watched quantity in a step.
template <class F>
void find_crossings_of(const Conditions<double>& c, const Body<double>& b, const EventSpec& spec, int index,
                       const F& at, CrossingList& list) {
  const double t = at.n0.t;
  const double h = at.n1.t - t;
  const auto value = [&](double theta) { return watched_value(c, b, spec, t + theta * h, at(theta)); };
  const auto look_between = [&](double from, double at_from, double to, double at_to) {
    if (!crosses(spec.direction, at_from, at_to)) return;
    // Near the root the quantity is as large as the value waited for; what it was elsewhere in the step says nothing.
    const double noise = 2.220446049250313e-16 * (abs(spec.value) + min(abs(at_from), abs(at_to)));
    list.add(find_root(value, from, at_from, to, at_to, kThetaTolerance, noise), index, at_from < 0);
  };
  const double at_start = at.watched_at(spec, at.n0);
  const double at_end = at.watched_at(spec, at.n1);
  const double rate_start = watched_rate(c, b, spec, at.n0.y, at.n0.a);
  const double rate_end = watched_rate(c, b, spec, at.n1.y, at.n1.a);
  if (!may_cross_twice(at_start, at_end, rate_start, rate_end)) return look_between(0, at_start, 1, at_end);
  const auto rate = [&](double theta) {
    const State<double> s = at(theta);
    return watched_rate(c, b, spec, s, acceleration(c, b, t + theta * h, s));
  };
  const double turn = find_root(rate, 0, rate_start, 1, rate_end, kThetaTolerance);
  const double at_turn = value(turn);
  // A shot from below the ground that never comes out of it has landed when it sinks.
  if (spec.kind == EventKind::ground && rate_start > 0 && at_turn <= 0) return list.add(turn, index, false);
  look_between(0, at_start, turn, at_turn);
  look_between(turn, at_turn, 1, at_end);
}

/// Finds every crossing in a step, in order of time, up to and with the first terminal one; returns how many.
/// `at` is the dense output, with the nodes n0 and n1 at its ends; whether something is crossed is decided as detect()
/// does, by its watched_at().
template <class F>
int find_crossings(const Conditions<double>& c, const Body<double>& b, const WatchList& watch, const F& at,
                   Found* found) {
  CrossingList list{found};
  for (int i = 0; i < watch.count; ++i) find_crossings_of(c, b, watch.item[i].spec, i, at, list);
  list.sort();
  for (int i = 0; i < list.count; ++i)
    if (watch.item[found[i].index].spec.terminal) return i + 1;
  return list.count;
}

PHYSIM_ISA_END
