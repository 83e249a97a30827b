// What a batch is asked to fly: shots with a projectile each, or launches of one, as structures or as columns.
#pragma once

#include <optional>
#include <span>

#include "base/assert.hpp"
#include "base/prefetch.hpp"
#include "model/sight.hpp"
#include "physim/flight.hpp"

namespace physim {

struct ShotList {
  std::span<const Shot> shots{};
  const ProjectileDef* one_projectile = nullptr;
  std::span<const Launch> launches{};
  const LaunchColumns* columns = nullptr;

  [[nodiscard]] std::size_t size() const {
    if (columns) return columns->size();
    return one_projectile ? launches.size() : shots.size();
  }
  /// But for what columns have of its drag: see ShotProjectiles.
  [[nodiscard]] const ProjectileDef& projectile(std::size_t i) const {
    return one_projectile ? *one_projectile : shots[i].projectile;
  }
  /// Whether columns have the drag of each shot.
  [[nodiscard]] bool has_own_drag() const { return columns && columns->has_drag(); }
  /// A launch, put together in `scratch` where it does not stand somewhere.
  [[nodiscard]] const Launch& launch(std::size_t i, Launch& scratch) const {
    PHYSIM_ASSERT(i < size());
    if (columns) return scratch = columns->at(i);
    return one_projectile ? launches[i] : shots[i].launch;
  }
  /// Prefetches a shot's structures: one with its own projectile is a kilobyte, read here and there.
  void prefetch(std::size_t i) const {
    if (i >= shots.size()) return;
    for (std::size_t at = 0; at < sizeof(Shot); at += 64) prefetch_at(&shots[i], at);
  }
  /// launch_speed() of each (model/sight.hpp).
  [[nodiscard]] double speed(std::size_t i) const {
    PHYSIM_ASSERT(i < size() && (!columns || !columns->common.velocity));
    if (columns) return columns->speed.empty() ? columns->common.speed : columns->speed[i];
    return launch_speed(one_projectile ? launches[i] : shots[i].launch);
  }
};

/// All that a batch is called with.
struct BatchTask {
  ShotList shots;
  const Environment& environment;  // of all shots ...
  const Weather& weather;          // ... but for this of each
  const Fidelity fidelity;         // a copy: it may lie in the result
  const Tolerance& tolerance;
  const Until& until;

  /// An environment that stands for those of all shots. Where they bring their own wind it is not calm, and air that
  /// they bring is no vacuum: what is granted must suit them all.
  [[nodiscard]] Environment granting() const {
    Environment all = environment;
    if (weather.has_wind() && !weather.moves_profile) all.wind = {};
    if (weather.has_wind()) all.wind.velocity = {1, 0, 0}, all.wind.field = {};
    if (!weather.density.empty()) all.atmosphere.density = 1;
    return all;
  }
};

/// The projectile of one shot after the other, as check() knows it.
class ShotProjectiles {
 public:
  explicit ShotProjectiles(const ShotList& shots) : shots_(shots) {
    if (shots.has_own_drag()) own_ = *shots.one_projectile;
  }
  [[nodiscard]] const ProjectileDef& of(std::size_t shot) {
    PHYSIM_ASSERT(shot < shots_.size());
    if (!own_) return shots_.projectile(shot);
    shots_.columns->put(shot, *own_);
    return *own_;
  }

 private:
  const ShotList& shots_;
  std::optional<ProjectileDef> own_;
};

/// The environment of one shot after the other.
class ShotEnvironments {
 public:
  explicit ShotEnvironments(const BatchTask& task) : task_(task) {
    if (!task.weather.empty()) own_ = task.environment;
  }
  [[nodiscard]] const Environment& of(std::size_t shot) {
    PHYSIM_ASSERT(shot < task_.shots.size());
    if (task_.weather.empty()) return task_.environment;
    if (task_.weather.moves_profile) own_.wind = task_.environment.wind;
    task_.weather.put(shot, own_);
    return own_;
  }

 private:
  const BatchTask& task_;
  Environment own_;
};

}  // namespace physim
