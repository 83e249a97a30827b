// The nose of a projectile: how much of the inertia of a material it meets.
//
// What it models: the part of the pressure by the speed, which grows with the square of the velocity's part along the
//   surface's normal, that a nose meets: 1 flat, 1/2 a hemisphere, less the sharper.
// When to use it: rigid projectiles that go in nose ahead.
// When it is wrong: noses that flatten or erode; friction along the nose; cones (an ogive as long meets less).
// Symbols: h length of the nose over the diameter [-]; psi radius of its profile over the diameter (an ogive's calibre
//   radius head) [-]; N nose factor [-].
// Equations: h >= 1/2, a tangent ogive: psi = h^2 + 1/4, N = 1 / (3 psi) - 1 / (24 psi^2);
//   h <= 1/2, a spherical cap: psi = (h^2 + 1/4) / (2 h), N = 1 - 1 / (8 psi^2).
//   Young's factor: N_Y = 0.18 h + 0.56.
// Source: Q. M. Li, X. W. Chen, "Dimensionless formulae for penetration depth of concrete target impacted by a
//   non-deformable projectile", Int. J. Impact Eng. 28 (2003) 93-116, eq. 3a and 3c; C. W. Young, "Penetration
//   equations", SAND97-2426 (1997) (ogives).
#pragma once

#include "base/assert.hpp"

namespace physim {

/// N of a nose of a length in diameters.
inline double nose_factor(double length) {
  PHYSIM_ASSERT(length >= 0);
  const double psi_2h = length * length + 0.25;
  if (length > 0.5) return (1 / 3.0 - 1 / (24 * psi_2h)) / psi_2h;
  const double inverse_psi = 2 * length / psi_2h;
  return 1 - inverse_psi * inverse_psi / 8;
}

/// N_Y of a nose of a length in diameters.
inline double young_nose_factor(double length) {
  PHYSIM_ASSERT(length >= 0);
  return 0.18 * length + 0.56;
}

}  // namespace physim
