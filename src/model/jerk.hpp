// Jerk: how fast the acceleration of a projectile changes along its path.
//
// What it models: the derivative of the acceleration that accelerations_of() gives, along the way that the projectile
//   takes: its place moves with its velocity, its velocity changes as flown, its attitude turns, its motor burns. When
// to use it: comfort and loads of what is carried, fuzes, cameras that follow; to see where a model has a corner. When
// it is wrong: nearer than h to a corner (a point of a linear drag curve, an edge of a stepped wind) it lies
//   between those of both sides, and a jump of the acceleration there shows as a peak. The end of an applied force and
//   the points of a motor's table have no such peak: there it is the one of the side that the time lies on. Generators
//   of a world and forces of its emitters count by place and velocity; what of them depends on time alone does not.
// Symbols: t time [s]; x position, v velocity in W; a acceleration [m/s^2]; j jerk [m/s^3]; h a step in time, 1 ms,
// less
//   where drag stops the projectile or its nose turns sooner.
// Equation: j = da/dt + (da/dx) v + (da/dv) dv/dt, as a difference of order 4: with
//   f(h) = a(t + h, x + v h + 1/2 dv/dt h^2, v + dv/dt h) and D(h) = (f(h) - f(-h)) / 2 h,  j = (4 D(h/2) - D(h)) / 3.
// Source: W. H. Press et al., Numerical Recipes, 3rd ed. (2007), sec. 5.7 (Richardson's extrapolation of differences).
#pragma once

#include <functional>

#include "model/acceleration.hpp"

namespace physim {

/// What pushes a projectile beside the models, at a place and velocity other than its own, less that at its own
/// [m/s^2].
using PushChange = std::function<Vec3d(const State<double>&)>;

/// On any rung, in double; `rotor` and `turn` are read by rungs that turn [m/s^3].
[[nodiscard]] Vec3d jerk_of(const Conditions<double>& c, const Body<double>& b, const Rotor<double>& rotor, double t,
                            const State<double>& s, const Turn<double>& turn, const PushChange& push_change = {});

}  // namespace physim
