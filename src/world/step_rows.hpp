// The world's loop over rows, pack by pack.
#pragma once

#include "flight/judge.hpp"
#include "world/frame.hpp"
#include "world/world_job.hpp"

PHYSIM_ISA_BEGIN

template <class R, class S>
PHYSIM_INLINE R load(const S* column, std::uint32_t row) {
  return R::load(column + row);
}
template <class R, class S>
PHYSIM_INLINE Vec3<R> load_vector(S* const (&column)[3], std::uint32_t row) {
  return {load<R>(column[0], row), load<R>(column[1], row), load<R>(column[2], row)};
}
template <class R, class S>
PHYSIM_INLINE void store_vector(const Vec3<R>& v, S* const (&column)[3], std::uint32_t row) {
  v.x.store(column[0] + row), v.y.store(column[1] + row), v.z.store(column[2] + row);
}

/// 0, 1, 2, ...
template <class R>
PHYSIM_INLINE R lane_numbers() {
  R numbers;
  for (int lane = 0; lane < kLanes<R>; ++lane) set_lane(numbers, lane, static_cast<ScalarOf<R>>(lane));
  return numbers;
}

/// Rows that need a closer look: something may have happened to them inside the step.
template <class R, class S>
PHYSIM_INLINE MaskOf<R> noteworthy(const WorldJob<S>& job, const Conditions<S>& c, const Step<R>& s,
                                   std::uint32_t row) {
  const Watchdog<S>& w = job.watchdog;
  const R zero(S(0));
  MaskOf<R> found =
      (!(height(c, s.end.x) > R(w.floor))) | (!is_finite(s.end)) | (length_squared(s.end.v) < R(w.slowest * w.slowest));
  if (w.simple) return found;
  const R climb = climb_rate(c, s.start);
  const R climb_later = climb_rate(c, s.end);
  // A step that sinks and rises again may have touched the ground in between.
  found = found | ((climb < zero) & (climb_later > zero));
  if (w.apex) found = found | ((climb > zero) & (climb_later <= zero));
  if (job.launched)
    found = found | (length_squared(s.end.x - load_vector<R>(job.columns.launch, row)) > R(w.farthest * w.farthest));
  if (w.box)
    found = found | (s.end.x.x < R(w.low.x)) | (s.end.x.x > R(w.high.x)) | (s.end.x.y < R(w.low.y)) |
            (s.end.x.y > R(w.high.y)) | (s.end.x.z < R(w.low.z)) | (s.end.x.z > R(w.high.z));
  return found;
}

template <class R, class S>
PHYSIM_INLINE void load_body(const WorldJob<S>& job, std::uint32_t row, Body<R>& b) {
  auto* number = reinterpret_cast<R*>(&b);
  for (unsigned i = 0; i < job.field_count; ++i) number[job.fields[i]] = load<R>(job.columns.field[job.fields[i]], row);
}

template <class R, class S>
PHYSIM_INLINE void load_clock(const WorldJob<S>& job, std::uint32_t row, Step<R>& s) {
  s.h = R(job.h);
  s.t = s.t_end = R(S(0));
  if (!job.clocked) return;
  const R offset = load<R>(job.columns.offset, row);
  const R steps = R(job.now) - load<R>(job.columns.born, row);
  s.t = offset + steps * job.h;
  s.t_end = offset + (steps + S(1)) * job.h;
}

/// Lanes that hold rows, as bits.
template <class R>
PHYSIM_INLINE unsigned filled_lanes(std::uint32_t rows) {
  return rows >= unsigned(kLanes<R>) ? ~0u : (1u << rows) - 1;
}

/// Steps packs of rows. `frame(body, row, step)` takes one, and returns lanes that did not get through.
template <class R, class S, class Frame>
PHYSIM_INLINE bool step_packs(const WorldJob<S>& job, const Conditions<S>& c, Body<R>& b, const Frame& frame) {
  constexpr unsigned kN = unsigned(kLanes<R>);
  Step<R> s;
  bool attention = false;
  for (std::uint32_t row = job.first; row < job.last; row += kN) {
    s.start = {load_vector<R>(job.columns.position, row), load_vector<R>(job.columns.velocity, row)};
    const MaskOf<R> lost = frame(b, row, s);
    const MaskOf<R> left = lost | noteworthy(job, c, s, row);
    const unsigned bits = lane_bits(left) & filled_lanes<R>(job.last - row);
    const unsigned shift = row % kRowsPerWord;
    std::uint32_t& word = job.attention[row / kRowsPerWord];
    word = shift == 0 ? bits : word | bits << shift;
    if (bits != 0) {
      attention = true;
      s.end = select(left, s.start, s.end);
    }
    store_vector(s.end.x, job.columns.previous, row);
    store_vector(s.end.v, job.columns.velocity, row);
    if (job.columns.carried[0]) store_vector(select(left, s.slope[0].v, s.slope[1].v), job.columns.carried, row);
  }
  return attention;
}

/// Any rung: the switches are inside, the same way for all lanes.
template <class R, class S>
bool step_any(const WorldJob<S>& job) {
  const Conditions<S>& c = *job.course->conditions;
  const bool classic = c.fidelity.motion != Motion::closed_form && c.fidelity.integrator == Integrator::classic;
  const R lane_number = lane_numbers<R>();
  Body<R> body{};
  return step_packs<R>(job, c, body, [&](Body<R>& b, std::uint32_t row, Step<R>& s) {
    load_body(job, row, b);
    load_clock(job, row, s);
    const Vec3<R> carried = classic ? load_vector<R>(job.columns.carried, row) : Vec3<R>{};
    const MaskOf<R> filled = lane_number < R(static_cast<S>(job.last - row));
    return take_frame(*job.course, b, carried, filled, s);
  });
}

/// The rungs that most games use: fixed at compile time, so that the models fold to a few instructions. The models are
/// the same functions.
template <DragModel drag, WindModel wind>
struct GameRung {
  static constexpr bool matches(const Fidelity& f) {
    return f.motion != Motion::closed_form && f.integrator == Integrator::semi_implicit_euler &&
           f.gravity == GravityModel::constant && f.earth == EarthModel::flat && f.drag == drag && f.wind == wind &&
           !f.planar;
  }
  /// The conditions that these rungs read, with the fidelity known.
  template <class S>
  PHYSIM_INLINE static Conditions<S> known(const Conditions<S>& c) {
    Conditions<S> k;
    k.fidelity.gravity = GravityModel::constant;
    k.fidelity.earth = EarthModel::flat;
    k.fidelity.drag = drag;
    k.fidelity.wind = wind;
    k.fidelity.planar = false;
    k.has_applied = k.has_gravity_scale = k.has_frozen = false;
    k.gravity = c.gravity;
    k.wind.velocity[0] = c.wind.velocity[0];
    return k;
  }
};

template <class Rung, class R, class S>
bool step_game_rung(const WorldJob<S>& job) {
  const Conditions<S> c = Rung::known(*job.course->conditions);
  Body<R> body;
  return step_packs<R>(job, c, body, [&](Body<R>& b, std::uint32_t row, Step<R>& s) {
    const auto& field = job.columns.field;
    if (c.fidelity.drag == DragModel::damping)
      b.damping_rate = load<R>(field[offsetof(Body<S>, damping_rate) / sizeof(S)], row);
    if (c.fidelity.drag == DragModel::linear_quadratic) {
      b.k1_per_mass = load<R>(field[offsetof(Body<S>, k1_per_mass) / sizeof(S)], row);
      b.k2_per_mass = load<R>(field[offsetof(Body<S>, k2_per_mass) / sizeof(S)], row);
    }
    s.h = R(job.h);
    s.slope[0].v = acceleration(c, b, R(S(0)), s.start);
    s.end.v = s.start.v + s.slope[0].v * s.h;
    s.end.x = s.start.x + s.end.v * s.h;
    return R(S(0)) != R(S(0));
  });
}

template <class R, class S>
bool step_packs_of(const WorldJob<S>& job) {
  const Conditions<S>& c = *job.course->conditions;
  const Fidelity& f = c.fidelity;
  if (job.watchdog.simple && !c.has_applied && !c.has_gravity_scale && !c.has_frozen) {
    using enum DragModel;
    if (GameRung<off, WindModel::off>::matches(f)) return step_game_rung<GameRung<off, WindModel::off>, R>(job);
    if (GameRung<damping, WindModel::off>::matches(f)) return step_game_rung<GameRung<damping, WindModel::off>, R>(job);
    if (GameRung<linear_quadratic, WindModel::off>::matches(f))
      return step_game_rung<GameRung<linear_quadratic, WindModel::off>, R>(job);
    if (GameRung<linear_quadratic, WindModel::constant>::matches(f))
      return step_game_rung<GameRung<linear_quadratic, WindModel::constant>, R>(job);
  }
  return step_any<R>(job);
}

PHYSIM_ISA_END
