// What a contact knows of a projectile, of the thing that it touches, and of the ways along that thing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

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
  /// How long it may go on along what it touched [s].
  [[nodiscard]] double longest_way(double passed) const { return std::min(r_.step_length() - passed, kLongestPart); }
  [[nodiscard]] Ball ball() const { return {collision().radius, collision().inertia, r_.turns()}; }
  [[nodiscard]] Vec3d spin(double passed) const { return component_product(r_.turns(), r_.spin(passed)); }
  [[nodiscard]] bool is_ball() const { return collision().radius > 0; }
  [[nodiscard]] bool is_float32() const { return r_.precision() == Precision::float32; }
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
  [[nodiscard]] State<double> carried(const SceneHit& hit, const Vec3d& x, const Vec3d& along, double passed,
                                      double time) const {
    return carried_by(*scene_, hit.instance, x, along, r_.scene_time() + passed, time);
  }
  /// True if the thing moves; the motion of an engine's thing is not known ahead.
  [[nodiscard]] bool moves(const SceneHit& hit) const {
    return !is_engines(hit) && !SceneByMotion(*scene_).rests(hit.instance.index);
  }
  [[nodiscard]] static bool is_engines(const SceneHit& hit) { return hit.instance.generation == kEngineGeneration; }
  /// Mean acceleration by all effects but the contact, in the frame of the thing, over a time that follows [m/s^2].
  [[nodiscard]] Vec3d acceleration_on(const State<double>& s, const SceneHit& hit, double passed, double time) const {
    const Vec3d a = r_.acceleration_at(s, passed);
    if (!moves(hit) || !(time > 0)) return a;
    return a - (carried(hit, s.x, {}, passed, time).v - hit.velocity) * (1 / time);
  }
  /// Acceleration that presses the projectile onto a thing that carries it, some time later [m/s^2].
  [[nodiscard]] double pressure_on(const State<double>& s, const SceneHit& hit, double passed, double later) const {
    constexpr double kShort = 1e-5;  // [s]
    const double own = -dot(r_.acceleration_at(s, passed), hit.normal);
    if (!moves(hit)) return own;
    const Vec3d now = carried(hit, s.x, {}, passed, later).v, then = carried(hit, s.x, {}, passed, later + kShort).v;
    return own + dot(then - now, hit.normal) / kShort;
  }
  /// The part of the time that follows in which a moving thing presses the projectile on [s].
  [[nodiscard]] double pressed_for(const State<double>& s, const SceneHit& hit, double passed) const {
    const double longest = longest_way(passed);
    if (!moves(hit)) return longest;
    // A thing whose velocity jumps may press again later; the projectile has left it before.
    const Vec3d a = r_.acceleration_at(s, passed);
    const double own = -dot(a, hit.normal), rounding = 1e-9 * length(a);
    PHYSIM_ASSERT(!is_engines(hit));
    const auto presses = [&](double later) {
      const double ahead = dot(carried(hit, s.x, {}, passed, later).v - hit.velocity, hit.normal) + own * later;
      return pressure_on(s, hit, passed, later) >= -rounding && ahead >= -rounding * later;
    };
    if (presses(longest)) return longest;
    double pressed = 0, free = longest;
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (pressed + free);
      (presses(middle) ? pressed : free) = middle;
    }
    return free;
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
  /// A way along a plane surface.
  [[nodiscard]] BallWay ball_way(const BallMotion& motion, const Pull& a, const SceneHit& hit, const Surface& on,
                                 const Vec3d& over, double time) const {
    BallWay way = way_on(motion, over, [&](const BallMotion& from) {
      return slid_or_rolled(from, a, hit.normal, ball(), {on.friction, on.rolling_resistance}, time);
    });
    way.way = r_.kept(way.way);
    way.motion.velocity = r_.kept(way.motion.velocity);
    return way;
  }

  ContactHost& r_;
  const Scene* scene_;
};

}  // namespace physim
