// What is behind a WorldRun.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/assert.hpp"
#include "physim/world_run.hpp"
#include "scenario/run_state.hpp"

namespace physim {

[[nodiscard]] inline Error with_place(Error error, const std::string& place) {
  error.place = place + (error.place.empty() ? "" : ": " + error.place);
  return error;
}

/// Where the shot of a name is, which is there: names are checked when a scenario is read.
[[nodiscard]] inline std::size_t index_of(const std::vector<ScenarioShot>& shots, const std::string& name) {
  std::size_t i = 0;
  while (i < shots.size() && shots[i].projectile.name != name) ++i;
  PHYSIM_ASSERT(i < shots.size());
  return i;
}

struct WorldRun::Impl : RunState {
  Scenario scenario;
  World world;
  std::vector<MaterialId> materials;  // in the scene of the world
  std::vector<Segment> segments;      // work space
  std::vector<ProjectileId> stopped;  // work space
  // Tracks of those whose index a particle took over in the step whose events are counted: it may be born before they
  // leave.
  std::map<ProjectileId, Track> taken_over;

  Impl(Scenario s, World w) : scenario(std::move(s)), world(std::move(w)) { lone.resize(scenario.shots.size()); }

  Status load();
  Status set_scene();
  Result<KindId> kind_of(std::size_t shot);
  Status add_group(const std::string& name, std::size_t shot);
  Status add_group(const std::string& name, std::size_t shot, const Volley& volley);
  Status add_emitters();
  WorldGroup& group_of(std::size_t emitter);
  Result<EmitterDef> in_world(const ScenarioEmitter& emitter);
  Track* adopt(const Event& born);
  [[nodiscard]] std::string place_of_shot(std::size_t index) const;
  Status add_forces(bool to_shots);
  Status add_force(const ScenarioForce& force);
  Status add_joints();
  void fire();
  void fire(Magazine& magazine);
  void look_at_wall(double dt);
  void count(std::span<const Event> news);
  void touch(Track& track, WorldGroup& group, double time, const Vec3d& position, const Vec3d& velocity);
  void step();
  [[nodiscard]] Track* track_of(ProjectileId id);
};

}  // namespace physim
