// Contact of two balls: what it does to their velocities and spins.
//
// What it models: the impulse that two hard balls give each other where they touch: restitution along the line of their
//   middles; along the surfaces they slide through the whole contact against Coulomb friction, or grip before its end
//   and have no slip left. Momentum stays, and so does the angular momentum of both; friction and e < 1 take energy.
// When to use it: balls of sports and billiards, round shot, debris that meets debris.
// When it is wrong: bodies that are not round; restitution of real balls falls with speed, and friction between them
//   with slip. Balls of a row that touch are hard balls a little apart: impulses run along the row. Contacts at one
//   moment are smooth if restitution and friction of several would give energy, or have no common solution.
// Symbols: a, b the two; n unit normal from b to a; v velocity before, v' after [m/s]; w spin [rad/s]; r radius [m];
//   M = 1/m a diagonal matrix of inverse mass along the axes, 0 along those on which it cannot move [1/kg]; I moment of
//   inertia [kg m^2]; e restitution, mu friction [-]; v_n = (v_a - v_b) . n < 0; u slip of the surfaces [m/s]; J
//   impulse along n, T along the slip [N s].
// Equations: u = v_a - v_b - v_n n - (r_a w_a + r_b w_b) x n;  t = u / |u|;
//   J = -(1 + e) v_n / (n . (M_a + M_b) n);  T = min(mu J, |u| / (t . (M_a + M_b) t + r_a^2/I_a + r_b^2/I_b));
//   P = J n - T t;  v_a' = v_a + M_a P, v_b' = v_b - M_b P;  w_a' = w_a + (r_a T / I_a) n x t, w_b' likewise.
//   Where axes are frozen J and T, a vector then, are found together: v_n' = -e v_n, and no slip is left, or |T| = mu J
//   against the slip that is left.
//   Contacts at one moment share their impulses: all J >= 0 and v_n' >= -e v_n, one of the two an equality, and T as
//   above by the motion that all others leave.
// Source: W. J. Stronge, Impact Mechanics (2000), ch. 3 and 4 (collinear impact of two bodies, friction that slides or
//   stops sliding); R. Cross, "Grip-slip behavior of a bouncing ball", Am. J. Phys. 70 (2002) 1093-1102: b without end.
#pragma once

#include <limits>
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

/// Two of the bodies that meet at one moment.
struct PairTouch {
  PairBody& a;
  PairBody& b;
  Vec3d normal;  // from b to a
  PairSurface surface;
};

namespace detail {

/// Velocity of a's surface over b's where they touch.
[[nodiscard]] inline Vec3d slide(const PairTouch& t) {
  return t.a.velocity - t.b.velocity - cross(t.a.spin * t.a.radius + t.b.spin * t.b.radius, t.normal);
}

/// The impulses of a touch so far.
struct TouchImpulse {
  Vec3d before;      // slide() before the contact [m/s]
  double along = 0;  // J [N s]
  Vec3d across{};    // -T t [N s]
};

/// Brings one touch to its equations by the motion that the others leave, with or without friction; returns the
/// change of velocity [m/s].
inline double settle(const PairTouch& t, TouchImpulse& given, bool rubs) {
  PairBody &a = t.a, &b = t.b;
  const Vec3d n = t.normal;
  const Vec3d mobility = a.mobility + b.mobility;
  const auto give_along = [&](const Vec3d& way) { return dot(component_product(mobility, way), way); };
  const auto push = [&](const Vec3d& impulse) {
    a.velocity += component_product(a.mobility, impulse);
    b.velocity -= component_product(b.mobility, impulse);
  };
  const double give = give_along(n);
  if (!(give > 0)) return 0;  // nothing moves either of them there
  const double asked = -t.surface.restitution * dot(given.before, n) - dot(a.velocity - b.velocity, n);
  const double more = max(asked / give, -given.along);
  given.along += more;
  PHYSIM_ASSERT(!(given.along < 0));
  push(n * more);
  const double change = abs(more) * give;
  const Vec3d w = slide(t), u = w - n * dot(w, n);
  const double slip = length(u);
  if (!(rubs && t.surface.friction > 0 && slip > 0)) return change;
  const Vec3d about = cross(n, u * (1 / slip));
  const double turned = a.radius * a.radius * a.turned_by(about) + b.radius * b.radius * b.turned_by(about);
  const double gives = give_along(u * (1 / slip)) + turned;
  if (!(gives > 0)) return change;
  Vec3d across = given.across - u * (1 / gives);
  const double most = t.surface.friction * given.along, asked_across = length(across);
  if (asked_across > most) across *= most / asked_across;
  const Vec3d rub = across - given.across;
  given.across = across;
  push(rub);
  a.spin -= component_product(a.turns, cross(n, rub)) * (a.radius * a.turnability);
  b.spin -= component_product(b.turns, cross(n, rub)) * (b.radius * b.turnability);
  return change + length(rub) * gives;
}

/// Brings all touches to their equations together; returns the energy that the impulses give [J], infinity if the
/// equations have no solution that is found.
inline double settle_all(std::span<const PairTouch> touches, bool rubs) {
  std::vector<TouchImpulse> given;
  double fastest = 0;
  for (const PairTouch& t : touches) {
    PHYSIM_ASSERT(!(abs(length_squared(t.normal) - 1) > 1e-6));
    given.push_back({slide(t)});
    fastest = max(fastest, -dot(given.back().before, t.normal));
  }
  constexpr int kMostPasses = 1000;
  constexpr double kRounding = 1e-15, kSolved = 1e-12;
  double change = 1;
  for (int pass = 0; pass < kMostPasses && change > kRounding * fastest; ++pass) {
    change = 0;
    for (std::size_t i = 0; i < touches.size(); ++i) change = max(change, settle(touches[i], given[i], rubs));
  }
  if (!(change <= kSolved * fastest)) return std::numeric_limits<double>::infinity();
  double energy = 0;
  for (std::size_t i = 0; i < touches.size(); ++i)
    energy += 0.5 * dot(touches[i].normal * given[i].along + given[i].across, given[i].before + slide(touches[i]));
  return energy;
}

}  // namespace detail

/// Motion of all after contacts at one moment, in each of which two approach. Contacts are smooth if friction of
/// several would give energy, as Newton's restitution lets it, or has no solution together with the others.
inline void meet(std::span<const PairTouch> touches) {
  std::vector<PairBody> before;
  for (const PairTouch& t : touches) before.insert(before.end(), {t.a, t.b});
  if (detail::settle_all(touches, true) <= 0 || touches.size() == 1) return;
  for (std::size_t i = 0; i < touches.size(); ++i) touches[i].a = before[2 * i], touches[i].b = before[2 * i + 1];
  detail::settle_all(touches, false);
}

}  // namespace physim
