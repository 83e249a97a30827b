// Young's penetration equations: heavy penetrators into soil, rock and concrete.
//
// What it models: the depth of a penetrator in a uniform, thick target by one number for the target, fitted to some
//   thousand tests of Sandia, and from it the speed behind a layer.
// When to use it: penetrators of 2 kg (rock and concrete: 5 kg) to tonnes, up to 1350 m/s, that go at least three
//   diameters deep.
// When it is wrong: bullets and fragments (too light), shallow hits, penetrators that break, ice, water and armour. The
//   two branches do not meet at 61 m/s: the upper one begins 17 % deeper.
// Symbols: D depth [m]; S S-number [-]; N nose factor, 0.56 flat (model/nose.hpp) [-]; m mass [kg]; A cross section
//   [m^2]; V speed [m/s]; K correction for light penetrators [-].
// Equations: V < 61: D = 0.0008 S N K (m / A)^0.7 ln(1 + 2.15e-4 V^2);  else D = 0.000018 S N K (m / A)^0.7 (V - 30.5);
//   soil: K = 0.27 m^0.4 below 27 kg;  rock, concrete: K = 0.46 m^0.15 below 182 kg;  else K = 1.
//   Behind a layer of the thickness T the penetrator has the speed at which it would go D - T deep: the resistance at a
//   speed is the same at every depth.
// Source: C. W. Young, "Penetration equations", Sandia National Laboratories, SAND97-2426 (1997), ch. 3. The speed
//   behind a layer follows from the equations.
#pragma once

namespace physim {

/// S N K (m / A)^0.7.
[[nodiscard]] double young_reach(double s_number, double nose_length, double mass, double area, bool hard);
/// D [m].
[[nodiscard]] double young_depth(double reach, double speed);
/// Speed at which a penetrator goes a depth [m/s].
[[nodiscard]] double young_speed(double reach, double depth);

}  // namespace physim
