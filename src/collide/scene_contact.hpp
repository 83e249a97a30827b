// Contact of what flies with things of a scene: what it is and their materials let follow.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "collide/carried.hpp"
#include "collide/contact_host.hpp"
#include "collide/contact_rules.hpp"
#include "collide/contact_view.hpp"
#include "collide/contact_within.hpp"
#include "collide/path_cast.hpp"
#include "collide/scene_by_motion.hpp"
#include "collide/way_through.hpp"
#include "model/ball_between.hpp"
#include "model/ball_rolling.hpp"
#include "model/body.hpp"
#include "physim/event.hpp"
#include "physim/scene.hpp"
#include "solve/judge.hpp"

namespace physim {

/// The contacts of one step.
class SceneContacts : private ContactView {
 public:
  explicit SceneContacts(ContactHost& host)
      : ContactView(host),
        solids_{.layers = scene_ ? collision().layers : 0, .sensors = false, .from_front = true},
        casts_(scene_, solids_) {}
  explicit operator bool() const { return scene_ != nullptr; }

  /// What a contact leads to; it lands where a thing brings it down to the ground.
  enum class Then { flies_on, lies, lands, sticks, stops, asks };
  struct After {
    Then then;
    State<double> state;
    double passed;  // into the step [s]
  };

  /// Where a step of a march first meets something, before what is watched ends it. `clock`: from the march's time to
  /// that of the step that contacts know [s]; `seen(state, time)`: where a state is for the scene.
  template <class S, class Seen>
  [[nodiscard]] std::optional<collide::PathHit> meeting(const Course<S>& course, const Judgement<S>& judged,
                                                        double clock, const Seen& seen) {
    const DenseLanes<S>& at = judged.at;
    const CrossingList& crossings = judged.crossings[0];
    double end = 1;
    if (crossings.count > 0) {
      const Found& last = crossings.found[crossings.count - 1];
      if (course.watch.item[last.index].spec.terminal) end = last.theta;
    }
    // The end of one step is the start of the next one, to the bit.
    const auto path = [&](double theta) {
      return seen(theta == 0 ? at.n0.y : theta == 1 ? at.n1.y : at(theta), at.time(theta));
    };
    return meeting(path, end, at.n0.t + clock, at.n1.t - at.n0.t, rounding_of(course, at));
  }
  /// Where a path first meets something, up to `end`; what it passes on the way is told. `path(theta)` gives states,
  /// `start` and `span` when they are, by the step's time [s].
  template <class Path>
  [[nodiscard]] std::optional<collide::PathHit> meeting(const Path& path, double end, double start, double span,
                                                        double rounding = 0) {
    const auto place = [&](double theta) { return path(theta).x; };
    const collide::PathTime time{r_.scene_time() + start, span};
    std::optional<collide::PathHit> met;
    if (collision().on_hit != OnHit::pass)
      met = collide::first_meeting(casts_, collision().radius, place, time, end, rounding);
    tell_passages(path, met ? met->theta : end, start, span);
    return met;
  }

  /// How far places within a step may be off: its ends are rounded to the flight's own numbers, the way between them is
  /// not; but closed forms give all of them in their own numbers, from the launch on [m].
  template <class S>
  [[nodiscard]] static double rounding_of(const Course<S>& course, const DenseLanes<S>& at) {
    const double places = 2 * std::max(spacing_at<S>(at.n0.y.x), spacing_at<S>(at.n1.y.x));
    if (course.conditions->fidelity.motion != Motion::closed_form) return places;
    const double times = std::abs(at.n1.t) * static_cast<double>(std::numeric_limits<S>::epsilon());
    return places + std::max(length(at.n0.y.v), length(at.n1.y.v)) * times;
  }

  /// Where a straight way that begins `passed` into the step first meets something; what it passes is told.
  struct OnWay {
    SceneHit hit;
    EvenWay::Moment at;
  };
  [[nodiscard]] std::optional<OnWay> meeting_on(const State<double>& from, const State<double>& to, double passed,
                                                double time) {
    const EvenWay way(from, to, time);
    const auto straight = [&](double part) { return way.steadily(part).state.x; };
    std::optional<OnWay> met;
    if (collision().on_hit != OnHit::pass)
      if (auto hit = collide::first_meeting(casts_, collision().radius, straight, {r_.scene_time() + passed, time})) {
        hit->hit.part = hit->theta;
        met = {hit->hit,
               hit->hit.velocity == Vec3d{} ? way.after_way(hit->theta) : moment_met(way, {}, hit->hit, {}, passed)};
        if (hit->hit.velocity != Vec3d{}) met->hit.position = met->at.state.x;
      }
    tell_passages(way, met && time > 0 ? met->at.time / time : 1, passed, time);
    return met;
  }

  /// What follows from meeting something, `passed` into the step.
  [[nodiscard]] After struck(const State<double>& s, const SceneHit& hit, double passed) {
    bends_ = 0;
    return followed(std::nullopt, s, with_facing_normal(hit), passed);
  }

  struct Support {
    SceneHit hit;
    double above;  // how far its surface is from that of the thing [m]
  };
  /// The contact that lasts at a moment: the projectile touches a thing, is pressed on it, and neither leaves nor
  /// strikes it. So a contact lasts from step to step, without gaps and new hits. None if the projectile flies.
  [[nodiscard]] std::optional<Support> lies_on(const State<double>& s, double passed) const {
    if (const OnHit does = collision().on_hit; does == OnHit::pass || ends_flights(does)) return std::nullopt;
    const double within = 4 * gap_at(s.x), reach = collision().radius + within;
    // Not only the nearest one: that may be a wall beside what it lies on.
    std::optional<Support> found;
    SceneByMotion(*scene_).each_beside(s.x, reach, solids_, r_.scene_time() + passed, [&](const SceneNearest& near) {
      const auto on = supported_by(near, s, passed, within);
      if (on && (!found || on->above < found->above)) found = on;
    });
    return found;
  }
  /// The motion that follows along the support that lies_on() found.
  [[nodiscard]] After goes_along(const State<double>& at, const Support& on, double passed) {
    PHYSIM_ASSERT(length(on.hit.normal) > 0);
    if (is_one_way_too_many(passed)) return After{Then::lies, at, r_.step_length()};
    note_touched(at, passed);
    State<double> s = at;
    SceneHit hit = on.hit;
    // What was left in it by a rounding comes out first: casts that start inside see no wall.
    if (on.above < 0) s.x = outside(s.x - hit.normal * on.above, hit.normal, passed);
    above_ = on.above + dot(s.x - at.x, hit.normal);
    const Vec3d n = hit.normal, relative = s.v - hit.velocity;
    const BallMotion motion{relative - n * dot(relative, n), spin(passed)};
    const Vec3d a = acceleration_on(s, hit, passed, pressed_for(s, hit, passed));
    const std::optional<After> after = moves_along(s, hit, passed, motion, a);
    return followed(after, s, hit, passed);
  }

  /// What a projectile that lies on something touches beside that goes on being touched: it is no new hit.
  void note_touched(const State<double>& s, double passed) {
    touched_.clear();
    const double time = r_.scene_time() + passed, within = collision().radius + 4 * gap_at(s.x);
    SceneByMotion(*scene_).each_beside(s.x, within, solids_, time,
                                       [&](const SceneNearest& near) { touched_.push_back(near.instance); });
  }

  /// It lies on what moves: it has no rest.
  [[nodiscard]] bool is_carried() const { return carried_; }

 private:
  /// The contact with a thing that the projectile touches by no more than `within`, if it lasts.
  [[nodiscard]] std::optional<Support> supported_by(const SceneNearest& near, const State<double>& s, double passed,
                                                    double within) const {
    const double time = r_.scene_time() + passed, radius = collision().radius;
    if (near.away == Vec3d{} || near.distance < radius - within) return std::nullopt;
    SceneHit hit{.position = s.x,
                 .normal = near.away,
                 .time = time,
                 .velocity = velocity_at(*scene_->state(near.instance, time), near.position),
                 .instance = near.instance,
                 .primitive = near.primitive,
                 .material = near.material,
                 .entering = true};
    if (moves(hit)) hit.velocity = carried(hit, s.x, {}, passed, 0).v;
    constrain(hit);
    const double pressure = pressure_on(s, hit, passed, 0), rate = dot(s.v - hit.velocity, hit.normal);
    double rounding = 8 * epsilon() * (length(s.v) + length(hit.velocity));
    if (is_ball()) rounding += 4 * spacing(s.x) / radius * length(s.v - hit.velocity);  // of the normal about an edge
    if (!(pressure > 0) || rate > rounding || rate < -rounding - std::sqrt(2 * pressure * within)) return std::nullopt;
    return Support{hit, near.distance - radius};
  }

  /// Resolves contacts, one after the other, until none follows at once.
  [[nodiscard]] After followed(std::optional<After> after, State<double> s, SceneHit hit, double passed) {
    while (!after) after = contact(s, hit, passed);
    after->state.v = r_.kept(after->state.v);
    return *after;
  }
  /// Tells what a path goes through up to `end`: sensors, and where it passes everything, all of it.
  template <class Path>
  void tell_passages(const Path& path, double end, double start, double span) {
    const bool passes = collision().on_hit == OnHit::pass;
    if (!passes && !scene_->has_sensors()) return;
    const auto tell = [&](double theta, const SceneHit& hit) {
      const bool sensor = scene_->is_sensor(hit.instance);
      if (!sensor && !passes) return;
      const EventKind kind = !hit.entering ? EventKind::left : sensor ? EventKind::sensed : EventKind::entered;
      r_.tell(kind, Reason::none, std::min(start + theta * span, r_.step_length()), path(theta), hit);
    };
    const auto place = [&](double theta) { return path(theta).x; };
    collide::each_passage(*scene_, {.layers = solids_.layers}, place, {r_.scene_time() + start, span}, end, tell);
  }
  /// Went straight along a surface.
  void went(const State<double>& from, double begin, const State<double>& to, double end, const Carrier& carrier) {
    r_.slid(from, begin, to, end);
    tell_passages(EvenWay(from, to, end - begin, carrier), 1, begin, end - begin);
  }

  [[nodiscard]] SceneHit cast(const Vec3d& from, const Vec3d& to, double passed, double duration) const {
    return with_facing_normal(casts_.first_hit({from, to, collision().radius, r_.scene_time() + passed, duration}));
  }

  /// A place that its numbers can hold, from which what touches something at `x` can go on: outside of it, and of what
  /// stands beside it. It lies about a tenth of a nanometre off, or as far as those are apart.
  [[nodiscard]] Vec3d outside(const Vec3d& x, const Vec3d& normal, double passed) const {
    const double gap = gap_at(x);
    Vec3d off = normal * gap;
    constexpr int kMostSides = 6;  // more than three things seldom meet
    for (int side = 0; side < kMostSides; ++side) {
      const Vec3d place = held(x + off);
      const SceneHit hit = cast(x + normal * 1e-10, place, passed, 0);
      if (!hit || hit.starts_inside) return place;
      off += hit.normal * gap;
    }
    return held(x + off);
  }

  /// True if more ways along surfaces began within kLongestPart than motion explains: rounding holds the projectile
  /// where it is, and it waits for the next step, so that no step is without end. A new way may bend kMostHits times.
  [[nodiscard]] bool is_one_way_too_many(double passed) {
    if (passed - ways_since_ >= kLongestPart) ways_since_ = passed, ways_ = 0;
    bends_ = 0;
    return ++ways_ > 2 * kMostHits;
  }

  /// One contact; nothing where another one follows in `s`, `hit` and `passed`.
  [[nodiscard]] std::optional<After> contact(State<double>& s, SceneHit& hit, double& passed) {
    if (hit.starts_inside && is_ball())
      push_out(scene_->nearest(s.x, collision().radius, solids_, r_.scene_time() + passed), s, hit, passed);
    if (hit.starts_inside) look_for_surface(within(s.x, passed), s, hit);
    if (hit.starts_inside && came_through_) enter_here(s, hit);
    hit = of_first_part(*scene_, solids_, hit, s.x - hit.normal * collision().radius, r_.scene_time() + passed);
    const bool inside = hit.starts_inside;
    const bool leaves = !inside && dot(s.v - hit.velocity, hit.normal) >= 0;
    if (!inside && !leaves && !is_ball() && ++hits_ <= kMostHits && grazes(s, hit, passed))
      return After{Then::flies_on, s, passed};
    const bool lay = !inside && !leaves && (lay_there(s, hit, passed) || is_touched(s, hit, passed));
    HitAnswer does{.then = lay ? OnHit::bounce : collision().on_hit};
    if (!leaves && !is_known(does, s, hit, passed)) return After{Then::asks, s, passed};
    const OnHit action = does.then;
    const double taken = ends_flights(action) ? energy_of({s.v - hit.velocity, spin(passed)}) : 0;
    if (!leaves && !lay) r_.tell(EventKind::hit, inside ? Reason::inside : Reason::none, passed, s, hit, 0, taken);
    if (action == OnHit::stop && !leaves) return After{Then::stops, s, passed};
    const Vec3d met = s.x, normal = hit.normal;
    constrain(hit);
    if (!inside) s.x = outside(s.x, hit.normal, passed);
    if (inside || (action == OnHit::stick && !leaves) || ++hits_ > kMostHits) return After{Then::sticks, s, passed};
    if (leaves) return After{Then::flies_on, s, passed};
    if (action == OnHit::impact)
      if (auto after = impacted(s, met, normal, hit, passed)) return into_next(*after, s, hit, passed);
    if (action == OnHit::pass)
      if (auto after = let_through(s, met, normal, hit, passed, does.velocity))
        return into_next(*after, s, hit, passed);
    return rebound(s, hit, passed, action == OnHit::bounce ? does.velocity : std::nullopt);
  }
  /// True if a point only touches an edge of a thing; the point is moved behind the edge.
  [[nodiscard]] bool grazes(State<double>& s, const SceneHit& hit, double passed) const {
    const auto beyond = beyond_edge(*scene_, solids_, s, hit, r_.scene_time() + passed);
    if (!beyond) return false;
    s.x = held(*beyond + normalized(s.v - hit.velocity) * (2 * spacing(s.x)));
    return true;
  }
  /// Kinetic energy in the frame of the thing [J].
  [[nodiscard]] double energy_of(const BallMotion& motion) const {
    const double turns = collision().inertia * collision().radius * collision().radius;
    return 0.5 * r_.impact(hits_).mass * (length_squared(motion.velocity) + turns * length_squared(motion.spin));
  }
  /// Whether it is known what a hit does, which may be for others to say.
  [[nodiscard]] bool is_known(HitAnswer& does, const State<double>& s, const SceneHit& hit, double passed) const {
    if (does.then != OnHit::ask) return true;
    HitQuestion question = question_of(s, hit, r_.impact(hits_).mass);
    const HitAnswer* answer = r_.answer_to(question, passed);
    if (answer) return does = *answer, true;
    if (const auto through = way_from(s, hit, passed)) question.thickness = through->thickness;
    r_.leave_open(question);
    return false;
  }

  /// A ball that touches something where the step begins, as its middle is outside.
  void push_out(const SceneNearest& near, State<double>& s, SceneHit& hit, double passed) const {
    const double radius = collision().radius, time = r_.scene_time() + passed, rounding = 4 * gap_at(s.x);
    if (!near || near.away == Vec3d{} || scene_->is_one_way(near.instance)) return;
    // What lies there: at an edge a point may miss it.
    const Vec3d before = near.distance < rounding ? near.away * rounding : Vec3d{};
    const SceneHit there = scene_->first_hit({s.x + before, s.x - near.away * (2 * radius), 0, time, 0}, solids_);
    const bool found = there.instance == near.instance;
    // A middle that lies at a triangle by no more than a rounding goes to its front.
    const double side = found && before != Vec3d{} && !there.entering ? -1 : 1;
    const Vec3d away = near.away * side;
    const auto moves = scene_->state(near.instance, time);
    hit.material = found ? there.material : near.material;
    hit.primitive = found ? there.primitive : near.primitive;
    hit.velocity = moves->velocity + cross(moves->angular_velocity, near.position - moves->position);
    hit.normal = away, hit.instance = near.instance, hit.starts_inside = false;
    hit.entering = !found || there.entering || side < 0;
    SceneHit held_back = hit;
    constrain(held_back);
    const double part = std::max(dot(held_back.normal, away), 0.1);
    s.x += held_back.normal * ((radius - near.distance * side) / part);
  }

  /// A projectile that left a body inside another one, since they touch or overlap, meets that one at once.
  [[nodiscard]] std::optional<After> into_next(const After& after, State<double>& s, SceneHit& hit, double passed) {
    if (after.then != Then::flies_on || !came_through_) return after;
    SceneHit next = cast(after.state.x, after.state.x, passed, 0);
    if (!next.starts_inside)
      next = is_ball() ? SceneHit{} : entered_at(within(after.state.x, passed), after.state, hit);
    if (!next || is_one_body(*scene_, next, hit)) return after;
    hit = next;
    s = after.state;
    if (hit.starts_inside) look_for_surface(within(s.x, passed), s, hit);  // a ball's middle may be behind what is thin
    return std::nullopt;
  }
  /// How it is where it may be inside of something.
  [[nodiscard]] Within within(const Vec3d& x, double passed) const {
    const bool goes_through = collision().on_hit == OnHit::impact || came_through_;
    return {*scene_, solids_, collision().radius, gap_at(x), r_.scene_time() + passed, goes_through};
  }
  /// True if the projectile lay on an engine's surface before: it fell no farther than a part of the skin, to which the
  /// surface is known.
  [[nodiscard]] bool lay_there(const State<double>& s, const SceneHit& hit, double passed) const {
    if (!is_engines(hit) || collision().on_hit == OnHit::pass || ends_flights(collision().on_hit)) return false;
    const double pressure = -dot(r_.acceleration_at(s, passed), hit.normal), fell = 0.2 * scene_->skin();
    return pressure > 0 && dot(s.v - hit.velocity, hit.normal) >= -std::sqrt(2 * pressure * fell);
  }
  /// True if the projectile touched the thing when the step began, and comes back to it no faster than it is pressed
  /// on.
  [[nodiscard]] bool is_touched(const State<double>& s, const SceneHit& hit, double passed) const {
    const double pressure = std::max(-dot(r_.acceleration_at(s, passed), hit.normal), 0.0);
    return std::ranges::find(touched_, hit.instance) != touched_.end() &&
           dot(s.v - hit.velocity, hit.normal) >= -pressure * frame() - 1e-9 * length(s.v);
  }

  /// Whether something stands in a way at once: it is as near as what is put beside a surface lies off it.
  [[nodiscard]] bool is_at_once(const SceneHit& next, const Vec3d& x, const Vec3d& way, double time) const {
    if (!next || next.starts_inside || next.part * time <= 1e-6 * frame()) return bool(next);
    return next.part * std::abs(dot(way - next.velocity * time, next.normal)) <= 4 * gap_at(x);
  }

  /// Further surfaces that it meets at the moment at which it meets one: what stands in the rest of its way at once.
  [[nodiscard]] PHYSIM_COLD std::vector<SceneHit> met_at_once(const State<double>& s, const SceneHit& first,
                                                              double passed) const {
    std::vector<SceneHit> all{first};
    constexpr std::size_t kMostAtOnce = 4;  // more walls than that seldom meet in a corner
    const double near = 4 * gap_at(s.x);
    while (all.size() < kMostAtOnce) {
      Vec3d along = s.v - first.velocity;
      for (int turn = 0; turn < 4; ++turn)
        for (const SceneHit& hit : all) along -= hit.normal * min(dot(along, hit.normal), 0.0);
      if (!(length(along) > 1e-9 * length(s.v - first.velocity))) break;
      SceneHit next = cast(s.x, s.x + normalized(along) * near, passed, 0);
      if (!next || next.starts_inside) break;
      constrain(next);
      const auto is_known = [&](const SceneHit& hit) { return dot(hit.normal, next.normal) > 1 - 1e-6; };
      if (std::ranges::any_of(all, is_known) || !(dot(s.v - next.velocity, next.normal) < 0)) break;
      all.push_back(next);
    }
    return all;
  }
  /// It meets several surfaces at one moment and leaves all of them: their impulses are found together, so that none
  /// comes first. Nothing if it meets one, or stays on some.
  [[nodiscard]] PHYSIM_COLD std::optional<After> leaves_together(State<double>& s, const SceneHit& first,
                                                                 double passed) {
    std::vector<SceneHit> all = met_at_once(s, first, passed);
    if (all.size() == 1) return std::nullopt;
    std::vector<Surface> on;
    for (const SceneHit& hit : all) on.push_back(surface(hit));
    for (SceneHit& hit : all) hit.velocity = running(hit, passed);
    const BallMotion came{s.v, spin(passed)}, gone = met_together(came, ball(), all, on);
    const Vec3d v = r_.kept(gone.velocity), a = r_.acceleration_at(s, passed);
    for (const SceneHit& hit : all)
      if (!lifts_off(dot(v - hit.velocity, hit.normal), dot(a, hit.normal), frame())) return std::nullopt;
    for (const SceneHit& hit : all)
      if (&hit != &all.front()) r_.tell(EventKind::hit, Reason::none, passed, s, hit);
    s.v = v;
    if (is_ball()) r_.put_spin(gone.spin, passed);
    for (const SceneHit& hit : all) {
      const double lost =
          energy_of({came.velocity - hit.velocity, came.spin}) - energy_of({v - hit.velocity, gone.spin});
      r_.tell(EventKind::bounced, Reason::none, passed, s, hit, 0, &hit == &all.front() ? lost : 0);
    }
    return After{Then::flies_on, s, passed};
  }

  /// Bounces, or lies on what it met, in the frame of the surface that rubs. `own`: with the velocity of an answer.
  [[nodiscard]] std::optional<After> rebound(State<double>& s, SceneHit& hit, double& passed,
                                             const std::optional<Vec3d>& own) {
    const Vec3d n = hit.normal, u = running(hit, passed), over = runs(hit, passed);
    const Surface on = surface(hit);
    BallMotion motion{s.v - u, spin(passed)};
    const double before = dot(motion.velocity, n);
    if (before >= 0) return After{Then::flies_on, s, passed};
    const BallMotion came = motion;
    const auto bounce = [&](double grip) {
      if (own)
        motion.velocity = *own - u;
      else if (is_ball())
        motion = bounced(came, n, ball(), {on.restitution, on.friction, grip});
      else
        motion.velocity = bounced(came.velocity, n, on);
      motion.velocity = r_.kept(motion.velocity);
      if (is_ball()) r_.put_spin(motion.spin, passed);
    };
    const double grip = scene_->material(hit.material).grip_restitution;
    if (!own && grip == 0)
      if (auto after = leaves_together(s, hit, passed)) return after;
    bounce(grip);
    const Vec3d a = acceleration_on(s, hit, passed, pressed_for(s, hit, passed));
    const double lifts = dot(a, n) - (moves(hit) ? pressed_by_speed(motion.velocity, hit, passed) : 0);
    if (lifts_off(dot(motion.velocity, n), lifts, frame()) || lifts > 0) {
      s.v = motion.velocity + u;
      r_.tell(EventKind::bounced, Reason::none, passed, s, hit, 0, energy_of(came) - energy_of(motion));
      return After{Then::flies_on, s, passed};
    }
    if (grip > 0) bounce(0);  // and what stays on the surface does not turn its slip around
    motion.velocity -= n * dot(motion.velocity, n);
    s.v = motion.velocity + u;
    if (is_strike(before, lifts, frame()))
      r_.tell(EventKind::bounced, Reason::none, passed, s, hit, 0, energy_of(came) - energy_of(motion));
    if (over != Vec3d{}) motion.velocity += over;
    return moves_along(s, hit, passed, motion, a + changed_by(r_, {s.x, came.velocity + u}, s, passed));
  }

  /// What a ball turns about at the end of its way, if the surface falls away there from the plane on which it goes: an
  /// edge, or what is round.
  struct Turn {
    SceneNearest about;
    bool leaves = false;  // it is too fast to turn
  };
  /// The way is cut to where it turns by little; where the ball leaves, to less.
  [[nodiscard]] PHYSIM_COLD Turn find_turn(const Vec3d& x, const BallMotion& motion, const Pull& a, const SceneHit& hit,
                                           const Surface& on, double passed, BallWay& way) const {
    const Vec3d over = runs(hit, passed);
    constexpr double kLittle = 0.02, kFine = 1e-3;  // of the radius
    const double radius = collision().radius, flat = 8 * gap_at(x);
    for (;;) {
      const double far = length(way.way), time = r_.scene_time() + passed + way.time;
      if (!(far > 0)) return {};
      const SceneNearest below = scene_->nearest(x + way.way, radius + far, solids_, time);
      if (!below || below.away == Vec3d{} || below.distance <= radius + flat) return {};
      double part = 0.9 * kLittle * radius / far;
      if (far <= kLittle * radius) {
        if (dot(below.away, hit.normal) < 0.5 || holds_on(x, a.moving, below, way)) return {below};
        if (far <= kFine * radius) return {{}, true};
        part = 0.3;
      }
      PHYSIM_ASSERT(part > 0 && part < 1);
      way = ball_way(motion, a, hit, on, over, way.time * part);
    }
  }
  /// Whether a point's way goes over an edge, at which it is cut then; an engine's edges are not known. `way_in(time)`;
  /// `end_of(way)`: where it ends.
  template <class WayIn, class EndOf>
  [[nodiscard]] PHYSIM_COLD bool runs_out(const SceneHit& hit, double passed, BallWay& way, const WayIn& way_in,
                                          const EndOf& end_of) const {
    const auto is_beyond = [&](const BallWay& at) {
      const Vec3d x = end_of(at).x;
      const double flat = 8 * gap_at(x), reach = length(at.way) + flat;
      const SceneNearest below = scene_->nearest(x, reach, solids_, r_.scene_time() + passed + at.time);
      return !below || (below.distance > flat && std::abs(dot(below.away, hit.normal)) < 0.5);
    };
    if (way.way == Vec3d{} || !is_beyond(way)) return false;
    double on = 0, off = way.time;
    constexpr int kHalvings = 48;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (on + off);
      (is_beyond(way_in(middle)) ? off : on) = middle;
    }
    way = way_in(off);
    return true;
  }
  /// Where it is beside the surface that it turns about.
  [[nodiscard]] Vec3d turned_place(const SceneNearest& about, const Vec3d& x) const {
    return held(about.position + about.away * (collision().radius + gap_at(x)));
  }
  /// Whether what presses it on turns its way as fast as the surface falls away.
  [[nodiscard]] bool holds_on(const Vec3d& x, const Vec3d& a, const SceneNearest& about, const BallWay& way) const {
    const Vec3d to = x + way.way;
    const double bend = length_squared(way.way) / (2 * (about.distance - collision().radius));  // radius of its way
    const BallMotion after = turned_about(way.motion, a, turned_place(about, to) - to, about.away, ball());
    return length_squared(after.velocity) <= bend * -dot(a, about.away);
  }

  /// Another thing than the one below that a way goes into at once, as it begins inside of it: by a micrometre at most,
  /// as rounding, a net or a call leaves it. What is deeper was put there, and goes on as if nothing were.
  [[nodiscard]] PHYSIM_COLD SceneHit stands_here(State<double> s, const SceneHit& below, SceneHit wall,
                                                 const Vec3d& way, double passed) const {
    const Vec3d was = s.x;
    if (!is_ball()) return point_stands_here(within(was, passed), was, below, wall, way);
    push_out(in_way(*scene_, solids_, below.instance, s.x, way, collision().radius, r_.scene_time() + passed), s, wall,
             passed);
    const bool deep = length(s.x - was) > max(1e-6, 4 * gap_at(was));
    if (deep || wall.starts_inside || !(dot(way, wall.normal) < 0)) return {};
    wall.part = 0, wall.position = s.x;
    return wall;
  }

  /// A way along a thing that ends where it turns, and at the ground.
  struct Ahead {
    BallWay way;
    Turn turn;
    Vec3d to, then_at;   // where it ends [m]; velocity of the thing there [m/s]
    Vec3d over;          // so far above the way a cast goes [m]
    bool lands = false;  // at its end, or at once
  };
  [[nodiscard]] Ahead look_ahead(const State<double>& s, const SceneHit& hit, const BallMotion& motion,
                                 const Pull& pull, double passed, double left) {
    const Vec3d u = hit.velocity, over_it = runs(hit, passed);
    const auto way_in = [&](double time) { return way_along(hit, motion, over_it, pull, time); };
    const auto end_of = [&](const BallWay& way) {
      return moves(hit) ? carried(hit, s.x, way.way, passed, way.time) : State<double>{s.x + way.way + u * way.time, u};
    };
    Ahead ahead{way_in(left), {}, {}, {}, {}};
    BallWay& way = ahead.way;
    if (is_ball() && !moves(hit)) ahead.turn = find_turn(s.x, motion, pull, hit, surface(hit), passed, way);
    if (!is_ball() && !is_engines(hit)) ahead.turn.leaves = runs_out(hit, passed, way, way_in, end_of);
    const Turn& turn = ahead.turn;
    auto lands = comes_to_ground(s.x, way.time, [&](double time) { return end_of(way_in(time)).x; });
    if (lands && !turn.about) way = way_in(*lands);
    const auto [there, then_at] = end_of(way);
    if (moves(hit)) turn_with(hit, s.x, over_it, passed, way);
    ahead.to = held(there), ahead.then_at = then_at;
    // A thing that turns bends the way: the cast goes along the chord, above the arc.
    if (moves(hit)) ahead.over = hit.normal * (0.25 * way.time * length(then_at - u));
    if (above_) {  // what its places are rounded to adds up
      const double gap = gap_at(ahead.to), then_above = *above_ + dot(ahead.to - there, hit.normal);
      if (then_above < 0.5 * gap || then_above > 2 * gap)
        ahead.to = outside(there - hit.normal * *above_, hit.normal, passed + way.time);
      above_.reset();
    }
    if (turn.about) {
      ahead.over += hit.normal * (0.5 * (turn.about.distance - collision().radius));  // the chord lies below the arc
      ahead.to = turned_place(turn.about, ahead.to);
      way.motion = turned_about(way.motion, pull.moving, ahead.to - there, turn.about.away, ball());
      way.motion.velocity = r_.kept(way.motion.velocity);
      const auto place = [&](double part) { return s.x + (ahead.to - s.x) * part; };
      lands = comes_to_ground(s.x, 1, place);
      if (lands) {
        const EvenWay::Moment at =
            EvenWay({s.x, motion.velocity}, {ahead.to, way.motion.velocity}, way.time).after_way(*lands);
        way = {at.time, way.way, {at.state.v, at.mixed(motion.spin, way.motion.spin)}};
        ahead.to = at.state.x;
      }
    }
    ahead.lands = lands.has_value();
    return ahead;
  }
  /// When a way comes to the ground from above; at once if the ground holds it already.
  [[nodiscard]] PHYSIM_COLD std::optional<double> comes_to_ground(const Vec3d& from, double time,
                                                                  FunctionRef<Vec3d(double)> place) const {
    const auto above = [&](double at) { return r_.ground_below(place(at)).height; };
    const double before = r_.ground_below(from).height, after = above(time);
    if (!(after < 0)) return std::nullopt;
    return before > 0 ? find_root(above, 0, before, time, after, 0) : 0;
  }

  /// Slides or rolls along what it lies on, up to what stands in its way.
  [[nodiscard]] std::optional<After> moves_along(State<double>& s, SceneHit& hit, double& passed,
                                                 const BallMotion& motion, const Vec3d& a) {
    const Vec3d u = hit.velocity, over_it = runs(hit, passed);
    const double left = pressed_for(s, hit, passed);
    const Pull pull = pull_on(s, hit, motion, a, passed, left);
    const auto [way, turn, to, then_at, over, lands] = look_ahead(s, hit, motion, pull, passed, left);
    carried_ = u != Vec3d{} || then_at != Vec3d{} || over_it != Vec3d{};
    if (lands && way.time == 0) return lies_between(s, hit, {.normal = r_.ground_below(s.x).up}, passed, a);
    SceneHit next = cast(s.x + over, to + over, passed, way.time);
    const bool inside = next.starts_inside;
    if (inside && over == Vec3d{}) next = stands_here(s, hit, next, to - s.x, passed);
    const double part = next && !next.starts_inside ? next.part : 1.0;
    const State<double> began = s;
    const double begin = passed;
    const Carrier carrier = carrier_of(hit, s.x, passed);
    const EvenWay even({s.x, motion.velocity + u}, {to, way.motion.velocity + then_at}, way.time, carrier);
    const bool moved = part < 1 && (carrier || next.velocity != Vec3d{});
    const EvenWay::Moment then = moved ? moment_met(even, hit, next, over, passed) : even.after_way(part);
    passed = part < 1 || way.time < r_.step_length() - passed ? passed + then.time : r_.step_length();
    s = {moved || part == 1 ? then.state.x : next.position - over, then.state.v};
    if (is_ball()) r_.put_spin(then.mixed(motion.spin, way.motion.spin), passed);
    went(began, begin, s, passed, carrier);
    if (part == 1 && lands) return After{Then::lands, s, passed};
    if (part == 1 && turn.leaves) return After{Then::flies_on, s, passed};
    if (part == 1 && turn.about) hit.normal = turn.about.away, constrain(hit);
    if (part == 1 && way.time < left && !moves(hit) && ++bends_ <= kMostHits)
      return moves_along(s, hit, passed, way.motion, a + changed_by(r_, began, s, begin));
    if (part == 1) return After{passed < r_.step_length() ? Then::flies_on : Then::lies, s, passed};
    const double comes = -dot(s.v - next.velocity, next.normal);
    const bool bounces = !inside && lifts_off(surface(next).restitution * comes, -length(a), frame());
    const bool goes_on = bounces || !is_at_once(next, began.x, to - began.x, way.time);
    const SceneHit below = std::exchange(hit, next);
    s.x = outside(s.x, hit.normal, passed);
    if (!goes_on) return lies_between(s, below, hit, passed, a);
    if (dot(s.v - hit.velocity, hit.normal) < 0 && ++hits_ <= kMostHits) return std::nullopt;
    return rests(s.x, hit.velocity, passed);
  }

  /// Moves on with the thing up to the next obstacle; stays if an obstacle is met at once.
  [[nodiscard]] After rests(const Vec3d& x, const Vec3d& velocity, double passed) {
    const double left = longest_way(passed);
    const State<double> s{x, velocity};
    const SceneHit next = velocity == Vec3d{} ? SceneHit{} : cast(x, x + velocity * left, passed, left);
    const bool is_held = is_at_once(next, x, velocity * left, left);
    return along(s, is_held ? Vec3d{} : velocity * left, velocity, is_held ? SceneHit{} : next, passed, {}, {});
  }
  /// Moves straight by `way`, to the velocity at its end, up to the next obstacle; a thing carries it with `by`.
  [[nodiscard]] After along(const State<double>& s, const Vec3d& way, const Vec3d& velocity, const SceneHit& next,
                            double passed, const SceneHit& thing, const Vec3d& by) {
    const double left = longest_way(passed), meets = next ? next.part : 1.0;
    const auto ground = comes_to_ground(s.x, 1, [&](double at) { return s.x + way * at; });
    const bool lands = ground && *ground > 0 && *ground < meets;
    const double part = lands ? *ground : meets;
    const Carrier carrier = by == Vec3d{} ? Carrier{} : [&](double time) { return State<double>{s.x + by * time, by}; };
    const EvenWay even(s, {s.x + way, velocity}, left, carrier);
    const bool moved = next && !lands && (carrier || next.velocity != Vec3d{});
    const EvenWay::Moment at = moved     ? moment_met(even, thing, next, {}, passed)
                               : carrier ? even.after_time(part)
                                         : even.after_way(part);
    const double then = part < 1 || left < r_.step_length() - passed ? passed + at.time : r_.step_length();
    const Vec3d met = moved ? at.state.x : next.position;
    const State<double> end{next && !lands ? outside(met, next.normal, then) : held(s.x + way * part), at.state.v};
    went(s, passed, end, then, carrier);
    if (lands) return {Then::lands, end, then};
    return {then < r_.step_length() ? Then::flies_on : Then::lies, end, then};
  }

  /// The projectile lies on one thing, and another one obstructs it at once: it moves along the line between both, with
  /// the velocity that both impose.
  [[nodiscard]] PHYSIM_COLD After lies_between(State<double> s, const SceneHit& one, SceneHit other, double passed,
                                               const Vec3d& a) {
    constrain(other);
    const Vec3d line = r_.kept(cross(one.normal, other.normal)), middle = one.normal + other.normal;
    if (length(line) < 1e-6 || length(middle) < 1e-6) return rests(s.x, one.velocity, passed);
    // The velocity across the line that follows both surfaces: u . n1 = u1 . n1, u . n2 = u2 . n2.
    const double c = dot(one.normal, other.normal), per = 1 / (1 - c * c);
    PHYSIM_ASSERT(per > 0);
    const double first = dot(one.velocity, one.normal), second = dot(other.velocity, other.normal);
    const Vec3d u = one.normal * ((first - c * second) * per) + other.normal * ((second - c * first) * per);
    const double left = longest_way(passed);
    const Vec3d along_it = normalized(line), n = normalized(middle);
    const std::array<BallFace, 2> faces{face_of(one, s.x, passed), face_of(other, s.x, passed)};
    const Vec3d before = along_it * dot(s.v - u, along_it), over = along_it * dot(faces[0].runs, along_it);
    const auto way_by = [&](const Pull& pull, double time) -> BallWay {
      const BallMotion motion{u + before, spin(passed)};
      if (is_ball()) return moved_between(motion, pull.moving, faces, ball(), time);
      if (over != along_it * dot(faces[1].runs, along_it))
        return moved_between(motion, pull.moving, faces, kPoint, time);
      BallWay way = point_between(faces, before, over, pull, along_it, time);
      way.way += u * time, way.motion.velocity += u;
      return way;
    };
    const Pull pull = pull_along(r_, a, s, {before - over, n, passed, left},
                                 [&](const Pull& by) { return way_by(by, left).motion.velocity - u - over; });
    const BallWay on = way_by(pull, left);
    const Vec3d way = r_.kept(on.way);
    carried_ = carried_ || u != Vec3d{} || faces[0].runs != Vec3d{} || faces[1].runs != Vec3d{};
    const Vec3d above = n * (4 * gap_at(s.x) / dot(n, one.normal));  // the cast goes along both, and meets neither
    SceneHit next = cast(s.x + above, s.x + above + way, passed, left);
    if (is_at_once(next, s.x, way, left)) return rests(s.x, u, passed);
    next.position -= above;
    const After after = along({s.x, before + u}, way, r_.kept(on.motion.velocity), next, passed, one, u);
    const double taken = after.passed - passed;
    if (is_ball()) r_.put_spin(taken < left ? way_by(pull, taken).motion.spin : on.motion.spin, after.passed);
    return after;
  }
  /// One of two surfaces that it lies between: of a thing, or the ground. What does not roll slides against a rolling
  /// resistance, if a point has one.
  [[nodiscard]] BallFace face_of(const SceneHit& hit, const Vec3d& x, double passed) const {
    const Ground* ground = hit.instance ? nullptr : r_.ground_below(x).ground;
    const Surface on = ground ? surface_between(*ground, r_.surface()) : surface(hit);
    const Vec3d runs = ground ? r_.kept(conveyor_along(*ground, hit.normal)) : this->runs(hit, passed);
    const bool rolls = !is_ball() && on.rolling_resistance > 0;
    return {hit.normal, hit.velocity, runs, {rolls ? on.rolling_resistance : on.friction, on.rolling_resistance}};
  }
  /// The way of a point along the line between two surfaces, of which each resists by what presses the point on it.
  [[nodiscard]] static BallWay point_between(const std::array<BallFace, 2>& faces, const Vec3d& velocity,
                                             const Vec3d& over, const Pull& pull, const Vec3d& line, double time) {
    const Vec3d &n0 = faces[0].normal, &n1 = faces[1].normal;
    const double c = dot(n0, n1), by_0 = -dot(pull.moving, n0), by_1 = -dot(pull.moving, n1);
    double on_0 = (by_0 - c * by_1) / (1 - c * c), on_1 = (by_1 - c * by_0) / (1 - c * c);
    if (on_0 <= 0)
      on_0 = 0, on_1 = max(by_1, 0.0);
    else if (on_1 <= 0)
      on_0 = max(by_0, 0.0), on_1 = 0;
    const double resistance = faces[0].grip.friction * on_0 + faces[1].grip.friction * on_1;
    const Vec3d on_it = -n0;  // of pressure 1
    const Pull along_it{line * dot(pull.moving, line) + on_it, line * dot(pull.at_rest, line) + on_it};
    return point_way({velocity, {}}, over, along_it, n0, {0, resistance, 0}, time);
  }
  static constexpr Ball kPoint{1, 1, {0.0, 0.0, 0.0}};  // one that friction does not turn

  // ------------------------------------------------------------------------------------------- into and through
  /// As the material lets it, see impact(); nothing where it bounces. `normal`: of the surface, whatever it is held by.
  [[nodiscard]] std::optional<After> impacted(State<double>& s, const Vec3d& met, const Vec3d& normal,
                                              const SceneHit& hit, double passed) {
    const Vec3d relative = s.v - hit.velocity;
    const double speed = length(relative);
    if (!(speed > 0)) return std::nullopt;
    const Vec3d way = relative * (1 / speed);
    const auto through = way_through(met - normal * collision().radius, way, hit, passed);
    if (!through) return std::nullopt;
    Impact asked = r_.impact(hits_);
    asked.inertia = collision().inertia;
    asked.velocity = s.v;
    asked.spin = spin(passed);
    asked.normal = normal;
    asked.surface_velocity = hit.velocity;
    asked.thickness = through->thickness;
    const Result<ImpactResult> result = impact(asked, scene_->material(hit.material));
    if (!result) return std::nullopt;  // no law knows what has no mass or diameter
    const auto tell = [&](EventKind kind) {
      r_.tell(kind, Reason::none, passed, s, hit, result->depth, result->energy);
    };
    s.v = r_.kept(result->velocity);
    came_through_ = came_through_ || result->kind == ImpactKind::penetrated;
    switch (result->kind) {
      case ImpactKind::none: return After{Then::flies_on, s, passed};
      case ImpactKind::bounced: s.v = asked.velocity; return std::nullopt;
      case ImpactKind::ricocheted:
        tell(EventKind::ricocheted);
        r_.put_spin(result->spin, passed);
        return After{Then::flies_on, s, passed};
      case ImpactKind::penetrated:
        s.x = behind(met, way, *through, passed);
        tell(EventKind::penetrated);
        return After{Then::flies_on, s, passed};
      case ImpactKind::stopped:
        s.x = held(met + way * result->depth);
        tell(EventKind::stopped);
        return After{Then::sticks, s, passed};
    }
    return std::nullopt;
  }

  /// Out behind what it met, at once; nothing where a ball only grazes an edge.
  [[nodiscard]] std::optional<After> let_through(State<double>& s, const Vec3d& met, const Vec3d& normal,
                                                 const SceneHit& hit, double passed,
                                                 const std::optional<Vec3d>& velocity) {
    const Vec3d before = s.v - hit.velocity;
    if (!(length(before) > 0)) return std::nullopt;
    const Vec3d way = normalized(before);
    const auto through = way_through(met - normal * collision().radius, way, hit, passed);
    if (!through) return std::nullopt;
    if (velocity) s.v = r_.kept(*velocity);
    s.x = behind(met, way, *through, passed);
    const double lost = length_squared(before) - length_squared(s.v - hit.velocity);
    const double energy = 0.5 * r_.impact(hits_).mass * lost;
    r_.tell(EventKind::penetrated, Reason::none, passed, s, hit, through->thickness, energy);
    came_through_ = true;
    return After{Then::flies_on, s, passed};
  }

  /// From where it touches a thing; nothing where a ball only grazes an edge.
  [[nodiscard]] std::optional<collide::WayThrough> way_through(const Vec3d& touched, const Vec3d& way,
                                                               const SceneHit& hit, double passed) const {
    return collide::way_through(*scene_, solids_, hit, {touched, way, collision().radius, r_.scene_time() + passed});
  }
  /// From where it is as it touches a thing, on its way.
  [[nodiscard]] std::optional<collide::WayThrough> way_from(const State<double>& s, const SceneHit& hit,
                                                            double passed) const {
    const Vec3d way = normalized(s.v - hit.velocity);
    if (hit.starts_inside || !(length(way) > 0)) return std::nullopt;
    return way_through(s.x - hit.normal * collision().radius, way, hit, passed);
  }
  /// Where it comes out; a ball's middle is then a radius beyond the surface.
  [[nodiscard]] Vec3d behind(const Vec3d& met, const Vec3d& way, const collide::WayThrough& through,
                             double passed) const {
    const double radius = collision().radius + scene_->skin();
    PHYSIM_ASSERT(std::abs(length(through.normal) - 1) < 1e-6);
    const double cosine = dot(way, through.normal);
    Vec3d x = through.out + through.normal * radius;
    if (radius > 0 && cosine > 0.1) x = met + way * ((dot(through.out - met, through.normal) + radius) / cosine);
    const Vec3d off = r_.kept(through.normal);
    // What has no end is left so far behind that it is not met again.
    return through.thickness > 0 ? outside(x, off, passed) : held(x + off * (8 * gap_at(x)));
  }

  SceneFilter solids_;
  collide::TubeCasts casts_;  // about the way that was looked at last
  int hits_ = 0;
  int bends_ = 0;          // of one way along a surface
  int ways_ = 0;           // that began since then:
  double ways_since_ = 0;  // into the step [s]
  bool carried_ = false;
  std::optional<double> above_;      // what it goes along, to begin with [m]
  std::vector<InstanceId> touched_;  // when the step began, by what lay there
  bool came_through_ = false;        // something, in this step
};

}  // namespace physim
