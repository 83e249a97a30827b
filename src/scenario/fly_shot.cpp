// Flies a shot of a scenario; where it asks for a fidelity by its error, that is found first.
#include <algorithm>

#include "base/ieee_mode.hpp"
#include "physim/auto_fidelity.hpp"
#include "physim/scenario.hpp"

namespace physim {

Flight fly_shot(const Scenario& scenario, const ScenarioShot& shot) {
  const IeeeMode mode;
  const ProjectileDef& projectile = shot.projectile;
  const auto fly_at = [&](const Fidelity& fidelity) {
    return fly(projectile, shot.launch, scenario.environment, fidelity, scenario.tolerance, scenario.until);
  };
  if (!shot.cheapest_within) return fly_at(projectile.fidelity);

  // The scenario may end a flight in ways that a purpose does not know; a first flight tells how long it lasts.
  Purpose purpose{.error = *shot.cheapest_within,
                  .step = scenario.tolerance.step,
                  .ground = scenario.until.ground,
                  .truth = projectile.fidelity,
                  .tolerance = scenario.tolerance};
  purpose.truth.integrator = Integrator::dop853;
  purpose.truth.precision = Precision::float64;
  const Flight flight = fly_at(purpose.truth);
  if (flight.error()) return flight;
  const bool landed = flight.outcome() == Outcome::landed;
  purpose.time = landed ? std::min(2 * flight.duration(), scenario.until.time) : flight.duration();
  return fly_within(projectile, shot.launch, scenario.environment, purpose, scenario.until);
}

}  // namespace physim
