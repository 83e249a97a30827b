#include "simclient/core/prediction.hpp"

#include <algorithm>
#include <cmath>

namespace physim::client {
namespace {

constexpr std::uint64_t kMaxSteps = 12000;
constexpr double kMostBehind = 20000;  // steps; a world that is farther behind the session's is saved anew
constexpr int kMostHits = 4;           // on things: what comes later hangs on the last digits of the aim

void look(Prediction& prediction, const Event& event) {
  if (event.kind != EventKind::landed && event.kind != EventKind::expired && event.kind != EventKind::hit) return;
  TrackSample at = prediction.path.back();
  at.time = event.time, at.position = event.position, at.velocity = event.velocity;
  prediction.path.push_back(at);
}

/// Steps the world until the shot is gone or rests, or the limit is reached.
void fly(World& world, ProjectileId id, std::uint64_t limit, Prediction& prediction) {
  const ProjectileView projectile = world[id];
  const double start = world.time();
  int hits = 0;
  prediction.is_cut = false;
  for (std::uint64_t i = 0; i < limit && projectile.is_alive() && !projectile.is_asleep() && hits < kMostHits; ++i) {
    world.step(world.def().step);
    bool has_hit = false;  // once a step: what slides along a thing touches it all the time
    for (Event event : world.events()) {
      if (event.id != id) continue;
      event.time -= start;
      look(prediction, event);
      has_hit |= event.kind == EventKind::bounced && event.instance;
      has_hit |= event.kind == EventKind::ricocheted || event.kind == EventKind::penetrated;
    }
    hits += has_hit;
    if (projectile.is_alive()) prediction.path.push_back(sample_of(projectile, projectile.age()));
    if (projectile.status() == LifeStatus::landed) return;  // where it is, it stays
  }
  prediction.is_cut = projectile.is_alive() && !projectile.is_asleep() && hits < kMostHits;
}

}  // namespace

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

Prediction Predictor::predict(const Session& session, const ScenarioShot& shot, double max_time) {
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
  fly(world, *fired, std::min(kMaxSteps, static_cast<std::uint64_t>(std::ceil(max_time / world.def().step))),
      prediction);
  return prediction;
}

}  // namespace physim::client
