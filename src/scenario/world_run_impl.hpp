// What is behind a WorldRun.
#pragma once

#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/assert.hpp"
#include "scenario/names.hpp"
#include "scenario/run_state.hpp"
#include "scenario/world_run.hpp"

namespace physim {

[[nodiscard]] inline Error with_place(Error error, const std::string& place) {
  error.place = place + (error.place.empty() ? "" : ": " + error.place);
  return error;
}

struct WorldRun::Impl : RunState {
  Scenario scenario;
  ScenarioNames names{scenario};
  World world;
  std::vector<MaterialId> materials;  // in the scene of the world
  std::vector<InstanceId> things;     // of Scenario::things
  std::vector<JointId> joints;        // of Scenario::joints
  std::vector<KindId> kinds;          // of Scenario::shots; none of a shot that has no group
  std::vector<Segment> segments;      // work space
  std::vector<ProjectileId> stopped;  // work space
  // Tracks with an index that a particle took over in the step of the counted events: it may appear before they
  // leave.
  std::map<ProjectileId, Track> taken_over;
  std::unordered_map<std::uint32_t, std::size_t> group_of_emitter;  // by EmitterId::index; made when it is asked for

  Impl(Scenario s, World w) : scenario(std::move(s)), world(std::move(w)) {
    lone.resize(scenario.shots.size()), kinds.resize(scenario.shots.size());
  }

  /// Where the shot of a name is, which is there: names are checked when a scenario is read.
  [[nodiscard]] std::size_t index_of_shot(const std::string& name) const {
    const std::optional<std::size_t> found = names.shots.find(name);
    PHYSIM_ASSERT(found.has_value());
    return *found;
  }
  Status load();
  Status set_scene();
  Result<KindId> kind_of(std::size_t shot);
  Status add_group(const std::string& name, std::size_t shot);
  Status add_group(const std::string& name, std::size_t shot, const Volley& volley);
  Status add_emitters();
  WorldGroup& group_of(std::size_t emitter);
  Result<EmitterDef> in_world(std::size_t emitter);
  /// The group of an emitter's particles; null: no group.
  [[nodiscard]] const std::size_t* group_fired_by(std::uint32_t emitter);
  Track* adopt(const Event& born);
  [[nodiscard]] std::string place_of_shot(std::size_t index) const;
  Status add_forces(bool to_shots);
  Status add_force(const ScenarioForce& force);
  Status add_joints();
  [[nodiscard]] std::uint64_t steps() const;
  [[nodiscard]] double coming_step() const;
  void fire();
  void fire(Magazine& magazine);
  void look_at_wall(double dt);
  void count(std::span<const Event> news);
  void touch(Track& track, WorldGroup& group, double time, const Vec3d& position, const Vec3d& velocity);
  void step();
  [[nodiscard]] Track* track_of(ProjectileId id);
};

}  // namespace physim
