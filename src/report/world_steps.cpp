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

/// The least time of some steps for each of `count` copies, the first step left out: it takes in memory, and begins
/// rails, burns and the steps of adaptive integrators [s].
std::optional<double> least_time(const WorldDef& def, const ScenarioShot& shot, double dt, std::size_t count) {
  using Clock = std::chrono::steady_clock;
  constexpr int kSteps = 12;
  constexpr double kPatience = 0.1;  // [s]
  std::vector<ProjectileId> ids(count);
  std::optional<World> world = world_of(def, shot, ids);
  if (!world) return std::nullopt;
  world->step(dt);
  double least = kInfinity, spent = 0;
  for (int i = 0; i < kSteps && (i == 0 || spent < kPatience); ++i) {
    const auto start = Clock::now();
    world->step(dt);
    const double time = std::chrono::duration<double>(Clock::now() - start).count();
    least = std::min(least, time);
    spent += time;
  }
  return least / static_cast<double>(count);
}

}  // namespace

std::optional<double> time_of_step(const WorldDef& def, const ScenarioShot& shot, double dt) {
  PHYSIM_ASSERT(dt > 0);
  constexpr std::size_t kFew = 64, kMany = 1024;
  constexpr double kSlow = 100e-6;  // a step so long takes as long in any company [s]
  const std::optional<double> of_few = least_time(def, shot, dt, kFew);
  return of_few && *of_few < kSlow ? least_time(def, shot, dt, kMany) : of_few;
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
