// The step of fixed-step integrators.
#pragma once

#include <optional>

#include "physim/flight.hpp"

namespace physim {

/// The fixed step to use, 0 for adaptive integrators and closed forms; nothing where a pilot flight must find it.
[[nodiscard]] std::optional<double> step_without_pilot(const Fidelity& granted, const Tolerance& tolerance);
/// The step, at most `longest` [s], with which a shot ends within `error_allowed` [m] of a reference flight.
[[nodiscard]] Result<double> step_within(const ProjectileDef& projectile, const Launch& launch,
                                         const Environment& environment, const Fidelity& granted,
                                         const Tolerance& tolerance, const Until& until, double error_allowed,
                                         double longest);

}  // namespace physim
