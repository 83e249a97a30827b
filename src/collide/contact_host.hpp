// The interface by which contacts with things of a scene read and change a projectile: rows of worlds and lanes of
// flights implement it.
#pragma once

#include <limits>

#include "collide/contact_rules.hpp"
#include "math/vec3.hpp"
#include "model/body.hpp"
#include "physim/event.hpp"
#include "physim/scene.hpp"

namespace physim {

/// The ground below a place.
struct GroundBelow {
  double height =
      std::numeric_limits<double>::infinity();  // of the place above the ground; infinite without a ground [m]
  Vec3d up{};                                   // [-]
  const Ground* ground = nullptr;               // null without one
};

/// A projectile in its step, as contacts see it. `passed`: time since the step began [s].
class ContactHost {
 public:
  /// The scene; null if the projectile meets nothing.
  [[nodiscard]] virtual const Scene* scene() const = 0;
  /// The precision of the projectile's state.
  [[nodiscard]] virtual Precision precision() const = 0;
  [[nodiscard]] virtual const CollisionDef& collision() const = 0;
  /// The projectile's restitution and friction, how both are combined, and its rolling resistance [-].
  [[nodiscard]] virtual OwnSurface surface() const = 0;
  /// 1 along the axes of W about which the projectile turns, 0 along others, as Ball::turns [-].
  [[nodiscard]] virtual Vec3d turns() const = 0;
  /// Time of the scene at the start of the step [s].
  [[nodiscard]] virtual double scene_time() const = 0;
  /// Length of the step [s].
  [[nodiscard]] virtual double step_length() const = 0;
  /// Angular velocity in W [rad/s].
  [[nodiscard]] virtual Vec3d spin(double passed) const = 0;
  virtual void put_spin(const Vec3d& spin, double passed) = 0;
  /// Acceleration by all effects but the contact [m/s^2].
  [[nodiscard]] virtual Vec3d acceleration_at(const State<double>& s, double passed) const = 0;
  /// The part of a vector that the constraints of motion leave.
  [[nodiscard]] virtual Vec3d kept(const Vec3d& v) const = 0;
  /// Mass, measures and random draws of an Impact, by the number of the hit in the step.
  [[nodiscard]] virtual Impact impact(int hits) const = 0;
  /// Takes an event; the host adds the projectile's id and the time to event_of().
  virtual void tell(EventKind kind, Reason reason, double passed, const State<double>& s, const SceneHit& hit = {},
                    double depth = 0, double energy = 0) = 0;
  /// Takes a way along a surface between two times of the step; a host without a path ignores it.
  virtual void slid(const State<double>&, double, const State<double>&, double) {}
  /// The ground that takes over what a thing brings down to it; flights end there by themselves.
  [[nodiscard]] virtual GroundBelow ground_below(const Vec3d&) const { return {}; }
  /// The answer to a hit of OnHit::ask; null if there is none yet.
  [[nodiscard]] virtual const HitAnswer* answer_to(HitQuestion&, double) const { return nullptr; }
  /// Keeps a hit without an answer; the step is flown again when there is one.
  virtual void leave_open(const HitQuestion&) {}

 protected:
  ~ContactHost() = default;
};

}  // namespace physim
