// Body and Rotor of a projectile, ready to compute but for its launch.
#pragma once

#include <span>

#include "model/body.hpp"
#include "model/conditions.hpp"
#include "model/table_pool.hpp"

namespace physim {

/// i A / (2 m): from the ballistic coefficient, or from mass, diameter and form factor [m^2/kg].
[[nodiscard]] double half_area_per_mass(const ProjectileDef& projectile);
/// half_area_per_mass() of shots of one projectile that have ballistic coefficients > 0 of their own, or form factors;
/// where there are none all have the projectile's.
void put_half_areas(const ProjectileDef& projectile, std::span<const double> ballistic_coefficients,
                    std::span<const double> form_factors, std::span<double> into);

/// Adds the projectile's tables to the pool and its flags to the conditions.
[[nodiscard]] Body<double> prepare_kind(const ProjectileDef& projectile, TablePool& pool,
                                        Conditions<double>& conditions);
/// ... where it is kept; what was there is not read.
void put_kind(const ProjectileDef& projectile, TablePool& pool, Conditions<double>& conditions, Body<double>& body);
/// What of it only rungs that fly the attitude read, its tables added to the pool.
[[nodiscard]] Rotor<double> prepare_rotor_kind(const ProjectileDef& projectile, TablePool& pool,
                                               Conditions<double>& conditions);
/// The drag curve alone, with its flags: part of prepare_kind().
void prepare_curve(const ProjectileDef& projectile, TablePool& pool, Conditions<double>& conditions,
                   Body<double>& body);

}  // namespace physim
