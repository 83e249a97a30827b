// One lane that is flown to its end with its path kept: from a launch, or frame by frame from where it is.
#pragma once

#include <algorithm>
#include <vector>

#include "base/assert.hpp"
#include "flight/under_way.hpp"
#include "solve/judge.hpp"
#include "solve/stages.hpp"

namespace physim {

[[nodiscard]] inline std::size_t coefficient_count(const FlightRecord& record) {
  const Fidelity& f = record.cohort.in_use.fidelity;
  return f.motion == Motion::closed_form ? 0 : static_cast<std::size_t>(dense_coefficient_count(f.integrator));
}

/// Keeps what was crossed, with spin drift.
inline void keep_event(FlightRecord& record, const Watched& watched, bool rising, double time,
                       const State<double>& flown) {
  const State<double> s = with_drift(flown, record.drift, record.sight.right, time);
  record.events.push_back({.kind = watched.spec.kind,
                           .direction = rising ? Crossing::rising : Crossing::falling,
                           .value = watched.spec.value,
                           .time = time,
                           .position = s.x,
                           .velocity = s.v});
}

/// The loop over steps is that of the batch kernels (flight/batch_driver.hpp), with a record kept. Times are those of
/// the march, since launch; the record's are since the flight began.
template <class S>
class LaneFlight {
 public:
  LaneFlight(FlightRecord& record, const Course<S>& course, const Body<S>& body)
      : record_(record), course_(course), march_(course_) {
    lane().body = body;
    const auto take_rotor = [&](auto& rotor) { cast_numbers(record.rotor, rotor); };
    for_rotors(fidelity(), take_rotor, lane());
  }
  LaneFlight(const LaneFlight&) = delete;  // the march points to the course
  LaneFlight& operator=(const LaneFlight&) = delete;
  ~LaneFlight() = default;

  void from_launch() {
    march_.launch();
    keep_start(0);
    while (!ended_) step();
    count_work();
  }

  /// Up to a time after the start [s], or for so many frames.
  void by_frames(const FrameStart& from, double until, std::int64_t most_frames) {
    take_start(from);
    for (std::int64_t frame = 0; !ended_; ++frame) {
      begins_ = static_cast<double>(frame) * from.dt;
      if (begins_ >= until) break;
      if (frame >= most_frames) return end(Outcome::step_limit, begins_);
      if (from.pushes && from.pushes->begin_frame(frame, mass_now(from, frame)))
        pushed_frame(from, frame);
      else
        free_frame(from, frame);
    }
    if (ended_ && record_.duration <= until) return;
    end(Outcome::time_limit, until);
    std::erase_if(record_.events, [until](const Event& e) { return e.time > until; });
  }

 private:
  [[nodiscard]] Lanes<S>& lane() { return march_.lanes; }
  [[nodiscard]] const Fidelity& fidelity() const { return course_.conditions->fidelity; }

  /// One step, or a try at it.
  void step() {
    const bool accepted = march_.try_step();
    const bool special = needs_attention(course_, lane(), accepted).special;
    const bool sound = accepted && ends_finite(fidelity(), lane().step);
    if (sound) dense_lanes(course_, lane(), j_.at);
    judge(accepted, special, sound);
    if (ended_) {
      if (sound) lane().count += S(1);
      return;
    }
    march_.accept(accepted);
    if (sound && has_stops(*course_.conditions)) keep_jump();
  }

  /// What the step tried means; its dense output is there where it is sound.
  void judge(bool accepted, bool special, bool sound) {
    Verdict verdict{false, Outcome::step_limit, 1};
    j_.crossings[0].count = 0;
    if (special) {
      find_crossings<S>(course_, sound, j_);
      verdict = verdict_on(course_, lane(), step_marks(course_, lane()), 0, accepted, j_.crossings[0]);
    }
    if (sound) keep_step();
    for (int i = 0; i < j_.crossings[0].count; ++i) {
      const Found& found = j_.crossings[0].found[i];
      const double time = j_.at.time(found.theta);
      PHYSIM_ASSERT(record_.events.empty() || record_.events.back().time <= since_start(time));
      keep_event(record_, course_.watch.item[found.index], found.rising, since_start(time), j_.at.at_time(time));
    }
    if (verdict.ended)
      end(verdict.outcome, sound ? since_start(j_.at.time(verdict.theta)) : record_.path.nodes.back().t);
  }

  void end(Outcome outcome, double duration) {
    record_.outcome = outcome;
    record_.duration = duration;
    ended_ = true;
    PHYSIM_ASSERT(duration >= 0 && !record_.path.nodes.empty());
  }

  void count_work() {
    const auto tries = static_cast<std::int64_t>(lane().tries);
    record_.cost.steps += static_cast<std::int64_t>(lane().count + lane().parts);
    record_.cost.rejected += tries - static_cast<std::int64_t>(lane().count + lane().parts);
    PHYSIM_ASSERT(record_.cost.steps >= 0 && record_.cost.rejected >= 0);
    record_.cost.evaluations += evaluations(fidelity(), tries);
  }

  // ------------------------------------------------------------------------------------------- frames
  void take_start(const FrameStart& from) {
    PHYSIM_ASSERT(from.dt > 0 && course_.plan.step == S(0));
    cast_numbers(from.now, lane().step.start);
    if (is_classic(fidelity())) lane().step.slope[0].v = vec_cast<S>(from.carried);
    const auto take_turn = [&](const auto&) { cast_numbers(from.turn, lane().step.turn->start); };
    for_rotors(fidelity(), take_turn, lane());
    is_pushed_ = from.pushes != nullptr;
    record_.has_own_force = from.has_own_force;
  }
  /// What the march's clock shows at the start of a frame.
  [[nodiscard]] static S clock_at(const FrameStart& from, std::int64_t frame) {
    if (!from.is_clocked) return S(0);
    return static_cast<S>(from.clock) +
           static_cast<S>(from.steps + static_cast<double>(frame)) * static_cast<S>(from.dt);
  }
  [[nodiscard]] static S clock_behind(const FrameStart& from, std::int64_t frame) {
    return from.is_clocked ? clock_at(from, frame + 1) : static_cast<S>(from.dt);
  }

  /// Generators know the mass at the start of the frame.
  [[nodiscard]] double mass_now(const FrameStart& from, std::int64_t frame) {
    Body<double> body;
    cast_numbers(lane().body, body);
    return course_.conditions->has_motor ? mass_at(body, static_cast<double>(clock_at(from, frame)))
                                         : record_.projectile.mass;
  }

  /// Nothing but its own models moves it.
  void free_frame(const FrameStart& from, std::int64_t frame) {
    const S start = clock_at(from, frame);
    push_ = {};
    for (double begin = 0; begin < from.dt && !ended_;) {
      const double part = end_of_part(begin, from.dt, from.longest_part);
      const bool whole = begin == 0 && part == from.dt;
      const S h = static_cast<S>(part - begin);
      lane().step.t = whole ? start : start + static_cast<S>(begin);
      const S limit = whole ? clock_behind(from, frame) : lane().step.t + h;
      note_times(lane().step.t, begins_ + begin, limit, part == from.dt ? end_of(from, frame) : begins_ + part);
      march_.restart(limit, h);
      starts_frame();
      while (!march_.arrived() && !ended_) step();
      count_work();
      begin = part;
    }
  }

  /// Generators push it, stage by stage; a frame is one step.
  void pushed_frame(const FrameStart& from, std::int64_t frame) {
    const Conditions<S>& c = *course_.conditions;
    Step<S>& s = lane().step;
    s.t = clock_at(from, frame);
    s.t_end = clock_behind(from, frame);
    s.h = static_cast<S>(from.dt);
    note_times(s.t, begins_, s.t_end, end_of(from, frame));
    const Body<S> own = lane().body;
    const auto feel = [&](double place, const State<S>& at, S t) {
      lane().body = own;
      State<double> wide;
      cast_numbers(at, wide);
      push_ = from.pushes->at(place, wide);
      if (place == 0 && record_.path.pushes.size() < 2) record_.path.pushes.assign(1, push_);
      add_push(c, t, vec_cast<S>(push_), from.has_own_force, lane().body);
    };
    const Integrator integrator = fidelity().integrator;
    if (is_classic(fidelity())) s.slope[0].x = s.start.v;
    for (int stage = 0; stage < end_slope(integrator); ++stage) {
      const State<S> at = stage == 0 ? s.start : s.end;
      feel(stage_place(integrator, stage), at, stage_time(integrator, stage, s));
      advance_stage(c, stage, lane());
    }
    if (is_classic(fidelity())) {
      s.slope[0].v = s.slope[1].v;
    } else {
      feel(1, s.end, s.t_end);
      set_slope(c, lane(), end_slope(integrator));
    }
    starts_frame();
    judge_pushed();
    if (!ended_) march_.accept(true);
    lane().body.applied = own.applied;
    lane().body.applied_until = own.applied_until;
    ++record_.cost.steps;
    record_.cost.evaluations += last_slope(fidelity());
  }
  void judge_pushed() {
    const bool sound = ends_finite(fidelity(), lane().step);
    if (sound) {
      dense_lanes(course_, lane(), j_.at);
      drop_higher_terms(j_.at);
    }
    lane().tries = S(1);
    judge(true, true, sound);
  }

  /// The first node of a frame: the last one's end, but where the acceleration jumps.
  void starts_frame() {
    if (record_.path.nodes.empty())
      keep_start(0);
    else if (fidelity().motion != Motion::closed_form)
      keep_jump();
  }
  [[nodiscard]] static double end_of(const FrameStart& from, std::int64_t frame) {
    return static_cast<double>(frame + 1) * from.dt;
  }
  /// A part of a frame: its start and end on the march's clock, and since the flight began.
  void note_times(S clock, double start, S limit, double finish) {
    part_ = {static_cast<double>(clock), start, static_cast<double>(limit), finish};
  }
  /// A time of the march as one since the flight began. The end of a frame is a whole number of frames, so that flights
  /// are asked there for what was flown and not for what lies a rounding beside it.
  [[nodiscard]] double since_start(double time) const {
    if (part_.finish == 0) return time;  // from a launch
    if (time >= part_.limit) return part_.finish;
    return std::min(part_.start + (time - part_.clock), part_.finish);
  }

  // ------------------------------------------------------------------------------------------- the record
  void keep_step() {
    const auto keep = [this, count = coefficient_count(record_)](const auto& dense, auto& path) {
      PHYSIM_ASSERT(!path.nodes.empty() && path.coefficients.size() == (path.nodes.size() - 1) * count);
      // Fixed steps count their time, which may differ from start + step by a rounding.
      path.nodes.back().t = since_start(dense.n0.t);
      path.nodes.push_back(dense.n1);
      path.nodes.back().t = since_start(dense.n1.t);
      path.coefficients.insert(path.coefficients.end(), dense.coefficient, dense.coefficient + count);
    };
    for_parts(fidelity(), keep, j_.at, record_.path);
    keep_push();
  }

  /// Keeps where a step starts; of a state's slope the acceleration alone.
  void keep_start(double time) {
    const auto keep = [time](const auto& part, auto& path) {
      path.nodes.push_back({});
      auto& node = path.nodes.back();
      node.t = time;
      cast_numbers(part.start, node.y);
      if constexpr (requires { node.slope; })
        cast_numbers(part.slope[0], node.slope);
      else
        node.a = vec_cast<double>(part.slope[0].v);
    };
    for_parts(fidelity(), keep, lane().step, record_.path);
  }

  /// Where a stop makes the acceleration jump, the next step starts from a node of its own, after a step of no length.
  void keep_jump() {
    const Node& last = record_.path.nodes.back();
    if (vec_cast<double>(lane().step.slope[0].v) == last.a) return;
    keep_start(last.t);
    const auto no_change = [count = coefficient_count(record_)](auto& path) {
      path.coefficients.resize(path.coefficients.size() + count);
    };
    for_parts(fidelity(), no_change, record_.path);
    keep_push();
  }
  void keep_push() {
    if (is_pushed_) record_.path.pushes.resize(record_.path.nodes.size(), push_);
  }

  FlightRecord& record_;
  Course<S> course_;
  March<S> march_;
  Judgement<S> j_{};
  bool ended_ = false;
  bool is_pushed_ = false;  // by generators, now and then
  Vec3d push_{};            // of late [m/s^2]
  double begins_ = 0;       // the frame at hand, since the flight began [s]
  struct {
    double clock, start, limit, finish;
  } part_{};  // of it; all 0 in flights from a launch
};

}  // namespace physim
