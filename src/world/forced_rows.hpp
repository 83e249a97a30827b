// The loop over forced rows, pack by pack: from the forces in one stage to the next stage.
#pragma once

#include "solve/stages.hpp"
#include "world/forced_job.hpp"
#include "world/step_rows.hpp"

PHYSIM_ISA_BEGIN

template <class R, class S>
PHYSIM_INLINE Vec3<R> load_scratch(const ForcedJob<S>& job, unsigned k, std::uint32_t row) {
  return {load<R>(job.column(k), row), load<R>(job.column(k + 1), row), load<R>(job.column(k + 2), row)};
}
template <class R, class S>
PHYSIM_INLINE void store_scratch(const Vec3<R>& v, const ForcedJob<S>& job, unsigned k, std::uint32_t row) {
  v.x.store(job.column(k) + row), v.y.store(job.column(k + 1) + row), v.z.store(job.column(k + 2) + row);
}

template <class R, class S>
PHYSIM_INLINE void load_scratch_turn(const ForcedJob<S>& job, unsigned k, std::uint32_t row, Turn<R>& turn) {
  for (unsigned i = 0; i < kNumbers<Turn>; ++i) numbers(turn)[i] = load<R>(job.column(k + i), row);
}
template <class R, class S>
PHYSIM_INLINE void store_scratch_turn(const Turn<R>& turn, const ForcedJob<S>& job, unsigned k, std::uint32_t row) {
  for (unsigned i = 0; i < kNumbers<Turn>; ++i) numbers(turn)[i].store(job.column(k + i) + row);
}

/// The rotation's part of a stage: `y` is the state there; gives the acceleration.
template <class R, class S>
PHYSIM_INLINE Vec3<R> advance_turn(const ForcedJob<S>& job, const Conditions<S>& c, std::uint32_t row, const R& t,
                                   const State<R>& y, const Body<R>& b, Step<R>& s) {
  const Integrator integrator = c.fidelity.integrator;
  const int stage = job.stage, stages = end_slope(integrator);
  TurnStep<R>& turn = *s.turn;
  Rotor<R> rotor;
  load_turn(job.rows, row, rotor, turn.start);
  Turn<R> at = turn.start;
  if (stage > 0) load_scratch_turn(job, turn_column(stages), row, at);
  for (int i = 0; i < stage; ++i) load_scratch_turn(job, turn_slope_column(stages, i), row, turn.slope[i]);
  const Vec3<R> a = evaluated(c, b, rotor, t, y, at, turn.slope[stage]);
  store_scratch_turn(turn.slope[stage], job, turn_slope_column(stages, stage), row);
  if (stage + 1 < stages)
    turn.end = next_stage(integrator, stage + 1, turn, s.h);
  else
    finish_turn_stages(c, rotor, s);
  store_scratch_turn(turn.end, job, turn_column(stages), row);
  return a;
}

/// The slope of the stage at hand, then the state of the next one, or the end of the step.
template <class R, class S>
PHYSIM_INLINE void advance_stage(const ForcedJob<S>& job, const Conditions<S>& c, std::uint32_t row, Body<R>& b,
                                 Step<R>& s) {
  const Integrator integrator = c.fidelity.integrator;
  const int stage = job.stage;
  const unsigned slope = kSlopes + 6 * static_cast<unsigned>(stage);
  const R t = s.t + s.h * constant<R>(stage_place(integrator, stage));
  add_push(c, t, load_scratch<R>(job, stage == 0 ? kFirstPush : kPush, row), job.own_force, b);
  if (integrator == Integrator::classic) {
    s.slope[0] = {s.start.v, load_vector<R>(job.rows.columns.carried, row)};
    classic_frame(c, b, s);
    store_scratch(s.slope[1].v, job, slope + 3, row);
    return;
  }
  State<R> y = s.start;
  if (stage > 0) y = {load_scratch<R>(job, kStagePosition, row), load_scratch<R>(job, kStageVelocity, row)};
  for (unsigned i = 0; i < static_cast<unsigned>(stage); ++i)
    s.slope[i] = {load_scratch<R>(job, kSlopes + 6 * i, row), load_scratch<R>(job, kSlopes + 6 * i + 3, row)};
  s.slope[stage] = {y.v, turns(c.fidelity) ? advance_turn(job, c, row, t, y, b, s) : evaluated(c, b, t, y)};
  store_scratch(s.slope[stage].x, job, slope, row);
  store_scratch(s.slope[stage].v, job, slope + 3, row);
  if (stage + 1 < end_slope(integrator))
    s.end = next_stage(integrator, stage + 1, s, s.h);
  else
    finish_stages(integrator, s);
}

template <class R, class S>
PHYSIM_INLINE MaskOf<R> turned_bad(const Conditions<S>& c, const Step<R>& s) {
  return turns(c.fidelity) ? !is_finite(s.turn->end) : R(S(0)) != R(S(0));
}

/// All rows of a job. After the last stage true where rows need a closer look; they are marked.
template <class R, class S>
bool advance_packs(const ForcedJob<S>& job) {
  const Conditions<S>& c = *job.rows.course->conditions;
  const bool last = job.stage + 1 == end_slope(c.fidelity.integrator);
  Body<R> body{};
  Step<R> s;
  bool attention = false;
  for (std::uint32_t row = job.rows.first; row < job.rows.last; row += unsigned(kLanes<R>)) {
    load_body(job.rows, row, body);
    load_clock(job.rows, row, s);
    s.start = {load_vector<R>(job.rows.columns.position, row), load_vector<R>(job.rows.columns.velocity, row)};
    advance_stage(job, c, row, body, s);
    store_scratch(s.end.x, job, kStagePosition, row);
    store_scratch(s.end.v, job, kStageVelocity, row);
    if (!last) continue;
    const unsigned bits =
        lane_bits(noteworthy(job.rows, c, s, row) | turned_bad(c, s)) & filled_lanes<R>(job.rows.last - row);
    const unsigned shift = row % kRowsPerWord;
    std::uint32_t& word = job.rows.attention[row / kRowsPerWord];
    word = shift == 0 ? bits : word | bits << shift;
    attention = attention || bits != 0;
  }
  return attention;
}

PHYSIM_ISA_END
