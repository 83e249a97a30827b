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

PHYSIM_INLINE bool watches_height(const EventSpec& spec) {
  return spec.kind == EventKind::ground || spec.kind == EventKind::height;
}

/// Lanes in which a step crosses something watched. A step that goes over the apex and has a height above both its ends
/// may cross it twice, up and down; such lanes count too.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> detect(const Conditions<S>& c, const Body<R>& b, const WatchList& watch, const Step<R>& s) {
  const R zero(S(0));
  MaskOf<R> found = zero != zero;
  MaskOf<R> below = found;  // lanes with a watched height at or above both ends
  for (int i = 0; i < watch.count; ++i) {
    const EventSpec& spec = watch.item[i].spec;
    const R from = watched_value(c, b, spec, s.t, s.start);
    const R to = watched_value(c, b, spec, s.t_end, s.end);
    found = found | crosses(spec.direction, from, to);
    if (watches_height(spec)) below = below | ((from <= zero) & (to <= zero));
  }
  if (any(below)) found = found | (below & crosses(Crossing::falling, climb_rate(c, s.start), climb_rate(c, s.end)));
  return found;
}

/// Finds every crossing in a step, in order of time, up to and with the first terminal one; returns how many.
/// `at` is the dense output, with the nodes n0 and n1 at its ends; whether something is crossed is decided as detect()
/// does, by its watched_at().
template <class F>
int find_crossings(const Conditions<double>& c, const Body<double>& b, const WatchList& watch, const F& at,
                   Found* found) {
  const double t = at.n0.t;
  const double h = at.n1.t - t;
  const double climb_start = climb_rate(c, at.n0.y);
  const double climb_end = climb_rate(c, at.n1.y);
  double apex = 1;
  if (climb_start > 0 && climb_end < 0)
    apex = find_root([&](double theta) { return climb_rate(c, at(theta)); }, 0, climb_start, 1, climb_end,
                     kThetaTolerance);
  int count = 0;
  for (int i = 0; i < watch.count; ++i) {
    const EventSpec& spec = watch.item[i].spec;
    const auto value = [&](double theta) { return watched_value(c, b, spec, t + theta * h, at(theta)); };
    const auto look_between = [&](double from, double at_from, double to, double at_to) {
      if (!crosses(spec.direction, at_from, at_to) || count == 2 * kMaxWatched) return;
      // Near the root the quantity is as large as the value waited for; what it was elsewhere in the step says nothing.
      const double noise = 2.220446049250313e-16 * (abs(spec.value) + min(abs(at_from), abs(at_to)));
      found[count++] = {find_root(value, from, at_from, to, at_to, kThetaTolerance, noise), i, at_from < 0};
    };
    const double at_start = at.watched_at(spec, at.n0);
    const double at_end = at.watched_at(spec, at.n1);
    if (apex < 1 && watches_height(spec)) {
      const double at_apex = value(apex);
      look_between(0, at_start, apex, at_apex);
      look_between(apex, at_apex, 1, at_end);
    } else {
      look_between(0, at_start, 1, at_end);
    }
  }
  for (int i = 1; i < count; ++i)  // insertion sort: few, nearly sorted, and stable
    for (int j = i; j > 0 && found[j].theta < found[j - 1].theta; --j) {
      const Found swap = found[j];
      found[j] = found[j - 1];
      found[j - 1] = swap;
    }
  for (int i = 0; i < count; ++i)
    if (watch.item[found[i].index].spec.terminal) return i + 1;
  return count;
}

PHYSIM_ISA_END
