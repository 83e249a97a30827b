// Watching for events: detecting that a step crosses one, and finding where.
//
// Detection runs once per accepted step, finding in double on the dense output of steps that cross something. Both
// doors, fly() with one lane and fly_batch() with packs, use the same two functions, so that their events agree bit for
// bit.
#pragma once

#include "base/assert.hpp"
#include "base/event_table.hpp"
#include "math/root.hpp"
#include "math/vec3.hpp"
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
  bool without_air;  // judging a step reads no air of a body: neither what is watched nor the dense output
};

/// A crossing inside a step.
struct Found {
  double theta;  // place in the step, 0..1
  int index;     // in the watch list
  bool rising;
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// Behind a call: air and wind are long, and few flights watch it.
template <class R, class S>
[[gnu::noinline]] void mach_number(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s, R& mach) {
  mach = length(air_velocity(c, b, t, s)) * air_state(c, b, s.x).per_sound_speed;
}

/// The quantity that an event watches, less the value it waits for.
template <class R, class S>
PHYSIM_INLINE R watched_value(const Conditions<S>& c, const Body<R>& b, const EventSpec& spec, const R& t,
                              const State<R>& s) {
  const R value = constant<R>(spec.value);
  switch (row_of(spec.kind).watch) {
    case Watch::height: return height(c, s.x) - value;
    case Watch::climb_rate: return climb_rate(c, s);
    case Watch::range: return dot(s.x - b.launch.x, b.sight) - value;
    case Watch::mach: {
      R mach;
      mach_number(c, b, t, s, mach);
      return mach - value;
    }
    case Watch::speed: return length(s.v) - value;
    case Watch::ignition: return t - b.ignition;
    case Watch::burnout: return t - b.burnout;
    case Watch::rail: return select(b.rail_phase < constant<R>(kOffRail), dot(s.x, b.rail) - b.rail_end, R(S(1)));
    case Watch::none:
    case Watch::time: break;
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
  switch (row_of(spec.kind).watch) {
    case Watch::height: return climb_rate(c, s);
    case Watch::range: return dot(s.v, b.sight);
    case Watch::speed: return dot(s.v, a);
    case Watch::none:
    case Watch::climb_rate:
    case Watch::mach:
    case Watch::time:
    case Watch::ignition:
    case Watch::burnout:
    case Watch::rail: break;
  }
  return R(S(0));
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

/// What detect() says about lanes.
template <class R>
struct Detected {
  MaskOf<R> some;             // something watched is crossed, or may be crossed twice
  MaskOf<R> surely_terminal;  // something that ends the flight is crossed
  MaskOf<R> maybe_terminal;   // ... or may be crossed twice
};

/// Whether a step crosses something watched. `a_start` and `a_end` are the accelerations at its ends.
template <class R, class S>
PHYSIM_INLINE Detected<R> detect(const Conditions<S>& c, const Body<R>& b, const WatchList& watch, const Step<R>& s,
                                 const Vec3<R>& a_start, const Vec3<R>& a_end) {
  PHYSIM_ASSERT(watch.count >= 0 && watch.count <= kMaxWatched);
  const MaskOf<R> none = R(S(0)) != R(S(0));
  Detected<R> d{none, none, none};
  for (int i = 0; i < watch.count; ++i) {
    const EventSpec& spec = watch.item[i].spec;
    const R from = watched_value(c, b, spec, s.t, s.start);
    const R to = watched_value(c, b, spec, s.t_end, s.end);
    MaskOf<R> twice = none;
    if (may_turn(row_of(spec.kind).watch))
      twice =
          may_cross_twice(from, to, watched_rate(c, b, spec, s.start, a_start), watched_rate(c, b, spec, s.end, a_end));
    const MaskOf<R> once = crosses(spec.direction, from, to);
    d.some = d.some | once | twice;
    if (!spec.terminal) continue;
    d.surely_terminal = d.surely_terminal | (once & !twice);
    d.maybe_terminal = d.maybe_terminal | once | twice;
  }
  return d;
}

/// The crossings of one lane's step.
struct CrossingList {
  Found found[2 * kMaxWatched];
  int count;

  PHYSIM_INLINE void add(double theta, int index, bool rising) {
    PHYSIM_ASSERT(count >= 0 && count < 2 * kMaxWatched);  // each that is watched is found twice at most
    found[count++] = {theta, index, rising};
  }
  /// In order of time, up to and with the first terminal one. Insertion sort: few, nearly sorted, and stable.
  void put_in_order(const WatchList& watch) {
    for (int i = 1; i < count; ++i)
      for (int j = i; j > 0 && found[j].theta < found[j - 1].theta; --j) {
        const Found swap = found[j];
        found[j] = found[j - 1];
        found[j - 1] = swap;
      }
    for (int i = 0; i < count; ++i)
      if (watch.item[found[i].index].spec.terminal) count = i + 1;
  }
};

/// Finds the crossings of one watched quantity in the steps of lanes.
template <class W, class Dense>
struct CrossingFinder {
  const Conditions<double>& c;
  const EventSpec& spec;
  int index;  // in the watch list
  const Dense& at;
  CrossingList* lists;

  PHYSIM_INLINE void find(const MaskOf<W>& asked) const {
    const W at_start = at.watched_at_start(spec);
    const W at_end = at.watched_at_end(spec);
    const W rate_start = watched_rate(c, at.body, spec, at.n0.y, at.n0.a);
    const W rate_end = watched_rate(c, at.body, spec, at.n1.y, at.n1.a);
    const MaskOf<W> twice = asked & may_cross_twice(at_start, at_end, rate_start, rate_end);
    look_between(W(0.0), at_start, W(1.0), at_end, asked & !twice);
    if (any(twice)) look_around_turn(at_start, rate_start, at_end, rate_end, twice);
  }

 private:
  PHYSIM_INLINE W value(const W& theta) const { return watched_value(c, at.body, spec, at.time(theta), at(theta)); }

  PHYSIM_INLINE void add(const MaskOf<W>& lanes, const W& theta, const MaskOf<W>& rising) const {
    for (unsigned left = lane_bits(lanes); left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      PHYSIM_ASSERT(lane_of(theta, lane) >= 0 && lane_of(theta, lane) <= 1);
      lists[lane].add(lane_of(theta, lane), index, lane_of(rising, lane));
    }
  }

  [[gnu::noinline]] void look_between(const W& from, const W& at_from, const W& to, const W& at_to,
                                      const MaskOf<W>& asked) const {
    const MaskOf<W> crossing = asked & crosses(spec.direction, at_from, at_to);
    if (!any(crossing)) return;
    // Near the root the quantity is as large as the value waited for; what it was elsewhere in the step says nothing.
    const W noise = 2.220446049250313e-16 * (abs(spec.value) + min(abs(at_from), abs(at_to)));
    const auto f = [&](const W& theta) { return value(theta); };
    add(crossing, find_roots(f, from, at_from, to, at_to, kThetaTolerance, noise, crossing), at_from < W(0.0));
  }

  [[gnu::noinline]] void look_around_turn(const W& at_start, const W& rate_start, const W& at_end, const W& rate_end,
                                          const MaskOf<W>& asked) const {
    const W zero(0.0);
    const auto rate = [&](const W& theta) {
      const State<W> s = at(theta);
      return watched_rate(c, at.body, spec, s, at.acceleration(theta, s));
    };
    const W turn = find_roots(rate, zero, rate_start, W(1.0), rate_end, kThetaTolerance, zero, asked);
    const W at_turn = value(turn);
    // A shot from below the ground that never comes out of it has landed when it sinks.
    const MaskOf<W> is_ground = spec.kind == EventKind::ground ? asked : zero != zero;
    const MaskOf<W> drowned = is_ground & (rate_start > zero) & (at_turn <= zero);
    add(drowned, turn, zero != zero);
    look_between(zero, at_start, turn, at_turn, asked & !drowned);
    look_between(turn, at_turn, W(1.0), at_end, asked & !drowned);
  }
};

/// Finds every crossing in the steps of the lanes asked for, in order of time, up to and with the first terminal one.
/// `at` is the dense output, with the nodes n0 and n1 at its ends; whether something is crossed is decided as detect()
/// does, by the watched values there.
template <class W, class Dense>
PHYSIM_INLINE void find_crossings(const Conditions<double>& c, const WatchList& watch, const Dense& at,
                                  const MaskOf<W>& asked, CrossingList* lists) {
  for (int i = 0; i < watch.count; ++i) CrossingFinder<W, Dense>{c, watch.item[i].spec, i, at, lists}.find(asked);
  for (unsigned left = lane_bits(asked); left != 0; left &= left - 1) lists[__builtin_ctz(left)].put_in_order(watch);
}

PHYSIM_ISA_END
