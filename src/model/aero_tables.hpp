// Tables of aerodynamic coefficients, as rows that a kernel reads without a search.
//
// What it models: the coefficients of AeroDef by Mach number, those of Magnus also by the square of the angle of
//   attack: straight lines between their points, exactly.
// How: all Mach numbers at which some coefficient has a point are the borders of cells; in a cell every coefficient is
//   a + b M, two to a row of four numbers. Equal buckets, so narrow that none holds two borders, lead to the cell: a
//   bucket's row holds how many borders lie at or below its start, and the one inside. In cells of Mach and angle a
//   Magnus coefficient is f0 + f1 A + M (g0 + g1 A), A = alpha^2, one row.
// Source: the interpolation is that of R. L. McCoy, Modern Exterior Ballistics (1999), ch. 9.
#pragma once

#include <optional>

#include "model/rotor.hpp"
#include "model/table_pool.hpp"

namespace physim {

/// Numbers of a coefficient outside of its points, or between them [-].
[[nodiscard]] double coefficient_at(const AeroCoefficient& coefficient, double mach, double angle_squared);

/// Buckets cannot separate points closer than this: Mach numbers of one projectile, squares of angles [rad^2] of one
/// coefficient.
inline constexpr double kClosestAeroPoints = 1.0 / 16384;
/// Two borders that are closer, if there are such.
struct ClosePair {
  double first;
  double second;
};
[[nodiscard]] std::optional<ClosePair> mach_numbers_too_close(const AeroDef& aero);
[[nodiscard]] std::optional<ClosePair> angles_too_close(const AeroCoefficient& coefficient);

[[nodiscard]] bool has_aero(const AeroDef& aero);
/// Some coefficient has more than one point.
[[nodiscard]] bool has_aero_tables(const AeroDef& aero);
/// Some coefficient that a rung reads depends on the angle.
[[nodiscard]] bool has_aero_angles(const AeroDef& aero, const Fidelity& rung);

/// Adds the tables of a projectile to the pool and fills in where they are, as AeroPlace.
void add_aero(const AeroDef& aero, TablePool& pool, Rotor<double>& rotor);

}  // namespace physim
