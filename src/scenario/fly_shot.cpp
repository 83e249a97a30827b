// Flies a shot of a scenario through its things, and tells what it hits; if the shot sets a fidelity by its error, that
// is found first.
#include <algorithm>
#include <functional>

#include "base/assert.hpp"
#include "base/ieee_mode.hpp"
#include "flight/flight_record.hpp"
#include "physim/solve.hpp"
#include "scenario/scenario.hpp"
#include "scenario/suggest.hpp"
#include "scenario/thing_hits.hpp"
#include "scenario/world_run.hpp"
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

/// Which of a scenario's shots it is; of a copy, the first of its name.
std::size_t number_of(const Scenario& scenario, const ScenarioShot& shot) {
  const std::less<> before;
  const ScenarioShot *const first = scenario.shots.data(), *const end = first + scenario.shots.size();
  if (!before(&shot, first) && before(&shot, end)) return static_cast<std::size_t>(&shot - first);
  const auto own = std::ranges::find(scenario.shots, shot.projectile.name,
                                     [](const ScenarioShot& each) { return each.projectile.name; });
  return own != scenario.shots.end() ? static_cast<std::size_t>(own - scenario.shots.begin()) : 0;
}

/// The solid that a point lies inside of, a micrometre deep at least; none: it is outside, or on a surface.
InstanceId around(const Scene& scene, const Vec3d& point, const SceneFilter& solid, double time) {
  constexpr double kDeep = 1e-6;
  InstanceId found{};
  for (const Vec3d& way : {Vec3d{kDeep, 0, 0}, Vec3d{0, kDeep, 0}, Vec3d{0, 0, kDeep}})
    for (const Vec3d& near : {point + way, point - way}) {
      const SceneNearest nearest = scene.nearest(near, 0, solid, time);
      if (!nearest || nearest.away != Vec3d{}) return {};
      found = nearest.instance;
    }
  return found;
}

}  // namespace

ProjectileDef projectile_of(const ScenarioShot& shot) {
  const IeeeMode mode;
  const BodyDef& body = shot.body;
  ProjectileDef p = shot.projectile;
  p.gravity_scale *= own_of(body).gravity_scale;
  if (body.drag_scale == 1) return p;
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

FlightHits flight_hits(const Scenario& scenario, const ScenarioShot& shot, const Flight& flight,
                       const SceneParts& parts) {
  const IeeeMode mode;
  FlightHits out;
  const auto is_of_thing = [](const Event& event) { return static_cast<bool>(event.instance); };
  if (std::ranges::none_of(flight.events(), is_of_thing)) return out;
  const SceneOfRun run{&scenario, parts.materials};
  Track track;
  track.launched = {number_of(scenario, shot), 1};
  for (const Event& event : flight.events()) {
    const ThingHit* hit = take_event(out.all, track, shot.body.collision, run, event, parts.scene);
    if (hit != nullptr) count_hit(out.on_things, out.by_thing, *hit, scenario);
  }
  drop_contacts(out.all);
  for (const ThingHit& hit : out.all) count_passage(out.passages, hit, scenario);
  return out;
}

std::vector<std::string> notes_of_beginnings(const Scenario& scenario, const Scene& scene,
                                             std::span<const InstanceId> things) {
  PHYSIM_ASSERT(things.size() == scenario.things.size());
  const IeeeMode mode;
  std::vector<std::string> notes;
  for (const ScenarioShot& shot : scenario.shots) {
    const std::string& name = shot.projectile.name;
    if (scenario.world.given && emitter_alone_of(scenario, name)) continue;
    const auto volley = std::ranges::find(scenario.volleys, name, &Volley::shot);
    const bool is_of_volley = scenario.world.given && volley != scenario.volleys.end();
    const CollisionDef& collision = shot.body.collision;
    if (collision.on_hit == OnHit::pass) continue;
    const SceneFilter solid{.layers = collision.layers, .sensors = false};
    const double time = is_of_volley ? volley->start : 0;
    const auto thing = std::ranges::find(things, around(scene, shot.launch.position, solid, time));
    if (thing == things.end()) continue;
    const std::string& met = scenario.things[static_cast<std::size_t>(thing - things.begin())].name;
    notes.push_back("shot " + in_quotes(name) + " begins inside of the thing " + in_quotes(met));
  }
  return notes;
}

}  // namespace physim
