// What a rung is worth in a world: how far its steps of a frame go astray, and what one of them costs.
#pragma once

#include <optional>

#include "physim/world.hpp"
#include "scenario/scenario.hpp"

namespace physim::report {

/// A frame of a game [s].
inline constexpr double kGameFrame = 1.0 / 60;

/// Time of one step of one projectile among a thousand that fly side by side on one thread, by the shot's own fidelity,
/// among 64 where it is 0.1 ms or more; nothing if the world refuses it [s].
[[nodiscard]] std::optional<double> time_of_step(const WorldDef& def, const ScenarioShot& shot, double dt);
/// The greatest distance between a world's projectile and a flight of the same shot at any frame of the flight; nothing
/// if the world refuses it, or if the flight has more than 36 000 frames [m].
[[nodiscard]] std::optional<double> error_of_steps(const WorldDef& def, const ScenarioShot& shot, double dt,
                                                   const Flight& reference);

}  // namespace physim::report
