// Drag curves: Cd by Mach number, of standard functions and of points that a user gives.
//
// What it models: curves through tabulated points; see math/interpolation.hpp for what goes between them.
// Source: math/interpolation.hpp for the interpolation; data/drag for the figures.
#pragma once

#include <vector>

#include "math/interpolation.hpp"
#include "physim/projectile.hpp"

namespace physim {

inline constexpr int kMaxCurveCells = 16384;  // half a megabyte of rows at most for one curve

/// The curve of a table; of constants Cd = 1.
[[nodiscard]] PiecewiseCubic drag_curve(const DragDef& drag, Interpolation interpolation);
/// The curve of a table that is not custom, on equal cells. Each is fitted once: it takes as long as a short flight.
[[nodiscard]] const UniformCubic& standard_drag_cells(DragTable table, Interpolation interpolation);

/// Whether two curves have the same points, to the bit: quicker than ==, for batches in which many have a curve.
[[nodiscard]] bool same_points(const std::vector<DragPoint>& a, const std::vector<DragPoint>& b);
/// Whether a cubic spline through a custom curve would swing out between its points: sparse points around Mach 1 do it.
[[nodiscard]] bool spline_overshoots(const DragDef& drag);

}  // namespace physim
