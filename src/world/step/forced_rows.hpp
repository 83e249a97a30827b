// The loop over forced rows, pack by pack: from the forces in one stage to the next stage.
#pragma once

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

/// The slope of the stage at hand, then the state of the next one, or the end of the step.
template <class R, class S>
PHYSIM_INLINE void advance_rows(const ForcedJob<S>& job, const Conditions<S>& c, std::uint32_t row, Flyer<R>& l) {
  const Fidelity& f = c.fidelity;
  const int stage = job.stage, stages = end_slope(f.integrator);
  Step<R>& s = l.step;
  Vec3<R> push;
  load_scratch(job, stage == 0 ? kFirstPush : kPush, row, push);
  l.drag_rate = load<R>(job.column(stage == 0 ? kFirstPushRate : kPushRate), row);
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

/// All rows of a job, on any rung; returns whether some need a closer look after the last stage. They are marked.
template <class R, class S>
bool advance_packs(const ForcedJob<S>& job) {
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
  return attention;
}

PHYSIM_ISA_END
