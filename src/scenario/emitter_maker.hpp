// Emitters of a scenario as those of a world.
#pragma once

#include <algorithm>

#include "base/assert.hpp"
#include "physim/scenario.hpp"
#include "scenario/scene_maker.hpp"

namespace physim {

/// All of an emitter but what only its world knows: kinds, whom it follows, and the ids of its subs' emitters.
[[nodiscard]] inline EmitterDef def_of(const ScenarioEmitter& emitter) {
  EmitterDef def = emitter.def;
  def.rotation = emitter.rotation.quaternion();
  def.motion = motion_of(emitter.motion);
  for (const ScenarioSub& sub : emitter.subs) def.subs.push_back(sub.def);
  return def;
}

/// The id of an emitter in the world of its scenario, where there are no others and none has gone.
[[nodiscard]] inline EmitterId emitter_id(std::size_t index) { return {static_cast<std::uint32_t>(index + 1), 1}; }

/// ... with those ids, and with what its shot's launch says.
[[nodiscard]] inline EmitterDef def_in_world(const Scenario& scenario, std::size_t index) {
  const ScenarioEmitter& emitter = scenario.emitters[index];
  EmitterDef def = def_of(emitter);
  const auto shot = std::ranges::find(scenario.shots, emitter.shot, [](const auto& s) { return s.projectile.name; });
  PHYSIM_ASSERT(shot != scenario.shots.end());  // names are checked when a scenario is read
  def.launch.rail_length = shot->launch.rail_length;
  def.launch.attitude = shot->launch.attitude;
  def.launch.spin = shot->launch.spin;
  for (std::size_t i = 0; i < def.subs.size(); ++i) {
    const auto fires = std::ranges::find(scenario.emitters, emitter.subs[i].emitter,
                                         [](const ScenarioEmitter& each) { return each.def.name; });
    PHYSIM_ASSERT(fires != scenario.emitters.end());
    def.subs[i].emitter = emitter_id(static_cast<std::size_t>(fires - scenario.emitters.begin()));
  }
  return def;
}

}  // namespace physim
