// Flies a shot of a scenario through its things; if it sets a fidelity by its error, that is found first.
#include <algorithm>

#include "base/ieee_mode.hpp"
#include "flight/flight_record.hpp"
#include "physim/solve.hpp"
#include "scenario/scenario.hpp"
#include "world/core/registry.hpp"

namespace physim {
namespace {

/// How long a fidelity must keep its error: it is measured on flights that meet nothing, and may land elsewhere.
double time_of_purpose(const Flight& flight, const Until& until) {
  for (const Event& event : flight.events())
    if (event.kind == EventKind::hit && event.time > 0) return event.time;
  return flight.outcome() == Outcome::landed ? std::min(2 * flight.duration(), until.time) : flight.duration();
}

Flight fly_until(const Scenario& scenario, const ScenarioShot& shot, const Until& until) {
  const ProjectileDef projectile = projectile_of(shot);
  const auto fly_at = [&](const Fidelity& fidelity) {
    return fly(projectile, shot.launch, scenario.environment, fidelity, scenario.tolerance, until);
  };
  if (!shot.cheapest_within) return fly_at(projectile.fidelity);

  // The scenario may end a flight in ways that a purpose cannot express; a first flight shows how long it lasts.
  Purpose purpose{.error = *shot.cheapest_within,
                  .step = scenario.tolerance.step,
                  .ground = until.ground,
                  .truth = projectile.fidelity,
                  .tolerance = scenario.tolerance};
  purpose.truth.integrator = Integrator::dop853;
  purpose.truth.precision = Precision::float64;
  const Flight flight = fly_at(purpose.truth);
  if (flight.error()) return flight;
  purpose.time = time_of_purpose(flight, until);
  return fly_within(projectile, shot.launch, scenario.environment, purpose, until);
}

}  // namespace

ProjectileDef projectile_of(const ScenarioShot& shot) {
  const IeeeMode mode;
  const BodyDef& body = shot.body;
  ProjectileDef p = shot.projectile;
  p.gravity_scale *= own_of(body).gravity_scale;
  if (body.drag_scale == 0) {  // on every rung; numbers of no drag at all
    p.drag = {.coefficient = 0};
    p.motor.drag_curve.clear();
    for (AeroPoint& point : p.aero.drag_yaw) point.value = 0;
  } else if (Result<ProjectileDef> scaled = with_drag_scaled(p, body.drag_scale)) {
    p = *std::move(scaled);
  }  // else the world refuses it
  return p;
}

ScenarioShot as_flown(ScenarioShot shot) {
  shot.projectile = projectile_of(shot);
  shot.body.gravity_scale = shot.body.drag_scale = 1;
  shot.body.use_gravity = true;
  return shot;
}

ContactDef contact_of(const ScenarioShot& shot) {
  const BodyDef& body = shot.body;
  return {.collision = body.collision,
          .restitution = body.restitution,
          .friction = body.friction,
          .rolling_resistance = body.rolling_resistance,
          .combine = body.combine};
}

Flight fly_shot(const Scenario& scenario, const ScenarioShot& shot, const Scene& scene) {
  const IeeeMode mode;
  Until until = scenario.until;
  until.scene = &scene;
  until.contact = contact_of(shot);
  return fly_until(scenario, shot, until);
}

Flight fly_shot(const Scenario& scenario, const ScenarioShot& shot) {
  const IeeeMode mode;
  if (scenario.world.given || scenario.things.empty()) return fly_until(scenario, shot, scenario.until);
  const Result<Scene> scene = scene_of(scenario);
  if (scene) return fly_shot(scenario, shot, *scene);
  auto refused = std::make_shared<FlightRecord>();
  refused->error = scene.error();
  return Flight(refused);
}

}  // namespace physim
