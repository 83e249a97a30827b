// Read access of contacts to a projectile, to the thing that it touches, and to the motion along that thing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/carried.hpp"
#include "collide/contact_host.hpp"
#include "collide/contact_rules.hpp"
#include "collide/scene_by_motion.hpp"
#include "model/ball_rolling.hpp"
#include "model/body.hpp"
#include "physim/scene.hpp"

namespace physim {

class ContactView {
 public:
  explicit ContactView(ContactHost& host) : r_(host), scene_(host.scene()) {}

 protected:
  [[nodiscard]] const CollisionDef& collision() const { return r_.collision(); }
  [[nodiscard]] double frame() const { return frame_of_contact(r_.step_length()); }
  /// The rest of the step, at most kLongestPart: the longest time that one motion along a surface covers [s].
  [[nodiscard]] double longest_way(double passed) const { return std::min(r_.step_length() - passed, kLongestPart); }
  [[nodiscard]] Ball ball() const { return {collision().radius, collision().inertia, r_.turns()}; }
  [[nodiscard]] Vec3d spin(double passed) const { return component_product(r_.turns(), r_.spin(passed)); }
  [[nodiscard]] bool is_ball() const { return collision().radius > 0; }
  [[nodiscard]] bool is_float32() const { return r_.precision() == Precision::float32; }
  /// The machine epsilon of the number type of the projectile's state.
  [[nodiscard]] double epsilon() const {
    return is_float32() ? double{std::numeric_limits<float>::epsilon()} : std::numeric_limits<double>::epsilon();
  }
  /// A vector rounded to the precision of the projectile's state.
  [[nodiscard]] Vec3d held(const Vec3d& x) const { return is_float32() ? vec_cast<double>(vec_cast<float>(x)) : x; }
  [[nodiscard]] double spacing(const Vec3d& x) const {
    return is_float32() ? spacing_at<float>(x) : spacing_at<double>(x);
  }
  [[nodiscard]] double gap_at(const Vec3d& x) const {
    return is_float32() ? physim::gap_at<float>(x) : physim::gap_at<double>(x);
  }
  /// Constraints take up what would push it to where it is not free to go: it meets the line in which the surface cuts
  /// the plane that it is held in, and that line moves as the surface does there.
  void constrain(SceneHit& hit) const {
    const Vec3d along = r_.kept(hit.normal);
    if (along == hit.normal && r_.kept(hit.velocity) == hit.velocity) return;
    const double part = length(along);
    const double speed = dot(hit.velocity, hit.normal);
    hit.velocity = r_.kept(hit.velocity);
    if (!(part > 1e-9)) return;
    PHYSIM_ASSERT(part <= 1 + 1e-6);
    hit.normal = along * (1 / part);
    hit.velocity += hit.normal * (speed / part - dot(hit.velocity, hit.normal));
  }
  [[nodiscard]] SceneByMotion::Ride ride(const SceneHit& hit, double passed) const {
    PHYSIM_ASSERT(!is_engines(hit));
    return SceneByMotion(*scene_).ride(hit.instance.index, r_.scene_time() + passed);
  }
  [[nodiscard]] OnThing on(const SceneHit& hit, const Vec3d& x, double passed) const {
    return {x, hit.normal, collision().radius, r_.scene_time() + passed};
  }
  /// The state after `time` of a projectile at x that moves by `along` relative to the thing's surface. If motion along
  /// some axes is frozen, the displacement and velocity of the thing are projected onto the free axes.
  [[nodiscard]] State<double> carried(const SceneHit& hit, const Vec3d& x, const Vec3d& along, double passed,
                                      double time) const {
    const SceneByMotion::Ride by = ride(hit, passed);
    const State<double> free = by.by->carried(*by.piece, on(hit, x, passed), along, time);
    if (!is_held()) return free;
    const Vec3d u = by.by->carried(*by.piece, on(hit, x, passed), {}, 0).v, way = along + hit.velocity * time;
    return {x + way + r_.kept(free.x - x - along - u * time), hit.velocity + r_.kept(free.v - u)};
  }
  /// True if motion along some axes is frozen.
  [[nodiscard]] bool is_held() const {
    constexpr Vec3d kAny{1, 0.7, 0.4};  // it lies in no plane to which motion may be held
    return r_.kept(kAny) != kAny;
  }
  /// The motion of the thing's surface at x, as a function of time since `passed`; empty if the thing is at rest.
  [[nodiscard]] PHYSIM_COLD Carrier carrier_of(const SceneHit& hit, const Vec3d& x, double passed) const {
    if (moves(hit)) return [this, hit, x, passed](double time) { return carried(hit, x, {}, passed, time); };
    if (hit.velocity == Vec3d{}) return {};
    return [u = hit.velocity, x](double time) { return State<double>{x + u * time, u}; };
  }
  /// True if the thing moves; the motion of an engine's thing is not known ahead.
  [[nodiscard]] bool moves(const SceneHit& hit) const {
    return !is_engines(hit) && !SceneByMotion(*scene_).rests(hit.instance.index);
  }
  [[nodiscard]] static bool is_engines(const SceneHit& hit) { return hit.instance.generation == kEngineGeneration; }
  /// The change of the thing's surface velocity at x over `time`, without the components along frozen axes [m/s].
  [[nodiscard]] Vec3d speeds_up(const SceneHit& hit, const Vec3d& x, double passed, double time) const {
    PHYSIM_ASSERT(moves(hit));
    return carried(hit, x, {}, passed, time).v - carried(hit, x, {}, passed, 0).v;
  }
  /// Mean acceleration by all effects but the contact, in the frame of the thing, over a time that follows [m/s^2].
  [[nodiscard]] Vec3d acceleration_on(const State<double>& s, const SceneHit& hit, double passed, double time) const {
    const Vec3d a = r_.acceleration_at(s, passed);
    if (!moves(hit) || !(time > 0)) return a;
    return a - speeds_up(hit, s.x, passed, time) * (1 / time);
  }
  /// Normal component of the Coriolis acceleration at the velocity v_r relative to a thing that turns: 2 n . (w x v_r),
  /// positive if it presses the projectile onto the thing; 0 if the thing does not turn [m/s^2].
  [[nodiscard]] PHYSIM_COLD double pressed_by_speed(const Vec3d& v_r, const SceneHit& hit, double passed) const {
    const SceneByMotion::Ride by = ride(hit, passed);
    return by.turns() ? 2 * dot(hit.normal, cross(by.piece->axis * by.piece->rate, v_r)) : 0;
  }
  /// Acceleration that presses the projectile onto a thing that carries it, some time later [m/s^2].
  [[nodiscard]] double pressure_on(const State<double>& s, const SceneHit& hit, double passed, double later) const {
    constexpr double kShort = 1e-5;  // [s]
    const double own = -dot(r_.acceleration_at(s, passed), hit.normal);
    if (!moves(hit)) return own;
    const Vec3d now = carried(hit, s.x, {}, passed, later).v, then = carried(hit, s.x, {}, passed, later + kShort).v;
    return own + dot(then - now, hit.normal) / kShort + pressed_by_speed(s.v - hit.velocity, hit, passed);
  }
  /// The part of the time that follows in which a moving thing presses the projectile on [s].
  [[nodiscard]] double pressed_for(const State<double>& s, const SceneHit& hit, double passed) const {
    if (!moves(hit)) return longest_way(passed);
    const SceneByMotion::Ride by = ride(hit, passed);
    constexpr double kTurn = 0.1;  // of the thing, in which its surface is near its place at the first moment [rad]
    const double turned = by.turns() ? kTurn / std::abs(by.piece->rate) : kInfinity;
    const double longest = min(min(longest_way(passed), by.lasts), turned);
    // A thing whose velocity jumps may press again later; the projectile has left it before.
    const Vec3d a = r_.acceleration_at(s, passed);
    const double own = pressed_by_speed(s.v - hit.velocity, hit, passed) - dot(a, hit.normal);
    const double rounding = 1e-9 * length(a);
    PHYSIM_ASSERT(!is_engines(hit));
    const auto presses = [&](double later) {
      const double ahead = dot(speeds_up(hit, s.x, passed, later), hit.normal) + own * later;
      return pressure_on(s, hit, passed, later) >= -rounding && ahead >= -rounding * later;
    };
    if (presses(longest)) return longest;
    double pressed = 0, free = longest;
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (pressed + free);
      (presses(middle) ? pressed : free) = middle;
    }
    const double shortest = 1e-3 * frame();  // so that a step has not too many parts
    return max(free, min(longest, shortest));
  }
  [[nodiscard]] Surface surface(const SceneHit& hit) const {
    return surface_between(scene_->material(hit.material), r_.surface());
  }
  /// Velocity with which a conveyor's surface runs over its thing, as far as constraints of motion leave it [m/s].
  [[nodiscard]] Vec3d runs(const SceneHit& hit, double passed) const {
    const Vec3d v = scene_->conveyor_velocity(hit.instance, hit.normal, r_.scene_time() + passed);
    return v == Vec3d{} ? v : r_.kept(v);
  }
  /// Velocity of the surface that rubs [m/s].
  [[nodiscard]] Vec3d running(const SceneHit& hit, double passed) const {
    const Vec3d over = runs(hit, passed);
    return over == Vec3d{} ? hit.velocity : hit.velocity + over;
  }
  /// The slip that rounding leaves to a ball that rolls [m/s].
  [[nodiscard]] double no_slip(const BallMotion& motion, const SceneHit& hit) const {
    return max(1e-9, 2 * epsilon() * (length(motion.velocity) + length(hit.velocity)));
  }
  /// A way along a plane surface.
  [[nodiscard]] BallWay ball_way(const BallMotion& motion, const Pull& a, const SceneHit& hit, const Surface& on,
                                 const Vec3d& over, double time) const {
    const BallGrip grip{on.friction, on.rolling_resistance, no_slip(motion, hit)};
    BallWay way = way_on(
        motion, over, [&](const BallMotion& from) { return slid_or_rolled(from, a, hit.normal, ball(), grip, time); });
    way.way = r_.kept(way.way);
    way.motion.velocity = r_.kept(way.motion.velocity);
    return way;
  }
  /// The motion over `time` relative to the surface, along which it slides as a point or rolls as a ball.
  [[nodiscard]] BallWay way_along(const SceneHit& hit, const BallMotion& motion, const Vec3d& over, const Pull& pull,
                                  double time) const {
    return is_ball() ? ball_way(motion, pull, hit, surface(hit), over, time)
                     : point_way(motion, over, pull, hit.normal, surface(hit), time);
  }
  /// The mean acceleration over `time` relative to the thing, with drag and, on a thing that turns, inertial forces.
  [[nodiscard]] Pull pull_on(const State<double>& s, const SceneHit& hit, const BallMotion& motion, const Vec3d& a,
                             double passed, double time) const {
    const Vec3d over = runs(hit, passed), w = s.v - hit.velocity - over, v_t = w - hit.normal * dot(w, hit.normal);
    const auto way = [&](const Pull& pull) { return way_along(hit, motion, over, pull, time); };
    const auto pulls = [&](const Vec3d& on_it) {
      return pull_along(r_, on_it, s, {v_t, hit.normal, passed, time},
                        [&](const Pull& pull) { return way(pull).motion.velocity - over; });
    };
    Pull pull = pulls(a);
    if (!moves(hit) || !(time > 0)) return pull;
    const SceneByMotion::Ride by = ride(hit, passed);
    constexpr int kRounds = 8;  // each brings it a hundred times nearer
    for (int round = 0; by.turns() && round < kRounds; ++round) {
      const BallWay it = way(pull);
      pull = pulls(by.by->seen_from_turning(*by.piece, on(hit, s.x, passed), a, motion.velocity,
                                            {over, it.way * (time / it.time), time}));
    }
    return pull;
  }
  /// Turns the motion at the end of a way with the surface of a thing that turns.
  PHYSIM_COLD void turn_with(const SceneHit& hit, const Vec3d& x, const Vec3d& over, double passed,
                             BallWay& way) const {
    const SceneByMotion::Ride by = ride(hit, passed);
    if (!by.turns()) return;
    way.motion = by.by->turned(*by.piece, on(hit, x, passed), way.motion, ball(), {over, way.way, way.time});
    way.motion.velocity = r_.kept(way.motion.velocity);
  }
  /// The moment at which a way meets `next`, if that moves or the way is carried by a thing.
  [[nodiscard]] PHYSIM_COLD EvenWay::Moment moment_met(const EvenWay& way, const SceneHit& carries,
                                                       const SceneHit& next, const Vec3d& over, double passed) const {
    const Carriage* by = ride(next, passed).by;
    if (!by) by = ride(carries, passed).by;
    return by ? by->moment_met(way, next, over) : way.steadily(next.part);  // an engine's motion is not known
  }

  ContactHost& r_;
  const Scene* scene_;
};

}  // namespace physim
