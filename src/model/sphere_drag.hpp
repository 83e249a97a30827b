// Drag coefficient of a smooth sphere by Reynolds number.
//
// What it models: Cd(Re) of a smooth sphere in incompressible flow from creeping flow through the drag crisis.
// When to use it: balls without seams or dimples, pellets, drops, hail, dust, below about Mach 0.3.
// When it is wrong: above Re = 1e6 (the value there is held), near and above the speed of sound, for rough or spinning
//   balls (roughness moves the drag crisis to lower Re).
// Symbols: Re = rho v d / mu [-]; rho density [kg/m^3]; v air speed [m/s]; d diameter [m]; mu viscosity [Pa s].
// Equation: Cd = 24/Re + 2.6 (Re/5) / (1 + (Re/5)^1.52) + 0.411 (Re/2.63e5)^-7.94 / (1 + (Re/2.63e5)^-8.00)
//              + Re^0.80 / 461000
// Source: F. A. Morrison, An Introduction to Fluid Mechanics (Cambridge University Press, 2013), eq. 8.83.
#pragma once

#include "math/elementary.hpp"

PHYSIM_ISA_BEGIN

/// Behind a call: it is long, and few kernels come here.
template <class R>
PHYSIM_NOINLINE void sphere_cd(const R& reynolds, R& cd) {
  using S = ScalarOf<R>;
  const R re = clamp(reynolds, R(S(1e-6)), R(S(1e6)));
  const R ln_re = log(re);
  const R low = re * S(0.2);                                           // Re / 5
  const R low_power = exp(S(1.52) * (ln_re - S(1.6094379124341003)));  // (Re / 5)^1.52; ln 5
  const R ln_crisis = ln_re - S(12.479909311159902);                   // ln(Re / 2.63e5)
  // Numerator and denominator are multiplied by (Re/2.63e5)^8, so that nothing overflows in creeping flow.
  const R crisis = S(0.411) * exp(S(0.06) * ln_crisis) / (S(1) + exp(S(8) * ln_crisis));
  cd = S(24) / re + S(2.6) * low / (S(1) + low_power) + crisis + exp(S(0.8) * ln_re) * S(1.0 / 461000.0);
}

PHYSIM_ISA_END
