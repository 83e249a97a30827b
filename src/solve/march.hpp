// March: lanes on their way, with their step control, stops and corners. The one place where steps are chosen, cut,
// accepted and followed by others.
//
// fly() and fly_batch() launch lanes and march until their flights end; a world lets rows march from moment to moment,
// a frame at a time: the fixed steps of a flight are those of its plan, a frame is one step of its length. Adaptive
// integrators try a frame as one step and divide it where their error or a corner requires it; they remember nothing
// from frame to frame. Rows that push each other go through a step stage by stage (solve/stages.hpp).
#pragma once

#include "base/assert.hpp"
#include "math/vec3.hpp"
#include "solve/corners.hpp"
#include "solve/step_control.hpp"

PHYSIM_ISA_BEGIN

/// Closed forms need steps only to look for events in: the first a part of the time to the apex, each twice the last,
/// so that a few cover flights of any length; with drag short enough that nothing turns twice in one.
template <class R, class S>
PHYSIM_INLINE R longest_closed_form_step(const Conditions<S>& c, const Body<R>& b) {
  const R sixty(S(60));
  return c.fidelity.drag == DragModel::off ? sixty : min(S(0.5) / max(b.damping_rate, R(S(1e-6))), sixty);
}
template <class R, class S>
PHYSIM_INLINE R closed_form_step(const Conditions<S>& c, const Body<R>& b) {
  const R speed = length(b.launch.v);
  const R rise = speed / max(R(c.gravity), R(S(1e-3)));  // time to the apex of a shot straight up
  const R first = select(speed > R(S(0)), clamp(rise * S(0.5), R(S(1e-12)), R(S(10))), R(S(1e-3)));
  return min(first, longest_closed_form_step(c, b));
}

template <class R>
PHYSIM_INLINE MaskOf<R> stands_still(const Lanes<R>& l) {
  return stands_still(l.step.t, l.step.h, l.step.t_end);
}

template <class R>
class March {
  using S = ScalarOf<R>;
  using Mask = MaskOf<R>;

 public:
  PHYSIM_INLINE March() : March(Body<R>{}) {}
  PHYSIM_INLINE explicit March(const Course<S>& course) : March() { set_course(course); }
  PHYSIM_INLINE March(const Course<S>& course, const Body<R>& body) : March(body) { set_course(course); }

  /// Before a launch or a restart nothing is set but the body and the first slope, which closed forms started by frames
  /// keep at zero.
  Lanes<R> lanes;

  [[nodiscard]] PHYSIM_INLINE const Course<S>& course() const { return *course_; }
  /// Sets the course of the lanes in place: a march is too large to be rebuilt and copied.
  PHYSIM_INLINE void set_course(const Course<S>& course) { course_ = &course; }

  /// Launches lanes; their body, and rotor where it is read, is set.
  PHYSIM_INLINE void launch() {
    const Conditions<S>& c = conditions();
    Lanes<R>& l = lanes;
    const R zero(S(0));
    l.step.t = zero;
    l.step.start = l.body.launch;
    if (has_stops(c)) pass_stops(c, zero, zero == zero, l.step.start, l.body);
    for_rotors(
        c.fidelity, [&](const auto& rotor) { l.step.turn->start = rotor.launch; }, l);
    if (is_braked(c)) l.step.h = R(course_->plan.step);
    set_slope(c, l, 0);
    if (is_classic(c.fidelity)) l.step.slope[0].v = {zero, zero, zero};
    l.control = {zero, first_length()};
    note_regime();
    l.count = l.parts = l.tries = l.cut = zero;
    framed_ = false;
  }

  /// Starts a frame where step.start is, at the time step.t; it ends at `limit`, which is `frame` away. What the
  /// original loop carries over from its last frame is in step.slope[0].v.
  PHYSIM_INLINE void restart(const R& limit, const R& frame) {
    const Conditions<S>& c = conditions();
    Lanes<R>& l = lanes;
    const R zero(S(0));
    if (has_stops(c)) pass_stops(c, l.step.t, zero == zero, l.step.start, l.body);
    PHYSIM_ASSERT(course_->plan.step == S(0));  // a frame is one step of its length
    PHYSIM_ASSERT(!any(frame < zero) && !any(limit < l.step.t));
    l.step.h = frame;
    begin_frame();
    l.control = {zero, frame};
    note_regime();
    l.count = l.parts = l.tries = l.cut = zero;
    limit_ = limit;
    left_ = frame;
    framed_ = true;
  }

  /// Continues from step.start at the time step.t as from a launch, with what chooses its steps itself.
  PHYSIM_INLINE void relaunch() {
    const Conditions<S>& c = conditions();
    Lanes<R>& l = lanes;
    const R zero(S(0));
    PHYSIM_ASSERT(steps_itself(c.fidelity) && course_->plan.step == S(0));
    if (has_stops(c)) pass_stops(c, l.step.t, zero == zero, l.step.start, l.body);
    begin_frame();
    l.control = {zero, first_length()};
    note_regime();
    l.cut = zero;
    framed_ = false;
  }

  /// Takes the velocity where a step starts from one of steps of a length to one of steps of another. Length 0: the
  /// velocity of the motion itself, which contacts read and leave (stagger()). The slope there is known. Drag leaves
  /// less of a long step's slope than of a short one's (BrakedSum): each length has its own.
  PHYSIM_INLINE void restagger(const R& from, const R& to) {
    const double part = stagger(conditions().fidelity);
    if (part == 0) return;
    PHYSIM_ASSERT(!any(from < R(S(0))) && !any(to < R(S(0))));
    Step<R>& s = lanes.step;
    if (!is_braked(conditions()))
      s.start.v += s.slope[0].v * (constant<R>(part) * (from - to));
    else if (any(from > R(S(0))))
      s.start.v += lead(slope_over(from), from, part) - lead(slope_over(to), to, part);
    else
      s.start.v -= lead(slope_over(to), to, part);
    s.slope[0].x = s.start.v;
  }
  /// The acceleration where the step starts, of a step of length h, with what the body feels of generators there.
  PHYSIM_INLINE Vec3<R> slope_over(const R& h) {
    Step<R>& s = lanes.step;
    if (!is_braked(conditions())) return s.slope[0].v;
    const R length = s.h;
    const Vec3<R> own = s.slope[0].v;
    s.h = h;
    set_slope(conditions(), lanes, 0);
    const Vec3<R> found = s.slope[0].v;
    s.h = length;
    s.slope[0].v = own;
    return found;
  }

  /// Tries one step in each of some marches side by side, by what takes steps as take_steps() does; says in which lanes
  /// of each it was accepted.
  PHYSIM_INLINE static void try_steps(March* const* marches, int count, Mask* accepted, const auto& take) {
    PHYSIM_ASSERT(count > 0 && count <= kMostSets && marches[0]->course_ != nullptr);
    const Course<S>& course = *marches[0]->course_;
    FlyerSet<R> flyers;
    for (int i = 0; i < count; ++i) {
      marches[i]->set_step(*course.conditions);
      flyers.add(marches[i]->lanes);
    }
    take(*course.conditions, flyers, course.plan.relative, course.plan.absolute);
    for (int i = 0; i < count; ++i) accepted[i] = marches[i]->control_step(*course.conditions, all());
  }
  /// Tries one in the lanes that are asked for; what others do means nothing.
  PHYSIM_INLINE Mask try_step(const Mask& asked = all()) {
    const Conditions<S>& c = conditions();
    set_step(c);
    take_step(c, lanes, course_->plan.relative, course_->plan.absolute);
    return control_step(c, asked);
  }

  /// Moves accepted lanes to the end of their step.
  PHYSIM_INLINE void accept(const Mask& accepted) { accept(conditions(), accepted); }
  PHYSIM_INLINE void accept(const Conditions<S>& c, const Mask& accepted) {
    Lanes<R>& l = lanes;
    const int last = last_slope(c.fidelity);
    if constexpr (std::is_floating_point_v<R>) {
      if (!accepted) return;
    }
    PHYSIM_ASSERT(!any(accepted & (l.step.t_end < l.step.t)));  // clocks run forwards
    l.step.t = select(accepted, l.step.t_end, l.step.t);
    if (course_->corners && expects_kinks(c)) {
      const R rate = R(S(1)) / l.step.h;
      const Vec3<R> change = l.step.slope[last].v - l.step.slope[0].v;
      l.jerk = select(accepted, Vec3<R>{change.x * rate, change.y * rate, change.z * rate}, l.jerk);
    }
    const auto move_on = [&](auto& part) {
      part.start = select(accepted, part.end, part.start);
      part.slope[0] = select(accepted, part.slope[last], part.slope[0]);
    };
    for_parts(c.fidelity, move_on, l.step);
    const Mask whole = has_stops(c) ? pass_on(accepted) : accepted;
    l.count = select(whole, l.count + R(S(1)), l.count);
    if (framed_)
      left_ = select(accepted, limit_ - l.step.t, left_);
    else if (c.fidelity.motion == Motion::closed_form)
      l.control.h = min(l.control.h * S(2), longest_closed_form_step(c, l.body));
  }

  /// Lanes that are through their frame.
  [[nodiscard]] PHYSIM_INLINE Mask arrived() const { return lanes.step.t >= limit_; }
  /// Lanes with too many or too short steps.
  [[nodiscard]] PHYSIM_INLINE Mask is_stuck() const {
    return (lanes.tries >= R(course_->plan.max_tries)) | stands_still(lanes);
  }

  /// Takes a frame; step.start and step.t are given, step.end is where it ends. Returns those of the lanes asked for
  /// that do not get there.
  PHYSIM_INLINE Mask take_frame(const R& limit, const R& frame, const Mask& asked) {
    const Conditions<S>& c = conditions();
    if (!steps_itself(c.fidelity) || c.fidelity.motion == Motion::closed_form) return take_in_one(limit, frame);
    restart(limit, frame);
    Mask under_way = asked;
    Mask lost = none();
    while (any(under_way)) {
      const Mask accepted = try_step(under_way);
      lost = lost | (under_way & is_stuck());
      accept(accepted & !lost);
      under_way = under_way & !lost & !arrived();
    }
    for_parts(
        c.fidelity, [](auto& part) { part.end = part.start; }, lanes.step);
    return lost;
  }

 private:
  [[nodiscard]] PHYSIM_INLINE const Conditions<S>& conditions() const { return *course_->conditions; }

  [[nodiscard]] PHYSIM_INLINE static Mask all() { return R(S(0)) == R(S(0)); }
  [[nodiscard]] PHYSIM_INLINE static Mask none() { return R(S(0)) != R(S(0)); }

  /// The first slope of a frame; the original loop's is there but for the velocity.
  PHYSIM_INLINE void begin_frame() {
    const Fidelity& f = conditions().fidelity;
    if (is_classic(f)) lanes.step.slope[0].x = lanes.step.start.v;
    if (!is_classic(f) && f.motion != Motion::closed_form) set_slope(conditions(), lanes, 0);
  }

  PHYSIM_INLINE void note_regime() {
    Lanes<R>& l = lanes;
    if (!course_->corners) return;
    l.regime = regime(conditions(), l.body, *l.rotor, l.step.t, l.step.start);
    l.jerk = {R(S(0)), R(S(0)), R(S(0))};
  }

  /// The length of a flight's first step.
  [[nodiscard]] PHYSIM_INLINE R first_length() const {
    const Conditions<S>& c = conditions();
    const StepPlan<S>& plan = course_->plan;
    if (plan.step > S(0)) return R(plan.step);
    PHYSIM_ASSERT(steps_itself(c.fidelity));
    if (c.fidelity.motion == Motion::closed_form) return closed_form_step(c, lanes.body);
    const Step<R>& s = lanes.step;
    R h = min(first_step(c.fidelity.integrator, s.start, s.slope[0].v, plan.relative, plan.absolute), R(plan.max_step));
    const auto turns_fast = [&](const auto&) { h = min(h, first_turn_step(c.fidelity.integrator, *s.turn)); };
    for_rotors(c.fidelity, turns_fast, lanes);
    return h;
  }

  /// A frame without step control: the slope at its end, which nothing reads, is left out.
  PHYSIM_INLINE Mask take_in_one(const R& limit, const R& frame) {
    const Conditions<S>& c = conditions();
    lanes.step.h = frame;
    lanes.step.t_end = limit;
    begin_frame();
    reach_ends(c, FlyerSet<R>(lanes));
    return none();
  }

  /// The coming step: as long as its control wants it, or what is left of a whole one, or up to a stop or a kink.
  PHYSIM_INLINE void set_step(const Conditions<S>& c) {
    if (!is_braked(conditions())) return set_length(c);
    const R before = lanes.step.h;
    set_length(c);
    if (any(lanes.step.h != before)) set_slope(c, lanes, 0);  // that of a step as long as the one before stays the same
  }
  PHYSIM_INLINE void set_length(const Conditions<S>& c) {
    set_length_before_kinks(c);
    if (course_->corners && expects_kinks(c)) end_behind_kinks(*course_, lanes);
  }
  /// Fixed steps count, so that time does not gather rounding errors.
  PHYSIM_INLINE void set_length_before_kinks(const Conditions<S>& c) {
    Lanes<R>& l = lanes;
    const bool counted = !steps_itself(c.fidelity);
    if (!framed_ && !has_stops(c)) {
      l.step.h = l.control.h;
      l.step.t_end = counted ? (l.count + R(S(1))) * l.step.h : l.step.t + l.step.h;
      return;
    }
    // What is left of a fixed step is the next one; a step that was cut at a corner is as long as it was cut.
    const R plan_step(course_->plan.step);
    const R end = framed_ ? limit_ : (l.count + R(S(1))) * plan_step;
    const R left = framed_ ? left_ : select(l.step.t == l.count * plan_step, plan_step, end - l.step.t);
    Mask whole = l.cut == R(S(0));
    if (!counted) whole = framed_ ? whole & (l.control.h >= left) : none();
    l.step.t_end = select(whole, end, l.step.t + l.control.h);
    l.step.h = select(whole, left, l.control.h);
    if (!has_stops(c)) return;
    const R stop = next_stop(c, l.body);
    const Mask stops = stop < l.step.t_end;
    l.step.t_end = select(stops, stop, l.step.t_end);
    l.step.h = select(stops, l.step.t_end - l.step.t, l.step.h);
  }

  /// Judges a step taken: returns the lanes in which it is accepted, and sets control.h to the next step to try.
  PHYSIM_INLINE Mask control_step(const Conditions<S>& c, const Mask& asked) {
    Lanes<R>& l = lanes;
    l.tries += R(S(1));
    Mask accepted = asked;
    if (steps_itself(c.fidelity) && c.fidelity.motion != Motion::closed_form) {
      const R proposed = l.control.h;
      accepted = judge_error(c.fidelity.integrator, l.step.h, l.step.error, asked, course_->plan.max_step, l.control);
      // A step that had to end at a stop, a kink or a frame says nothing against the longer one it would have been.
      if (framed_ || has_stops(c) || expects_kinks(c))
        l.control.h = select(accepted & (l.step.h < proposed), max(l.control.h, proposed), l.control.h);
      // Behind a corner it bends in another way: half of the step that was allowed before is tried.
      if (course_->corners) l.control.h = select(accepted, max(l.control.h, R(S(0.5)) * l.cut), l.control.h);
    }
    if (!course_->corners) return accepted;
    if constexpr (std::is_floating_point_v<R>) {
      if (only_below_first_layer(c, l)) return accepted;  // as c says, of which the compiler may know more
    }
    return respect_corners(*course_, l, accepted);
  }

  /// Counts what was accepted, and passes on behind its end: the first slope there is another one where something
  /// stops. Returns the lanes in which a whole step is over.
  PHYSIM_INLINE Mask pass_on(const Mask& accepted) {
    const Conditions<S>& c = conditions();
    Lanes<R>& l = lanes;
    const R one(S(1));
    Mask whole = accepted;
    if (!steps_itself(c.fidelity)) whole = accepted & (l.step.t >= (l.count + one) * course_->plan.step);
    l.parts += select(accepted & !whole, one, R(S(0)));
    const Mask changed = pass_stops(c, l.step.t, accepted, l.step.start, l.body);
    if (!any(changed)) return whole;
    constexpr int kUnused = kMaxSlopes - 1;  // until the dense output of the next step
    for_parts(
        c.fidelity, [](auto& part) { part.slope[kUnused] = part.slope[0]; }, l.step);
    set_slope(c, l, 0);
    const auto keep = [&](auto& part) { part.slope[0] = select(changed, part.slope[0], part.slope[kUnused]); };
    for_parts(c.fidelity, keep, l.step);
    if (c.has_rail) l.regime.rail = l.body.rail_phase;  // without rails the regime knows none
    return whole;
  }

  PHYSIM_INLINE explicit March(const Body<R>& body) {
    lanes.body = body;
    lanes.drag_rate = R(S(0));
    lanes.step.slope[0] = {};
  }

  const Course<S>* course_ = nullptr;
  bool framed_ = false;  // goes by frames, to a limit
  R limit_{};            // where the frame ends [s]
  R left_{};             // until then, as it was given or counted [s]
};

PHYSIM_ISA_END
