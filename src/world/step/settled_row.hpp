// One row of a cohort, taken out of its columns to be stepped by itself, and put back. S is the cohort's number type.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "base/assert.hpp"
#include "base/unset.hpp"
#include "collide/scene_contact.hpp"
#include "math/elementary.hpp"
#include "model/contact.hpp"
#include "physim/scene.hpp"
#include "solve/judge.hpp"
#include "solve/lane_motion.hpp"
#include "solve/stages.hpp"
#include "world/core/apex.hpp"
#include "world/step/drive.hpp"
#include "world/step/ground_contact.hpp"
#include "world/step/settle.hpp"

namespace physim {

template <class S>
class SettledRow final : public ContactHost {
 public:
  SettledRow(const SettleContext& context, Chunk& chunk, std::uint32_t row)
      : context_(context),
        chunk_(chunk),
        cohort_(context.registry->cohort(chunk.cohort)),
        rows_(context.state->rows[chunk.cohort]),
        columns_(rows_.columns<S>()),
        row_(row),
        slot_index_(rows_.slot(row)),
        taken_(taken_of(context, cohort_)),
        is_traced_(context.pairs && collision().others != 0),
        told_{chunk.events.size(), chunk.changes.size(), chunk.traces.size()},
        march(cohort_.course<S>()) {
    PHYSIM_ASSERT(row < rows_.size());
    read();
    start_ = here();
    if (cohort_.key.forced) find_drive();
  }

  // ------------------------------------------------------------------------------------------- where it is
  [[nodiscard]] State<S>& now() { return march.lanes.step.start; }
  [[nodiscard]] const State<S>& now() const { return march.lanes.step.start; }
  [[nodiscard]] State<double> here() const { return {vec_cast<double>(now().x), vec_cast<double>(now().v)}; }
  [[nodiscard]] const State<double>& at_start() const { return start_; }
  /// It is somewhere, and what generators give it there is a number.
  [[nodiscard]] bool is_sound() const {
    return is_finite(now()) && (!taken_ || is_finite(State<S>{taken_->push[0].a, {}}));
  }
  [[nodiscard]] bool ends_finite() const { return physim::ends_finite(cohort_.key.fidelity, march.lanes.step); }
  [[nodiscard]] bool gone() const { return gone_; }
  /// Another piece of its motor's table, another phase on the rail, the end of its force.
  [[nodiscard]] bool has_passed_stops() const {
    const Body<S>& body = march.lanes.body;
    return has_stops(conditions()) &&
           (body.burn_piece != from_row_->burn_piece || body.rail_phase != from_row_->rail_phase ||
            (conditions().has_force_end && from_row_->applied_until <= t_end_));
  }
  [[nodiscard]] const Slot& slot() const { return context_.state->slots[slot_index_]; }
  [[nodiscard]] std::uint32_t slot_index() const { return slot_index_; }
  [[nodiscard]] const WorldCohort& cohort() const { return cohort_; }
  [[nodiscard]] const Conditions<double>& conditions() const { return cohort_.conditions; }
  [[nodiscard]] const TakenStep<S>* taken() const { return taken_; }
  [[nodiscard]] bool is_stepped() const { return taken_ && taken_->is_stepped; }
  [[nodiscard]] bool turning() const { return rows_.layout().turning; }
  [[nodiscard]] bool is_clocked() const { return rows_.layout().clocked; }
  [[nodiscard]] S t_start() const { return t_start_; }
  [[nodiscard]] S t_end() const { return t_end_; }
  [[nodiscard]] std::uint32_t row() const { return row_; }
  [[nodiscard]] bool is_held() const { return context_.state->joints.of_slot(slot_index_) != nullptr; }
  [[nodiscard]] bool meets() const { return rows_.layout().meeting; }

  // ------------------------------------------------------------------------------------------- as SceneContacts asks
  [[nodiscard]] const Scene* scene() const override { return meets() ? context_.scene : nullptr; }
  [[nodiscard]] Precision precision() const override { return cohort_.key.fidelity.precision; }
  [[nodiscard]] const CollisionDef& collision() const override { return kind().body.collision; }
  [[nodiscard]] OwnSurface surface() const override { return OwnSurface::of(kind().body); }
  [[nodiscard]] Vec3d turns() const override {
    return context_.state->extras.turns(slot_index_, kind().body.frozen_rotation);
  }
  [[nodiscard]] double scene_time() const override { return context_.time; }
  [[nodiscard]] double step_length() const override { return length_; }
  [[nodiscard]] Impact impact(int hits) const override {
    Impact impact;
    impact.mass = kind().flown.mass;
    impact.diameter = kind().flown.diameter;
    impact.length = kind().flown.length;
    impact.seed = slot().generation;
    impact.projectile = slot_index_;
    impact.hit = hit_number(std::bit_cast<std::uint64_t>(context_.time), hits);  // a time is part of the hash
    return impact;
  }
  /// What is known of a hit, which is told whose it is and when; null: nothing.
  [[nodiscard]] const HitAnswer* answer_to(HitQuestion& question, double passed) const override {
    PHYSIM_ASSERT(context_.asking && context_.asking->has_function());
    question.projectile = {slot_index_, slot().generation};
    question.kind = {kind().number};
    question.time = context_.time + passed;
    return context_.asking->find(question);
  }
  /// It is left as it was, and nothing of what it told happened, until somebody answers.
  void leave_open(const HitQuestion& question) override {
    PHYSIM_ASSERT(!gone_);
    gone_ = true;
    chunk_.events.resize(told_.events);
    chunk_.changes.resize(told_.changes);
    forget_traces();
    chunk_.open.push_back({chunk_.cohort, row_, question});
  }

  /// So far from where it is now it may fly before it can be near anything.
  [[nodiscard]] S& clear() const { return columns_.clear[row_]; }
  /// In which nothing stands.
  void put_tube(const ClearTube<S>& tube) const { Rows::put(columns_.tube, row_, tube); }
  [[nodiscard]] bool has_launch_place() const { return rows_.layout().launched; }
  [[nodiscard]] Vec3d launch_place() const { return Rows::at(columns_.launch, row_); }

  /// How it spins, `passed` into the step, in W: as its rung flies it, or as it is shown [rad/s].
  [[nodiscard]] Vec3d spin(double passed) const override {
    if (const auto flown = spin_of_lane(conditions(), march.lanes, t_start_, passed)) return *flown;
    if (shown_) return *shown_;
    const Turning* turning = context_.state->extras.find_turning(slot_index_);
    return turning ? turning->angular_velocity : Vec3d{};
  }
  void put_spin(const Vec3d& spin, double passed) override {
    if (spin == this->spin(passed)) return;
    if (!put_spin_of_lane(conditions(), march.lanes, t_start_, passed, spin)) {
      shown_ = spin;
      return;
    }
    if (!spins(cohort_.key.fidelity)) return;
    from_row_->spin = march.lanes.body.spin;
    respun_ = true;
  }
  void count_step() { ++chunk_.flown; }
  /// Where it points and how it turns, where that is flown.
  void put_turn(const Turn<double>& turn) { cast_numbers(turn, march.lanes.step.turn->start); }
  [[nodiscard]] Vec3d acceleration_at(const State<double>& s, double after) const override {
    const Vec3d a =
        acceleration_of_lane(conditions(), march.lanes, march.course().body, static_cast<double>(t_start_) + after, s);
    return driven_ ? a + kept(driven_->by.at(context_.time + after, s).a - driven_->felt.a) : a;
  }

  [[nodiscard]] GroundBelow ground_below(const Vec3d& x) const override {
    return physim::ground_below(conditions(), context_.def->ground, x);
  }

  /// What constraints leave of a velocity or a way.
  [[nodiscard]] Vec3d kept(const Vec3d& v) const override { return kept_of_lane(conditions(), march.lanes, v); }

  /// From now to the end of the step the models feel the mean of what generators give it in that time.
  void feel_as_at(double passed) {
    if (!taken_) return;
    felt_from_ = t_start_ + static_cast<S>(passed);
    if (driven_)
      feel_drive(passed, now(), felt_from_, mean_from(driven_->held, passed));
    else
      feel(mean_from(taken_->push, passed), felt_from_);
  }
  /// Whether its emitter acts on its flight.
  [[nodiscard]] bool is_driven() const { return driven_.has_value(); }
  /// One step from `passed` on to the march's limit, stage by stage: what drives it is felt in each.
  void take_driven_step(double passed, S limit, S h) {
    PHYSIM_ASSERT(driven_ && passed >= 0);
    const Conditions<S>& c = *march.course().conditions;
    const Integrator integrator = c.fidelity.integrator;
    Step<S>& s = march.lanes.step;
    s.h = h;
    s.t_end = limit;
    const double length = h == static_cast<S>(context_.dt) ? context_.dt : static_cast<double>(h);  // as packs take it
    driven_->by.begin_step(integrator, context_.time + passed, length);
    if (is_classic(c.fidelity)) s.slope[0].x = s.start.v;
    for (int stage = 0; stage < end_slope(integrator); ++stage) {
      const State<S> at = stage == 0 ? s.start : s.end;
      const double then = passed + stage_place(integrator, stage) * length;
      feel_drive(then, at, stage_time(integrator, stage, s), push_at(driven_->held, then));
      advance_stage(c, stage, march.lanes);
    }
    if (is_classic(c.fidelity)) {
      s.slope[0].v = s.slope[1].v;
    } else {
      feel_drive(passed + length, s.end, s.t_end, push_at(driven_->held, passed + length));
      set_slope(c, march.lanes, end_slope(integrator));
    }
  }

  // ------------------------------------------------------------------------------------------- parts of a step
  /// Only so much of the step is flown [s].
  void end_at(double until) {
    PHYSIM_ASSERT(until >= 0 && until <= context_.dt);
    length_ = until;
  }
  /// It was born `passed` into the step: its clock starts there.
  void begin_at(double passed) {
    PHYSIM_ASSERT(passed >= 0 && passed <= length_);
    t_start_ = -static_cast<S>(passed);
    t_end_ = static_cast<S>(context_.dt - passed);
    relaunched_ = is_clocked();
    feel_as_at(passed);
  }

  // ------------------------------------------------------------------------------------------- where it is put
  /// It is there now.
  void put(const State<double>& s, double passed) {
    trace_way_to(passed, s);
    now() = {vec_cast<S>(s.x), vec_cast<S>(s.v)};
    relaunch(passed);
    trace(passed, here());
  }
  /// Nothing more happens to it in this step.
  void put_at_last(const State<double>& s, double passed) {
    put(s, passed);
    trace_way_to(length_, s);
    trace(length_, here());
  }
  /// To the end of the step that was taken together with others; what is missing is the slope there.
  void put_taken() {
    Step<S>& s = march.lanes.step;
    const Fidelity& f = cohort_.key.fidelity;
    s = taken_->step;
    s.h = static_cast<S>(context_.dt);
    s.t = t_start_;
    s.t_end = is_clocked() ? t_end_ : t_start_ + s.h;
    if (is_classic(f)) {
      s.slope[0].v = s.slope[1].v;  // what its next frame begins with
    } else {
      feel(taken_->push[1], s.t_end);
      set_slope(*march.course().conditions, march.lanes, end_slope(f.integrator));
    }
  }
  /// To the moment of a meeting with another one. Of those that turn it needs how they do then; what others are like
  /// there follows from the meeting.
  void go_to(const Parting& parting) {
    double from = 0;
    if (const Trace* last = parting.from) {
      from = last->passed;
      if (turning()) put_turn(last->turn);
      now() = {vec_cast<S>(last->state.x), vec_cast<S>(last->state.v)};
      put_spin(last->spin, from);
    }
    feel_as_at(from);
    if (turning() && parting.passed > from) fly_unseen(from, parting.passed);
    feel_as_at(parting.passed);
  }

  // ------------------------------------------------------------------------------------------- what happens to it
  void tell(EventKind kind, Reason reason, double passed, const State<double>& s, const SceneHit& hit = {},
            double depth = 0, double energy = 0) override {
    Event& event = chunk_.events.emplace_back(event_of(kind, reason, s, hit, depth, energy));
    event.id = {slot_index_, slot().generation};
    event.time = context_.time + passed;
  }
  /// True if the projectile's last event in this step at a sensor is `left`; its events are the last of the chunk.
  [[nodiscard]] bool has_left(const InstanceId& sensor) const {
    for (std::size_t i = chunk_.events.size(); i > 0; --i) {
      const Event& told = chunk_.events[i - 1];
      if (told.id != ProjectileId{slot_index_, slot().generation}) break;
      if (told.instance == sensor) return told.kind == EventKind::left;
    }
    return false;
  }
  void change(Change::Kind kind, LifeStatus status, Reason reason) {
    chunk_.changes.push_back({slot_index_, kind, status, reason, {}});
  }
  void leave(LifeStatus status, Reason reason) {
    gone_ = true;
    change(Change::Kind::remove, status, reason);
  }
  /// Leaves the world; it keeps the last sound state that it had.
  void retire(Reason reason) {
    tell(EventKind::retired, reason, 0, start_);
    leave(LifeStatus::retired, reason);
  }
  /// Whether a step that was tried leaves it in the world.
  [[nodiscard]] bool outlives(bool accepted) {
    const bool finite = !is_adaptive(cohort_.key.fidelity.integrator) || is_finite(march.lanes.step.error);
    if (march.is_stuck()) return retire(finite ? Reason::stalled : Reason::non_finite), false;
    if (!accepted || ends_finite()) return true;
    return retire(Reason::non_finite), false;
  }
  /// It meets others, who look at its path.
  [[nodiscard]] bool is_traced() const { return is_traced_; }
  /// Keeps a moment for others that it may meet.
  void trace(double passed, const State<double>& s) {
    if (!is_traced_) return;
    Trace& moment = chunk_.traces.emplace_back(Trace{slot_index_, passed, s, spin(passed), {}, {}});
    if (turning()) cast_numbers(march.lanes.step.turn->start, moment.turn);
  }
  /// Its way along a surface, with the velocities that it had there: behind its end it may bounce at once.
  void slid(const State<double>& from, double begin, const State<double>& to, double end) override {
    if (!(end > begin)) return;
    trace(begin, from);
    trace(end, to);
    if (!context_.def->apex_events || is_held()) return;
    if (climb_rate(conditions(), from) > 0) drop_hop();
    if (const auto apex = apex_between(conditions(), from, to, end - begin))
      tell(EventKind::apex, Reason::none, begin + apex->passed, apex->at);
  }
  /// The apex of a flight: where it comes down in the same step to what it slides up, it only hopped on its way.
  void tell_apex(double passed, const State<double>& s) {
    if (is_held()) return;  // its net tells it
    hop_ = chunk_.events.size();
    tell(EventKind::apex, Reason::none, passed, s);
  }
  void end_hop() { hop_.reset(); }
  /// The moment at which an accepted step ended, with the velocity that it moves with.
  void trace_moving(double passed) {
    trace(passed, here());
    tell_last_trace_moves();
  }
  /// The last moment is where the step at hand starts: with the velocity that it moves with there.
  void tell_last_trace_moves() {
    const Step<S>& s = march.lanes.step;
    const double part = stagger(conditions().fidelity);
    if (!is_traced_ || part == 0 || chunk_.traces.empty()) return;
    Trace& last = chunk_.traces.back();
    const double plain = plain_step(*context_.def, context_.dt);  // its row is put for such steps
    const Vec3<S> over_plain = is_driven() ? s.slope[0].v : march.slope_over(static_cast<S>(plain));
    last.state.v = here().v + lead(vec_cast<double>(s.slope[0].v), static_cast<double>(s.h), part);
    last.ahead = lead(vec_cast<double>(over_plain), plain, part);
  }
  void forget_traces() {
    PHYSIM_ASSERT(chunk_.traces.size() >= told_.traces);
    chunk_.traces.resize(told_.traces);
  }

  void write() {
    PHYSIM_ASSERT(!gone_);
    // The current position of this step is the previous one of the next: the columns change places afterwards.
    for (int axis = 0; axis < 3; ++axis) {
      columns_.previous[axis][row_] = part(now().x, axis);
      columns_.velocity[axis][row_] = part(now().v, axis);
      if (rows_.layout().carried) columns_.carried[axis][row_] = part(march.lanes.step.slope[0].v, axis);
    }
    if (turning()) Rows::put(columns_.turn, row_, march.lanes.step.turn->start);
    if (shown_)
      chunk_.changes.push_back({slot_index_, Change::Kind::spin, LifeStatus::in_flight, Reason::none, *shown_});
    if (!relaunched_ && !respun_ && !has_passed_stops()) return;
    Body<S>& body = march.lanes.body;
    if (taken_) {  // what generators gave is not its own
      body.applied = from_row_->applied;
      body.applied_until = from_row_->applied_until;
      if (conditions().has_force_end) pass_force(t_end_, true, body);
    }
    const S* number = numbers(body);
    for (const std::uint8_t field : rows_.layout().fields) columns_.field[field][row_] = number[field];
    if (!relaunched_) return;
    columns_.offset[row_] = t_end_;
    columns_.born[row_] = static_cast<S>(context_.now + 1);
  }

 private:
  void drop_hop() {
    if (!hop_) return;
    auto& events = chunk_.events;
    PHYSIM_ASSERT(*hop_ >= told_.events && events[*hop_].kind == EventKind::apex);
    std::move(events.begin() + static_cast<std::ptrdiff_t>(*hop_) + 1, events.end(),
              events.begin() + static_cast<std::ptrdiff_t>(*hop_));
    events.resize(events.size() - 1);
    hop_.reset();
  }
  static const TakenStep<S>* taken_of(const SettleContext& context, const WorldCohort& cohort) {
    static const TakenStep<S> kNothingHeld{};
    if (context.taken) return static_cast<const TakenStep<S>*>(context.taken);
    return cohort.key.forced ? &kNothingHeld : nullptr;
  }
  [[nodiscard]] const Kind& kind() const { return context_.registry->kind(slot().kind); }
  void read() {
    Lanes<S>& lane = march.lanes;  // a March begins with an empty body
    S* number = numbers(lane.body);
    for (const std::uint8_t field : rows_.layout().fields) number[field] = columns_.field[field][row_];
    for (int axis = 0; axis < 3; ++axis) {
      part(now().x, axis) = columns_.position[axis][row_];
      part(now().v, axis) = columns_.velocity[axis][row_];
      if (rows_.layout().carried) part(lane.step.slope[0].v, axis) = columns_.carried[axis][row_];
    }
    if (is_clocked()) {
      const S steps = static_cast<S>(context_.now) - columns_.born[row_];
      t_start_ = columns_.offset[row_] + steps * static_cast<S>(context_.dt);
      t_end_ = columns_.offset[row_] + (steps + S(1)) * static_cast<S>(context_.dt);
    }
    felt_from_ = t_start_;
    if (taken_ || has_stops(conditions())) *from_row_ = lane.body;
    if (turning()) {
      Rows::get<RotorConstants>(columns_.rotor, row_, *lane.rotor);
      Rows::get(columns_.turn, row_, lane.step.turn->start);
    }
    if (taken_) feel(mean_from(taken_->push, 0), t_start_);
  }
  /// What generators give it at a time of the step, of what they give at its start and end.
  [[nodiscard]] Pushed<S> push_at(const Pushed<S> (&ends)[2], double passed) const {
    return ends[0] + (ends[1] - ends[0]) * static_cast<S>(passed / context_.dt);
  }
  /// Mean push from `passed` to the end of the step: a(T) + (a(passed) - a(T)) w, w = 1/z - 1/(e^z - 1) of what decays
  /// as exp(-r t), r = drag_rate, z = r (T - passed); w = 1/2 without drag. Strong drag takes the push at the end, as
  /// the implicit step in the air does, and so stays stable.
  [[nodiscard]] Pushed<S> mean_from(const Pushed<S> (&ends)[2], double passed) const {
    constexpr double kStraight = 1e-3;
    const double z = static_cast<double>(ends[0].drag_rate) * (context_.dt - passed);
    const double part = z > kStraight ? 1 / z - 1 / expm1(z) : 0.5;  // of that at `passed`
    return ends[1] + (push_at(ends, passed) - ends[1]) * static_cast<S>(part);
  }
  /// From now on the models feel that by generators.
  void feel(const Pushed<S>& push, S t) {
    march.lanes.body = *from_row_;
    add_push(*march.course().conditions, {felt_from_, t_end_}, t, push.a, taken_->own_force, march.lanes.body);
    march.lanes.drag_rate = push.drag_rate;
  }
  [[nodiscard]] static Pushed<S> narrow(const Pushed<double>& push) {
    return {vec_cast<S>(push.a), static_cast<S>(push.drag_rate)};
  }
  /// From now on they feel a push of generators, and what its emitter does to it at a time.
  void feel_drive(double passed, const State<S>& at, S t, const Pushed<S>& held) {
    driven_->felt = driven_->by.at(context_.time + passed, {vec_cast<double>(at.x), vec_cast<double>(at.v)});
    feel(held + narrow(driven_->felt), t);
  }
  /// Whether its emitter acts on it; and what generators alone gave it then.
  void find_drive() {
    const Drive drive(*context_.registry, *context_.state, slot_index_);
    if (!drive) return;
    PHYSIM_ASSERT(taken_);
    Driven& d = driven_.emplace(Driven{drive, {}, {}});
    if (taken_->pushed || !taken_->driven) d.held[0] = taken_->push[0], d.held[1] = taken_->push[1];
    if (!taken_->driven) return;
    d.by.begin_step(cohort_.key.fidelity.integrator, context_.time, context_.dt);
    d.felt = d.by.at(context_.time, start_);
    if (!taken_->pushed) return;
    const State<S>& end = taken_->step.end;
    const State<double> there{vec_cast<double>(end.x), vec_cast<double>(end.v)};
    d.held[0] = d.held[0] - narrow(d.felt);
    d.held[1] = d.held[1] - narrow(d.by.at(context_.time + context_.dt, there));
  }
  /// Closed forms know only their launch: after a bounce it is where they bounced, and their clock starts there.
  void relaunch(double passed) {
    if (cohort_.key.fidelity.motion != Motion::closed_form) return;
    march.lanes.body.launch = now();
    t_start_ = -static_cast<S>(passed);
    t_end_ = static_cast<S>(context_.dt - passed);
    relaunched_ = true;
  }
  /// Others see the way along the ground or a thing as steady, unless the velocities at its ends say that it was a
  /// parabola: what meets a row on a parabola needs the velocity of that moment, not that of the way.
  void trace_way_to(double passed, const State<double>& end) {
    if (!is_traced_ || chunk_.traces.empty() || !(passed > chunk_.traces.back().passed)) return;
    const Trace last = chunk_.traces.back();
    const double h = passed - last.passed;
    const Vec3d way = end.x - last.state.x, steady = (last.state.v + end.v) * (0.5 * h);
    constexpr double kSteady = 1e-3;                                                 // of the way
    if (length(steady - way) <= kSteady * length(way) + touch_at<S>(end.x)) return;  // it was put beside a surface
    trace(last.passed, {last.state.x, way * (1 / h)});
  }
  void fly_unseen(double from, double to) {
    march.lanes.step.t = t_start_ + static_cast<S>(from);
    const S h = static_cast<S>(to - from);
    march.restart(march.lanes.step.t + h, h);
    while (!march.arrived()) {
      if (driven_) take_driven_step(from, march.lanes.step.t + h, h);
      const bool accepted = driven_ || march.try_step();
      if (march.is_stuck()) return;  // asked behind a step: before the first one there is no length
      march.accept(accepted);
    }
  }
  static S& part(Vec3<S>& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

  const SettleContext& context_;
  Chunk& chunk_;
  const WorldCohort& cohort_;
  const Rows& rows_;
  const RowColumns<S>& columns_;
  std::uint32_t row_;
  std::uint32_t slot_index_;
  const TakenStep<S>* taken_;
  /// Where its emitter acts on its flight.
  struct Driven {
    Drive by;
    Pushed<S> held[2];    // by generators at the start and the end of the step
    Pushed<double> felt;  // what it feels of its emitter now
  };
  std::optional<Driven> driven_;
  bool is_traced_;  // it meets others
  struct Told {
    std::size_t events, changes, traces;
  };
  Told told_;                // by the chunk before it
  Unset<Body<S>> from_row_;  // where generators or stops change what is flown
  State<double> start_{};
  S t_start_ = 0;
  S t_end_ = 0;
  S felt_from_ = 0;              // from then on it feels what it does: since the start of the step, or a contact in it
  double length_ = context_.dt;  // of the step as far as it is flown [s]
  bool gone_ = false;
  bool relaunched_ = false;
  bool respun_ = false;
  std::optional<std::size_t> hop_;  // the event of its last apex since a contact, in this step
  std::optional<Vec3d> shown_;      // the spin that a contact gave to what only shows it [rad/s]

 public:
  March<S> march;
};

}  // namespace physim
