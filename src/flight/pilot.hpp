// The step of fixed-step integrators.
#pragma once

#include <optional>

#include "physim/flight.hpp"
#include "physim/math.hpp"
#include "prepare/cohort.hpp"

namespace physim {

/// The step to use, 0 for adaptive integrators and closed forms; nothing where it is automatic.
[[nodiscard]] std::optional<double> step_given(const Fidelity& granted, const Tolerance& tolerance);

/// Whether an automatic step is a game's frame, or what strong drag leaves of it; else pilot flights find it.
[[nodiscard]] bool steps_by_frames(const Fidelity& granted);

/// A game's frame [s].
inline constexpr double kFrame = 1.0 / 60;
/// The step of a body of a finished cohort that steps by frames: no longer than half of what drag needs to take all
/// speed away at the rate at which it begins. Longer ones would turn the velocity around, and let it grow without
/// bound [s].
[[nodiscard]] double frame_step(const Cohort& cohort, const Body<double>& body, const Rotor<double>& rotor,
                                const Until& until);

/// A step found by pilot flights, and how near it comes.
struct PilotStep {
  double step;     // [s]
  double reached;  // largest error [m]
};
/// The fixed step, at most `longest` [s], with which a shot stays within `error_allowed` [m] of a reference flight
/// along its whole path, in place, and in time where it ends times its greatest speed; where max_steps or a million
/// steps of all pilot flights come first, the one that comes nearest.
[[nodiscard]] Result<PilotStep> step_within(const ProjectileDef& projectile, const Launch& launch,
                                            const Environment& environment, const Fidelity& granted,
                                            const Tolerance& tolerance, const Until& until, double error_allowed,
                                            double longest = kInfinity);
/// The note on a step that does not keep an error [m].
[[nodiscard]] FidelityNote note_of_step(const PilotStep& found, double error_allowed);

}  // namespace physim
