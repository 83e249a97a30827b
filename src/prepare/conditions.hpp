// Environment and granted rungs, ready to compute.
#pragma once

#include "model/conditions.hpp"
#include "physim/environment.hpp"
#include "prepare/profile_tables.hpp"

namespace physim {

/// Pools of curves, and flags of what some projectile has, are added with the projectiles. Conditions point to the
/// tables; those of an environment without profiles need none.
[[nodiscard]] Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted,
                                                    ProfileTables& tables);
[[nodiscard]] Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted);
/// What WindPart::wind of a shot with weather of its own has beside the numbers of its columns [m/s].
[[nodiscard]] Vec3d own_wind_less_column(const Weather& weather, const Wind& common, WindModel granted);
/// Whether functions of one's own are in it.
[[nodiscard]] inline bool has_functions(const Environment& e) { return e.wind.field || e.force; }
/// The environment of a world as a flight knows it that is launched at a time of that world [s].
[[nodiscard]] Environment as_launched_at(double time, const Environment& environment);
/// The air at the origin, at the nearest altitude of the standard atmosphere where it lies beyond that.
[[nodiscard]] Result<AirSample> air_at_origin(const Environment& environment);
/// Without the tables of projectiles: their rows are other ones in float.
[[nodiscard]] Conditions<float> to_float(const Conditions<double>& conditions, const ProfileTables& tables);

}  // namespace physim
