// Residual speed: what a projectile keeps that goes through a plate faster than its ballistic limit.
//
// What it models: the plate takes the energy that it takes at the limit, and a plug that is driven out ahead shares the
//   momentum of what is left; in the form of Lambert and Jonas, with any two numbers fitted to tests.
// When to use it: plates with a known ballistic limit, by test or by another model.
// When it is wrong: projectiles that break up; hypervelocity; the turn of the path by a plate that is met aslant.
// Symbols: v speed, v_l ballistic limit, v_r residual speed [m/s]; m mass, m_p mass of the plug [kg]; a, p [-].
// Equations: v_r = a (v^p - v_l^p)^(1/p) above the limit; Recht and Ipson: p = 2, a = m / (m + m_p), where sharp noses
//   drive out no plug (a = 1).
//   Met aslant, the part of the speed along the normal must reach the limit: v_l / cos of the obliquity.
// Source: R. F. Recht, T. W. Ipson, "Ballistic perforation dynamics", J. Appl. Mech. 30 (1963) 384-390; J. P. Lambert,
//   G. H. Jonas, "Towards standardization in terminal ballistics testing: velocity representation", BRL Report 1852
//   (1976).
#pragma once

#include "base/assert.hpp"
#include "math/elementary.hpp"

namespace physim {

/// v_r, of a speed not below the limit.
inline double residual_speed(double speed, double limit, double a, double p) {
  PHYSIM_ASSERT(speed >= limit && limit >= 0 && speed > 0 && a >= 0 && p >= 1);
  if (limit == 0) return a * speed;
  const double left = 1 - pow(limit / speed, p);
  return left > 0 ? a * speed * pow(left, 1 / p) : 0.0;
}

/// a of Recht and Ipson.
inline double plug_share(double mass, double plug_mass) {
  PHYSIM_ASSERT(mass > 0 && plug_mass >= 0);
  return mass / (mass + plug_mass);
}

}  // namespace physim
