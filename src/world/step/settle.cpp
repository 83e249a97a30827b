#include "world/step/settle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "world/core/placement.hpp"
#include "world/step/ground_contact.hpp"
#include "world/step/height_crossings.hpp"
#include "world/step/look_around.hpp"
#include "world/step/row_rules.hpp"
#include "world/step/settled_row.hpp"

namespace physim {
namespace {

/// One row on its way through a step: it flies from contact to contact, and the ground or the scene says what follows.
template <class S>
class Settling {
 public:
  Settling(const SettleContext& context, SettledRow<S>& row, RowsAhead* waiting = nullptr)
      : context_(context),
        r_(row),
        waiting_(waiting),
        course_(row.march.course()),
        parts_(row.step_length(), flies_in_parts(*context.def, context.dt)),
        ground_(row, context.def->ground, parts_),
        scene_(row) {}

  void run() {
    r_.trace(0, r_.at_start());
    if (!r_.is_sound()) return r_.retire(Reason::non_finite);
    if (ground_.is_met_at_start(r_.at_start()))
      touch_ground(r_.at_start(), 0);
    else if (!stays(0) && r_.is_stepped())
      look_at_taken();
    finish();
    if (!is_always_looked_at()) r_.forget_traces();
  }

  /// By itself, from the start or from its birth inside of the step.
  void run_alone(std::optional<double> born) {
    run_part(born);
    follow_rules();
  }
  /// As far as the row's part of the step goes.
  void run_part(std::optional<double> born) {
    if (born) r_.begin_at(*born);
    fly_from(born.value_or(0));
  }

  /// From a meeting with another one inside the step.
  void run_after(const Parting& parting) {
    r_.go_to(parting);
    if (parting.spin) r_.put_spin(*parting.spin, parting.passed);
    put(parting.state, parting.passed);
    if (parting.then == Parting::Then::lies) {
      go_with_others(parting);
    } else if (parting.then != Parting::Then::flies_on) {
      stay(parting.state, parting.then == Parting::Then::sticks);
    } else {
      parts_.come_near(parting.passed);
      parts_.go_on(parting.passed);
    }
    finish();
  }

 private:
  /// Whether any step like this one is. Which rows that only fly are looked at follows from what they found out about
  /// things before, and others that they may meet know nothing of that: their path is that of one that was not.
  [[nodiscard]] bool is_always_looked_at() const {
    return touched_ || grounded_ || r_.gone() || r_.has_passed_stops() || flies_in_parts(*context_.def, context_.dt);
  }
  /// The rest of the step.
  void finish() {
    fly();
    follow_rules();
  }
  /// A step, or what is flown of it, that is all its own.
  void fly_from(double passed) {
    if (!r_.is_sound()) return r_.retire(Reason::non_finite);
    parts_.start_at(passed);
    if (ground_.is_met_at_start(r_.at_start())) {
      parts_.begin(passed);
      touch_ground(r_.at_start(), passed);
    }
    fly();
  }
  void fly() {
    while (const auto from = r_.gone() ? std::nullopt : parts_.next())
      if (!stays(*from)) go(*from);
    if (!r_.gone() && !is_finite(r_.now())) r_.retire(Reason::non_finite);  // a roll's end may overflow
  }
  void follow_rules() {
    if (r_.gone()) return;
    tell_stays();
    RowRules<S>(context_, r_).follow(scene_.is_carried() || ground_.is_carried() || lies_on_others_);
    r_.write();
    if (r_.meets()) look_around();
  }
  /// Reports `stayed` for each sensor that contains the projectile at the start and at the end of the step, except one
  /// that it left at the end: rounding may put its last place inside that sensor again.
  void tell_stays() {
    const Scene* scene = r_.scene();
    if (scene == nullptr || !scene->tells_stay()) return;
    const double start = r_.scene_time(), end = start + r_.step_length();
    for (const SceneHit& in : sensors_around(*scene, r_.collision().layers, r_.at_start().x, start, r_.here().x, end))
      if (!r_.has_left(in.instance)) r_.tell(EventKind::stayed, Reason::none, r_.step_length(), r_.here(), in);
  }
  /// What is clear about where it is now.
  void look_around() {
    const double gone = context_.dt * length(r_.here().v);
    S& clear = r_.clear();
    if (touched_)
      clear = waited(S(0), r_.row(), gone);  // it is near what it touched
    else
      clear =
          is_look_due(clear, gone) ? clear_way<S>(context_, r_.here(), r_.collision()) : waited(clear, r_.row(), gone);
    // It is far from everything, or nobody can tell.
    if (!(clear < 0) || !knows_rest(context_)) return;
    const Vec3d acceleration = r_.acceleration_at(r_.here(), r_.step_length());
    const double beside = beside_chord(context_.dt, acceleration);
    const TubeAhead ahead = way_ahead<S>(context_, r_.here(), acceleration, beside, r_.collision());
    if (ahead.room > 0) return look_ahead(ahead);
    r_.put_tube({});
  }
  /// With others, or now.
  void look_ahead(const TubeAhead& ahead) {
    if (waiting_) return waiting_->add(r_.row(), ahead);
    TubeAhead looked = ahead;
    looked.query.part = SceneByMotion(*context_.scene).clear_part(ahead.query.segment, {.layers = ahead.query.layers});
    r_.put_tube(tube_along<S>(looked));
  }

  // ------------------------------------------------------------------------------------------- flying
  /// Flies on to the end of the part at hand, as far as nothing ends it before.
  void go(double passed) {
    March<S>& march = r_.march;
    Step<S>& s = march.lanes.step;
    const S h = static_cast<S>(parts_.end() - passed);
    const bool whole = passed == 0 && parts_.end() == context_.dt;
    s.t = whole ? r_.t_start() : r_.t_start() + static_cast<S>(passed);
    const double clock = passed - static_cast<double>(s.t);  // from the march's clock to time into the step
    const S limit = whole && r_.is_clocked() ? r_.t_end() : s.t + h;
    march.restart(limit, h);
    if (steps_of_) march.restagger(*std::exchange(steps_of_, h), h);
    while (!march.arrived()) {
      r_.count_step();
      const bool accepted = r_.is_driven() || march.try_step();
      if (r_.is_driven()) r_.take_driven_step(passed, limit, h);
      if (!r_.outlives(accepted)) return;
      if (!accepted) continue;
      if (look(clock)) return;
      move_on();
      // The march's clock is rounded to the row's precision.
      const double now = march.arrived() ? parts_.end() : static_cast<double>(s.t) + clock;
      r_.trace_moving(std::min(now, parts_.end()));
    }
    // The next step is one of the length of all.
    if (steps_of_ && parts_.is_last()) march.restagger(h, static_cast<S>(plain_step(*context_.def, context_.dt)));
  }
  /// Accepts the step just taken. Others see with which velocities it moved.
  void move_on() {
    r_.tell_last_trace_moves();
    r_.march.accept(true);
  }

  /// The step was taken together with others, whole.
  void look_at_taken() {
    parts_.make_last();
    r_.put_taken();
    if (!r_.ends_finite()) return r_.retire(Reason::non_finite);
    if (look(-static_cast<double>(r_.march.lanes.step.t))) return;
    move_on();
    r_.trace_moving(context_.dt);
  }

  /// Looks for events in the step just taken; true where one of them ends it.
  bool look(double clock) {
    if (!scene_ && (course_.watch.count == 0 || !may_cross(course_, r_.march.lanes))) return false;
    DenseLanes<S>& at = judgement_->at;
    dense_lanes(course_, r_.march.lanes, at);
    // The generators' part in the higher terms would take them once more: the cubic through both ends does.
    if (r_.taken()) drop_higher_terms(at);
    find_row_crossings(course_, *judgement_);
    const CrossingList& crossings = judgement_->crossings[0];
    const auto as_flown = [](const State<double>& s, double) { return s; };
    const auto met = scene_ ? scene_.meeting(course_, *judgement_, clock, as_flown) : std::nullopt;
    for (int i = 0; i < crossings.count; ++i) {
      if (met && met->theta < crossings.found[i].theta) break;
      const double t = at.time(crossings.found[i].theta);
      const State<double> s = at.at_time(t);
      const Watched& watched = course_.watch.item[crossings.found[i].index];
      if (watched.outcome == Outcome::landed) return land(at.moving_at_time(t, ground_.up_at(s.x)), t, clock), true;
      if (watched.outcome == Outcome::left_domain) return r_.retire(Reason::left_domain), true;
      if (watched.spec.kind == EventKind::apex)
        r_.tell_apex(t + clock, s);
      else
        r_.tell(watched.spec.kind, Reason::none, t + clock, s);
    }
    if (met) strike(*met, clock);
    return met.has_value();
  }
  /// The march's clock is rounded to the row's precision, so a part may end behind the step.
  [[nodiscard]] double passed_at(double t, double clock) const { return std::min(t + clock, parts_.end()); }

  // ------------------------------------------------------------------------------------------- contacts
  /// Came to the ground inside a step.
  void land(const State<double>& s, double t, double clock) {
    const double passed = passed_at(t, clock);
    trace_way(s.x, t, passed);
    stop_at(t, passed);
    touch_ground(s, passed);
  }
  /// Met a thing of the scene inside a step.
  void strike(const collide::PathHit& met, double clock) {
    const double t = judgement_->at.time(met.theta);
    const double passed = passed_at(t, clock);
    PHYSIM_ASSERT(met.theta >= 0 && met.theta <= 1);
    const Vec3d v = judgement_->at.moving_at_time(t, met.hit.normal, met.hit.velocity).v;
    const State<double> s{met.hit.position, v};
    trace_way(s.x, t, passed);
    r_.trace(passed, s);
    put(s, passed);
    stop_at(t, passed);
    touch_thing(s, met.hit, passed);
  }
  /// For others: the way up to a contact, which ends with its own velocity.
  void trace_way(const Vec3d& x, double t, double passed) {
    r_.tell_last_trace_moves();
    if (r_.is_traced()) r_.trace(passed, {x, judgement_->at.velocity_of_way(t)});
  }
  /// What goes on from a time inside the step begins there.
  void stop_at(double t, double passed) {
    if (r_.turning()) r_.put_turn(judgement_->at.turn_at_time(t));
    r_.feel_as_at(passed);
  }

  void touch_ground(State<double> s, double passed) {
    grounded_ = true;
    const Vec3d up = ground_.up_at(s.x);
    if (passed > 0) s.x = ground_.put_on(s.x);
    r_.trace(passed, s);
    const auto after = ground_.struck(s, up, passed);
    using Then = typename GroundContacts<SettledRow<S>>::Then;
    switch (after.then) {
      case Then::stops:
      case Then::sticks: return stay(after.state, after.then == Then::sticks);
      case Then::flies_on: return go_on(after.state, passed);
      case Then::lies: return lie(after.state, passed);
      case Then::rolls: return roll(after.state, after.rolled, passed);
    }
  }
  /// Straight over the ground to the end of the step, or to what it meets there.
  void roll(const State<double>& from, const State<double>& to, double passed) {
    if (!meets_on(from, to, passed, r_.step_length() - passed)) lie(to, r_.step_length());
  }
  /// On others that it lies on, as straight, or down to the ground.
  void go_with_others(const Parting& parting) {
    lies_on_others_ = true;
    const auto& [x, v] = parting.state;
    const double left = r_.step_length() - parting.passed;
    const State<double> end{x + v * left + parting.pull * (0.5 * left * left), v + parting.pull * left};
    const double above = r_.ground_below(x).height, below = r_.ground_below(end.x).height;
    if (!(above > 0 && below < 0)) return roll(parting.state, end, parting.passed);
    const EvenWay::Moment down = EvenWay(parting.state, end, left).after_way(above / (above - below));
    if (!meets_on(parting.state, down.state, parting.passed, down.time))
      touch_ground(down.state, parting.passed + down.time);
  }
  /// Whether a straight way that takes some time meets something; the row goes on from there then.
  [[nodiscard]] bool meets_on(const State<double>& from, const State<double>& to, double passed, double time) {
    const auto met = scene_ ? scene_.meeting_on(from, to, passed, time) : std::nullopt;
    if (!met) return false;
    scene_.note_touched(from, passed);
    const State<double> s{met->hit.position, met->at.state.v};
    const double at = std::min(passed + met->at.time, r_.step_length());
    put(s, at);
    touch_thing(s, met->hit, at);
    return true;
  }

  /// True if the projectile lies on a thing; it moves along the thing then.
  bool stays(double passed) {
    const auto on = scene_ ? scene_.lies_on(r_.here(), passed) : std::nullopt;
    if (!on) return false;
    r_.count_step();
    touched_ = true;
    parts_.come_near(passed);
    leave_thing(scene_.goes_along(r_.here(), *on, passed));
    return true;
  }
  void touch_thing(const State<double>& s, const SceneHit& hit, double passed) {
    touched_ = true;
    parts_.come_near(passed);
    leave_thing(scene_.struck(s, hit, passed));
  }
  void leave_thing(const SceneContacts::After& after) {
    using Then = SceneContacts::Then;
    switch (after.then) {
      case Then::stops:
      case Then::sticks: return stay(after.state, after.then == Then::sticks);
      case Then::lies: return lie(ground_.lying(after.state), after.passed);
      case Then::asks: return;  // the row is left as it was
      case Then::lands:
      case Then::flies_on: break;
    }
    parts_.come_to(after.passed);
    if (!(after.passed < r_.step_length())) return lie(after.state, r_.step_length());
    if (after.then != Then::lands && !ground_.is_met_too(after.state)) return go_on(after.state, after.passed);
    if (!parts_.may_bounce()) return lie(ground_.lying(after.state), r_.step_length());
    touch_ground(after.state, after.passed);
  }

  // ------------------------------------------------------------------------------------------- what follows
  void go_on(const State<double>& s, double passed) {
    r_.end_hop();
    put(s, passed);
    parts_.go_on(passed);
  }
  /// A contact leaves the velocity of the motion itself.
  void put(const State<double>& s, double passed) {
    r_.put(s, passed);
    steps_of_ = S(0);
  }
  /// Nothing more happens in this step.
  void lie(const State<double>& s, double passed) {
    r_.put_at_last(s, passed);
    parts_.make_last();
  }
  /// Ends where it struck: it leaves the world, or stays there.
  void stay(const State<double>& s, bool sticks) {
    parts_.make_last();
    r_.now() = {vec_cast<S>(s.x), {}};
    if (!sticks) return r_.leave(LifeStatus::landed, Reason::none);
    r_.change(Change::Kind::stick, LifeStatus::landed, Reason::none);
  }

  const SettleContext& context_;
  SettledRow<S>& r_;
  RowsAhead* waiting_;           // who look ahead together; null: it looks at once
  bool touched_ = false;         // a thing, in this step
  bool grounded_ = false;        // it touched the ground in this step
  bool lies_on_others_ = false;  // which may leave: it does not sleep
  std::optional<S> steps_of_;  // since a contact: of steps of which length its velocity is, see March::restagger() [s]
  const Course<S>& course_;
  StepParts parts_;
  GroundContacts<SettledRow<S>> ground_;
  SceneContacts scene_;
  Unset<Judgement<S>> judgement_;  // of the last step that was looked at
};

/// f of the row, taken out of its columns.
template <class F>
auto with_settled(const SettleContext& context, Chunk& chunk, std::uint32_t row, const F& f) {
  PHYSIM_ASSERT(chunk.cohort < context.state->rows.size() && context.dt > 0);
  PHYSIM_ASSERT(is_in_place(*context.registry, *context.state, chunk.cohort, row));
  if (context.state->rows[chunk.cohort].layout().float32) {
    SettledRow<float> settled(context, chunk, row);
    return f(settled);
  }
  SettledRow<double> settled(context, chunk, row);
  return f(settled);
}

/// Whether a hit was left open, about which something is known now.
bool answers_open(const SettleContext& context, Chunk& chunk) {
  if (chunk.open.empty()) return false;
  PHYSIM_ASSERT(chunk.open.size() == 1);
  const HitQuestion question = chunk.open.front().question;
  chunk.open.clear();
  context.asking->ask({&question, 1});
  return true;
}

}  // namespace

void settle_row(const SettleContext& context, Chunk& chunk, std::uint32_t row) {
  with_settled(context, chunk, row, [&]<class S>(SettledRow<S>& r) { Settling<S>(context, r).run(); });
}

void settle_row(const SettleContext& context, Chunk& chunk, std::uint32_t row, RowsAhead& waiting) {
  if (waiting.is_full()) put_tubes(context, chunk, waiting);
  with_settled(context, chunk, row, [&]<class S>(SettledRow<S>& r) { Settling<S>(context, r, &waiting).run(); });
}

void settle_after(const SettleContext& context, Chunk& chunk, std::uint32_t row, const Parting& parting) {
  do {
    with_settled(context, chunk, row, [&]<class S>(SettledRow<S>& r) { Settling<S>(context, r).run_after(parting); });
  } while (answers_open(context, chunk));
}

void settle_alone(const SettleContext& context, Chunk& chunk, std::uint32_t row, std::optional<double> born) {
  do {
    with_settled(context, chunk, row, [&]<class S>(SettledRow<S>& r) { Settling<S>(context, r).run_alone(born); });
  } while (answers_open(context, chunk));
}

std::optional<State<double>> state_inside(const SettleContext& context, Chunk& chunk, std::uint32_t row,
                                          std::optional<double> born, double until) {
  std::optional<State<double>> there;
  do {
    with_settled(context, chunk, row, [&]<class S>(SettledRow<S>& r) {
      r.end_at(until);
      Settling<S>(context, r).run_part(born);
      there = r.gone() ? std::nullopt : std::optional(r.here());
    });
  } while (answers_open(context, chunk));
  return there;
}

Vec3d spin_at(const SettleContext& context, Chunk& chunk, std::uint32_t row, const Parting& parting) {
  return with_settled(context, chunk, row, [&](auto& r) {
    r.go_to(parting);
    return r.spin(parting.passed);
  });
}

}  // namespace physim
