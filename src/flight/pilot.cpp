// The step of a fixed-step integrator, found by pilot flights.
#include "flight/pilot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/ieee_mode.hpp"
#include "base/text.hpp"
#include "math/elementary.hpp"
#include "physim/names.hpp"
#include "solve/take_step.hpp"

namespace physim {
Result<double> step_within(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                           const Fidelity& fidelity, const Tolerance& tolerance, const Until& until,
                           double error_allowed, double longest) {
  Fidelity exact = fidelity;
  exact.integrator = Integrator::dop853;
  exact.precision = Precision::float64;
  Tolerance tight = tolerance;
  tight.relative = tight.absolute = clamp(1e-6 * error_allowed, 1e-13, 1e-9);
  const Flight reference = fly(projectile, launch, environment, exact, tight, until);
  if (reference.error()) return *reference.error();
  if (reference.outcome() == Outcome::step_limit)
    return Error{"the pilot flight took all steps allowed", "tolerance.max_steps", "allow more, or give a step"};
  if (!ended_as_planned(reference.outcome()))
    return Error{"the pilot flight ended as " + std::string(name(reference.outcome())), "launch",
                 "check the figures of projectile and launch, or give a step"};
  PHYSIM_ASSERT(error_allowed > 0 && longest > 0);
  const double order = order_of(fidelity.integrator);
  Fidelity coarse = fidelity;
  coarse.precision = Precision::float64;
  const auto error_at = [&](double step) {
    Tolerance fixed = tolerance;
    fixed.step = step;
    const Flight flight = fly(projectile, launch, environment, coarse, fixed, until);
    const double miss = length(flight.end().position - reference.end().position);
    return std::isfinite(miss) ? miss : 1e9;
  };
  double step = std::max(std::min(reference.duration() / 4, longest), 1e-6);
  for (int i = 0; i < 40 && step > 1e-7; ++i) {
    // Two steps are tried, so that an error which happens to pass through zero is not taken for a small one.
    const double error = std::max(error_at(step), error_at(0.8 * step));
    if (error <= error_allowed) return step;
    const double factor = 0.95 * pow(error_allowed / error, 1 / order);
    step *= std::clamp(factor, 0.1, 0.9);
  }
  return Error{"no step above 1e-7 s keeps the position error below " + short_text(tolerance.position_error) + " m",
               "tolerance.position_error", "allow a larger error, or use an adaptive integrator"};
}

Result<double> pilot_step(const ProjectileDef& projectile, const Launch& launch, const Environment& environment,
                          const Fidelity& fidelity, const Tolerance& tolerance, const Until& until) {
  const IeeeMode mode;
  return step_within(projectile, launch, environment, fidelity, tolerance, until, tolerance.position_error,
                     std::numeric_limits<double>::infinity());
}

std::optional<double> step_without_pilot(const Fidelity& granted, const Tolerance& tolerance) {
  if (steps_itself(granted)) return 0.0;
  if (tolerance.step > 0) return tolerance.step;
  if (order_of(granted.integrator) == 1) return 1.0 / 60;  // a game's frame; accuracy is not what these are for
  return std::nullopt;
}

}  // namespace physim
