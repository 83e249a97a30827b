// The step of fixed-step integrators.
#pragma once

#include <limits>
#include <optional>

#include "physim/flight.hpp"
#include "prepare/cohort.hpp"

namespace physim {

/// The step to use, 0 for adaptive integrators and closed forms; nothing where automatic_step() finds it.
[[nodiscard]] std::optional<double> step_given(const Fidelity& granted, const Tolerance& tolerance);

/// A game's frame, the step of methods of first order [s].
inline constexpr double kFrame = 1.0 / 60;

/// Whether an automatic step is a frame, or what strong drag leaves of it.
[[nodiscard]] bool steps_by_frames(const Fidelity& granted);
/// That step for a body of a finished cohort: no longer than half of what drag needs to take all speed away at the rate
/// at which it begins. Longer ones would turn the velocity around, and let it grow without bound [s].
[[nodiscard]] double frame_step(const Cohort& cohort, const Body<double>& body, const Rotor<double>& rotor,
                                const Until& until);

/// A fixed step, and how near it comes.
struct AutomaticStep {
  double step;     // [s]
  double reached;  // error that was measured, 0 where none was [m]
};

/// A fixed step for a shot, at most `longest` [s]: frame_step(), or one found by pilot flights with which the shot
/// stays within `error_allowed` [m] of a reference flight along its whole path, in place, and in time where it ends
/// times its greatest speed; where max_steps comes first, the step that comes nearest.
[[nodiscard]] Result<AutomaticStep> automatic_step(const ProjectileDef& projectile, const Launch& launch,
                                                   const Environment& environment, const Fidelity& granted,
                                                   const Tolerance& tolerance, const Until& until, double error_allowed,
                                                   double longest = std::numeric_limits<double>::infinity());

/// What to tell of a step that does not keep an error [m].
[[nodiscard]] FidelityNote note_of_step(const AutomaticStep& found, double error_allowed);

}  // namespace physim
