// One lane that is flown to its end with its path kept: from a launch, or frame by frame from where it is.
#pragma once

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "flight/known_step.hpp"
#include "flight/meeting_lane.hpp"
#include "flight/path_keeper.hpp"
#include "flight/step_parts.hpp"
#include "flight/under_way.hpp"
#include "solve/judge.hpp"
#include "solve/stages.hpp"

namespace physim {

/// Keeps what was crossed, with spin drift.
inline void keep_event(FlightRecord& record, const Watched& watched, bool rising, double time,
                       const State<double>& flown) {
  const State<double> s = with_drift(flown, record.drift_at(time), record.sight.right, time);
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
  LaneFlight(FlightRecord& record, const Tolerance& tolerance, double step, const Until& until, const Body<S>& body,
             const Obstacles& obstacles)
      : record_(record),
        course_(record.cohort.course<S>(tolerance, step, until, Watcher::flight)),
        march_(course_, body),
        obstacles_(obstacles),
        host_(record, march_, obstacles_),
        path_(record, march_.lanes) {
    const auto take_rotor = [&](auto& rotor) { cast_numbers(record.rotor, rotor); };
    for_rotors(fidelity(), take_rotor, lane());
  }
  LaneFlight(const LaneFlight&) = delete;  // the march points to the course
  LaneFlight& operator=(const LaneFlight&) = delete;
  ~LaneFlight() = default;

  /// Up to a time [s], which what is watched ends it at; with steps that it chooses itself where it may meet things.
  void from_launch(double until) {
    ends_at_rest_ = true;
    parts_ = {until, false};
    parts_.make_last();
    march_.launch();
    begin_contacts({.scene_time = obstacles_.contact.scene_time, .length = until, .ends = until});
    is_plain_ = kMayBeKnown && known_ && !contacts_;
    path_.keeps_slopes = is_plain_ && known_.interpolate;
    path_.reserve();
    path_.keep_start(0);
    if (is_plain_) fly_known();
    met_ = contacts_ && stays(0);
    if (met_) go_on();
    while (!ended_) {
      step();
      if (met_) go_on();
    }
    count_work();
    put_events_in_order();
  }

  /// Up to a time after the start [s], or for `most_frames` frames.
  void by_frames(const FrameStart& start, double until, std::int64_t most_frames) {
    frames_ = start;
    const FrameStart& from = frames_;
    take_start(from);
    for (std::int64_t frame = 0; !ended_; ++frame) {
      begins_ = static_cast<double>(frame) * from.dt;
      if (begins_ >= until) break;
      if (frame >= most_frames) {
        end(Outcome::step_limit, begins_);
        break;
      }
      begin_frame(frame);
      if (from.pushes && from.pushes->begin_frame(frame, mass_now(from, frame)))
        pushed_frame(from, frame);
      else
        free_frame(frame);
      if (is_relaunched_) frames_.clock = static_cast<double>(t_end_), frames_.steps = -static_cast<double>(frame + 1);
    }
    put_events_in_order();
    if (ended_ && record_.duration <= until) return;
    end_at_limit(Outcome::time_limit, until);
    std::erase_if(record_.events, [until](const Event& e) { return e.time > until; });
  }

 private:
  static constexpr bool kMayBeKnown = std::is_same_v<S, double>;  // its rung

  [[nodiscard]] Lanes<S>& lane() { return march_.lanes; }
  [[nodiscard]] const Fidelity& fidelity() const { return course_.conditions->fidelity; }

  /// Most steps of known rungs are taken and kept without a look at them.
  void fly_known() {
    if constexpr (kMayBeKnown) {
      while (!ended_) {
        const auto [why, may_cross] = path_.go_on(known_, course_, lane());
        look_at_step(why == KnownEnd::of_another_rung ? march_.try_step() : why == KnownEnd::accepted, may_cross);
      }
    }
  }

  /// One step, or a try at it.
  void step() { look_at_step(march_.try_step(), kAllWatched); }
  void look_at_step(bool accepted, WatchedSet may_cross) {
    const bool told = accepted && may_cross != 0 && may_cross != kAllWatched;  // by known steps
    const bool special = told || needs_attention(course_, lane(), accepted, may_cross).special;
    const bool sound = accepted && ends_finite(fidelity(), lane().step);
    if constexpr (kMayBeKnown) {
      if (known_ && !special && !contacts_) {  // most steps: they are kept, and that is all
        if (sound) path_.keep_known_step(known_);
        return march_.accept(accepted);
      }
    }
    if (sound) make_dense();
    judge(accepted, special, sound, may_cross);
    if (ended_ || met_) {
      if (sound) lane().count += S(1);
      return;
    }
    march_.accept(accepted);
    if (sound && has_stops(*course_.conditions)) path_.keep_jump();
  }

  /// Continues the flight behind a contact.
  void go_on() {
    auto from = next();
    while (from && stays(*from)) from = next();
    if (from) relaunch(*from);
  }

  void make_dense() {
    if (!is_plain_) return dense_lanes(course_, lane(), j_->at);
    dense_ends(course_, lane(), j_->at);
    if constexpr (kMayBeKnown) {
      if (known_.interpolate) known_.interpolate(lane().step, j_->at.coefficient);
    }
  }

  /// What the step tried means; its dense output is there where it is sound.
  void judge(bool accepted, bool special, bool sound, WatchedSet may_cross) {
    Verdict verdict{false, Outcome::step_limit, 1};
    j_->crossings[0].count = 0;
    if (special) {
      find_crossings<S>(course_, sound, *j_, may_cross);
      verdict = verdict_on(course_, lane(), step_marks(course_, lane()), 0, accepted, j_->crossings[0]);
    }
    if (sound) path_.keep_step(j_->at);
    const auto met = sound && contacts_ ? meeting() : std::nullopt;
    bool ends = false;  // where something is crossed, before it meets anything
    for (int i = 0; i < j_->crossings[0].count; ++i) {
      const Found& found = j_->crossings[0].found[i];
      if (met && met->theta < found.theta) return strike(*met);
      const double time = j_->at.time(found.theta);
      PHYSIM_ASSERT(record_.events.empty() || record_.events.back().time <= path_.since_start(time));
      ends = course_.watch.item[found.index].spec.terminal;
      keep_crossing(course_.watch.item[found.index], found.rising, path_.since_start(time), j_->at.at_time(time));
    }
    if (met && !ends) return strike(*met);
    if (verdict.ended)
      end(verdict.outcome, sound ? path_.since_start(j_->at.time(verdict.theta)) : record_.path.nodes.back().t);
  }

  void keep_crossing(const Watched& watched, bool rising, double time, const State<double>& flown) {
    keep_event(record_, watched, rising, time, flown);
    if (row_of(watched.spec.kind).watch == Watch::range) record_.events.back().value += passed_range_;
    if (row_of(watched.spec.kind).watch == Watch::time) record_.events.back().value += passed_time_;
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
    path_.is_pushed = from.pushes != nullptr;
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

  void begin_frame(std::int64_t frame) {
    t_start_ = clock_at(frames_, frame);
    t_end_ = clock_behind(frames_, frame);
    is_relaunched_ = false;
    steps_of_.reset();
    parts_ = {frames_.dt, frames_.in_parts};
    push_at_start_ = push_at_end_ = {};
    const double steps = static_cast<double>(frames_.run_steps + static_cast<std::uint64_t>(frame));
    ends_at_rest_ = frames_.from_launch;
    const double now = frames_.run_start + steps * frames_.dt;
    begin_contacts({.begins = begins_,
                    .scene_time = now,
                    .length = frames_.dt,
                    .ends = end_of(frames_, frame),
                    .draw = std::bit_cast<std::uint64_t>(now)});
  }
  /// Nothing but its own models moves it.
  void free_frame(std::int64_t frame) {
    path_.push = {};
    fly_on(frame);
  }
  /// To the end of the frame.
  void fly_on(std::int64_t frame) {
    while (const auto from = next())
      if (!stays(*from)) go(*from, frame);
  }
  [[nodiscard]] std::optional<double> next() { return ended_ ? std::nullopt : parts_.next(); }
  void go(double passed, std::int64_t frame) {
    const bool whole = passed == 0 && parts_.is_last();
    const S h = static_cast<S>(parts_.end() - passed);
    lane().step.t = whole ? t_start_ : t_start_ + static_cast<S>(passed);
    into_step_ = passed - static_cast<double>(lane().step.t);
    // From a launch each part ends where the next one begins, on the clock too: no time falls between them.
    const S own = parts_.is_last() ? t_end_ : t_start_ + static_cast<S>(parts_.end());
    const S limit = whole || frames_.from_launch ? own : lane().step.t + h;
    path_.note_times(lane().step.t, begins_ + passed, limit,
                     parts_.is_last() ? end_of(frames_, frame) : begins_ + parts_.end());
    march_.restart(limit, h);
    if (steps_of_) march_.restagger(*std::exchange(steps_of_, h), h);
    path_.starts_frame();
    met_ = false;
    while (!march_.arrived() && !ended_ && !met_) step();
    if (steps_of_ && !ended_ && !met_ && parts_.is_last()) {
      march_.restagger(h, static_cast<S>(StepParts::first(frames_.dt, frames_.in_parts)));
      if (stagger(fidelity()) != 0) path_.keep_jump();
    }
    count_work();
  }

  /// Generators push it, stage by stage; a frame is one step.
  void pushed_frame(const FrameStart& from, std::int64_t frame) {
    const Conditions<S>& c = *course_.conditions;
    Step<S>& s = lane().step;
    parts_.make_last();
    s.t = t_start_;
    s.t_end = t_end_;
    into_step_ = -static_cast<double>(s.t);
    s.h = static_cast<S>(from.dt);
    path_.note_times(s.t, begins_, s.t_end, end_of(from, frame));
    const Body<S> own = lane().body;
    const auto feel = [&](double place, const State<S>& at, S t) {
      lane().body = own;
      State<double> wide;
      cast_numbers(at, wide);
      const Pushed<double> push = from.pushes->at(place, wide);
      (place == 0 ? push_at_start_ : push_at_end_) = push;
      path_.push = push.a;
      if (place == 0 && record_.path.pushes.size() < 2) record_.path.pushes.assign(1, push.a);
      add_push(c, {s.t, s.t_end}, t, vec_cast<S>(push.a), from.has_own_force, lane().body);
      lane().drag_rate = static_cast<S>(push.drag_rate);
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
    if (is_classic(fidelity())) push_at_end_ = push_at_start_;
    path_.own_body = own;
    met_ = false;
    if (!stays_pushed()) {
      path_.starts_frame();
      judge_pushed();
      if (!ended_ && !met_) march_.accept(true);
    }
    ++record_.cost.steps;
    record_.cost.evaluations += last_slope(fidelity());
    fly_on(frame);
    path_.own_body.reset();
    lane().body.applied = own.applied;
    lane().body.applied_until = own.applied_until;
    lane().drag_rate = S(0);
  }
  /// True if the projectile lies on a thing at the start of the frame; it moves along the thing then.
  [[nodiscard]] bool stays_pushed() {
    if (!contacts_) return false;
    const Body<S> felt = lane().body;
    const S felt_rate = lane().drag_rate;
    feel_push(0);
    if (stays(0)) return true;
    lane().body = felt;
    lane().drag_rate = felt_rate;
    return false;
  }
  void judge_pushed() {
    const bool sound = ends_finite(fidelity(), lane().step);
    if (sound) {
      dense_lanes(course_, lane(), j_->at);
      drop_higher_terms(j_->at);
    }
    lane().tries = S(1);
    judge(true, true, sound, kAllWatched);
  }

  [[nodiscard]] static double end_of(const FrameStart& from, std::int64_t frame) {
    return static_cast<double>(frame + 1) * from.dt;
  }
  // ------------------------------------------------------------------------------------------- things of a scene
  void begin_contacts(MeetingStep step) {
    if (!is_framed()) step.draw = record_.legs.size();
    host_.begin(step);
    if (host_.scene() != nullptr)
      contacts_.emplace(host_);
    else
      contacts_.reset();
  }

  [[nodiscard]] std::optional<collide::PathHit> meeting() {
    const auto seen = [this](const State<double>& s, double clock) { return drifted(s, clock); };
    return contacts_->meeting(course_, *j_, into_step_, seen);
  }
  [[nodiscard]] State<double> drifted(const State<double>& s, double clock) const {
    return record_.legs.empty() ? with_drift(s, record_.drift, record_.sight.right, path_.since_start(clock)) : s;
  }

  /// Met something inside a step.
  PHYSIM_COLD void strike(const collide::PathHit& met) {
    met_ = true;
    const double clock = j_->at.time(met.theta);
    const double passed = std::min(clock + into_step_, parts_.end());
    State<double> s = drifted(j_->at.moving_at_time(clock, met.hit.normal, met.hit.velocity), clock);
    s.x = met.hit.position;
    if (turns(fidelity())) cast_numbers(j_->at.turn_at_time(clock), lane().step.turn->start);
    begin_contact(passed);
    put(s, passed);
    feel_push(passed);
    leave_thing(contacts_->struck(s, met.hit, passed));
  }
  void begin_contact(double passed) {
    if (record_.legs.empty()) record_.legs.push_back({.clock = record_.clock}), record_.bodies.push_back(record_.body);
    if (is_framed()) parts_.come_near(passed);
    host_.slides.clear();
    if (!is_framed() && passed - counts_from_ > kLongestPart) counts_from_ = passed, begin_contacts(host_.step());
  }
  /// True if the projectile lies on a thing; it moves along the thing then.
  bool stays(double passed) {
    if (!contacts_) return false;
    const State<double> s{vec_cast<double>(lane().step.start.x), vec_cast<double>(lane().step.start.v)};
    const auto on = contacts_->lies_on(s, passed);
    if (!on) return false;
    begin_contact(passed);
    leave_thing(contacts_->goes_along(s, *on, passed));
    return true;
  }
  PHYSIM_COLD void leave_thing(const SceneContacts::After& after) {
    keep_slides();
    if (ended_) return;
    using Then = SceneContacts::Then;
    const double time = host_.time_of(after.passed);
    if (after.then == Then::stops || after.then == Then::sticks) {
      const bool sticks = after.then == Then::sticks;
      const Vec3d at = vec_cast<double>(vec_cast<S>(after.state.x));
      path_.keep_node(time, {at, sticks ? Vec3d{} : after.state.v}, true);
      return end(Outcome::hit, time);
    }
    put(after.state, after.passed);
    path_.put_leg(time);
    if (is_framed() && (after.then == Then::lies || !(after.passed < frames_.dt))) return parts_.make_last();
    if (is_framed()) parts_.come_to(after.passed);
    parts_.go_on(after.passed);
    if (!is_framed() && !(after.passed < parts_.end())) end_at_limit(Outcome::time_limit, parts_.end());
  }
  /// The time is over, or the steps.
  void end_at_limit(Outcome outcome, double time) {
    path_.finish_leg();
    end(outcome, time);
  }
  [[nodiscard]] bool is_framed() const { return frames_.dt > 0; }

  /// Continues from where a contact left it, with a step that it chooses itself.
  void relaunch(double passed) {
    const bool closed = fidelity().motion == Motion::closed_form;
    lane().step.t = closed ? S(0) : static_cast<S>(passed);
    into_step_ = passed - static_cast<double>(lane().step.t);
    path_.note_times(lane().step.t, passed, static_cast<S>(kInfinity), kInfinity);
    if (lane().step.t >= static_cast<S>(parts_.end())) return end_at_limit(Outcome::time_limit, parts_.end());
    if (lane().tries >= course_.plan.max_tries) return end_at_limit(Outcome::step_limit, passed);
    march_.relaunch();
    path_.starts_frame();
    met_ = false;
  }

  /// It is there now; closed forms know only their launch, and their clock starts there.
  void put(const State<double>& s, double passed) {
    Lanes<S>& l = lane();
    l.step.start = {vec_cast<S>(s.x), vec_cast<S>(s.v)};
    steps_of_ = S(0);
    host_.put_clock(t_start_);
    if (fidelity().motion != Motion::closed_form) return;
    const double along = dot(s.x - vec_cast<double>(l.body.launch.x), vec_cast<double>(l.body.sight));
    const double clock = static_cast<double>(t_start_) + passed;
    l.body.launch = l.step.start;
    t_start_ = -static_cast<S>(passed);
    t_end_ = static_cast<S>(frames_.dt - passed);
    host_.put_clock(t_start_);
    is_relaunched_ = true;
    // Ranges and times go on from the first launch.
    passed_range_ += along;
    passed_time_ += clock;
    for (int i = 0; i < course_.watch.count; ++i) {
      EventSpec& spec = course_.watch.item[i].spec;
      if (row_of(spec.kind).watch == Watch::range) spec.value -= along;
      if (row_of(spec.kind).watch == Watch::time) spec.value -= clock;
    }
  }
  /// In a frame in which generators push it, they go on as they were at the contact.
  void feel_push(double passed) {
    if (!path_.own_body) return;
    const double part = passed / frames_.dt;
    const Pushed<double> push = push_at_start_ + (push_at_end_ - push_at_start_) * part;
    path_.push = push.a;
    lane().drag_rate = static_cast<S>(push.drag_rate);
    Body<S>& body = lane().body;
    body.applied = path_.own_body->applied;
    body.applied_until = path_.own_body->applied_until;
    const S from = t_start_ + static_cast<S>(passed);
    add_push(*course_.conditions, {from, t_end_}, from, vec_cast<S>(path_.push), frames_.has_own_force, body);
  }

  /// What it did along surfaces, up to where something ends it there.
  void keep_slides() {
    for (const Slide& slide : host_.slides) {
      if (slide.end < slide.begin) continue;
      path_.keep_node(slide.begin, slide.from, true);
      path_.keep_node(slide.end, slide.to, false);
      if (find_crossings_of(slide)) return;
      const bool rests = slide.from.v == Vec3d{} && slide.to.v == Vec3d{};
      if (rests && ends_at_rest_ && !host_.scene()->has_motion() && !has_stops(*course_.conditions))
        return end(Outcome::hit, slide.begin);
    }
  }
  /// True where one of them ends the flight.
  PHYSIM_COLD bool find_crossings_of(const Slide& slide) {
    const Conditions<double>& c = *course_.conditions_double;
    const Body<double> body = wide_body(lane());
    struct Crossed {
      double time;
      int index;
      bool rising;
    };
    std::vector<Crossed> found;
    for (int i = 0; i < course_.watch.count; ++i) {
      const EventSpec& spec = course_.watch.item[i].spec;
      const double clock = static_cast<double>(t_start_) - begins_;  // of the march, at the start of the flight
      const auto value = [&](double t) { return watched_value(c, body, spec, clock + t, record_.state(t)); };
      const double from = value(slide.begin), to = watched_value(c, body, spec, clock + slide.end, slide.to);
      if (!crosses(spec.direction, from, to)) continue;
      found.push_back({find_root(value, slide.begin, from, slide.end, to, kThetaTolerance), i, from < 0});
    }
    std::ranges::stable_sort(found, {}, &Crossed::time);
    for (const auto& [time, i, rising] : found) {
      const Watched& watched = course_.watch.item[i];
      keep_crossing(watched, rising, time, record_.state(time));
      if (watched.spec.terminal) return end(watched.outcome, time), true;
    }
    return false;
  }

  void put_events_in_order() {
    if (host_.told.empty()) return;
    auto& events = record_.events;
    events.insert(events.end(), host_.told.begin(), host_.told.end());
    if (ended_) std::erase_if(events, [this](const Event& e) { return e.time > record_.duration; });
    std::ranges::stable_sort(events, {}, &Event::time);
  }

  FlightRecord& record_;
  Course<S> course_;
  March<S> march_;
  Obstacles obstacles_;
  MeetingLane<S> host_;
  PathKeeper<S> path_;
  std::optional<SceneContacts> contacts_;  // none: it meets nothing
  FrameStart frames_;                      // dt 0: none, from a launch
  Unset<Judgement<S>> j_;                  // of the last step that was looked at
  bool is_plain_ = false;                  // known steps go on from a launch and meet nothing
  KnownStep known_ = known_step(*course_.conditions_double);
  bool ended_ = false;
  bool met_ = false;            // something, in the step at hand
  bool is_relaunched_ = false;  // a closed form, in this frame
  bool ends_at_rest_ = false;
  StepParts parts_{0, false};                  // of the frame, or the flight
  std::optional<S> steps_of_;                  // as in world/step/settle.cpp, since a contact in the frame
  S t_start_{}, t_end_{};                      // of the frame, on the march's clock
  double into_step_ = 0;                       // from the march's clock to the time into the contacts' step [s]
  double passed_range_ = 0, passed_time_ = 0;  // where closed forms were relaunched [m], [s]
  double counts_from_ = 0;                     // hits, where no frame does [s]
  Pushed<double> push_at_start_{}, push_at_end_{};
  double begins_ = 0;  // the frame at hand, since the flight began [s]
};

}  // namespace physim
