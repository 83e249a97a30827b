#include "report/world_steps.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "base/assert.hpp"

namespace physim::report {
namespace {

/// A world in which the shot flies all the time, in `count` copies.
std::optional<World> world_of(WorldDef def, const ScenarioShot& shot, std::vector<ProjectileId>& ids) {
  def.pools.clear();
  def.threading.threads = 1;
  def.ground.mode = GroundMode::none;
  Result<World> world = World::create(def);
  if (!world) return std::nullopt;
  BodyDef body = shot.body;
  body.pool = 0;
  body.despawn = {};
  const Result<KindId> kind = world->add_kind(shot.projectile, body);
  const std::vector<Launch> launches(ids.size(), shot.launch);
  if (!kind || world->spawn(*kind, launches, ids) != ids.size()) return std::nullopt;
  return std::move(*world);
}

}  // namespace

std::optional<double> time_of_step(const WorldDef& def, const ScenarioShot& shot, double dt) {
  PHYSIM_ASSERT(dt > 0);
  using Clock = std::chrono::steady_clock;
  constexpr int kSteps = 12;
  constexpr double kPatience = 0.1;  // [s]
  std::vector<ProjectileId> ids(1024);
  std::optional<World> world = world_of(def, shot, ids);
  if (!world) return std::nullopt;
  double best = kPatience * kSteps, spent = 0;
  for (int i = 0; i < kSteps && spent < kPatience; ++i) {
    const auto start = Clock::now();
    world->step(dt);
    const double time = std::chrono::duration<double>(Clock::now() - start).count();
    best = i == 0 ? time : std::min(best, time);
    spent += time;
  }
  return best / static_cast<double>(ids.size());
}

std::optional<double> error_of_steps(const WorldDef& def, const ScenarioShot& shot, double dt,
                                     const Flight& reference) {
  PHYSIM_ASSERT(dt > 0 && !reference.error());
  constexpr double kMostFrames = 36000;
  const double frames = reference.duration() / dt;
  if (!(frames <= kMostFrames)) return std::nullopt;
  std::vector<ProjectileId> ids(1);
  std::optional<World> world = world_of(def, shot, ids);
  if (!world) return std::nullopt;
  double largest = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    world->step(dt);
    const Projectile flown = (*world)[ids[0]];
    if (!flown.is_alive()) return std::nullopt;
    largest = std::max(largest, length(flown.position() - reference.at(frame * dt).position));
  }
  return largest;
}

}  // namespace physim::report
