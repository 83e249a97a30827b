// De Marre's armour formula: solid shot through steel plate.
//
// What it models: the speed at which armour-piercing shot just goes through a plate, and the plate that a speed goes
//   through.
// When to use it: solid shot of full calibre on plates of 0.8 to 1.4 times its diameter; against other steels, with a
//   quality that a test of similar shot gave.
// When it is wrong: long rods, shaped charges, shot that shatters, lead bullets; face-hardened plate met by shot
// without
//   a cap; thin plates. The cosine is a first guess: at 45 degrees MIL-DTL-12560K requires 1.30 times the limit at 30,
//   the cosine for 1.22.
// Symbols: d diameter, T thickness along the normal [m]; m mass [kg]; theta obliquity [rad]; q quality, limit speed
// over
//   that of nickel steel [-]; v_l ballistic limit [m/s].
// Equations: v_l = q C d^0.75 T^0.70 / (m^0.5 cos theta); C = 10^3.00945 for ft/s, inches and pounds: 43131 in SI
// units. Source: J. de Marre, "Perforation des cuirasses", Memorial de l'artillerie de la marine (1886); Naval
// Ordnance, a
//   text-book for the midshipmen of the United States Naval Academy (1937), armor (C, and its examples); also W.
//   Herrmann, A. H. Jones, "Survey of hypervelocity impact information", MIT ASRL Report 99-1 (1961). The cosine takes
//   the part of the speed along the normal.
#pragma once

#include <cmath>

#include "base/assert.hpp"
#include "math/elementary.hpp"

namespace physim {

inline constexpr double kDeMarre = 43130.94204018313;  // C [m^-0.45 kg^0.5 / s]

/// v_l [m/s], of a thickness along the normal and the cosine of the obliquity.
inline double de_marre_limit(double quality, double diameter, double mass, double thickness, double cosine) {
  PHYSIM_ASSERT(quality > 0 && diameter > 0 && mass > 0 && thickness > 0 && cosine > 0);
  return quality * kDeMarre * pow(diameter, 0.75) * pow(thickness, 0.7) / (std::sqrt(mass) * cosine);
}

/// Thickness along the normal that a speed just goes through [m].
inline double de_marre_thickness(double quality, double diameter, double mass, double speed, double cosine) {
  PHYSIM_ASSERT(quality > 0 && diameter > 0 && mass > 0 && speed >= 0 && cosine >= 0);
  const double power = speed * cosine * std::sqrt(mass) / (quality * kDeMarre * pow(diameter, 0.75));
  return power > 0 ? pow(power, 1 / 0.7) : 0.0;
}

}  // namespace physim
