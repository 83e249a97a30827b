// The laws of the shipped force generators.
//
// What it models: pushes and pulls on point masses that are no property of the projectile: a given force or
//   acceleration, drag towards a wind, springs and elastic ropes, a liquid, an attracting point, a blast, thrust.
// When to use it: on single projectiles or groups in motion `force`, for as long as they last. Gravity, air and wind of
//   the whole world are rungs of the fidelity and cheaper there.
// When it is wrong: springs and ropes have no mass and no waves. A liquid has no waves and no added mass (that of a
//   sphere is half its liquid: it bobs too fast) and is left and entered without a splash. The blast is a game's: no
//   shock wave, no shadow; real overpressure falls faster than linearly. Thrust takes no mass off the projectile.
//   Borders of boxes and blasts and corners of tables are corners of the force: steps that do not end there make an
//   error of first order, as large as force times step.
// Symbols: x position [m], v velocity [m/s], m mass [kg], F force [N]; u = v - w velocity relative to air or liquid
//   [m/s]; d = x - anchor, or from the other end [m], n = d / |d|; k stiffness [N/m], l rest length [m], c damping
//   [kg/s]; k1 [kg/s], k2 [kg/m]; rho density of the liquid [kg/m^3], V volume [m^3], g gravity [m/s^2], y_s height of
//   the surface, b half height of the body [m], s part of the volume under the surface [-]; mu = G M strength
//   [m^3/s^2], e softening [m], r distance to a centre [m], R radius of a blast [m], F0 its force at the centre [N].
// Equations:
//   drag       F = -(k1 + k2 |u|) u
//   spring     F = -(k (|d| - l) + c v_rel.n) n;  at |d| = 0 no direction is known: F = 0
//   rope       the same where |d| > l and it pulls, else F = 0: elastic and damper side by side, and no push
//   liquid     F = rho V g s up - c s v,  q = clamp((y_s - y) / (2 b) + 1/2, 0, 1);
//              a sphere, b = D/2: s = q^2 (3 - 2 q), the cap pi h^2 (3 b - h) / 3 of height h = 2 b q over 4/3 pi b^3;
//              an upright cylinder or box of half height b: s = q
//   attractor  F = -m mu d / (r^2 + e^2)^(3/2)
//   blast      F = F0 (1 - r / R) n for r < R;  at the very centre no direction is known: F = 0
//   thrust     F(t) on straight lines between the points of its table, from the first until before the last
// Source: I. Millington, Game Physics Engine Development (2010), sec. 5.2 (drag) and 6.2 (spring, bungee, buoyancy,
//   with the linear law of the box); R. Hooke, De Potentia Restitutiva (1678); Archimedes, On Floating Bodies, I,
//   prop. 5-7 (lift) and On the Sphere and Cylinder (cap); H. C. Plummer, MNRAS 71 (1911) 460 (softening). The blast is
//   ours.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "math/pack.hpp"
#include "math/vec3.hpp"
#include "model/body.hpp"
#include "physim/units.hpp"
#include "physim/world.hpp"

namespace physim {

/// [N]
[[nodiscard]] inline Vec3d drag_force(const LinearQuadraticDragForce& law, const Vec3d& v) {
  const Vec3d u = v - law.wind;
  return u * -(law.k1 + law.k2 * length(u));
}

/// The pull of a spring (any law with stiffness, rest_length and damping) on its end at d from the other, which moves
/// at v_rel relative to it [N].
template <class Law>
[[nodiscard]] Vec3d spring_force(const Law& law, const Vec3d& d, const Vec3d& v_rel) {
  const double now = length(d);
  if (now == 0) return {};
  const Vec3d n = d * (1 / now);
  return n * -(law.stiffness * (now - law.rest_length) + law.damping * dot(v_rel, n));
}

/// The pull of an elastic rope; d and v_rel as for springs [N]. Comparisons keep NaN as NaN, for the world to see.
[[nodiscard]] inline Vec3d bungee_force(const Bungee& law, const Vec3d& d, const Vec3d& v_rel) {
  const double now = length(d);
  if (now <= law.rest_length || now == 0) return {};
  const Vec3d n = d * (1 / now);
  const double pull = law.stiffness * (now - law.rest_length) + law.damping * dot(v_rel, n);
  return pull < 0 ? Vec3d{} : n * -pull;
}

/// Part of a body under the surface of a liquid [-], with its centre `below` the surface [m]. Half the height of a body
/// of 1e-323 m rounds to 0: it is a point.
[[nodiscard]] inline double submerged_box(double below, double half_height) {
  PHYSIM_ASSERT(half_height >= 0);
  if (half_height == 0) return below < 0 ? 0 : below >= 0 ? 1 : below;
  const double q = below / (2 * half_height) + 0.5;
  return q < 0 ? 0 : q > 1 ? 1 : q;
}
[[nodiscard]] inline double submerged_sphere(double below, double radius) {
  const double q = submerged_box(below, radius);
  return q * q * (3 - 2 * q);
}

/// Part of a projectile of a diameter that a liquid covers [-].
[[nodiscard]] inline double submerged(const Buoyancy& law, double diameter, const Vec3d& x) {
  const double below = law.surface - x.y;
  return law.depth > 0 ? submerged_box(below, law.depth) : submerged_sphere(below, diameter / 2);
}
/// On a projectile of a diameter [N].
[[nodiscard]] inline Vec3d buoyancy_force(const Buoyancy& law, double diameter, const State<double>& s) {
  constexpr double kSixthOfPi = 0.52359877559829887308;
  const double part = submerged(law, diameter, s.x);
  const double volume = law.volume > 0 ? law.volume : kSixthOfPi * diameter * diameter * diameter;
  return Vec3d{0, law.density * volume * law.gravity * part, 0} - s.v * (law.damping * part);
}

/// Without softening the very centre has no direction, and no force [N].
[[nodiscard]] inline Vec3d attractor_force(const PointAttractor& law, double mass, const Vec3d& x) {
  const Vec3d d = law.centre - x;
  const double square = length_squared(d) + law.softening * law.softening;
  if (square == 0) return {};
  return d * (1 / sqrt(square)) * (mass * (law.strength / square));
}

/// Borders belong to the box.
[[nodiscard]] inline bool is_inside(const WindZone& zone, const Vec3d& x) {
  return zone.low.x <= x.x && x.x <= zone.high.x && zone.low.y <= x.y && x.y <= zone.high.y && zone.low.z <= x.z &&
         x.z <= zone.high.z;
}

/// [N]
[[nodiscard]] inline Vec3d explosion_force(const Explosion& law, const Vec3d& x) {
  const Vec3d d = x - law.centre;
  const double r = length(d);
  if (r >= law.radius || r == 0) return {};
  return d * (law.force * (1 - r / law.radius) / r);
}

/// Thrust at a time [N]. The last point does not belong to the table: so an integrator that looks at the start of each
/// step gives a constant thrust for exactly its time.
[[nodiscard]] inline double thrust_at(std::span<const Thrust::Point> curve, double time) {
  const auto later = [](double t, const Thrust::Point& p) { return t < p.time; };
  const auto next = std::upper_bound(curve.begin(), curve.end(), time, later);
  if (next == curve.begin() || next == curve.end()) return 0;
  const Thrust::Point& from = *(next - 1);
  PHYSIM_ASSERT(from.time <= time && time < next->time);
  return from.force + (next->force - from.force) * ((time - from.time) / (next->time - from.time));
}

/// Unit vector that a thrust acts along [-]; none at rest where it follows the velocity.
[[nodiscard]] inline Vec3d thrust_direction(const Thrust& law, const Vec3d& v) {
  return normalized(law.direction == Vec3d{} ? v : law.direction);
}

// ------------------------------------------------------------------------------ laws that one projectile alone decides
// `p` is the projectile: position(), velocity() [m, m/s], mass() [kg], diameter() [m]. Springs between two, zones of
// wind, thrust by time and user functions know more (world/step/force_eval.cpp).

[[nodiscard]] Vec3d force_on(const ConstantForce& law, const auto&) { return law.force; }
[[nodiscard]] Vec3d force_on(const ConstantAcceleration& law, const auto& p) { return law.acceleration * p.mass(); }
[[nodiscard]] Vec3d force_on(const GravityForce& law, const auto& p) { return law.gravity * p.mass(); }
[[nodiscard]] Vec3d force_on(const LinearQuadraticDragForce& law, const auto& p) {
  return drag_force(law, p.velocity());
}
[[nodiscard]] Vec3d force_on(const AnchoredSpring& law, const auto& p) {
  return spring_force(law, p.position() - law.anchor, p.velocity());
}
[[nodiscard]] Vec3d force_on(const Buoyancy& law, const auto& p) {
  return buoyancy_force(law, p.diameter(), {p.position(), p.velocity()});
}
[[nodiscard]] Vec3d force_on(const PointAttractor& law, const auto& p) {
  return attractor_force(law, p.mass(), p.position());
}
[[nodiscard]] Vec3d force_on(const Explosion& law, const auto& p) { return explosion_force(law, p.position()); }

// Rates of the drag in them, times the mass [kg/s]: steps of order one are braked by it (model/ledger.hpp).
[[nodiscard]] double drag_rate_on(const LinearQuadraticDragForce& law, const auto& p) {
  return law.k1 + law.k2 * length(p.velocity() - law.wind);
}
[[nodiscard]] double drag_rate_on(const Buoyancy& law, const auto& p) {
  return law.damping * submerged(law, p.diameter(), p.position());
}
/// That of drag of a force F on what moves through air at a velocity u [kg/s].
[[nodiscard]] inline double drag_rate_of(const Vec3d& force, const Vec3d& u) {
  const double square = length_squared(u);
  return square > 0 ? max(-dot(force, u) / square, 0.0) : 0;
}

// ------------------------------------------------------------------------------------------------- the table of laws
/// Which values a member of a law may have.
enum class Limit {
  any,           // every number; a projectile, or none
  not_negative,  // 0 or more
  positive,      // more than 0
  infinite,      // every number, and infinities
  needed,        // a projectile
};

/// A member of a law: a setting, and a check.
template <auto kPointer>
struct LawMember {
  static constexpr auto pointer = kPointer;
  std::string_view name;  // as spelled
  std::string_view doc;   // one line
  Quantity quantity = Quantity::number;
  Limit limit = Limit::any;
  std::string_view hint = {};  // to whom a value is refused
};

/// A law: the name of its table in scenario files, and its members.
template <class... Member>
struct LawRow {
  std::string_view name;
  std::tuple<Member...> members;
};
template <class... Member>
constexpr LawRow<Member...> law_row(std::string_view name, const Member&... members) {
  return {name, {members...}};
}

namespace laws {
using Q = Quantity;
using enum Limit;
template <auto kPointer>
using M = LawMember<kPointer>;

// clang-format off
template <class Law>
constexpr M<&Law::stiffness> stiffness{"stiffness", "force for each metre of stretch", Q::stiffness, not_negative,
                                       "a spring pulls back when it is stretched"};
template <class Law>
constexpr M<&Law::rest_length> rest_length{"rest_length", "at which it is slack", Q::length, not_negative, "in m"};
constexpr std::string_view kFeedsEnergy = "negative damping would feed energy in";
template <class Law>
constexpr M<&Law::damping> damping{"damping", "of the rate at which its length changes", Q::linear_drag, not_negative,
                                   kFeedsEnergy};
constexpr std::string_view kDragFeedsEnergy = "negative drag would feed energy in";

/// The row of a law; what has none has no members either, and does not compile.
template <class Law>
inline constexpr auto row = nullptr;
template <> inline constexpr auto row<ConstantForce> = law_row("constant_force",
    M<&ConstantForce::force>{"force", "the force", Q::force});
template <> inline constexpr auto row<ConstantAcceleration> = law_row("constant_acceleration",
    M<&ConstantAcceleration::acceleration>{"acceleration", "of every mass", Q::acceleration});
template <> inline constexpr auto row<GravityForce> = law_row("gravity_force",
    M<&GravityForce::gravity>{"gravity", "proportional to mass, in any direction", Q::acceleration});
template <> inline constexpr auto row<LinearQuadraticDragForce> = law_row("linear_quadratic_drag_force",
    M<&LinearQuadraticDragForce::k1>{"k1", "linear part of -(k1 + k2 |u|) u", Q::linear_drag, not_negative,
                                     kDragFeedsEnergy},
    M<&LinearQuadraticDragForce::k2>{"k2", "quadratic part", Q::quadratic_drag, not_negative, kDragFeedsEnergy},
    M<&LinearQuadraticDragForce::wind>{"wind", "velocity that u is relative to", Q::speed});
template <> inline constexpr auto row<AnchoredSpring> = law_row("anchored_spring",
    M<&AnchoredSpring::anchor>{"anchor", "fixed end of the spring", Q::length},
    stiffness<AnchoredSpring>, rest_length<AnchoredSpring>, damping<AnchoredSpring>);
template <> inline constexpr auto row<Spring> = law_row("spring",
    M<&Spring::other>{"other", "name of the shot at its other end, which is fired once", Q::number, needed,
                      "a spring to a fixed point is an AnchoredSpring"},
    stiffness<Spring>, rest_length<Spring>, damping<Spring>);
template <> inline constexpr auto row<Bungee> = law_row("bungee",
    M<&Bungee::other>{"other", "name of the shot at its other end, which is fired once; empty: the anchor"},
    M<&Bungee::anchor>{"anchor", "fixed end of a spring that only pulls", Q::length},
    stiffness<Bungee>, rest_length<Bungee>, damping<Bungee>);
template <> inline constexpr auto row<Buoyancy> = law_row("buoyancy",
    M<&Buoyancy::surface>{"surface", "height of the liquid", Q::length},
    M<&Buoyancy::volume>{"volume", "of the projectile; 0: the sphere of its diameter", Q::volume, not_negative,
                         "0: that of a sphere"},
    M<&Buoyancy::depth>{"depth", "half the height of an upright cylinder; 0: a sphere", Q::length, not_negative,
                        "0: a sphere"},
    M<&Buoyancy::density>{"density", "of the liquid", Q::density, not_negative, "in kg/m^3"},
    M<&Buoyancy::damping>{"damping", "of the velocity in the liquid", Q::linear_drag, not_negative, kFeedsEnergy},
    M<&Buoyancy::gravity>{"gravity", "that weighs the liquid", Q::acceleration, not_negative, "its size, downwards"});
template <> inline constexpr auto row<PointAttractor> = law_row("point_attractor",
    M<&PointAttractor::centre>{"centre", "that it pulls to", Q::length},
    M<&PointAttractor::strength>{"strength", "G M of the attracting mass; negative: it repels", Q::attraction},
    M<&PointAttractor::softening>{"softening", "keeps the force finite near the centre", Q::length, not_negative,
                                  "in m"});
template <> inline constexpr auto row<WindZone> = law_row("wind_zone",
    M<&WindZone::velocity>{"velocity", "of the air in the box", Q::speed},
    M<&WindZone::low>{"low", "corner of the box; may be infinite", Q::length, infinite},
    M<&WindZone::high>{"high", "opposite corner", Q::length, infinite},
    M<&WindZone::density>{"density", "of its air", Q::density, not_negative, "in kg/m^3"});
template <> inline constexpr auto row<Explosion> = law_row("explosion",
    M<&Explosion::centre>{"centre", "of the blast", Q::length},
    M<&Explosion::force>{"force", "outwards at the centre, falling linearly to the radius", Q::force},
    M<&Explosion::radius>{"radius", "that it reaches to", Q::length, positive, "in m"});
template <> inline constexpr auto row<Thrust> = law_row("thrust",
    M<&Thrust::direction>{"direction", "of the thrust; zero: along the velocity"},
    M<&Thrust::curve>{"curve", "thrust by time, straight lines between; nothing before and after"});
/// No file can hold a function.
template <> inline constexpr auto row<CustomForce> = law_row("custom_force", M<&CustomForce::function>{"function", ""});
// clang-format on
}  // namespace laws

/// The row of a law.
template <class Law>
inline constexpr const auto& kLaw = laws::row<Law>;

/// Calls f with each member of a law. Members stand side by side, so that a forgotten one shows in the size.
template <class Law, class F>
constexpr void for_each_member(const F& f) {
  std::apply(
      [&](const auto&... member) {
        static_assert((sizeof(std::declval<Law>().*member.pointer) + ...) == sizeof(Law), "a member is not in the row");
        (f(member), ...);
      },
      kLaw<Law>.members);
}

/// Calls f with a null pointer to each law that can be had.
constexpr void for_each_law(const auto& f) {
  [&]<class... Law>(const std::variant<Law...>*) {
    (f(static_cast<const Law*>(nullptr)), ...);
  }(static_cast<const ForceLaw*>(nullptr));
}

/// The other end of a law between two; null for other laws.
template <class AnyLaw>  // a ForceLaw, const or not
[[nodiscard]] auto* other_end_of(AnyLaw& law) {
  using Id = std::conditional_t<std::is_const_v<AnyLaw>, const ProjectileId, ProjectileId>;
  return std::visit(
      [](auto& each) -> Id* {
        if constexpr (requires { each.other; }) return &each.other;
        return nullptr;
      },
      law);
}
/// Whether a law needs a projectile at its other end.
[[nodiscard]] inline bool needs_other_end(const ForceLaw& law) {
  bool needs = false;
  std::visit(
      [&]<class Law>(const Law&) { for_each_member<Law>([&](const auto& m) { needs |= m.limit == Limit::needed; }); },
      law);
  return needs;
}

}  // namespace physim
