// The air of an environment, ready for computing; what a shot's own weather changes of it apart.
//
// Model, symbols, equations and Source: model/station.hpp; exponential and constant air: model/air.hpp.
#pragma once

#include "model/air_levels.hpp"
#include "model/station.hpp"
#include "physim/environment.hpp"

namespace physim {

/// The standard's own air at a geopotential height [m].
[[nodiscard]] Readings<double> standard_air(double height);
/// What a station measures, or the standard's air at its height.
[[nodiscard]] Readings<double> station_air(const Environment& environment);

/// The air at an altitude that the standard defines [m].
[[nodiscard]] AirSample air_sample(const Environment& environment, double altitude);

/// The air of an environment, into numbers that are all zero; `model` is the granted rung, the levels are those of the
/// environment's profile.
void put_air(const Environment& environment, AirModel model, const std::vector<AirLevel>& levels, Air<double>& air);
/// What the weather changes of an environment's air.
[[nodiscard]] AirNumbers<double> prepare_air_numbers(const Environment& environment, AirModel model);
/// For put_air(), in lanes.
[[nodiscard]] StationPlace station_place(const Environment& environment, AirModel model);

}  // namespace physim
