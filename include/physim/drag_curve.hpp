// Drag coefficients by Mach number, for tools and tests.
#pragma once

#include <span>

#include "physim/projectile.hpp"

namespace physim {

/// The published points of a standard drag function; empty for constant, sphere and custom.
[[nodiscard]] std::span<const DragPoint> drag_points(DragTable table);
/// The drag coefficient [-] that a projectile's drag data give at a Mach number [-] (tables, custom curve, constant).
/// NaN where they give no curve: no points, or points that do not rise.
[[nodiscard]] double drag_coefficient(const DragDef& drag, Interpolation interpolation, double mach);
/// The drag coefficient of a smooth sphere [-] at a Reynolds number [-] (Morrison 2013).
[[nodiscard]] double sphere_drag_coefficient(double reynolds);

}  // namespace physim
