// Lambert and Jonas: long rods through metal plates.
//
// What it models: the ballistic limit of a plate against a rod, and the two numbers of the residual speed.
// When to use it: rods of 0.5 g to 3.6 kg, 2 mm to 5 cm thick, 4 to 30 diameters long, of 7800 to 19000 kg/m^3, on
// plates
//   of 6 to 150 mm, up to 60 degrees from the normal.
// When it is wrong: bullets and shot, which are shorter; layered and ceramic armour.
// Symbols: T thickness along the normal, D diameter, L length [m]; theta obliquity [rad]; z = T sec^0.75(theta) / D
// [-];
//   u coefficient, rolled homogeneous armour 4000, aluminium 1750 [m/s g^1/2 cm^-3/2]; M mass [kg]; rho density of the
//   plate [kg/m^3]; v_l ballistic limit [m/s]; a, p of model/recht_ipson.hpp [-].
// Equations: v_l = u (L / D)^0.15 sqrt((z + exp(-z) - 1) D^3 / M), D in cm and M in g;
//   M' = rho pi D^3 z / 4;  a = M / (M + M' / 3);  p = 2 + z / 3.
// Source: J. P. Lambert, G. H. Jonas, "Towards standardization in terminal ballistics testing: velocity
// representation",
//   BRL Report 1852 (1976) (a, p); J. P. Lambert, "A residual velocity predictive model for long rod penetrators", BRL
//   Memorandum Report 2828 (1978) (limit); J. A. Zukas, T. Nicholas, H. F. Swift, L. B. Greszczuk, D. R. Curran, Impact
//   Dynamics (1982), ch. 5.
#pragma once

namespace physim {

struct LongRod {
  double mass;      // M [kg]
  double diameter;  // D [m]
  double length;    // L [m]
};

/// z, of the thickness along the way and the cosine of the obliquity.
[[nodiscard]] double lambert_z(double way, double diameter, double cosine);
/// v_l [m/s].
[[nodiscard]] double lambert_limit(double coefficient, const LongRod& rod, double z);
/// z of the plate that a speed just passes.
[[nodiscard]] double lambert_passed(double coefficient, const LongRod& rod, double speed);

struct LambertResidual {
  double a;
  double p;
};
[[nodiscard]] LambertResidual lambert_residual(const LongRod& rod, double density, double z);

}  // namespace physim
