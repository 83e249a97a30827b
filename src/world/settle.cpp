#include "world/settle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "flight/under_way.hpp"
#include "model/contact.hpp"
#include "world/look_around.hpp"
#include "world/settled_row.hpp"

namespace physim {
namespace {

/// Bounces in one part of a step; then a projectile lies on the ground.
constexpr int kMostBounces = 16;

Vec3d normal_at(const Conditions<double>& c, const Vec3d& x) {
  return is_round(c.fidelity.earth) ? vertical_at(c, x) : Vec3d{0, 1, 0};
}

/// One row on its way through a step.
template <class S>
class Settling {
 public:
  Settling(const SettleContext& context, Chunk& chunk, std::uint32_t row)
      : context_(context),
        chunk_(chunk),
        r_(context, chunk, row),
        course_(r_.march.course()),
        contacts_(r_),
        traced_(context.pairs && body().collision.others != 0) {}

  void run() {
    trace(0, r_.at_start());
    if (!is_finite(r_.now())) return r_.leave(LifeStatus::retired, Reason::non_finite);
    if (r_.taken() && !is_finite(State<S>{r_.taken()->push[0], {}}))
      return r_.leave(LifeStatus::retired, Reason::non_finite);
    if (descends_into_ground())
      contact(r_.at_start(), 0);
    else if (r_.taken())
      look_at_taken();
    else
      start_part(0), resume_ = 0.0;
    finish();
  }

  /// From a meeting with another one inside the step.
  void run_after(const Parting& parting) {
    go_to(parting);
    if (parting.spin) r_.put_spin(*parting.spin, parting.passed);
    put(parting.state.x, parting.state.v, parting.passed);
    if (parting.then != Parting::Then::flies_on) {
      stay(parting.state, parting.then == Parting::Then::sticks);
    } else {
      is_near_ = true;
      start_part(parting.passed), resume_ = parting.passed;
    }
    finish();
  }
  [[nodiscard]] Vec3d spin_at(const Parting& parting) {
    go_to(parting);
    return r_.spin(parting.passed);
  }

 private:
  /// The rest of the step.
  void finish() {
    fly_on();
    while (!r_.gone() && part_end_ < context_.dt) {
      const double from = part_end_;
      start_part(from), resume_ = from;
      fly_on();
    }
    if (r_.gone()) return;
    if (!is_finite(r_.now())) return r_.leave(LifeStatus::retired, Reason::non_finite);  // a roll's end may overflow
    follow_rules();
    r_.write();
    if (r_.meets()) r_.put_clear(clear());
  }

  /// So far it may fly from where it is now before it can touch anything [m].
  [[nodiscard]] S clear() const {
    if (!r_.scene() || r_.scene()->has_motion()) return S(0);
    return clear_way<S>(context_, vec_cast<double>(r_.now().x), vec_cast<double>(r_.now().v), r_.collision());
  }

  // ------------------------------------------------------------------------------------------- meeting others
  void trace(double passed, const State<double>& s) {
    if (!traced_) return;
    Trace& moment = chunk_.traces.emplace_back(Trace{r_.slot_index(), passed, s, r_.spin(passed), {}});
    if (r_.turning()) cast_numbers(r_.march.lanes.step.turn->start, moment.turn);
  }
  /// Somewhere along the ground or a thing: on the straight way there.
  void trace_way_to(double passed, const Vec3d& x) {
    if (!traced_ || chunk_.traces.empty() || !(passed > chunk_.traces.back().passed)) return;
    const Trace last = chunk_.traces.back();
    trace(last.passed, {last.state.x, (x - last.state.x) * (1 / (passed - last.passed))});
  }

  /// To the moment of a meeting. Of those that turn it needs how they do then; what others are like there follows from
  /// the meeting.
  void go_to(const Parting& parting) {
    double from = 0;
    if (const Trace* last = parting.from) {
      from = last->passed;
      if (r_.turning()) r_.put_turn(last->turn);
      r_.now() = {vec_cast<S>(last->state.x), vec_cast<S>(last->state.v)};
      r_.put_spin(last->spin, from);
    }
    if (const TakenStep<S>* taken = r_.taken()) feel_at(*taken, from);
    if (r_.turning() && parting.passed > from) fly_unseen(from, parting.passed);
    if (const TakenStep<S>* taken = r_.taken()) feel_at(*taken, parting.passed);
  }
  void fly_unseen(double from, double to) {
    March<S>& march = r_.march;
    march.lanes.step.t = r_.t_start() + static_cast<S>(from);
    const S h = static_cast<S>(to - from);
    march.restart(march.lanes.step.t + h, h);
    while (!march.arrived() && !march.is_stuck()) march.accept(march.try_step());
  }

  [[nodiscard]] const Conditions<double>& conditions() const { return r_.conditions(); }
  [[nodiscard]] const Ground& ground() const { return context_.def->ground; }
  [[nodiscard]] const BodyDef& body() const { return context_.registry->kind(r_.slot().kind).body; }

  /// On the ground or below it, and not on its way up.
  [[nodiscard]] bool descends_into_ground() const {
    const State<double>& s = r_.at_start();
    if (ground().mode == GroundMode::none || height(conditions(), s.x) > ground().height) return false;
    const double climb = climb_rate(conditions(), s);
    return climb < 0 || (climb == 0 && dot(r_.acceleration_at(s, 0), normal_at(conditions(), s.x)) < 0);
  }

  // ------------------------------------------------------------------------------------------- flying
  /// From a time into the step: how far the next part goes. Before the first contact most steps are one part.
  void start_part(double from) {
    bounces_ = 0;
    part_end_ = context_.dt;
    if (!is_near_ && !flies_in_parts(*context_.def, context_.dt)) return;
    part_end_ = end_of_part(from, context_.dt, kLongestPart);
    PHYSIM_ASSERT(part_end_ > from || from == context_.dt);
  }
  /// From where the last contact left it, to the end of the part.
  void fly_on() {
    while (resume_ && !r_.gone()) {
      const double from = *std::exchange(resume_, std::nullopt);
      go(static_cast<S>(part_end_ - from), from);
    }
  }

  /// Flies on for a time h, `passed` into the step, as far as nothing ends it.
  void go(S h, double passed) {
    March<S>& march = r_.march;
    Step<S>& s = march.lanes.step;
    const bool whole = passed == 0 && part_end_ == context_.dt;
    s.t = whole ? r_.t_start() : r_.t_start() + static_cast<S>(passed);
    const double clock = passed - static_cast<double>(s.t);  // from the march's clock to time into the step
    march.restart(whole && r_.is_clocked() ? r_.t_end() : s.t + h, h);
    while (!march.arrived()) {
      const bool accepted = march.try_step();
      if (!ends_well(accepted)) return;
      if (!accepted) continue;
      if (look(clock)) return;
      march.accept(true);
      trace_now(clock);
    }
  }

  /// Whether a step tried leaves it in the world.
  bool ends_well(bool accepted) {
    const March<S>& march = r_.march;
    const bool finite = is_finite(march.lanes.step.error) || !is_adaptive(r_.cohort().key.fidelity.integrator);
    if (march.is_stuck()) return r_.leave(LifeStatus::retired, finite ? Reason::stalled : Reason::non_finite), false;
    if (!accepted || ends_finite(r_.cohort().key.fidelity, march.lanes.step)) return true;
    return r_.leave(LifeStatus::retired, Reason::non_finite), false;
  }

  /// The step was taken together with others; what is missing is the slope at its end.
  void look_at_taken() {
    March<S>& march = r_.march;
    Step<S>& s = march.lanes.step;
    const Fidelity& f = r_.cohort().key.fidelity;
    s = r_.taken()->step;
    s.h = static_cast<S>(context_.dt);
    s.t = r_.t_start();
    s.t_end = r_.is_clocked() ? r_.t_end() : r_.t_start() + s.h;
    if (is_classic(f)) {
      s.slope[0].v = s.slope[1].v;  // what its next frame begins with
    } else {
      r_.feel(r_.taken()->push[1], s.t_end);
      set_slope(*course_.conditions, march.lanes, end_slope(f.integrator));
    }
    if (!ends_finite(f, s)) return r_.leave(LifeStatus::retired, Reason::non_finite);
    if (look(-static_cast<double>(s.t))) return;
    march.accept(true);
    trace(context_.dt, {vec_cast<double>(r_.now().x), vec_cast<double>(r_.now().v)});
  }
  void trace_now(double clock) {
    // The march's clock is rounded to the row's precision.
    const double passed = r_.march.arrived() ? part_end_ : static_cast<double>(r_.march.lanes.step.t) + clock;
    if (traced_) trace(std::min(passed, part_end_), {vec_cast<double>(r_.now().x), vec_cast<double>(r_.now().v)});
  }

  /// Looks for events in the step just taken; true where one of them ends it.
  bool look(double clock) {
    DenseLanes<S>& at = judgement_.at;
    dense_lanes(course_, r_.march.lanes, at);
    // The generators' part in the higher terms would take them once more: the cubic through both ends does.
    if (r_.taken()) drop_higher_terms(at);
    find_crossings<S>(course_, true, judgement_);
    const CrossingList& crossings = judgement_.crossings[0];
    const auto met = contacts_ ? meeting(crossings, clock) : std::nullopt;
    for (int i = 0; i < crossings.count; ++i) {
      if (met && met->theta < crossings.found[i].theta) break;
      const double t = at.time(crossings.found[i].theta);
      const State<double> s = at.at_time(t);
      const Watched& watched = course_.watch.item[crossings.found[i].index];
      // The march's clock is rounded to the row's precision, so a part may end behind the step.
      if (watched.outcome == Outcome::landed) return land(s, t, std::min(t + clock, part_end_)), true;
      if (watched.outcome == Outcome::left_domain) return r_.leave(LifeStatus::retired, Reason::left_domain), true;
      r_.tell(watched.spec.kind, Reason::none, t + clock, s);
    }
    if (met) strike(*met, clock);
    return met.has_value();
  }

  /// Came to the ground inside a step.
  void land(const State<double>& s, double t, double passed) {
    stop_at(t, passed);
    contact(s, passed);
  }
  /// What goes on from a time inside the step begins there.
  void stop_at(double t, double passed) {
    if (r_.turning()) r_.put_turn(judgement_.at.turn_at_time(t));
    if (const TakenStep<S>* taken = r_.taken()) feel_at(*taken, passed);
  }
  void feel_at(const TakenStep<S>& taken, double passed) {
    const S part = static_cast<S>(passed / context_.dt);
    r_.feel(taken.push[0] + (taken.push[1] - taken.push[0]) * part, r_.t_start() + static_cast<S>(passed));
  }

  // ------------------------------------------------------------------------------------------- on the ground
  /// Reached the ground, `passed` into the step.
  void contact(State<double> s, double passed) {
    const Conditions<double>& c = conditions();
    const Vec3d n = normal_at(c, s.x);
    if (passed > 0) s.x -= n * (height(c, s.x) - ground().height);
    trace(passed, s);
    if (ground().mode != GroundMode::bounce) {
      r_.tell(EventKind::landed, Reason::none, passed, s);
      return stay(s, ground().mode == GroundMode::stick);
    }
    if (!std::exchange(is_near_, true)) start_part(passed);
    const BodyDef& b = body();
    const Surface surface{ground().restitution * b.restitution, ground().friction * b.friction, b.rolling_resistance};
    const Vec3d v = bounced(s.v, n, surface);
    const Vec3d a = r_.acceleration_at(s, passed);
    // A bounce that would be over within this step does not lift it any more.
    const double frame = std::min(context_.dt, kLongestPart);
    if (dot(v, n) > -dot(a, n) * (0.5 * frame) && bounces_++ < kMostBounces) {
      r_.tell(EventKind::bounced, Reason::none, passed, {s.x, v});
      return go_on(s.x, v, passed);
    }
    if (dot(a, n) > 0) {  // something lifts it
      const bool flies = bounces_++ < kMostBounces;
      return flies ? go_on(s.x, v - n * dot(v, n), passed) : put_at_last(s.x, v - n * dot(v, n), passed);
    }
    // What falls from higher than a step's fall struck the ground, even where nothing of its speed is left.
    if (dot(s.v, n) < dot(a, n) * frame) r_.tell(EventKind::bounced, Reason::none, passed, {s.x, v - n * dot(v, n)});
    const Rolled rolled_on = rolled(v, a, n, surface, context_.dt - passed);
    Vec3d x = s.x + rolled_on.way;
    x -= normal_at(c, x) * (height(c, x) - ground().height);
    roll({s.x, v - n * dot(v, n)}, {x, rolled_on.velocity}, passed);
  }

  /// Straight over the ground to the end of the step, or to what it meets there.
  void roll(const State<double>& from, const State<double>& to, double passed) {
    const double left = context_.dt - passed;
    const auto path = [&](double theta) {
      return State<double>{from.x + (to.x - from.x) * theta, from.v + (to.v - from.v) * theta};
    };
    const auto met = contacts_ ? contacts_.meeting(path, 1, passed, left) : std::nullopt;
    if (!met) return put_at_last(to.x, to.v, context_.dt);
    State<double> s = path(met->theta);
    s.x = met->hit.position;
    const double at = std::min(passed + met->theta * left, context_.dt);
    put(s.x, s.v, at);
    follow_contact(s, met->hit, at);
  }
  /// At the ground's height or below it, and not on its way up.
  [[nodiscard]] bool is_on_ground(const State<double>& s) const {
    return ground().mode == GroundMode::bounce && height(conditions(), s.x) <= ground().height &&
           climb_rate(conditions(), s) <= 0;
  }
  /// Where it lies: what slid along a thing down to the ground lies on that.
  void lie(State<double> s, double passed) {
    if (is_on_ground(s)) {
      const Vec3d n = normal_at(conditions(), s.x);
      s.x -= n * (height(conditions(), s.x) - ground().height);
      s.v -= n * dot(s.v, n);
    }
    put_at_last(s.x, s.v, passed);
  }

  void put(const Vec3d& x, const Vec3d& v, double passed) {
    trace_way_to(passed, x);
    r_.now() = {vec_cast<S>(x), vec_cast<S>(v)};
    r_.relaunch(passed);
    trace(passed, {vec_cast<double>(r_.now().x), vec_cast<double>(r_.now().v)});
  }
  /// Nothing more happens in this step.
  void put_at_last(const Vec3d& x, const Vec3d& v, double passed) {
    put(x, v, passed);
    part_end_ = context_.dt;
    trace_way_to(part_end_, x);
    trace(part_end_, {vec_cast<double>(r_.now().x), vec_cast<double>(r_.now().v)});
  }
  void go_on(const Vec3d& x, const Vec3d& v, double passed) {
    put(x, v, passed);
    resume_ = passed;
  }

  /// Ends where it struck: it leaves the world, or stays there.
  void stay(const State<double>& s, bool sticks) {
    part_end_ = context_.dt;
    r_.now() = {vec_cast<S>(s.x), {}};
    if (!sticks) return r_.leave(LifeStatus::landed, Reason::none);
    r_.change(Change::Kind::stick, LifeStatus::landed, Reason::none);
  }

  // ------------------------------------------------------------------------------------------- things of the scene
  /// Where the step at hand meets something, before what ends it.
  [[nodiscard]] std::optional<collide::PathHit> meeting(const CrossingList& crossings, double clock) {
    const DenseLanes<S>& at = judgement_.at;
    double end = 1;
    if (crossings.count > 0) {
      const Found& last = crossings.found[crossings.count - 1];
      if (course_.watch.item[last.index].spec.terminal) end = last.theta;
    }
    // The end of one step is the start of the next one, to the bit.
    const auto path = [&](double theta) { return theta == 0 ? at.n0.y : theta == 1 ? at.n1.y : at(theta); };
    return contacts_.meeting(path, end, at.n0.t + clock, at.n1.t - at.n0.t);
  }

  /// Met something inside a step.
  void strike(const collide::PathHit& met, double clock) {
    const double t = judgement_.at.time(met.theta);
    const double passed = std::min(t + clock, part_end_);
    State<double> s = judgement_.at.at_time(t);
    s.x = met.hit.position;
    trace(passed, s);
    put(s.x, s.v, passed);
    stop_at(t, passed);
    follow_contact(s, met.hit, passed);
  }
  void follow_contact(const State<double>& s, const SceneHit& hit, double passed) {
    if (!std::exchange(is_near_, true)) start_part(passed);
    const auto after = contacts_.struck(s, hit, passed);
    using Then = typename SceneContacts<SettledRow<S>>::Then;
    switch (after.then) {
      case Then::stops: return stay(after.state, false);
      case Then::sticks: return stay(after.state, true);
      case Then::lies: return lie(after.state, after.passed);
      case Then::flies_on: break;
    }
    if (after.passed >= part_end_) start_part(after.passed);
    if (after.passed < context_.dt && is_on_ground(after.state)) {
      const bool goes_on = bounces_++ < kMostBounces;
      return goes_on ? contact(after.state, after.passed) : lie(after.state, context_.dt);
    }
    if (after.passed < context_.dt) return go_on(after.state.x, after.state.v, after.passed);
    put_at_last(after.state.x, after.state.v, context_.dt);
  }

  // ------------------------------------------------------------------------------------------- rules
  void follow_rules() {
    const CohortRules& rules = r_.cohort().key.rules;
    const DespawnRules& d = rules.despawn;
    const Vec3d x = vec_cast<double>(r_.now().x);
    const double speed = length(vec_cast<double>(r_.now().v));
    const auto outside = [](double at, double low, double high) { return at < low || at > high; };
    if (height(conditions(), x) < d.below) return expire(Reason::below);
    if (speed < d.slower && !waits_for_motor()) return expire(Reason::slower);
    if (r_.has_launch_place() && length(x - r_.launch_place()) > d.farther) return expire(Reason::farther);
    if (d.outside_box && (outside(x.x, d.box_low.x, d.box_high.x) || outside(x.y, d.box_low.y, d.box_high.y) ||
                          outside(x.z, d.box_low.z, d.box_high.z)))
      return expire(Reason::outside_box);
    if (speed < rules.sleep_speed && !waits_for_motor() && !contacts_.is_carried()) rest(rules.sleep_time);
  }

  /// On its rail, or before burnout: it only looks as if it rested.
  [[nodiscard]] bool waits_for_motor() const {
    const Conditions<S>& c = *course_.conditions;
    const Body<S>& b = r_.march.lanes.body;
    return (c.has_motor && std::isfinite(b.burn.end)) || (c.has_rail && b.rail_phase < S(kOffRail));
  }

  /// Counts the time at rest; enough of it, without a break, and it sleeps.
  void rest(double enough) {
    Rest& rest = context_.state->slots.rest(r_.slot_index());
    const auto step = static_cast<std::uint32_t>(context_.state->clock.steps);
    if (rest.step + 1 != step) rest.time = 0;
    rest.step = step;
    rest.time += static_cast<float>(context_.dt);
    if (static_cast<double>(rest.time) < enough) return;
    r_.change(Change::Kind::sleep, LifeStatus::in_flight, Reason::none);
  }

  void expire(Reason reason) {
    r_.tell(EventKind::expired, reason, context_.dt, {vec_cast<double>(r_.now().x), vec_cast<double>(r_.now().v)});
    r_.change(Change::Kind::remove, LifeStatus::expired, reason);
  }

  const SettleContext& context_;
  Chunk& chunk_;
  SettledRow<S> r_;
  const Course<S>& course_;
  SceneContacts<SettledRow<S>> contacts_;
  bool traced_;  // it meets others
  Judgement<S> judgement_{};
  std::optional<double> resume_;   // it flies on from there [s]
  double part_end_ = context_.dt;  // time into the step [s]
  bool is_near_ = false;
  int bounces_ = 0;
};

}  // namespace

bool is_in_its_cohort(const SettleContext& context, std::uint16_t cohort, std::uint32_t row) {
  const Slot& slot = context.state->slots[context.state->rows[cohort].slot(row)];
  const Prepared& rung = context.registry->kind(slot.kind).rungs[slot.rung];
  const std::uint16_t known = rung.cohort[slot.variant().index()];  // none where its environment was set anew
  return slot.is(kAlive) && !slot.is(kStill) && slot.cohort == cohort && slot.row == row &&
         (known == cohort || known == kNoCohort);
}

namespace {

template <class F>
auto settling(const SettleContext& context, Chunk& chunk, std::uint32_t row, const F& f) {
  PHYSIM_ASSERT(chunk.cohort < context.state->rows.size() && context.dt > 0);
  PHYSIM_ASSERT(is_in_its_cohort(context, chunk.cohort, row));
  if (context.state->rows[chunk.cohort].layout().float32) {
    Settling<float> settling(context, chunk, row);
    return f(settling);
  }
  Settling<double> settling(context, chunk, row);
  return f(settling);
}

}  // namespace

void settle_row(const SettleContext& context, Chunk& chunk, std::uint32_t row) {
  settling(context, chunk, row, [](auto& settling) { settling.run(); });
}

void settle_after(const SettleContext& context, Chunk& chunk, std::uint32_t row, const Parting& parting) {
  settling(context, chunk, row, [&](auto& settling) { settling.run_after(parting); });
}

Vec3d spin_at(const SettleContext& context, Chunk& chunk, std::uint32_t row, const Parting& parting) {
  return settling(context, chunk, row, [&](auto& settling) { return settling.spin_at(parting); });
}

}  // namespace physim
