// Motor: thrust and the mass that is left.
//
// What it models: a motor with a table of thrust over time, straight lines between its points; propellant that goes in
//   proportion to the impulse delivered (or by its own table); drag that differs while it burns.
// When to use it: rockets with a known thrust curve: certified model rocket motors, sounding rockets, boosters of
//   shells.
// When it is wrong: the rocket flies at zero angle of attack: its nose, and with it the thrust, points along
//   the velocity through the air, at once and always. Real rockets turn into the wind with a delay and swing about it,
//   most of all while they are slow; in gusts and just above the rail that is the largest error. Above the air there is
//   nothing to hold the nose to the path. Thrust is as measured at sea level: it does not rise as the air gets thin
//   (some 10 % more impulse in vacuum).
// Symbols: t time [s], s since the start of a piece of the table; F thrust [N]; m mass, m0 at launch, mp propellant
//   burned [kg]; I impulse delivered, It in all [N s]; u = v - w velocity through the air [m/s]; g
//   gravity, a acceleration [m/s^2].
// Equations: m = m0 - mp_total I(t) / It; a = g + (D + F u / |u|) / m, where every force that was divided by m0 is
//   divided by m; on each piece F = F0 + F1 s and so I = I0 + F0 s + F1 s^2 / 2, exactly.
//   On the launch rail (model/constraint.hpp) F points along it.
//   Specific impulse: It / (mp_total g0), g0 = 9.80665 m/s^2.
// Stops: F, I and the drag have corners at the table's points, at ignition, burnout and rail exit. Steps end there
//   (solve/stops.hpp), so that in each step a piece is smooth and integrators keep their order.
// Source: G. P. Sutton, O. Biblarz, Rocket Propulsion Elements, 8th ed. (2010), eq. 2-1 to 2-5 (impulse), 4-4 to 4-6
//   (flight; Tsiolkovsky's equation is their integral in vacuum without gravity).
#pragma once

#include "math/vec3.hpp"
#include "model/constraint.hpp"

PHYSIM_ISA_BEGIN

/// Time since the start of a body's piece [s]. Steps end with the piece; frames of bodies under generators may not.
template <class R>
PHYSIM_INLINE R time_in_piece(const Body<R>& b, const R& t) {
  return min(t, b.burn.end) - b.burn.start;
}

/// Mass [kg].
template <class R>
PHYSIM_INLINE R mass_at(const Body<R>& b, const R& t) {
  const R s = time_in_piece(b, t);
  return b.mass - (b.burn.burned + s * (b.burn.burn_rate + s * b.burn.burn_growth));
}

/// Thrust of the motor [N].
template <class R>
PHYSIM_INLINE R thrust_at(const Body<R>& b, const R& t) {
  return b.burn.thrust + time_in_piece(b, t) * b.burn.thrust_rate;
}

/// Where the nose of a point mass points, a unit vector: along the rail, then along the velocity through the air; where
/// that is zero, still along the rail [-].
template <class R>
PHYSIM_INLINE Vec3<R> nose_in_air(const Body<R>& b, const Vec3<R>& u) {
  using S = ScalarOf<R>;
  const R speed = length(u);
  const auto along_air = (b.rail_phase >= R(S(kOffRail))) & (speed > R(S(0)));
  const R per_speed = S(1) / select(along_air, speed, R(S(1)));
  return {select(along_air, u.x * per_speed, b.rail.x), select(along_air, u.y * per_speed, b.rail.y),
          select(along_air, u.z * per_speed, b.rail.z)};
}

PHYSIM_ISA_END
