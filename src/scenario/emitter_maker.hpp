// Emitters of a scenario as those of a world.
#pragma once

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

}  // namespace physim
