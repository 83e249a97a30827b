#include "world/settle.hpp"

#include <algorithm>

#include "model/contact.hpp"
#include "solve/judge.hpp"
#include "world/forced_rows.hpp"

namespace physim {
namespace {

/// Bounces in one step; then a projectile lies on the ground.
constexpr int kMostBounces = 16;

Vec3d normal_at(const Conditions<double>& c, const Vec3d& x) {
  return is_round(c.fidelity.earth) ? vertical_at(c, x) : Vec3d{0, 1, 0};
}

/// One row on its way through a step. S is the cohort's number type.
template <class S>
class Settling {
 public:
  Settling(const SettleContext& context, Chunk& chunk, std::uint32_t row)
      : context_(context),
        chunk_(chunk),
        cohort_(context.registry->cohort(chunk.cohort)),
        course_(cohort_.course<S>()),
        rows_(context.state->rows[chunk.cohort]),
        columns_(rows_.columns<S>()),
        row_(row),
        slot_index_(rows_.slot(row)),
        slot_(context.state->slots[slot_index_]),
        taken_(static_cast<const TakenStep<S>*>(context.taken)) {}

  void run() {
    read();
    if (!is_finite(lane_.step.start)) return leave(LifeStatus::retired, Reason::non_finite);
    if (taken_ && !is_finite(State<S>{taken_->push[0], {}})) return leave(LifeStatus::retired, Reason::non_finite);
    start_ = state_at_start();
    if (descends_into_ground()) {
      contact(start_, 0);
    } else if (taken_) {
      look_at_taken();
    } else {
      go(static_cast<S>(context_.dt), 0);
    }
    if (gone_) return;
    if (!is_finite(end_)) return leave(LifeStatus::retired, Reason::non_finite);  // a roll's end may overflow
    follow_rules();
    write();
  }

 private:
  void read() {
    lane_.body = {};
    S* number = numbers(lane_.body);
    for (const std::uint8_t field : rows_.layout().fields) number[field] = columns_.field[field][row_];
    for (int axis = 0; axis < 3; ++axis) {
      part(lane_.step.start.x, axis) = columns_.position[axis][row_];
      part(lane_.step.start.v, axis) = columns_.velocity[axis][row_];
      part(carried_, axis) = rows_.layout().carried ? columns_.carried[axis][row_] : S(0);
    }
    if (rows_.layout().clocked) {
      const S steps = static_cast<S>(context_.now) - columns_.born[row_];
      t_start_ = columns_.offset[row_] + steps * static_cast<S>(context_.dt);
      t_end_ = columns_.offset[row_] + (steps + S(1)) * static_cast<S>(context_.dt);
    } else {
      t_start_ = t_end_ = S(0);
    }
    from_row_ = lane_.body;
    if (rows_.layout().turning) {
      Rows::get<RotorConstants>(columns_.rotor, row_, *lane_.rotor);
      Rows::get(columns_.turn, row_, turn_);
    }
    if (taken_) feel(taken_->push[0], t_start_);
  }
  /// From now on the models feel this acceleration by generators.
  void feel(const Vec3<S>& push, S t) {
    lane_.body = from_row_;
    add_push(*course_.conditions, t, push, taken_->own_force, lane_.body);
  }
  static S& part(Vec3<S>& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

  [[nodiscard]] State<double> state_at_start() const {
    return {vec_cast<double>(lane_.step.start.x), vec_cast<double>(lane_.step.start.v)};
  }
  [[nodiscard]] const Conditions<double>& conditions() const { return cohort_.conditions; }
  [[nodiscard]] const Ground& ground() const { return context_.def->ground; }

  /// On the ground or below it, and not on its way up.
  [[nodiscard]] bool descends_into_ground() const {
    if (ground().mode == GroundMode::none || height(conditions(), start_.x) > ground().height) return false;
    const double climb = climb_rate(conditions(), start_);
    return climb < 0 || (climb == 0 && dot(acceleration_at(start_, 0), normal_at(conditions(), start_.x)) < 0);
  }

  [[nodiscard]] Vec3d acceleration_at(const State<double>& s, double after) const {
    Body<double> body;
    cast_numbers(lane_.body, body);
    const double t = static_cast<double>(t_start_) + after;
    if (!rows_.layout().turning) return acceleration(conditions(), body, t, s);
    Rotor<double> rotor;
    Turn<double> turn, slope;
    cast_numbers(*lane_.rotor, rotor);
    cast_numbers(turn_, turn);
    return evaluated(conditions(), body, rotor, t, s, turn, slope);
  }

  /// Flies on for a time h, `passed` into the step, as far as nothing stops it.
  void go(S h, double passed) {
    Step<S>& s = lane_.step;
    const bool whole = passed == 0;
    s.h = h;
    s.t = whole ? t_start_ : t_start_ + static_cast<S>(passed);
    s.t_end = whole ? (rows_.layout().clocked ? t_end_ : s.t + h) : s.t + h;
    const S frame_start = s.t;
    const Fidelity& f = cohort_.key.fidelity;
    const double clock = passed - static_cast<double>(frame_start);  // from a step's clock to time into the step
    const bool turning = rows_.layout().turning;
    if (turning) s.turn->start = turn_;
    if (stops_within()) return go_by_parts(clock);
    if (f.motion != Motion::closed_form && is_adaptive(f.integrator)) {
      bool stopped = false;
      const bool lost = divide_frame(course_, lane_.body, *lane_.rotor, true, s,
                                     [&](const Step<S>&, bool) { return stopped = look(clock); });
      if (!stopped && lost)
        leave(LifeStatus::retired, is_finite(s.error) ? Reason::stalled : Reason::non_finite);
      else if (!stopped)
        end_ = s.start;
      if (turning && !stopped) turn_ = s.turn->start;
      return;
    }
    first_slope(*course_.conditions, lane_.body, *lane_.rotor, carried_, s);
    take_step(*course_.conditions, lane_.body, *lane_.rotor, course_.plan.relative, course_.plan.absolute, s);
    if (look(clock)) return;
    end_ = s.end;
    if (turning) turn_ = s.turn->end;
    const bool classic = rows_.layout().carried;
    if (classic) carried_ = s.slope[1].v;
  }

  [[nodiscard]] bool stops_within() const {
    const Body<S>& b = lane_.body;
    return has_stops(*course_.conditions) && (b.burn.end <= lane_.step.t_end || b.rail_phase < S(kOffRail));
  }

  /// Steps end at stops of motor and rail: goes from one to the next, with the numbers of a flight.
  void go_by_parts(double clock) {
    const Conditions<S>& c = *course_.conditions;
    Step<S>& s = lane_.step;
    const S end = s.t_end;
    const bool counted = !steps_itself(c.fidelity);
    S left = s.h;
    lane_.control = {S(0), s.h};
    lane_.cut = S(0);
    pass_stops(c, s.t, true, s.start, lane_.body);
    changed_ = true;
    lane_.regime = regime(c, lane_.body, *lane_.rotor, s.t, s.start);
    set_slope(c, lane_.body, *lane_.rotor, 0, s);
    for (int tries = 0; s.t < end; ++tries) {
      if (tries == kMaxSubsteps) return leave(LifeStatus::retired, Reason::stalled);
      if (!counted) lane_.control.h = min(lane_.control.h, end - s.t);
      end_at_stop(end, left, counted, lane_);
      if (!counted && end - s.t <= s.h) s.t_end = min(end, lane_.body.burn.end);
      take_step(c, lane_.body, *lane_.rotor, course_.plan.relative, course_.plan.absolute, s);
      if (!control_step(course_, lane_)) {
        if (!is_finite(s.error) && !counted) return leave(LifeStatus::retired, Reason::non_finite);
        continue;
      }
      if (look(clock)) return;
      s.t = s.t_end;
      s.start = s.end;
      left = end - s.t;
      s.slope[0] = s.slope[last_slope(c.fidelity)];
      if (turns(c.fidelity)) {
        s.turn->start = turn_ = s.turn->end;
        s.turn->slope[0] = s.turn->slope[last_slope(c.fidelity)];
      }
      if (pass_stops(c, s.t, true, s.start, lane_.body)) {
        set_slope(c, lane_.body, *lane_.rotor, 0, s);
        note_rail(c, lane_);
      }
    }
    end_ = s.start;
  }

  /// The step was taken together with others; what is missing is the slope at its end.
  void look_at_taken() {
    Step<S>& s = lane_.step;
    const Integrator integrator = cohort_.key.fidelity.integrator;
    const S t_end = rows_.layout().clocked ? t_end_ : t_start_ + static_cast<S>(context_.dt);
    s = taken_->step;
    s.h = static_cast<S>(context_.dt);
    s.t = t_start_;
    s.t_end = t_end;
    if (integrator == Integrator::classic) {
      carried_ = s.slope[1].v;
    } else {
      feel(taken_->push[1], t_end);
      set_slope(*course_.conditions, lane_.body, *lane_.rotor, end_slope(integrator), s);
    }
    if (look(-static_cast<double>(t_start_))) return;
    end_ = s.end;
    if (rows_.layout().turning) turn_ = s.turn->end;
    if (!stops_within()) return;
    pass_stops(*course_.conditions, t_end, true, end_, lane_.body);
    changed_ = true;
  }

  /// Looks for events in the step just taken; true where one of them ends it.
  bool look(double clock) {
    if (!ends_finite(cohort_.key.fidelity, lane_.step)) return leave(LifeStatus::retired, Reason::non_finite), true;
    DenseLanes<S>& at = judgement_.at;
    dense_lanes(course_, lane_, at);
    // Its three more slopes would need the generators once more: the cubic through both ends does.
    if (taken_ && cohort_.key.fidelity.integrator == Integrator::dop853)
      std::fill(at.coefficient + 3, at.coefficient + 7, State<double>{});
    if (taken_ && rows_.layout().turning && cohort_.key.fidelity.integrator == Integrator::dop853)
      std::fill(at.turn->coefficient + 3, at.turn->coefficient + 7, Turn<double>{});
    find_crossings<S>(course_, true, judgement_);
    // Bouncing goes on from here with other steps, so what was found is kept.
    const CrossingList crossings = judgement_.crossings[0];
    for (int i = 0; i < crossings.count; ++i) {
      const double t = at.time(crossings.found[i].theta);
      const State<double> s = at.at_time(t);
      const double passed = t + clock;
      switch (course_.watch.item[crossings.found[i].index].outcome) {
        case Outcome::landed:
          if (rows_.layout().turning) cast_numbers(at.turn_at_time(t), turn_);
          if (taken_) {
            const S part = static_cast<S>(passed / context_.dt);
            feel(taken_->push[0] + (taken_->push[1] - taken_->push[0]) * part, t_start_ + static_cast<S>(passed));
          }
          contact(s, passed);
          return true;
        case Outcome::left_domain: leave(LifeStatus::retired, Reason::left_domain); return true;
        case Outcome::reached_range:
        case Outcome::event:
        case Outcome::time_limit:
        case Outcome::step_limit:
        case Outcome::non_finite:
        case Outcome::stalled:
        case Outcome::refused: tell(course_.watch.item[crossings.found[i].index].spec.kind, Reason::none, passed, s);
      }
    }
    return false;
  }

  /// Reached the ground, `passed` into the step.
  void contact(State<double> s, double passed) {
    const Conditions<double>& c = conditions();
    const Vec3d n = normal_at(c, s.x);
    if (passed > 0) s.x -= n * (height(c, s.x) - ground().height);
    if (ground().mode != GroundMode::bounce) {
      tell(EventKind::landed, Reason::none, passed, s);
      end_ = {vec_cast<S>(s.x), {}};
      if (ground().mode == GroundMode::land) return leave(LifeStatus::landed, Reason::none);
      chunk_.changes.push_back({slot_index_, Change::Kind::stick, LifeStatus::landed, Reason::none});
      return;
    }
    const BodyDef& body = context_.registry->kind(slot_.kind).body;
    const Surface surface{ground().restitution * body.restitution, ground().friction * body.friction,
                          body.rolling_resistance};
    const Vec3d v = bounced(s.v, n, surface);
    const Vec3d a = acceleration_at(s, passed);
    const double left = context_.dt - passed;
    // A bounce that would be over within this step does not lift it any more.
    if (dot(v, n) > -dot(a, n) * (0.5 * context_.dt) && bounces_++ < kMostBounces) {
      tell(EventKind::bounced, Reason::none, passed, {s.x, v});
      lane_.step.start = {vec_cast<S>(s.x), vec_cast<S>(v)};
      relaunch(lane_.step.start, passed);
      return go(static_cast<S>(left), passed);
    }
    if (dot(a, n) > 0) {  // something lifts it
      lane_.step.start = {vec_cast<S>(s.x), vec_cast<S>(v - n * dot(v, n))};
      relaunch(lane_.step.start, passed);
      return bounces_++ < kMostBounces ? go(static_cast<S>(left), passed) : void(end_ = lane_.step.start);
    }
    // What falls from higher than a step's fall struck the ground, even where nothing of its speed is left.
    if (dot(s.v, n) < dot(a, n) * context_.dt) tell(EventKind::bounced, Reason::none, passed, {s.x, v - n * dot(v, n)});
    const Rolled r = rolled(v, a, n, surface, left);
    Vec3d x = s.x + r.way;
    x -= normal_at(c, x) * (height(c, x) - ground().height);
    end_ = {vec_cast<S>(x), vec_cast<S>(r.velocity)};
    relaunch(end_, context_.dt);
  }

  /// Closed forms know only their launch: after a bounce it is where they bounced, and their clock starts there.
  void relaunch(const State<S>& from, double passed) {
    if (cohort_.key.fidelity.motion != Motion::closed_form) return;
    lane_.body.launch = from;
    t_start_ = -static_cast<S>(passed);
    t_end_ = static_cast<S>(context_.dt - passed);
    relaunched_ = true;
  }

  void follow_rules() {
    const CohortRules& rules = cohort_.key.rules;
    const DespawnRules& d = rules.despawn;
    const Vec3d x = vec_cast<double>(end_.x);
    const double speed = length(vec_cast<double>(end_.v));
    const auto outside = [](double at, double low, double high) { return at < low || at > high; };
    if (height(conditions(), x) < d.below) return expire(Reason::below);
    if (speed < d.slower && !waits_for_motor()) return expire(Reason::slower);
    if (rows_.layout().launched && length(x - Rows::at(columns_.launch, row_)) > d.farther)
      return expire(Reason::farther);
    if (d.outside_box && (outside(x.x, d.box_low.x, d.box_high.x) || outside(x.y, d.box_low.y, d.box_high.y) ||
                          outside(x.z, d.box_low.z, d.box_high.z)))
      return expire(Reason::outside_box);
    if (speed < rules.sleep_speed && !waits_for_motor()) rest(rules.sleep_time);
  }

  /// On its rail, or before burnout: it only looks as if it rested.
  [[nodiscard]] bool waits_for_motor() const {
    const Conditions<S>& c = *course_.conditions;
    const Body<S>& b = lane_.body;
    return (c.has_motor && std::isfinite(b.burn.end)) || (c.has_rail && b.rail_phase < S(kOffRail));
  }

  /// Counts the time at rest; enough of it, without a break, and it sleeps.
  void rest(double enough) {
    Rest& rest = context_.state->slots.rest(slot_index_);
    const auto step = static_cast<std::uint32_t>(context_.state->clock.steps);
    if (rest.step + 1 != step) rest.time = 0;
    rest.step = step;
    rest.time += static_cast<float>(context_.dt);
    if (static_cast<double>(rest.time) < enough) return;
    chunk_.changes.push_back({slot_index_, Change::Kind::sleep, LifeStatus::in_flight, Reason::none});
  }

  void expire(Reason reason) {
    const State<double> s{vec_cast<double>(end_.x), vec_cast<double>(end_.v)};
    tell(EventKind::expired, reason, context_.dt, s);
    chunk_.changes.push_back({slot_index_, Change::Kind::remove, LifeStatus::expired, reason});
  }

  /// Leaves the world; it keeps the last sound state that it had.
  void leave(LifeStatus status, Reason reason) {
    gone_ = true;
    if (status == LifeStatus::retired) tell(EventKind::retired, reason, 0, start_);
    chunk_.changes.push_back({slot_index_, Change::Kind::remove, status, reason});
  }

  void tell(EventKind kind, Reason reason, double passed, const State<double>& s) {
    chunk_.events.push_back({.kind = kind,
                             .reason = reason,
                             .id = {slot_index_, slot_.generation},
                             .time = context_.time + passed,
                             .position = s.x,
                             .velocity = s.v});
  }

  void write() {
    // The current position of this step is the previous one of the next: the columns change places afterwards.
    for (int axis = 0; axis < 3; ++axis) {
      columns_.previous[axis][row_] = part(end_.x, axis);
      columns_.velocity[axis][row_] = part(end_.v, axis);
      if (rows_.layout().carried) columns_.carried[axis][row_] = part(carried_, axis);
    }
    if (rows_.layout().turning) Rows::put(columns_.turn, row_, turn_);
    if (!relaunched_ && !changed_) return;
    if (taken_) {  // what generators gave is not its own
      lane_.body.applied = from_row_.applied;
      lane_.body.applied_until = from_row_.applied_until;
    }
    const S* number = numbers(lane_.body);
    for (const std::uint8_t field : rows_.layout().fields) columns_.field[field][row_] = number[field];
    if (!relaunched_) return;
    columns_.offset[row_] = t_end_;
    columns_.born[row_] = static_cast<S>(context_.now + 1);
  }

  const SettleContext& context_;
  Chunk& chunk_;
  const WorldCohort& cohort_;
  const Course<S>& course_;
  const Rows& rows_;
  const RowColumns<S>& columns_;
  std::uint32_t row_;
  std::uint32_t slot_index_;
  const Slot& slot_;
  const TakenStep<S>* taken_;
  Body<S> from_row_{};
  Lanes<S> lane_{};
  Judgement<S> judgement_{};
  Vec3<S> carried_{};
  Turn<S> turn_{};  // where it is now, of rungs that turn
  State<S> end_{};
  State<double> start_{};
  S t_start_ = 0;
  S t_end_ = 0;
  int bounces_ = 0;
  bool gone_ = false;
  bool relaunched_ = false;
  bool changed_ = false;  // another piece of its motor's table, another phase on the rail
};

}  // namespace

void settle_row(const SettleContext& context, Chunk& chunk, std::uint32_t row) {
  if (context.state->rows[chunk.cohort].layout().float32)
    Settling<float>(context, chunk, row).run();
  else
    Settling<double>(context, chunk, row).run();
}

}  // namespace physim
