// Gyroscopic and dynamic stability of a spinning, symmetric body at small angles of attack.
//
// What it models: whether the axis stays near the path. Gyroscopically stable: Sg > 1; and both yawing motions die away
//   where 1 / Sg < Sd (2 - Sd). A body that fins hold (CMa < 0) has a negative Sg and needs no spin.
// When it is wrong: at large angles, and where coefficients change fast with the angle: they are those at angle zero.
// Symbols: Ix, It moments of inertia about and across the axis [kg m^2]; p spin [rad/s]; rho [kg/m^3]; S, d reference
//   area and length [m^2], [m]; V air speed [m/s]; kx^2 = Ix / (m d^2), kt^2 = It / (m d^2).
// Equations: Sg = Ix^2 p^2 / (2 rho It S d V^2 CMa);
//   Sd = 2 (CLa + CMpa / kx^2) / (CLa - CD - (CMq + CMadot) / kt^2), with rates p d / V.
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), ch. 10.
#pragma once

#include "model/acceleration.hpp"
#include "physim/flight.hpp"

namespace physim {

/// At a time since launch [s]; nothing if the air, the speed or a coefficient is missing.
[[nodiscard]] std::optional<Stability> stability_of(const Conditions<double>& conditions, const Body<double>& body,
                                                    const Rotor<double>& rotor, double time, const State<double>& state,
                                                    const Turn<double>& turn);

}  // namespace physim
