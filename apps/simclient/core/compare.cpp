#include "simclient/core/compare.hpp"

#include <algorithm>
#include <chrono>

#include "physim/names.hpp"

namespace physim::client {
namespace {

/// After so many steps. One that has landed stays where it landed; one that left otherwise is not there any more.
std::optional<Vec3d> position_at(const Prediction& flight, std::size_t step) {
  if (step + 1 < flight.path.size()) return flight.path[step].position;
  return flight.impact ? std::optional(flight.path.back().position) : std::nullopt;
}

void measure_against(const Prediction& truth, ComparedRung& rung) {
  if (truth.path.empty() || rung.flight.path.empty()) return;
  const std::size_t steps = std::max(truth.path.size(), rung.flight.path.size());
  for (std::size_t i = 0; i < steps; ++i) {
    const auto a = position_at(truth, i), b = position_at(rung.flight, i);
    if (!a || !b) break;
    rung.at_end = length(*b - *a);
    rung.farthest = std::max(rung.farthest, rung.at_end);
  }
  rung.later = rung.flight.path.back().time - truth.path.back().time;
}

/// Of one step of each of a crowd [s].
double time_step(World& world, double dt, std::size_t crowd) {
  constexpr int kSteps = 12;
  double best = 1e9;
  for (int i = 0; i < kSteps; ++i) {
    const auto start = std::chrono::steady_clock::now();
    world.step(dt);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best / static_cast<double>(crowd);
}

double measure_cost(const Session& session, const ScenarioShot& shot) {
  constexpr std::size_t kMany = 1024;
  WorldDef def = session.world().def();
  def.environment = session.scenario().environment;
  def.pools.clear();
  def.threading.threads = 1;
  def.ground.mode = GroundMode::none;  // so that all of them fly all the time
  Result<World> made = World::create(def);
  if (!made) return 0;
  World& world = *made;
  BodyDef body = shot.body;
  body.pool = 0;
  body.despawn = {};
  const Result<KindId> kind = world.add_kind(shot.projectile, body);
  const std::vector<Launch> launches(kMany, shot.launch);
  std::vector<ProjectileId> ids(kMany);
  if (!kind || world.spawn(*kind, launches, ids) != kMany) return 0;
  return time_step(world, def.step, kMany);
}

}  // namespace

std::vector<ComparedRung> compare_rungs(const Session& session, const ScenarioShot& shot,
                                        const std::vector<std::string>& presets, CostTable& costs) {
  std::vector<ComparedRung> rungs;
  const auto add = [&](const std::string& name, const Fidelity& fidelity) {
    ScenarioShot changed = shot;
    changed.projectile.fidelity = fidelity;
    changed.cheapest_within.reset();
    ComparedRung rung{name, fidelity, palette(rungs.size()), predict(session, changed)};
    if (!rung.flight.error) rung.per_step = costs.of(session, changed);
    rungs.push_back(std::move(rung));
  };
  add("as set", shot.projectile.fidelity);
  for (const std::string& name : presets)
    if (const auto fidelity = fidelity_preset(name)) add(name, *fidelity);
  rungs.back().is_truth = true;
  for (ComparedRung& rung : rungs) measure_against(rungs.back().flight, rung);
  return rungs;
}

double CostTable::of(const Session& session, const ScenarioShot& shot) {
  for (const auto& [projectile, seconds] : known_)
    if (projectile == shot.projectile) return seconds;
  if (known_.size() >= 64) known_.clear();
  known_.emplace_back(shot.projectile, measure_cost(session, shot));
  return known_.back().second;
}

}  // namespace physim::client
