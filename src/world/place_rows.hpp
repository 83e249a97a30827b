// Rows of closed forms that wait: where they are at a step, and whether anything can happen to them before one.
#pragma once

#include <limits>

#include "model/closed_form.hpp"
#include "world/step_rows.hpp"

PHYSIM_ISA_BEGIN

/// end_on_clock(), but of a word whose rows have one clock it is not read from their columns.
template <class R, class S>
PHYSIM_INLINE R end_on_one_clock(const WorldJob<S>& job, std::uint32_t row) {
  static_assert(kLanes<R> <= int(kRowsPerWord));
  const WordClock& clock = job.clocks[row / kRowsPerWord];
  if (!clock.is_one()) return end_on_clock<R>(job, row);
  const S steps = job.now - static_cast<S>(clock.born);
  const R end(static_cast<S>(clock.offset) + (steps + S(1)) * job.h);
  PHYSIM_ASSERT((lane_bits(end != end_on_clock<R>(job, row)) & filled_lanes<R>(job.last - row)) == 0);
  return end;
}

/// Rows that fall freely keep their horizontal velocity: it is left where it stands, which spares a fifth of the memory
/// that placing many rows waits for.
template <class R, class S>
PHYSIM_INLINE void place_falling(const WorldJob<S>& job) {
  constexpr auto kN = static_cast<std::uint32_t>(kLanes<R>);
  for (std::uint32_t row = job.first; row < job.last; row += kN) {
    Body<R> b;
    load_part<LaunchPart>(job, row, b);
    const Conditions<S> known = KnownFall::known(*job.course->conditions);
    const State<R> s = closed_form_of_free(known, b, end_on_one_clock<R>(job, row));
    store_vector(s.x, job.columns.previous, row);
    if (!job.velocities) continue;
    s.v.y.store(job.columns.velocity[1] + row);
    PHYSIM_ASSERT((lane_bits((load<R>(job.columns.velocity[0], row) != s.v.x) |
                             (load<R>(job.columns.velocity[2], row) != s.v.z)) &
                   filled_lanes<R>(job.last - row)) == 0);
  }
}

/// Writes where rows are at the end of the step job.now, with the numbers of a step that takes them there.
template <class R, class S>
void place_packs_of(const WorldJob<S>& given) {
  const WorldJob<S> job = given;
  const Conditions<S>& c = *job.course->conditions;
  if (KnownFall::matches(c)) return place_falling<R>(job);
  constexpr auto kN = static_cast<std::uint32_t>(kLanes<R>);
  for (std::uint32_t row = job.first; row < job.last; row += kN) {
    Body<R> b;
    load_body(job, row, b);
    const State<R> s = closed_form(c, b, end_on_one_clock<R>(job, row));
    store_vector(s.x, job.columns.previous, row);
    if (job.velocities) store_vector(s.v, job.columns.velocity, row);
  }
}

/// Where rows may be between two moments, and how fast.
template <class R>
struct Hull {
  Vec3<R> low, high;   // places
  R slowest_squared;   // least square of the speed
  MaskOf<R> turns;     // it may go up at some time, and down at another
  MaskOf<R> in_range;  // squares of all of it are numbers
};

/// Along one axis the velocity of a closed form changes one way, so it lies between those at both ends, and so does the
/// place where the velocity keeps its sign. Elsewhere the place goes beyond by less than the first velocity would take
/// it. What is computed at a step may differ from that by rounding: `place` and `speed` say how much.
template <class R>
PHYSIM_INLINE void add_axis(const R& x0, const R& x1, const R& v0, const R& v1, const R& time, const R& place,
                            const R& speed, R& low, R& high, R& slowest_squared) {
  using S = ScalarOf<R>;
  const R zero(S(0));
  const MaskOf<R> keeps_sign = ((v0 > speed) & (v1 > speed)) | ((v0 < -speed) & (v1 < -speed));
  const R beyond = select(keeps_sign, zero, (abs(v0) + speed) * time);
  low = min(x0, x1) - place - select(v0 < speed, beyond, zero);
  high = max(x0, x1) + place + select(v0 > -speed, beyond, zero);
  const R least = max(min(abs(v0), abs(v1)) - speed, zero);
  slowest_squared += select(keeps_sign, least * least, zero);
}

template <class R, class S>
PHYSIM_INLINE Hull<R> hull_of(const Conditions<S>& c, const Body<R>& b, const R& t0, const R& t1) {
  const R zero(S(0));
  const State<R> s0 = closed_form(c, b, t0), s1 = closed_form(c, b, t1);
  const auto sum = [](const Vec3<R>& v) { return abs(v.x) + abs(v.y) + abs(v.z); };
  R wind = zero;
  if (c.fidelity.wind != WindModel::off) {
    const Vec3<S> w = c.wind.velocity;
    wind = sum(Vec3<R>{R(w.x), R(w.y), R(w.z)});
  }
  R g(c.fidelity.gravity == GravityModel::off ? S(0) : c.gravity);
  if (c.has_gravity_scale) g *= b.gravity_scale;
  // Some dozens of operations, each of which rounds what is no larger than the sum of all terms.
  const R rounding(S(256) * std::numeric_limits<S>::epsilon());
  const R fastest = sum(b.launch.v) + wind + abs(g) * t1;
  const R speed = rounding * fastest;
  const R place = rounding * (sum(b.launch.x) + fastest * t1);
  const R time = t1 - t0;
  Hull<R> h;
  h.slowest_squared = zero;
  add_axis(s0.x.x, s1.x.x, s0.v.x, s1.v.x, time, place, speed, h.low.x, h.high.x, h.slowest_squared);
  add_axis(s0.x.y, s1.x.y, s0.v.y, s1.v.y, time, place, speed, h.low.y, h.high.y, h.slowest_squared);
  add_axis(s0.x.z, s1.x.z, s0.v.z, s1.v.z, time, place, speed, h.low.z, h.high.z, h.slowest_squared);
  h.turns = ((s0.v.y > -speed) | (s1.v.y > -speed)) & ((s0.v.y < speed) | (s1.v.y < speed));
  const R most = length_squared(h.low) + length_squared(h.high) + fastest * fastest;
  h.in_range = is_finite(most * S(16)) & is_finite(length_squared(s0.v) + length_squared(s1.v));
  return h;
}

/// Whether noteworthy() finds none of the rows in any of `steps` steps from the one job.now on.
template <class R, class S>
bool quiet_packs_of(const WorldJob<S>& job, std::uint32_t steps) {
  const Conditions<S>& c = *job.course->conditions;
  const Watchdog<S>& w = job.watchdog;
  PHYSIM_ASSERT(!w.watched && !has_stops(c) && c.fidelity.earth == EarthModel::flat);
  constexpr auto kN = static_cast<std::uint32_t>(kLanes<R>);
  for (std::uint32_t row = job.first; row < job.last; row += kN) {
    Body<R> b;
    load_body(job, row, b);
    const R begun = R(job.now) - load<R>(job.columns.born, row), offset = load<R>(job.columns.offset, row);
    const Hull<R> h = hull_of(c, b, R(offset + begun * job.h), R(offset + (begun + static_cast<S>(steps)) * job.h));
    MaskOf<R> quiet = h.in_range & (h.low.y > R(w.floor));
    if (w.slowest > S(0)) quiet = quiet & (h.slowest_squared > R(w.slowest * w.slowest * S(1.001)));
    if (!w.simple) {
      if (w.apex) quiet = quiet & !h.turns;
      if (job.launched) {
        const Vec3<R> from = load_vector<R>(job.columns.launch, row);
        const auto farther = [](const R& low, const R& high, const R& at) {
          return max(abs(low - at), abs(high - at));
        };
        const Vec3<R> way{farther(h.low.x, h.high.x, from.x), farther(h.low.y, h.high.y, from.y),
                          farther(h.low.z, h.high.z, from.z)};
        quiet = quiet & (length_squared(way) * S(1.001) < R(w.farthest * w.farthest));
      }
      if (w.box)
        quiet = quiet & (h.low.x > R(w.low.x)) & (h.high.x < R(w.high.x)) & (h.low.y > R(w.low.y)) &
                (h.high.y < R(w.high.y)) & (h.low.z > R(w.low.z)) & (h.high.z < R(w.high.z));
    }
    if ((lane_bits(!quiet) & filled_lanes<R>(job.last - row)) != 0) return false;
  }
  return true;
}

PHYSIM_ISA_END
