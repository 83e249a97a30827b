// Contact of two balls: what it does to their velocities and spins.
//
// What it models: the impulse that two hard balls give each other where they touch: restitution along the line of their
//   middles; along the surfaces they slide through the whole contact against Coulomb friction, or grip before its end
//   and have no slip left. Momentum stays, and so does the angular momentum of both; friction and e < 1 take energy.
// When to use it: balls of sports and billiards, round shot, debris that meets debris.
// When it is wrong: bodies that are not round; restitution of real balls falls with speed, and friction between them
//   with slip. A row of balls that touch is taken as one of hard balls that stand a little apart: impulses run along
//   it.
// Symbols: a, b the two; n unit normal from b to a; v velocity before, v' after [m/s]; w spin [rad/s]; r radius [m];
//   M = 1/m a diagonal matrix of inverse mass along the axes, 0 along those on which it cannot move [1/kg]; I moment of
//   inertia [kg m^2]; e restitution, mu friction [-]; v_n = (v_a - v_b) . n < 0; u slip of the surfaces [m/s]; J
//   impulse along n, T along the slip [N s].
// Equations: u = v_a - v_b - v_n n - (r_a w_a + r_b w_b) x n;  t = u / |u|;
//   J = -(1 + e) v_n / (n . (M_a + M_b) n);  T = min(mu J, |u| / (t . (M_a + M_b) t + r_a^2/I_a + r_b^2/I_b));
//   P = J n - T t;  v_a' = v_a + M_a P, v_b' = v_b - M_b P;  w_a' = w_a + (r_a T / I_a) n x t, w_b' likewise.
//   Contacts at one moment share their impulses: all J >= 0 and v_n' >= -e v_n, one of the two an equality, and T as
//   above by the motion that all others leave.
// Source: W. J. Stronge, Impact Mechanics (2000), ch. 3 and 4 (collinear impact of two bodies, friction that slides or
//   stops sliding); R. Cross, "Grip-slip behavior of a bouncing ball", Am. J. Phys. 70 (2002) 1093-1102: b without end.
#pragma once

#include <span>
#include <vector>

#include "base/assert.hpp"
#include "math/pack.hpp"
#include "math/vec3.hpp"
#include "model/ball_contact.hpp"

namespace physim {

/// One of two that touch.
struct PairBody {
  Vec3d velocity;                 // v [m/s]
  Vec3d spin;                     // w [rad/s]
  Vec3d mobility;                 // M, its diagonal [1/kg]
  double radius = 0;              // r [m]
  double turnability = 0;         // 1/I [1/(kg m^2)]
  Vec3d turns = {1.0, 1.0, 1.0};  // as of a Ball [-]

  /// 1/I about an axis.
  [[nodiscard]] double turned_by(const Vec3d& axis) const {
    return turnability * Ball{radius, 1, turns}.free_part(axis);
  }
};

struct PairSurface {
  double restitution;  // e [-]
  double friction;     // mu [-]
};

/// Motion of both after a contact in which they approach along the normal, which points from b to a.
inline void meet(PairBody& a, PairBody& b, const Vec3d& normal, const PairSurface& surface) {
  PHYSIM_ASSERT(!(abs(length_squared(normal) - 1) > 1e-6));
  const Vec3d mobility = a.mobility + b.mobility;
  const auto given_way = [&](const Vec3d& along) { return dot(component_product(mobility, along), along); };
  if (!(given_way(normal) > 0)) return;  // nothing moves either of them there
  const Vec3d relative = a.velocity - b.velocity;
  const double v_n = dot(relative, normal);
  PHYSIM_ASSERT(!(v_n > 0));
  const double J = -(1 + surface.restitution) * v_n / given_way(normal);
  Vec3d impulse = normal * J;
  const Vec3d u = relative - normal * v_n - cross(a.spin * a.radius + b.spin * b.radius, normal);
  const double slip = length(u);
  if (surface.friction > 0 && slip > 0) {
    const Vec3d t = u * (1 / slip);
    const Vec3d about = cross(normal, t);
    const double turned = a.radius * a.radius * a.turned_by(about) + b.radius * b.radius * b.turned_by(about);
    const double give = given_way(t) + turned;
    const double T = give > 0 ? min(surface.friction * J, slip / give) : 0.0;
    impulse -= t * T;
    a.spin += component_product(a.turns, about) * (a.radius * T * a.turnability);
    b.spin += component_product(b.turns, about) * (b.radius * T * b.turnability);
  }
  a.velocity += component_product(a.mobility, impulse);
  b.velocity -= component_product(b.mobility, impulse);
}

/// Two of the bodies that meet at one moment.
struct PairTouch {
  PairBody& a;
  PairBody& b;
  Vec3d normal;  // from b to a
  PairSurface surface;
};

namespace detail {

/// The impulses of a touch so far.
struct TouchImpulse {
  double before;     // v_n [m/s]
  double along = 0;  // J [N s]
  Vec3d across{};    // along the surfaces [N s]
};

/// Brings one touch to its equations by the motion that the others leave; returns by how much that changed [m/s].
inline double settle(const PairTouch& t, TouchImpulse& given) {
  const auto [a, b, n, surface] = t;
  const Vec3d mobility = a.mobility + b.mobility;
  const auto given_way = [&](const Vec3d& along) { return dot(component_product(mobility, along), along); };
  const auto push = [&](const Vec3d& impulse) {
    a.velocity += component_product(a.mobility, impulse);
    b.velocity -= component_product(b.mobility, impulse);
  };
  const double give = given_way(n);
  if (!(give > 0)) return 0;
  const double asked = given.along - (dot(a.velocity - b.velocity, n) + surface.restitution * given.before) / give;
  const double more = max(0.0, asked) - given.along;
  given.along += more;
  PHYSIM_ASSERT(!(given.along < 0));
  push(n * more);
  double change = abs(more) * give;
  if (!(surface.friction > 0)) return change;
  const Vec3d relative = a.velocity - b.velocity;
  const Vec3d u = relative - n * dot(relative, n) - cross(a.spin * a.radius + b.spin * b.radius, n);
  const double slip = length(u);
  if (!(slip > 0)) return change;
  const Vec3d about = cross(n, u * (1 / slip));
  const double turned = a.radius * a.radius * a.turned_by(about) + b.radius * b.radius * b.turned_by(about);
  const double gives = given_way(u * (1 / slip)) + turned;
  if (!(gives > 0)) return change;
  Vec3d across = given.across - u * (1 / gives);
  const double most = surface.friction * given.along, length_across = length(across);
  if (length_across > most) across *= most / length_across;
  const Vec3d rub = across - given.across;
  given.across = across;
  push(rub);
  const Vec3d turn = cross(n, rub);
  a.spin -= component_product(a.turns, turn) * (a.radius * a.turnability);
  b.spin -= component_product(b.turns, turn) * (b.radius * b.turnability);
  return change + length(rub) * gives;
}

}  // namespace detail

/// Motion of all after contacts at one moment, in each of which two approach.
inline void meet(std::span<const PairTouch> touches) {
  if (touches.size() == 1) return meet(touches[0].a, touches[0].b, touches[0].normal, touches[0].surface);
  std::vector<detail::TouchImpulse> given;
  double fastest = 0;
  for (const PairTouch& t : touches) {
    given.push_back({dot(t.a.velocity - t.b.velocity, t.normal)});
    fastest = max(fastest, -given.back().before);
  }
  constexpr int kMostPasses = 1000;
  constexpr double kRounding = 1e-15;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    double change = 0;
    for (std::size_t i = 0; i < touches.size(); ++i) change = max(change, detail::settle(touches[i], given[i]));
    if (change <= kRounding * fastest) return;
  }
}

}  // namespace physim
