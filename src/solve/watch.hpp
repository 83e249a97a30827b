// Watching for events: detecting that a step crosses one, and finding where.
//
// Detection runs once per accepted step, finding in double on the dense output of steps that cross something. Both
// doors, fly() with one lane and fly_batch() with packs, use the same two functions, so that their events agree bit for
// bit.
#pragma once

#include "base/assert.hpp"
#include "base/event_table.hpp"
#include "math/lane_bits.hpp"
#include "math/root.hpp"
#include "math/vec3.hpp"
#include "physim/flight.hpp"
#include "solve/regime.hpp"
#include "solve/step.hpp"

namespace physim {

inline constexpr int kMaxWatched = 32;

/// Some items of a watch list: bit i is item i.
using WatchedSet = std::uint32_t;
inline constexpr WatchedSet kAllWatched = ~WatchedSet(0);
static_assert(kMaxWatched <= 32);
PHYSIM_INLINE constexpr bool contains(WatchedSet set, int item) { return (set >> item & 1u) != 0; }

/// How closely the place of an event in its step is found [-]: a few roundings.
inline constexpr double kThetaTolerance = 1e-15;

/// An event to look for, with what it means when it ends the flight.
struct Watched {
  EventSpec spec;
  Outcome outcome;  // of terminal events
};

/// The events of a cohort.
struct WatchList {
  WatchList() {}  // NOLINT: items behind the count stay as they are

  union {
    Watched item[kMaxWatched];
  };
  int count = 0;
  bool lands = false;        // of a flight: what drops from the ground has landed
  bool without_air = false;  // judging a step reads no air of a body: neither what is watched nor the dense output
};

/// A crossing inside a step.
struct Found {
  double theta;  // place in the step, 0..1
  int index;     // in the watch list
  bool rising;
};

}  // namespace physim

PHYSIM_ISA_BEGIN

/// The Mach number, 0 in a vacuum. Behind a call: air and wind are long, and few flights watch it.
template <class R, class S>
PHYSIM_NOINLINE void mach_number(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s, R& mach) {
  mach = R(S(0));
  if (c.fidelity.air == AirModel::vacuum) return;
  mach = length(air_velocity(c, b, t, s)) * air_state(c, b, s.x).per_sound_speed;
}

/// The way from the launch along the line of sight [m], and how fast it grows [m/s].
template <class R>
PHYSIM_INLINE R range(const Body<R>& b, const Vec3<R>& x) {
  return dot(x - b.launch.x, b.sight);
}
template <class R>
PHYSIM_INLINE R range_rate(const Body<R>& b, const Vec3<R>& v) {
  return dot(v, b.sight);
}

/// The quantity that is watched, less the value that is waited for.
template <class R, class S>
PHYSIM_INLINE R watched_value(const Conditions<S>& c, const Body<R>& b, Watch watch, double waits_for, const R& t,
                              const State<R>& s) {
  const R value = constant<R>(waits_for);
  switch (watch) {
    case Watch::height: return height(c, s.x) - value;
    case Watch::climb_rate: return climb_rate(c, s);
    case Watch::range: return range(b, s.x) - value;
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
template <class R, class S>
PHYSIM_INLINE R watched_value(const Conditions<S>& c, const Body<R>& b, const EventSpec& spec, const R& t,
                              const State<R>& s) {
  return watched_value(c, b, row_of(spec.kind).watch, spec.value, t, s);
}

/// On which side of zero a number lies; for NaN nothing holds.
template <class R>
struct SideOf {
  const R& x;
  PHYSIM_INLINE MaskOf<R> below() const { return x < zero(); }
  PHYSIM_INLINE MaskOf<R> above() const { return x > zero(); }
  PHYSIM_INLINE MaskOf<R> not_below() const { return x >= zero(); }
  PHYSIM_INLINE MaskOf<R> not_above() const { return x <= zero(); }

 private:
  PHYSIM_INLINE static R zero() { return R(ScalarOf<R>(0)); }
};

/// ... in bits of lanes.
struct SideBits {
  unsigned at_least, at_most;
  PHYSIM_INLINE unsigned below() const { return at_most & ~at_least; }
  PHYSIM_INLINE unsigned above() const { return at_least & ~at_most; }
  PHYSIM_INLINE unsigned not_below() const { return at_least; }
  PHYSIM_INLINE unsigned not_above() const { return at_most; }
};

template <class Side>
PHYSIM_INLINE auto side_changes(Crossing direction, const Side& from, const Side& to) {
  const auto rising = from.below() & to.not_below();
  const auto falling = from.above() & to.not_above();
  if (direction == Crossing::rising) return rising;
  if (direction == Crossing::falling) return falling;
  return rising | falling;
}
template <class R>
PHYSIM_INLINE MaskOf<R> crosses(Crossing direction, const R& from, const R& to) {
  return MaskOf<R>(side_changes(direction, SideOf<R>{from}, SideOf<R>{to}));
}

/// The sign of this is the sign of the rate at which the watched quantity changes; zero for quantities without a search
/// for turning points (Mach number) or without such points (time).
template <class R, class S>
PHYSIM_INLINE R watched_rate(const Conditions<S>& c, const Body<R>& b, const EventSpec& spec, const State<R>& s,
                             const Vec3<R>& a) {
  switch (row_of(spec.kind).watch) {
    case Watch::height: return climb_rate(c, s);
    case Watch::range: return range_rate(b, s.v);
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

/// The rate at which the watched quantity changes at an end of a step, or nearly; zero where it is not known, and in
/// the original loop, with straight steps.
template <class R, class S>
PHYSIM_INLINE R rough_rate(const Conditions<S>& c, const Body<R>& b, const EventSpec& spec, const State<R>& s,
                           const Vec3<R>& a) {
  const Watch watch = row_of(spec.kind).watch;
  if (c.fidelity.integrator == Integrator::classic) return R(S(0));
  if (watch == Watch::climb_rate) return climb_rate(c, State<R>{s.x, a});
  return watch == Watch::height || watch == Watch::range ? watched_rate(c, b, spec, s, a) : R(S(0));
}

/// A step in which the quantity turns on the far side of the value: it may cross it twice and end where it began.
template <class Side>
PHYSIM_INLINE auto side_may_change_twice(const Side& from, const Side& to, const Side& rate_from, const Side& rate_to) {
  const auto peak = from.not_above() & to.not_above() & rate_from.above() & rate_to.not_above();
  const auto dip = from.not_below() & to.not_below() & rate_from.below() & rate_to.not_below();
  return peak | dip;
}
template <class R>
PHYSIM_INLINE MaskOf<R> may_cross_twice(const R& from, const R& to, const R& rate_from, const R& rate_to) {
  using Side = SideOf<R>;
  return MaskOf<R>(side_may_change_twice(Side{from}, Side{to}, Side{rate_from}, Side{rate_to}));
}

/// A step that begins on the ground, not upwards, and ends below it: a level launch that nothing lifts, or the end of a
/// level rail. The flight lands where the step begins.
template <class Side>
PHYSIM_INLINE auto side_drops(const Side& from, const Side& to, const Side& rate_from) {
  return from.not_below() & from.not_above() & rate_from.not_above() & to.below();
}

/// Where lanes stand with one watched quantity at an end of a step: the sides of its value, and of its rate where it
/// may turn. What stands at the end of a step that is accepted stands at the start of the next.
class Standing {
 public:
  Standing() = default;
  PHYSIM_INLINE Standing(const SideBits& value, const SideBits& rate) : value_(joined(value)), rate_(joined(rate)) {}

  [[nodiscard]] PHYSIM_INLINE SideBits value() const { return {unsigned(value_), unsigned(value_ >> kField)}; }
  [[nodiscard]] PHYSIM_INLINE SideBits rate() const { return {unsigned(rate_), unsigned(rate_ >> kField)}; }
  /// Takes over some lanes of another one.
  PHYSIM_INLINE void take(const Standing& from, unsigned lanes) {
    const std::uint64_t taken = kFirstLane * lanes;
    value_ = (value_ & ~taken) | (from.value_ & taken);
    rate_ = (rate_ & ~taken) | (from.rate_ & taken);
  }
  /// ... or one lane, from another lane.
  PHYSIM_INLINE void take(const Standing& from, int from_lane, int lane) {
    PHYSIM_ASSERT(from_lane >= 0 && from_lane < kField && lane >= 0 && lane < kField);
    const std::uint64_t others = ~(kFirstLane << lane);
    value_ = (value_ & others) | ((from.value_ >> from_lane & kFirstLane) << lane);
    rate_ = (rate_ & others) | ((from.rate_ >> from_lane & kFirstLane) << lane);
  }

 private:
  static constexpr int kField = 32;                           // bits of lanes
  static constexpr std::uint64_t kFirstLane = 0x1'0000'0001;  // of both fields
  PHYSIM_INLINE static std::uint64_t joined(const SideBits& side) {
    return std::uint64_t(side.at_most) << kField | side.at_least;
  }

  std::uint64_t value_ = 0;
  std::uint64_t rate_ = 0;
};

/// Where lanes stand in a state at the time t, with the acceleration a.
template <class R, class S>
PHYSIM_INLINE Standing standing(const Conditions<S>& c, const Body<R>& b, const EventSpec& spec, const R& t,
                                const State<R>& s, const Vec3<R>& a) {
  const R zero(S(0));
  const auto side = [&](const R& x) PHYSIM_INLINE_LAMBDA {
    return SideBits{lanes_at_least(x, zero), lanes_at_most(x, zero)};
  };
  const SideBits value = side(watched_value(c, b, spec, t, s));
  if (!may_turn(row_of(spec.kind).watch)) return {value, {0, 0}};
  return {value, side(watched_rate(c, b, spec, s, a))};
}

/// What detect() says about lanes, in their bits.
struct Detected {
  unsigned some = 0;             // something watched is crossed, or may be crossed twice
  unsigned surely_terminal = 0;  // something that ends the flight is crossed
  unsigned maybe_terminal = 0;   // ... or may be crossed twice

  /// Looks at one watched quantity.
  PHYSIM_INLINE void add(const EventSpec& spec, const Standing& from, const Standing& to, bool lands) {
    const unsigned twice = side_may_change_twice(from.value(), to.value(), from.rate(), to.rate());
    unsigned once = side_changes(spec.direction, from.value(), to.value());
    if (lands && spec.kind == EventKind::ground) once |= side_drops(from.value(), to.value(), from.rate());
    some |= once | twice;
    if (!spec.terminal) return;
    surely_terminal |= once & ~twice;
    maybe_terminal |= once | twice;
  }
};

/// Whether a step crosses something watched, of the items that are asked for. `a_start` and `a_end` are the
/// accelerations at its ends.
template <class R, class S>
PHYSIM_INLINE Detected detect(const Conditions<S>& c, const Body<R>& b, const WatchList& watch, const Step<R>& s,
                              const Vec3<R>& a_start, const Vec3<R>& a_end, WatchedSet items = kAllWatched) {
  PHYSIM_ASSERT(watch.count >= 0 && watch.count <= kMaxWatched);
  Detected d;
  for (int i = 0; i < watch.count; ++i) {
    if (!contains(items, i)) continue;
    const EventSpec& spec = watch.item[i].spec;
    d.add(spec, standing(c, b, spec, s.t, s.start, a_start), standing(c, b, spec, s.t_end, s.end, a_end), watch.lands);
  }
  return d;
}

/// Where lanes stand with all that is watched at the starts of their steps, so that a step is looked at once, at its
/// end.
template <class R>
class StandingWatch {
 public:
  /// At steps that have not been taken yet.
  template <class S>
  PHYSIM_INLINE void begin(const Conditions<S>& c, const WatchList& watch, const Flyer<R>& l) {
    count_ = watch.count;
    for (int i = 0; i < count_; ++i)
      at_[i] = standing(c, l.body, watch.item[i].spec, l.step.t, l.step.start, l.step.slope[0].v);
  }
  /// As detect(), of steps from where begin() or the last call left off; those of `accepted` lanes are over.
  template <class S>
  PHYSIM_INLINE Detected pass(const Conditions<S>& c, const WatchList& watch, const Flyer<R>& l, int last_slope,
                              unsigned accepted) {
    PHYSIM_ASSERT(count_ == watch.count);
    Detected d;
    for (int i = 0; i < count_; ++i) {
      const EventSpec& spec = watch.item[i].spec;
      const Standing end = standing(c, l.body, spec, l.step.t_end, l.step.end, l.step.slope[last_slope].v);
      d.add(spec, at_[i], end, watch.lands);
      at_[i].take(end, accepted);
    }
    return d;
  }
  /// Copies one lane.
  PHYSIM_INLINE void take(const StandingWatch& from, int from_lane, int lane) {
    for (int i = 0; i < count_; ++i) at_[i].take(from.at_[i], from_lane, lane);
  }

 private:
  Standing at_[kMaxWatched];
  int count_ = 0;
};

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

/// How far a watched quantity near its value is from nothing but for rounding: interpolants add what happens in the
/// step to where it starts.
template <class W>
PHYSIM_INLINE W crossing_noise(double value, const W& from, const W& to) {
  return 2 * 2.220446049250313e-16 * (W(abs(value)) + abs(from) + abs(to));
}

/// Finds the crossings of one watched quantity in the steps of lanes.
template <class W, class Dense>
struct CrossingFinder {
  const Conditions<double>& c;
  const EventSpec& spec;
  int index;  // in the watch list
  const Dense& at;
  CrossingList* lists;
  bool lands = false;  // as WatchList::lands
  const Watch watch = row_of(spec.kind).watch;

  PHYSIM_INLINE void find(const MaskOf<W>& asked) const {
    const W at_start = at.watched_at_start(spec);
    const W at_end = at.watched_at_end(spec);
    const W rate_start = watched_rate(c, at.body, spec, at.n0.y, at.n0.a);
    const W rate_end = watched_rate(c, at.body, spec, at.n1.y, at.n1.a);
    const MaskOf<W> twice = asked & may_cross_twice(at_start, at_end, rate_start, rate_end);
    using Side = SideOf<W>;
    const W zero(0.0);
    if (lands && spec.kind == EventKind::ground)
      add(asked & MaskOf<W>(side_drops(Side{at_start}, Side{at_end}, Side{rate_start})), zero, zero != zero);
    const W h = at.n1.t - at.n0.t;
    const EndRates<W> rates{rough_rate(c, at.body, spec, at.n0.y, at.n0.a) * h,
                            rough_rate(c, at.body, spec, at.n1.y, at.n1.a) * h};
    look_between(W(0.0), at_start, W(1.0), at_end, asked & !twice, &rates);
    if (any(twice)) look_around_turn(at_start, rate_start, at_end, rate_end, twice);
  }

 private:
  PHYSIM_INLINE W value(const W& theta, const State<W>& s) const {
    return watched_value(c, at.body, watch, spec.value, at.time(theta), s);
  }
  /// Searches call it again and again: of the state the commonest quantities get what they read, and the compiler
  /// leaves out the rest.
  PHYSIM_INLINE W value(const W& theta) const {
    const bool is_flat = column<&EarthRow::shape>(c.fidelity.earth) == EarthShape::flat;
    if (watch == Watch::range) return value(theta, {at(theta).x, {}});
    if (watch == Watch::climb_rate && is_flat) return value(theta, {{}, at(theta).v});
    return value(theta, at(theta));
  }

  PHYSIM_INLINE void add(const MaskOf<W>& lanes, const W& theta, const MaskOf<W>& rising) const {
    for (unsigned left = lane_bits(lanes); left != 0; left &= left - 1) {
      const int lane = __builtin_ctz(left);
      PHYSIM_ASSERT(lane_of(theta, lane) >= 0 && lane_of(theta, lane) <= 1);
      lists[lane].add(lane_of(theta, lane), index, lane_of(rising, lane));
    }
  }

  [[gnu::noinline]] void look_between(const W& from, const W& at_from, const W& to, const W& at_to,
                                      const MaskOf<W>& asked, const EndRates<W>* rates = nullptr) const {
    const MaskOf<W> crossing = asked & crosses(spec.direction, at_from, at_to);
    if (!any(crossing)) return;
    const W noise = crossing_noise(spec.value, at_from, at_to);
    const auto f = [&](const W& theta) { return value(theta); };
    add(crossing, find_roots(f, from, at_from, to, at_to, kThetaTolerance, noise, crossing, rates), at_from < W(0.0));
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
    const MaskOf<W> hops = asked & (rate_start > zero) & (at_turn <= zero);
    W first = zero, at_first = at_start;
    put_behind_start(turn, at_turn, hops & (at_start == zero), first, at_first);
    // A shot from below the ground that never comes out of it has landed when it sinks, one from the ground at once.
    const MaskOf<W> is_ground = spec.kind == EventKind::ground ? asked : zero != zero;
    const MaskOf<W> drowned = is_ground & hops & (at_first <= zero);
    add(drowned, select(at_start < zero, turn, zero), zero != zero);
    look_between(first, at_first, turn, at_turn, asked & !drowned);
    look_between(turn, at_turn, W(1.0), at_end, asked & !drowned);
  }
  /// A place shortly behind the start of a step, where what rises from its value is above it, though it is below again
  /// where the velocity turns: steps of low order that are long beside such a hop.
  [[gnu::noinline]] void put_behind_start(const W& turn, const W& at_turn, MaskOf<W> asked, W& first,
                                          W& at_first) const {
    constexpr int kHalves = 40;
    first = select(asked, turn, first), at_first = select(asked, at_turn, at_first);
    for (int i = 0; i < kHalves && any(asked); ++i) {
      first = select(asked, W(0.5) * first, first);
      at_first = select(asked, value(first), at_first);
      asked = asked & (at_first <= W(0.0));
    }
  }
};

/// Finds every crossing of some items in the steps of the lanes asked for, in order of time, up to and with the first
/// terminal one. `at` is the dense output, with the nodes n0 and n1 at its ends; whether something is crossed is
/// decided as detect() does, by the watched values there.
template <class W, class Dense>
PHYSIM_INLINE void find_crossings(const Conditions<double>& c, const WatchList& watch, const Dense& at,
                                  const MaskOf<W>& asked, CrossingList* lists, WatchedSet items) {
  for (int i = 0; i < watch.count; ++i)
    if (contains(items, i)) CrossingFinder<W, Dense>{c, watch.item[i].spec, i, at, lists, watch.lands}.find(asked);
  for (unsigned left = lane_bits(asked); left != 0; left &= left - 1) lists[__builtin_ctz(left)].put_in_order(watch);
}

PHYSIM_ISA_END
