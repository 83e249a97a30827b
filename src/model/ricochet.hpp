// Ricochet: what comes in flat is thrown off.
//
// What it models: a projectile that meets a surface flatter than a critical angle leaves it again. Off solids, angle
//   and loss are data: restitution along the normal and friction along the surface. Off liquids, a sphere is lifted by
//   Birkhoff's pressure, half the density times the square of the velocity's part along the wetted surface's normal,
//   on the wetted part of its front, and slowed by the drag of the same pressure.
// When to use it: round shot and balls on water; bullets and shot on soil, stone and steel, if the critical angle was
//   measured.
// When it is wrong: spin (backspin raises the critical angle), bodies that are not round, floats lighter than about the
//   liquid, speeds below which gravity and surface waves count (v^2 below some tens of g a). The speed is taken as
//   constant while the sphere is lifted, so the loss of speed is one of first order. Near the critical angle, where the
//   sphere goes under before it comes out, the loss grows without end.
// Symbols: theta angle between path and surface [rad]; theta_c critical angle; s specific gravity of the sphere, its
//   mean density over that of the liquid [-]; z depth of its lowest point over its radius, 0 to 2 [-]; b angle of the
//   wetted cap, cos b = 1 - z; x = (theta / theta_c)^2; e restitution, mu friction [-].
// Equations: lift: z'' ~ -(3 / (64 s)) sin^4 b; its work up to z is G = 4/3 z^3 - z^4 + z^5 / 5; it turns the sphere
//   around before z = 2, G = 16/15, where theta < theta_c = 1 / sqrt(10 s) = 18.1 deg / sqrt(s).
//   Drag along the path: ln(v / v') = sqrt(10 / s) / pi * J(x), J(x) = integral from 0 to z_m of I / sqrt(x - 15/16 G)
//   dz, I = integral of sin^4 = 3/8 b - sin(2 b) / 4 + sin(4 b) / 32, x = 15/16 G(z_m). It leaves at the angle at which
//   it came.
//   Off solids: v_n' = -e v_n; |v_t'| = |v_t| - mu (1 + e) |v_n|, as in model/contact.hpp.
// Source: G. Birkhoff, G. D. Birkhoff, W. E. Bleick, E. H. Handler, F. D. Murnaghan, T. L. Smith, "Ricochet off water",
//   AMP Memo 42.4M (1944); W. Johnson, S. R. Reid, "Ricochet of spheres off water", J. Mech. Eng. Sci. 17 (1975) 71-81
//   (18 deg / sqrt(s), and experiments). The loss is the drag of their pressure, worked out here.
#pragma once

namespace physim {

/// theta_c of a sphere of a specific gravity [rad].
[[nodiscard]] double liquid_critical_angle(double specific_gravity);
/// v' / v of a sphere that meets a liquid at an angle below the critical one.
[[nodiscard]] double liquid_speed_kept(double specific_gravity, double angle);

}  // namespace physim
