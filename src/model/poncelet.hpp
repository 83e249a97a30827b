// Poncelet's penetration: a resistance that is a constant and a part by the square of the speed.
//
// What it models: how deep a rigid projectile goes into a thick material, and with which speed it comes out of a thin
//   one. Over the depth of a crater the resistance may grow in proportion to the depth first (concrete).
// When to use it: wood, soil, concrete and masonry, with a strength that was measured near the speed and size at hand;
//   liquids, with strength 0.
// When it is wrong: projectiles that deform, tumble or erode; the back of a wall, which breaks out before it is reached
//   (scabbing); layers thinner than the projectile is thick; gravity, which ends slow ways in liquids.
// Symbols: m mass [kg]; A greatest cross section [m^2]; v speed at the depth x [m/s, m]; v_0 at the surface; R strength
//   [Pa]; q = i N rho [kg/m^3], by the nose factor N (model/nose.hpp), density rho and inertia i (solids 1, liquids
//   1/2: the pressure of a stream); c depth of the crater [m]; X depth where it stops [m].
// Equations: m v dv/dx = -A (R + q v^2), beyond the crater: v^2 = (v_1^2 + R / q) exp(-2 A q (x - c) / m) - R / q,
//   X = c + m / (2 A q) ln(1 + q v_1^2 / R);  q = 0: v^2 = v_1^2 - 2 A R (x - c) / m.
//   In the crater the resistance is F x / c, with F = A (R + q v_1^2), so that it is steady at c, which gives
//   v_1^2 = (m v_0^2 - A R c) / (m + A q c), F = A m (R + q v_0^2) / (m + A q c), v^2 = v_0^2 - F x^2 / (c m); it stops
//   within the crater where v_1^2 < 0.
// Source: J.-V. Poncelet, "Rapport sur un memoire de MM. Piobert et Morin", Mem. Acad. Sci. 15 (1838) 55-91 (the law;
//   read 1835; wood keeps the constant alone); M. J. Forrestal, B. S. Altman, J. D. Cargile, S. J. Hanchak, "An
//   empirical equation for penetration depth of ogive-nose projectiles into concrete targets", Int. J. Impact Eng. 15
//   (1994) 395-405 (crater, N, and R = 82.6 f^(1 - 0.544) MPa for a compressive strength f [MPa], eq. 12).
#pragma once

namespace physim {

/// A projectile in a material.
struct Bore {
  double mass;      // m [kg]
  double area;      // A [m^2]
  double strength;  // R [Pa]
  double inertia;   // q [kg/m^3]
  double crater;    // c [m]
};

/// X; without end where nothing but inertia resists [m].
[[nodiscard]] double poncelet_depth(const Bore& bore, double speed);
/// Speed that is left at a depth, which the projectile reaches [m/s].
[[nodiscard]] double poncelet_speed(const Bore& bore, double speed, double depth);
/// Strength R of concrete by its compressive strength [Pa].
[[nodiscard]] double concrete_strength(double compressive_strength);

}  // namespace physim
