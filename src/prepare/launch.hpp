// Launches: what of Body and Rotor a launch gives, for flights, batches and worlds alike.
#pragma once

#include <optional>

#include "model/attitude.hpp"
#include "model/sight.hpp"
#include "model/spin_drift.hpp"
#include "physim/environment.hpp"
#include "prepare/projectile.hpp"

namespace physim {

/// What of a launch with a bore elevation above the horizon [rad] needs no projectile: state, sight, plane of fire, and
/// where the models read them, spin and rail. `sight` is the launch's frame. True where it starts on a rail.
bool put_launch(const Launch& launch, const SightFrame& sight, double elevation, const Fidelity& granted,
                Body<double>& body);
/// Launches a projectile; a rail comes with the launch, and its flag.
void put_launch(const ProjectileDef& projectile, const Launch& launch, const SightFrame& sight, double elevation,
                Conditions<double>& conditions, Body<double>& body);
/// A projectile launched: prepare_kind() and put_launch().
[[nodiscard]] Body<double> prepare_body(const ProjectileDef& projectile, const Launch& launch, double elevation,
                                        TablePool& pool, Conditions<double>& conditions);

/// The attitude at launch: as given, or along the bore.
[[nodiscard]] Attitude prepare_attitude(const ProjectileDef& projectile, const Launch& launch, double elevation,
                                        const Vec3d& velocity, const Conditions<double>& conditions);
/// Puts it into a rotor; `body` is launched already.
void put_launch(const ProjectileDef& projectile, const Launch& launch, double elevation, const Body<double>& body,
                const Conditions<double>& conditions, Rotor<double>& rotor);
/// A rotor launched: prepare_rotor_kind() and put_launch().
[[nodiscard]] Rotor<double> prepare_rotor(const ProjectileDef& projectile, const Launch& launch, double elevation,
                                          const Body<double>& body, TablePool& pool, Conditions<double>& conditions);

/// stability_factor() of input that is checked already; `launch_speed` in m/s.
[[nodiscard]] std::optional<double> stability_of_checked(const ProjectileDef& projectile, double launch_speed,
                                                         const Environment& environment);
/// Litz's aerodynamic jump, where it is granted: turns the launch velocity up or down.
void jump_in_crosswind(const ProjectileDef& projectile, const Environment& environment,
                       const Conditions<double>& conditions, Body<double>& body);
[[nodiscard]] SpinDrift prepare_spin_drift(const ProjectileDef& projectile, double launch_speed,
                                           const Environment& environment, const Fidelity& granted);

}  // namespace physim
