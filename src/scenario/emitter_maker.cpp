#include "scenario/emitter_maker.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/text.hpp"
#include "scenario/scene_maker.hpp"
#include "scenario/suggest.hpp"

namespace physim {

EmitterDef def_of(const ScenarioEmitter& emitter) {
  EmitterDef def = emitter.def;
  def.rotation = emitter.rotation.quaternion();
  def.motion = motion_of(emitter.motion);
  for (const ScenarioSub& sub : emitter.subs) def.subs.push_back(sub.def);
  return def;
}

std::size_t index_of_emitter(const Scenario& scenario, const std::string& name) {
  const auto found =
      std::ranges::find(scenario.emitters, name, [](const ScenarioEmitter& each) { return each.def.name; });
  return static_cast<std::size_t>(found - scenario.emitters.begin());
}

Result<std::vector<std::size_t>> order_of_emitters(const Scenario& scenario) {
  const std::size_t count = scenario.emitters.size();
  std::vector<std::size_t> order;
  std::vector<bool> is_in(count);
  const auto may_come = [&](std::size_t i) {
    return std::ranges::all_of(scenario.emitters[i].subs, [&](const ScenarioSub& sub) {
      const std::size_t fires = index_of_emitter(scenario, sub.emitter);
      PHYSIM_ASSERT(fires < count);  // names are checked before
      return fires == i || is_in[fires];
    });
  };
  while (order.size() < count) {
    const std::size_t before = order.size();
    for (std::size_t i = 0; i < count; ++i)
      if (!is_in[i] && may_come(i)) order.push_back(i), is_in[i] = true;
    if (order.size() > before) continue;
    const auto left = static_cast<std::size_t>(std::ranges::find(is_in, false) - is_in.begin());
    return Error{"emitters fire each other in a circle", scenario.emitters[left].def.name,
                 "an emitter may fire itself, and those that do not lead back to it"};
  }
  return order;
}

}  // namespace physim
