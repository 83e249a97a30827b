// A ball on a surface: it slides as long as it slips, then it rolls.
//
// What it models: a hard ball that is pressed onto a plane: Coulomb friction at the point of contact turns it until
// that
//   point does not slip any more; from then on it rolls, against a resistance in proportion to what presses it on.
// When to use it: balls of sports and billiards, round stones on slopes, over times in which the surface is plane.
// When it is wrong: bodies that are not round; surfaces that give way; a slip that turns much within the
//   time, as its direction is held; the spin about the normal is unchanged.
// Symbols: n unit normal towards the ball; v velocity along the surface [m/s]; w spin [rad/s]; r radius [m]; k moment
// of
//   inertia over m r^2 [-]; u slip of the point of contact [m/s]; a acceleration by everything but the surface, a_t
//   along it, over the time by drag as in model/contact.hpp, p = -a . n what presses the ball on, over its mass
//   [m/s^2]; mu friction, c rolling resistance [-].
// Equations: u = v - r w x n.  Sliding: dv/dt = a_t - mu p u/|u|, dw/dt = mu p / (k r) n x u/|u|, so that
//   du/dt = a_t - mu p (1 + 1/k) u/|u|.  Rolling (u = 0, w = n x v / r): dv/dt = (a_t - c p v/|v|) / (1 + k), as long
//   as the friction that this needs, k |a_t| / (1 + k), is below mu p. What constraints do not let turn does not roll:
//   it slides to rest, and friction holds it; 1/k above is T/k, as in model/ball_contact.hpp.
// Source: D. Kleppner, R. Kolenkow, An Introduction to Mechanics (2nd ed. 2014), ch. 7 (rolling and slipping bodies);
//   W. J. Stronge, Impact Mechanics (2000), sec. 3.2 (the friction of a slip).
#pragma once

#include "model/ball_contact.hpp"
#include "model/contact.hpp"

namespace physim {

/// What friction and rolling are like.
struct BallGrip {
  double friction;            // mu [-]
  double rolling_resistance;  // c [-]
  double no_slip = 1e-9;      // as velocities are rounded: what slips by no more rolls [m/s]
};

/// How a ball on a surface went on.
struct BallWay {
  double time;  // [s]
  Vec3d way;    // [m]
  BallMotion motion;
};

/// Motion of a ball on a surface for a time, or until it begins to roll. Its velocity is along the surface.
inline BallWay slid_or_rolled(const BallMotion& from, const Pull& by, const Vec3d& normal, const Ball& ball,
                              const BallGrip& grip, double time) {
  PHYSIM_ASSERT(time >= 0 && ball.radius > 0 && ball.inertia > 0);
  const Vec3d& a = by.moving;
  const double pressure = max(-dot(a, normal), 0.0);
  const Vec3d a_t = a - normal * dot(a, normal);
  const Vec3d u = from.velocity - cross(from.spin, normal) * ball.radius;
  const double slip = length(u);
  const double k = ball.inertia;
  // The part of the pull that makes the ball roll; friction holds the rest.
  const Vec3d a_roll = ball.is_free() ? a_t : cross(component_product(ball.turns, cross(normal, a_t)), normal);
  const double needed = ball.is_free() ? k / (1 + k) * length(a_t) : length(a_t - a_roll * (1 / (1 + k)));
  if (slip <= grip.no_slip && needed <= grip.friction * pressure) {
    const auto left_of = [&](const Vec3d& pull) { return ball.is_free() ? pull : pull - a_t + a_roll; };
    const Pull pulls(left_of(a) * (1 / (1 + k)), left_of(by.at_rest) * (1 / (1 + k)));
    const Rolled on = rolled(from.velocity, pulls, normal, {0, 0, grip.rolling_resistance}, time);
    const Vec3d about = cross(normal, on.velocity) * (1 / ball.radius) + normal * dot(from.spin, normal);
    return {time, on.way, {on.velocity, component_product(ball.turns, about)}};
  }
  const double pull = length(a_t);
  const Vec3d along = slip > grip.no_slip ? u * (1 / slip) : pull > 0 ? a_t * (1 / pull) : Vec3d{};
  const double friction = grip.friction * pressure;
  const Vec3d about = cross(normal, along);
  // Deceleration of the slip [m/s^2]. Without friction a slip of zero is no end: nothing makes the ball roll.
  const double ending = friction > 0 ? friction * (1 + ball.free_part(about) / k) - dot(a_t, along) : 0;
  const double taken = slip > grip.no_slip && ending > 0 ? min(time, slip / ending) : time;
  const Vec3d dv = a_t - along * friction;
  const Vec3d dw = component_product(ball.turns, about) * (friction / (k * ball.radius));
  return {
      taken, from.velocity * taken + dv * (0.5 * taken * taken), {from.velocity + dv * taken, from.spin + dw * taken}};
}

/// A motion along a surface that bends: where the surface has another normal, and what moves along it came there by
/// `way` from the plane on which it went on until then. It keeps its energy, as does what rolls.
inline BallMotion turned_about(const BallMotion& motion, const Vec3d& a, const Vec3d& way, const Vec3d& normal,
                               const Ball& ball) {
  PHYSIM_ASSERT(!(abs(length_squared(normal) - 1) > 1e-6) && ball.inertia > 0);
  const double before = length(motion.velocity);
  const Vec3d along = motion.velocity - normal * dot(motion.velocity, normal);
  if (!(length(along) > 0)) return motion;
  const bool rolls = length(motion.spin) * ball.radius > 0.5 * before;
  const double speed = sqrt(max(before * before + 2 * dot(a, way) / (rolls ? 1 + ball.inertia : 1), 0.0));
  return {along * (speed / length(along)), motion.spin * (speed / before)};
}

}  // namespace physim
