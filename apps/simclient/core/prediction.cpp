#include "simclient/core/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "simclient/core/stopwatch.hpp"
#include "simclient/core/subject.hpp"
#include "simclient/core/thinning.hpp"

namespace physim::client {
namespace {

constexpr std::uint64_t kAtOnce = 12000;                   // steps
constexpr std::uint64_t kMostSteps = 500000, kPart = 500;  // kPart: between looks at the machine's clock
constexpr double kMostBehind = 20000;  // steps; a world that is farther behind the session's is saved anew
constexpr int kMostHits = 4;           // on things: what comes later hangs on the last digits of the aim

void look(Prediction& prediction, const Event& event) {
  if (event.kind != EventKind::landed && event.kind != EventKind::expired && event.kind != EventKind::hit) return;
  TrackSample at = prediction.path.back();
  at.time = event.time, at.position = event.position, at.velocity = event.velocity;
  prediction.path.push_back(at);
}

}  // namespace

Prediction prediction_of(const Flight& flight, const Scenario& scenario) {
  Prediction prediction;
  if (flight.error()) return prediction.error = flight.error(), prediction;
  prediction.path = samples_of(flight, 0);  // enough for dots and an aim that is dragged
  prediction.muzzle = prediction.path.front().position;
  prediction.velocity = prediction.path.front().velocity;
  prediction.granted = flight.fidelity_in_use();
  prediction.is_cut = !has_end(flight, scenario.until);
  prediction.apsides = apsides_of(prediction.path, scenario.environment, prediction.granted.fidelity);
  return prediction;
}

Prediction beginning_of(Scenario scenario, const ScenarioShot& shot) {
  constexpr double kMoment = 1e-3;  // [s]
  scenario.until.time = std::min(scenario.until.time, kMoment);
  return prediction_of(fly_shot(scenario, shot), scenario);
}

/// The last sample of a path comes to where it crosses the wall of a world, if it does.
bool ends_at_wall(std::vector<TrackSample>& path, double wall) {
  if (path.size() < 2) return false;
  const TrackSample& last = path[path.size() - 2];
  const double from = last.position.x, to = path.back().position.x;
  if (!(from < wall && to >= wall)) return false;
  path.back() = between(last, path.back(), (wall - from) / (to - from));
  return true;
}

/// Steps the world until the shot is gone or rests, or the limit is reached.
void Predictor::fly(Prediction& prediction, std::uint64_t steps) {
  World& world = *world_;
  const ProjectileView projectile = world[id_];
  for (std::uint64_t i = 0; i < std::min(steps, left_) && prediction.grows; ++i) {
    world.step(world.def().step);
    bool has_hit = false;  // once a step: what slides along a thing touches it all the time
    for (Event event : world.events()) {
      if (event.id != id_) continue;
      event.time -= start_;
      look(prediction, event);
      has_hit |= event.kind == EventKind::bounced && event.instance;
      has_hit |= event.kind == EventKind::ricocheted || event.kind == EventKind::penetrated;
    }
    hits_ += has_hit;
    const bool is_alive = projectile.is_alive();
    if (is_alive) prediction.path.push_back(sample_of(projectile, projectile.age()));
    const bool stays = projectile.status() == LifeStatus::landed;
    const bool is_stopped = is_alive && wall_ && ends_at_wall(prediction.path, *wall_);
    prediction.grows = is_alive && !projectile.is_asleep() && hits_ < kMostHits && !stays && !is_stopped;
  }
  left_ -= std::min(steps, left_);
  prediction.is_cut = prediction.grows;
  prediction.grows &= left_ > 0;
}

/// The session's world as it is now, without those in it. One that was taken before catches up: nothing moves in it.
Status Predictor::take_world(const Session& session) {
  const World& now = session.world();
  const double step = now.def().step, behind = world_ ? std::round((now.time() - empty_.time()) / step) : -1;
  if (!(behind >= 0 && behind <= kMostBehind)) {
    const Result<std::vector<std::byte>> save = now.save();
    if (!save) return save.error();
    LoadOptions alone;
    alone.threading.threads = 1;
    Result<World> copy = World::load(*save, alone);
    if (!copy) return copy.error();
    world_ = std::move(*copy);
    world_->clear();
  } else {
    if (Status status = world_->restore(empty_); !status) return status;
    for (double i = 0; i < behind; ++i) world_->step(step);
    if (behind == 0) return {};
  }
  empty_ = world_->snapshot();
  return {};
}

Prediction Predictor::predict(const Session& session, const ScenarioShot& shot, double max_time, double patience) {
  Prediction prediction;
  if (Status status = take_world(session); !status) return prediction.error = status.error(), prediction;
  World& world = *world_;
  const Result<ProjectileId> fired = world.spawn(shot.projectile, shot.launch, body_of(session.scenario(), shot));
  if (!fired) return prediction.error = fired.error(), prediction;
  const ProjectileView projectile = world[*fired];
  prediction.muzzle = projectile.position();
  prediction.velocity = projectile.velocity();
  prediction.granted = projectile.fidelity_in_use();
  prediction.path.push_back(sample_of(projectile, projectile.age()));
  id_ = *fired, start_ = world.time(), hits_ = 0, thinned_ = 0;
  wall_ = session.scenario().world.given ? session.scenario().world.wall : std::nullopt;
  const auto revolution = revolution_time(session.scenario().environment, prediction.granted.fidelity,
                                          prediction.muzzle, prediction.velocity);
  const double steps = std::ceil(std::max(max_time, revolution.value_or(0)) / world.def().step);
  left_ = std::min(kMostSteps, static_cast<std::uint64_t>(std::min(steps, 1e9)));
  prediction.grows = projectile.is_alive();
  fly_at_once(prediction, patience);
  return prediction;
}

void Predictor::fly_at_once(Prediction& prediction, double patience) {
  const Stopwatch watch;
  for (std::uint64_t steps = 0; steps < kAtOnce && prediction.grows && watch.seconds() <= patience; steps += kPart)
    fly(prediction, kPart);
}

void Predictor::go_on(Prediction& prediction, double patience) {
  PHYSIM_ASSERT(world_ && prediction.grows);
  const Stopwatch watch;
  do {
    fly(prediction, kPart);
    if (prediction.path.size() - thinned_ > kFreshSamples || !prediction.grows) {
      thin_out(prediction.path, thinned_);
      thinned_ = prediction.path.size() - 1;
    }
  } while (prediction.grows && watch.seconds() <= patience);
}

}  // namespace physim::client
