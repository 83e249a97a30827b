// Contact of a ball that spins: what a bounce does to its velocity and to its spin.
//
// What it models: the impulse of a hard surface on a ball at one point: restitution along the normal; along the surface
//   the ball slides through the whole bounce against Coulomb friction, or grips before its end and then has no slip
//   left, or some of it turned around.
// When to use it: balls of sports, billiards, superballs, round shot on hard ground.
// When it is wrong: bodies that are not round; surfaces that give way (clay, grass), where the force acts ahead of the
//   middle; restitution and the grip of real balls change with speed. The spin about the normal is unchanged.
//   A ball that nothing spins, with inertia without end and grip 0, is the point of model/contact.hpp, the ground's.
// Symbols: n unit normal towards the ball; v velocity and w angular velocity before, v' and w' after [m/s, rad/s]; r
//   radius [m]; k moment of inertia over m r^2 [-]; T part of the turn about n x u that constraints leave, 1 without
//   any [-]; e restitution, mu friction, g restitution of grip [-]; v_n = v . n
//   < 0; u slip: velocity of the ball's surface along the wall [m/s]; J impulse over mass along the surface [m/s].
// Equations: u = v - v_n n - r w x n;  J = min(mu (1 + e) |v_n|, (1 + g) |u| k / (T + k)): sliding, or gripping;
//   v' = v - (1 + e) v_n n - J u/|u|;  w' = w + J / (k r) n x u/|u|.  Gripping leaves the slip -g u.
// Source: R. L. Garwin, "Kinematics of an ultraelastic rough ball", Am. J. Phys. 37 (1969) 88-92 (g = 1); R. Cross,
//   "Grip-slip behavior of a bouncing ball", Am. J. Phys. 70 (2002) 1093-1102 (sliding, and gripping with any g).
#pragma once

#include "base/assert.hpp"
#include "math/pack.hpp"
#include "math/vec3.hpp"

namespace physim {

struct BallSurface {
  double restitution;       // e [-]
  double friction;          // mu [-]
  double grip_restitution;  // g [-]
};

struct Ball {
  double radius;                  // r [m]
  double inertia;                 // k [-]
  Vec3d turns = {1.0, 1.0, 1.0};  // along the axes of W: 1 where it turns about one, 0 where it does not [-]

  [[nodiscard]] bool is_free() const { return turns == Vec3d{1.0, 1.0, 1.0}; }
  /// T, the part of a turn about an axis that constraints leave [-].
  [[nodiscard]] double free_part(const Vec3d& axis) const {
    return is_free() ? 1.0 : dot(component_product(turns, axis), axis);
  }
};

struct BallMotion {
  Vec3d velocity;
  Vec3d spin;
};

/// Motion after a bounce of a ball that moves towards the surface.
inline BallMotion bounced(const BallMotion& before, const Vec3d& normal, const Ball& ball, const BallSurface& surface) {
  PHYSIM_ASSERT(!(abs(length_squared(normal) - 1) > 1e-6) && ball.radius > 0 && ball.inertia > 0);
  const double v_n = dot(before.velocity, normal);
  PHYSIM_ASSERT(!(v_n > 0));
  const Vec3d u = before.velocity - normal * v_n - cross(before.spin, normal) * ball.radius;
  const double slip = length(u);
  const double sliding = surface.friction * (1 + surface.restitution) * abs(v_n);
  const Vec3d along = slip > 0 ? u * (1 / slip) : Vec3d{}, about = cross(normal, along);
  const double gripping =
      (1 + surface.grip_restitution) * slip * (ball.inertia / (ball.free_part(about) + ball.inertia));
  const double impulse = min(sliding, gripping);
  return {before.velocity - normal * ((1 + surface.restitution) * v_n) - along * impulse,
          before.spin + component_product(ball.turns, about) * (impulse / (ball.inertia * ball.radius))};
}

}  // namespace physim
