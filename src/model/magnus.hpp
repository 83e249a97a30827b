// Magnus: lift and drag of balls that spin.
//
// What it models: a ball with a constant spin axis while the spin dies away; lift across spin and path, drag that
//   depends on the spin; both by a formula in the spin parameter or by a table in speed and spin.
// When to use it: golf balls, baseballs, footballs, tennis balls with measured coefficients.
// When it is wrong: coefficients hold for balls of one make in the range they were measured in; smooth balls have a
//   lift that turns round near the drag crisis; a ball that does not spin (a knuckle ball) feels forces of its seams
//   that are not here. Spin decays by the time, not by the air flown through.
// Symbols: u = v - w velocity through the air [m/s]; omega spin in W [rad/s]; r radius, A = pi r^2 [m, m^2]; m mass
//   [kg]; rho density [kg/m^3]; S = r |omega x u| / |u|^2 spin parameter [-]; Cd, Cl drag and lift coefficient [-]; tau
//   time in which the spin falls to 1/e [s].
// Equations: a_lift = rho A / (2 m) Cl |u|^2 (omega x u) / |omega x u|;  a_drag = -rho A / (2 m) Cd |u| u;
//   omega(t) = omega_0 e^(-t / tau).
//   Formula: Cl = l S / (b + c S), so that a_lift = rho A / (2 m) l r / (b + c S) omega x u: with c = 0 in air of one
//   density a = kappa x v, the path is a trochoid. Cd = Cd_0 + k |omega|.
//   Table: bilinear in |u| and the spin across the path |omega x u| / |u| (or S), held at its borders; below the lowest
//   spin the lift falls to zero with it.
// Source: P. W. Bearman, J. K. Harvey, "Golf ball aerodynamics", Aeronautical Quarterly 27 (1976) 112-122; A. M.
//   Nathan, "The effect of spin on the flight of a baseball", American Journal of Physics 76 (2008) 119-124 and his
//   trajectory calculator (the formula); R. D. Mehta, "Aerodynamics of sports balls", Annual Review of Fluid Mechanics
//   17 (1985).
#pragma once

#include "math/vec3.hpp"
#include "model/drag.hpp"
#include "model/magnus_grid.hpp"

PHYSIM_ISA_BEGIN

/// Accelerations by the air.
template <class R>
struct SpinningAir {
  Vec3<R> drag;
  Vec3<R> lift;
};

/// One lane after the other: a table in two numbers has no short way.
template <class R, class S>
PHYSIM_NOINLINE void table_coefficients(const Conditions<S>& c, const Body<R>& b, const R& speed, const R& spin,
                                        const R& parameter, R& drag, R& lift) {
  PHYSIM_ASSERT(c.magnus_grids != nullptr);
  for (int lane = 0; lane < kLanes<R>; ++lane) {
    const S table = lane_of(b.magnus_table, lane);
    if (table < S(0)) continue;
    const auto at = magnus_at(c.magnus_grids[static_cast<int>(table)], static_cast<double>(lane_of(speed, lane)),
                              static_cast<double>(lane_of(spin, lane)), static_cast<double>(lane_of(parameter, lane)));
    set_lane(drag, lane, static_cast<S>(at.drag));
    set_lane(lift, lane, static_cast<S>(at.lift));
  }
}

/// Spin in W [rad/s].
template <class R>
PHYSIM_INLINE Vec3<R> spin_at(const Body<R>& b, const R& t) {
  return b.spin * exp(-(b.spin_decay * t));
}

template <class R, class S>
PHYSIM_NOINLINE void spinning_air(const Conditions<S>& c, const Body<R>& b, const R& t, const State<R>& s,
                                  SpinningAir<R>& out) {
  const R zero(S(0));
  const Vec3<R> u = air_velocity(c, b, t, s);
  const AirState<R> air = air_state(c, b, s.x);
  const Vec3<R> omega = spin_at(b, t);
  const Vec3<R> across = cross(omega, u);
  const R speed = length(u);
  const R tiny = constant<R>(1e-30);
  const R side = length(across);
  const R parameter = b.ball_radius * side / max(speed * speed, tiny);
  const R area = air.density * b.magnus_area;
  R lift = area * b.lift * b.ball_radius / (b.lift_base + b.lift_saturation * parameter);  // times omega x u
  const bool equation = c.fidelity.drag == DragModel::equation;
  Vec3<R> drag = equation ? drag_equation(c, b, air, u) : simple_drag(c, b, u);
  drag -= u * (area * speed * (b.drag_per_spin * length(omega)));
  if (c.has_magnus_tables) {
    R cd = zero, cl = zero;
    table_coefficients(c, b, speed, side / max(speed, tiny), parameter, cd, cl);
    const auto by_table = b.magnus_table >= zero;
    lift = select(by_table, area * cl * speed * speed / max(side, tiny), lift);
    const R braking = -(area * speed * cd);
    drag = {select(by_table, u.x * braking, drag.x), select(by_table, u.y * braking, drag.y),
            select(by_table, u.z * braking, drag.z)};
  }
  out = {drag, across * lift};
}

PHYSIM_ISA_END
