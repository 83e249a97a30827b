// Contact of what flies in a world with its ground: what the ground and the projectile let follow.
//
// The flying object is a Host, as for things of a scene (collide/scene_contact.hpp). Of it the ground uses
// surface(), step_length(), acceleration_at() and tell(), and for
//   conditions()                        of its motion: they know where up is
#pragma once

#include <algorithm>

#include "collide/scene_contact.hpp"
#include "flight/step_parts.hpp"
#include "model/contact.hpp"
#include "physim/body.hpp"

namespace physim {

[[nodiscard]] inline GroundBelow ground_below(const Conditions<double>& c, const Ground& ground, const Vec3d& x) {
  if (ground.mode == GroundMode::none) return {};
  return {height(c, x) - ground.height, vertical_at(c, x), &ground};
}

/// The contacts of one step.
template <class Host>
class GroundContacts {
 public:
  GroundContacts(Host& host, const Ground& ground, StepParts& parts) : r_(host), ground_(ground), parts_(parts) {}

  /// What a contact leads to.
  enum class Then { flies_on, rolls, lies, sticks, stops };
  struct After {
    Then then;
    State<double> state;
    State<double> rolled{};  // at the end of the step, straight over the ground
  };

  /// Which way is up.
  [[nodiscard]] Vec3d up_at(const Vec3d& x) const {
    return is_round(r_.conditions().fidelity.earth) ? vertical_at(r_.conditions(), x) : Vec3d{0, 1, 0};
  }
  /// Straight up or down to the ground.
  [[nodiscard]] Vec3d put_on(const Vec3d& x) const { return x - up_at(x) * (height_at(x) - ground_.height); }

  /// Where a step begins: on the ground or below it, and not on its way up.
  [[nodiscard]] bool is_met_at_start(const State<double>& s) const {
    if (ground_.mode == GroundMode::none || height_at(s.x) > ground_.height) return false;
    const double climb = climb_rate(r_.conditions(), s);
    return climb < 0 || (climb == 0 && dot(r_.acceleration_at(s, 0), up_at(s.x)) < 0);
  }
  /// Where a contact with something else left it: that the ground bounces it as well.
  [[nodiscard]] bool is_met_too(const State<double>& s) const {
    return ground_.mode == GroundMode::bounce && height_at(s.x) <= ground_.height &&
           climb_rate(r_.conditions(), s) <= 0;
  }
  /// What was pressed into the ground by a thing lies on the ground.
  [[nodiscard]] State<double> lying(State<double> s) const {
    if (!is_met_too(s)) return s;
    const Vec3d n = up_at(s.x);
    return {put_on(s.x), s.v - n * dot(s.v, n)};
  }

  /// What follows from coming to the ground, `passed` into the step.
  [[nodiscard]] After struck(const State<double>& s, const Vec3d& n, double passed) {
    if (ground_.mode != GroundMode::bounce) {
      r_.tell(EventKind::landed, Reason::none, passed, s);
      return {ground_.mode == GroundMode::stick ? Then::sticks : Then::stops, s};
    }
    parts_.come_near(passed);
    const Surface on = surface_between(ground_, r_.surface());
    const double frame = frame_of_contact(r_.step_length());
    const Vec3d runs = conveyor_along(ground_, n);
    const Vec3d v = runs == Vec3d{} ? bounced(s.v, n, on) : bounced(s.v - runs, n, on) + runs;
    const Vec3d along = v - n * dot(v, n);
    const Vec3d a = r_.acceleration_at(s, passed);
    if (lifts_off(dot(v, n), dot(a, n), frame) && parts_.may_bounce()) {
      r_.tell(EventKind::bounced, Reason::none, passed, {s.x, v});
      return {Then::flies_on, {s.x, v}};
    }
    if (dot(a, n) > 0)  // something lifts it
      return {parts_.may_bounce() ? Then::flies_on : Then::lies, {s.x, along}};
    if (is_strike(dot(s.v, n), dot(a, n), frame)) r_.tell(EventKind::bounced, Reason::none, passed, {s.x, along});
    const double left = r_.step_length() - passed;
    const auto rolls = [&](const Pull& pull) { return rolled(v - runs, pull, n, on, left); };
    Rolled on_it = rolls(pull_along(r_, a, {s.x, along}, {along - runs, n, passed, left},
                                    [&](const Pull& pull) { return rolls(pull).velocity; }));
    if (runs != Vec3d{}) on_it = {on_it.way + runs * left, on_it.velocity + runs}, carried_ = true;
    return {Then::rolls, {s.x, along}, {put_on(s.x + on_it.way), on_it.velocity}};
  }
  /// It lies on ground that runs: it has no rest.
  [[nodiscard]] bool is_carried() const { return carried_; }

 private:
  [[nodiscard]] double height_at(const Vec3d& x) const { return height(r_.conditions(), x); }

  Host& r_;
  const Ground& ground_;
  StepParts& parts_;
  bool carried_ = false;
};

}  // namespace physim
