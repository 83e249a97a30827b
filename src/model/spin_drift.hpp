// Spin drift and aerodynamic jump: what the spin of a bullet does to its path, by empirical formulas.
//
// What it models: Miller's gyroscopic stability factor; Litz's drift, added to the flown path: a right-hand twist
//   drifts to the right; Litz's aerodynamic jump: crosswind at the muzzle turns the launch up or down, with a
//   right-hand twist up where it comes from the right.
// When to use it: small-arms bullets in flat fire, supersonic most of the way.
// When it is wrong: shells, high angles, unstable or over-stabilised bullets (it is a fit to Sg between about 1.2 and
//   2.5); drift does not feed back on drag or drop. Modified point mass and 6-DOF do this by physics.
// Symbols: m mass [grains]; d diameter [in]; l length [calibres]; t twist [calibres per turn]; V muzzle speed [ft/s];
//   T air temperature [degF]; P pressure [inHg]; Sg stability factor [-]; tof time of flight [s]; w crosswind from the
//   right [mph].
// Equations: Sg = 30 m / (t^2 d^3 l (1 + l^2)) * (V / 2800)^(1/3) * ((T + 460) / 519) * (29.92 / P);
//   drift = 1.25 (Sg + 1.2) tof^1.83 inches;  jump = w (0.01 Sg - 0.0024 l + 0.032) minutes of arc.
// Source: D. Miller, "A new rule for estimating rifling twist", Precision Shooting (March 2005); B. Litz, Applied
//   Ballistics for Long-Range Shooting (2009), ch. 6, and its 3rd edition (2015), p. 422 (aerodynamic jump).
#pragma once

#include "physim/projectile.hpp"

namespace physim {

/// Beyond this stability factor (thin air, slow heavy rounds) the formula has no meaning and gives no drift.
inline constexpr double kMostStable = 10;

struct SpinDrift {
  double coefficient = 0;  // drift = coefficient tof^1.83, right positive [m/s^1.83]

  [[nodiscard]] double drift(double time) const;       // [m]
  [[nodiscard]] double drift_rate(double time) const;  // [m/s]
};

/// Miller's stability factor [-] in air of a temperature [K] and pressure [Pa].
[[nodiscard]] double miller_stability(const ProjectileDef& projectile, double speed, double temperature,
                                      double pressure);
/// Litz's spin drift for a stability factor; the sign of the twist gives the side.
[[nodiscard]] SpinDrift litz_spin_drift(double stability, double twist);

/// Litz's aerodynamic jump upwards [rad] in a crosswind from the right [m/s], of a bullet of a length [calibres].
[[nodiscard]] double litz_aerodynamic_jump(double stability, double calibres, double twist, double from_right);

}  // namespace physim
