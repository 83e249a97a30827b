// The loop over forced rows, pack by pack: from the forces in one stage to the next stage.
#pragma once

#include <limits>

#include "solve/stages.hpp"
#include "world/step/forced_job.hpp"
#include "world/step/step_rows.hpp"

PHYSIM_ISA_BEGIN

template <class S, template <class> class Y, class R>
PHYSIM_INLINE void load_scratch(const ForcedJob<S>& job, unsigned first, std::uint32_t row, Y<R>& y) {
  for (unsigned i = 0; i < kNumbers<Y>; ++i) numbers(y)[i] = load<R>(job.column(first + i), row);
}
template <class S, template <class> class Y, class R>
PHYSIM_INLINE void store_scratch(const ForcedJob<S>& job, unsigned first, std::uint32_t row, const Y<R>& y) {
  for (unsigned i = 0; i < kNumbers<Y>; ++i) numbers(y)[i].store(job.column(first + i) + row);
}

/// What pushes rows in the first stage.
template <class R, class S>
PHYSIM_INLINE Vec3<R> first_push(const ForcedJob<S>& job, std::uint32_t row) {
  Vec3<R> push;
  if (job.drag_rate == nullptr) {
    load_scratch(job, kFirstPush, row, push);
    return push;
  }
  using W = Cast<double, R>;
  const W rate = W::load(job.drag_rate + (row - job.rows.first));
  for (int axis = 0; axis < 3; ++axis)
    push[axis] = cast<S>(W(0.0) - cast<double>(load<R>(job.rows.columns.velocity[axis], row)) * rate);
  return push;
}

/// The rate of the drag in it.
template <class R, class S>
PHYSIM_INLINE R first_drag_rate(const ForcedJob<S>& job, std::uint32_t row) {
  if (job.drag_rate == nullptr) return load<R>(job.column(kFirstPushRate), row);
  using W = Cast<double, R>;
  return cast<S>(W::load(job.drag_rate + (row - job.rows.first)));
}

/// The slope of the stage at hand, then the state of the next one, or the end of the step.
template <class R, class S>
PHYSIM_INLINE void advance_rows(const ForcedJob<S>& job, const Conditions<S>& c, std::uint32_t row, Flyer<R>& l) {
  const Fidelity& f = c.fidelity;
  const int stage = job.stage, stages = end_slope(f.integrator);
  Step<R>& s = l.step;
  Vec3<R> push;
  if (stage == 0) {
    push = first_push<R>(job, row);
    l.drag_rate = first_drag_rate<R>(job, row);
    if (job.drag_rate != nullptr) {
      store_scratch(job, kFirstPush, row, push);
      l.drag_rate.store(job.column(kFirstPushRate) + row);
    }
  } else {
    load_scratch(job, kPush, row, push);
    l.drag_rate = load<R>(job.column(kPushRate), row);
  }
  add_push(c, {s.t, s.t_end}, stage_time(f.integrator, stage, s), push, job.own_force, l.body);
  const auto load_part = [&](auto& part) {
    const PartColumns at = columns_of(part, stages);
    if (stage > 0) load_scratch(job, at.stage, row, part.end);
    for (int i = 0; i < stage; ++i) load_scratch(job, at.slope(i), row, part.slope[i]);
  };
  for_parts(f, load_part, s);
  if (is_classic(f)) s.slope[0] = {s.start.v, load_vector<R>(job.rows.columns.carried, row)};
  advance_stage(c, stage, l);
  const auto store_part = [&](const auto& part) {
    const PartColumns at = columns_of(part, stages);
    store_scratch(job, at.slope(stage), row, part.slope[is_classic(f) ? 1 : stage]);
    store_scratch(job, at.stage, row, part.end);
  };
  for_parts(f, store_part, s);
}

/// All rows of a job, on any rung.
template <class R, class S>
Advanced advance_any(const ForcedJob<S>& job) {
  const Conditions<S>& c = *job.rows.course->conditions;
  const bool last = job.stage + 1 == end_slope(c.fidelity.integrator);
  Flyer<R> flyer{};
  Step<R>& s = flyer.step;
  bool attention = false;
  for (std::uint32_t row = job.rows.first; row < job.rows.last; row += unsigned(kLanes<R>)) {
    load_body(job.rows, row, flyer.body);
    load_clock(job.rows, row, s);
    load_turn(job.rows, row, flyer);
    s.start = load_state<R>(job.rows, row);
    advance_rows(job, c, row, flyer);
    if (!last) continue;
    MaskOf<R> found = noteworthy(job.rows, c, s, row) | turned_bad(c, flyer);
    if (job.rows.columns.clear != nullptr) found = found | comes_near(job.rows, s, row);
    if (job.rows.restless != nullptr) meets_restless<R>(job.rows, s.start, s.end, found);
    const unsigned bits = lane_bits(found) & filled_lanes<R>(job.rows.last - row);
    mark(job.rows.attention, row, bits);
    attention = attention || bits != 0;
  }
  return {attention, false};
}

/// Lets a body feel a push whatever its clock shows.
template <class R>
PHYSIM_INLINE void put_push(const Vec3<R>& push, Body<R>& b) {
  b.applied = push;
  b.applied_until = constant<R>(std::numeric_limits<double>::infinity());
}

/// A known rung with rows that feel an additional push.
template <class Rung>
struct PushedRung {
  template <class S>
  static constexpr bool matches(const Conditions<S>& c) {
    Features features{};
    features.has_applied = true;
    return Rung::matches(c, features);
  }
  template <class S>
  PHYSIM_INLINE static Conditions<S> known(const Conditions<S>& c) {
    Conditions<S> k = Rung::known(c);
    k.has_applied = true;
    return k;
  }

  /// Steps a pack and returns its marks. `told` is the job for calls, see look_for_near().
  template <class R, class S>
  PHYSIM_INLINE static unsigned step(const ForcedJob<S>& told, const ForcedJob<S>& job, const Conditions<S>& given,
                                     std::uint32_t row) {
    Body<R> b = Rung::template load_body<R>(job.rows, row);
    put_push(first_push<R>(job, row), b);
    const R h(job.rows.h);
    Moved<R> m;
    m.start = load_state<R>(job.rows, row);
    const Conditions<S> c = known(given);
    const R rate = first_drag_rate<R>(job, row);
    const Vec3<R> a = acceleration_over(c, b, R(S(0)), m.start, {h, rate});
    m.end = semi_implicit_end(m.start, a, h);
    MaskOf<R> found = plainly_noteworthy(job.rows.watchdog, c, m) | further_noteworthy(job.rows, c, m, row);
    if (job.rows.columns.clear != nullptr) found = found | comes_near(job.rows, m, row);
    if (job.rows.restless != nullptr) {
      MaskOf<R> meets = found;
      meets_restless<R>(told.rows, State<R>(m.start), State<R>(m.end), meets);
      found = meets;
    }
    const unsigned bits = lane_bits(found) & filled_lanes<R>(job.rows.last - row);
    if (bits != 0) {
      store_scratch(job, kFirstPush, row, b.applied);
      rate.store(job.column(kFirstPushRate) + row);
      store_scratch(job, kStagePosition, row, m.end);
      store_scratch(job, kSlopes, row, State<R>{m.start.v, a});
      m.end = select(found, State<R>{load_vector<R>(job.rows.columns.previous, row), m.start.v}, m.end);
    }
    put_positions(job.rows, m.end.x, row);
    store_vector(m.end.v, job.rows.columns.velocity, row);
    return bits;
  }
  /// The ends of the rows in packs without a mark, if another pack in their word has one.
  template <class R, class S>
  [[gnu::noinline]] static void keep_ends(const ForcedJob<S>& job, std::uint32_t first) {
    const std::uint32_t word = job.rows.attention[first / kRowsPerWord];
    constexpr unsigned kN = unsigned(kLanes<R>);
    for (std::uint32_t row = first; row < first + kRowsPerWord; row += kN) {
      if ((word >> row % kRowsPerWord & lowest_bits(kN)) != 0) continue;
      const RowColumns<S>& c = job.rows.columns;
      store_scratch(job, kStagePosition, row,
                    State<R>{load_vector<R>(c.previous, row), load_vector<R>(c.velocity, row)});
    }
  }
  PHYSIM_INLINE static constexpr std::uint32_t lowest_bits(unsigned count) {
    return count >= 32 ? ~0u : (1u << count) - 1;
  }

  template <class R, class S>
  static Advanced advance(const ForcedJob<S>& given) {
    const ForcedJob<S> job = given;  // a copy stays in registers: nothing that is stored to a column can change it
    bool attention = false;
    for (std::uint32_t first = job.rows.first; first < job.rows.last; first += kRowsPerWord) {
      const std::uint32_t last = first + kRowsPerWord;
      unsigned marks = 0;
      for (std::uint32_t row = first; row < last && row < job.rows.last; row += unsigned(kLanes<R>))
        marks |= step<R>(given, job, *job.rows.course->conditions, row) << row % kRowsPerWord;
      job.rows.attention[first / kRowsPerWord] = marks;
      if (marks == 0) continue;
      attention = true;
      keep_ends<R>(given, first);
    }
    if (job.rows.stream) finish_streams();
    return {attention, true};
  }
};

/// Steps of the rungs that games use most have one stage, and are known.
template <class R, class S>
Advanced advance_packs(const ForcedJob<S>& job) {
  bool known = false;
  Advanced advanced{};
  const auto try_rung = [&]<class Rung>(Rung) PHYSIM_INLINE_LAMBDA {
    if (known || !PushedRung<Rung>::matches(*job.rows.course->conditions)) return;
    known = true;
    advanced = PushedRung<Rung>::template advance<R>(job);
  };
  if constexpr (PHYSIM_KNOWS_RUNGS)
    if (job.at_once && !job.own_force && !job.rows.watchdog.watched) each_known_rung<KnownRung>(try_rung);
  return known ? advanced : advance_any<R>(job);
}

PHYSIM_ISA_END
