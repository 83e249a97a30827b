#include "simclient/core/prediction.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace physim::client {
namespace {

constexpr std::uint64_t kMaxSteps = 12000;

/// The forces of the scenario that would act on the shot. Those that tie two shots together are left out.
void add_forces(World& world, const Session& session, const ScenarioShot& shot) {
  for (const ScenarioForce& force : session.scenario().forces) {
    const bool is_named = std::find(force.shots.begin(), force.shots.end(), shot.projectile.name) != force.shots.end();
    const bool is_general = force.shots.empty() && force.layers == 0;
    if (!force.other.empty() || !(is_named || is_general || (force.layers & shot.body.layers) != 0)) continue;
    const double to_come = force.delay - session.time();
    const double left = force.duration + std::min(to_come, 0.0);
    if (left <= 0) continue;
    world.add_force({force.law, ForceTarget::everything(), std::max(to_come, 0.0), left});
  }
}

void look(Prediction& prediction, const Event& event) {
  TrackSample at = prediction.path.back();
  at.time = event.time, at.position = event.position, at.velocity = event.velocity;
  if (event.kind == EventKind::apex && !prediction.apex) prediction.apex = at;
  const bool touched = event.kind == EventKind::landed || event.kind == EventKind::bounced;
  if (touched && !prediction.impact) prediction.impact = at;
  if (event.kind == EventKind::landed || event.kind == EventKind::expired) prediction.path.push_back(at);
}

}  // namespace

Prediction predict(const Session& session, const ScenarioShot& shot, double max_time) {
  Prediction prediction;
  WorldDef def = session.world().def();
  def.environment = session.scenario().environment;
  def.apex_events = true;
  def.pools.clear();
  def.threading.threads = 1;
  Result<World> made = World::create(def);
  if (!made) return prediction.error = made.error(), prediction;
  World& world = *made;
  add_forces(world, session, shot);
  BodyDef body = body_of(session.scenario(), shot);
  body.pool = 0;
  const Result<ProjectileId> fired = world.spawn(shot.projectile, shot.launch, body);
  if (!fired) return prediction.error = fired.error(), prediction;
  const ProjectileView projectile = world[*fired];
  prediction.muzzle = projectile.position();
  prediction.velocity = projectile.velocity();
  prediction.granted = projectile.fidelity_in_use();
  prediction.path.push_back(sample_of(projectile, projectile.age()));
  const auto limit = std::min(kMaxSteps, static_cast<std::uint64_t>(std::ceil(max_time / def.step)));
  const auto start = std::chrono::steady_clock::now();
  while (projectile.is_alive() && !projectile.is_asleep() && prediction.steps < limit) {
    world.step(def.step);
    ++prediction.steps;
    for (const Event& event : world.events()) look(prediction, event);
    if (projectile.is_alive()) prediction.path.push_back(sample_of(projectile, projectile.age()));
  }
  prediction.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  prediction.complete = !projectile.is_alive() || projectile.is_asleep();
  return prediction;
}

}  // namespace physim::client
