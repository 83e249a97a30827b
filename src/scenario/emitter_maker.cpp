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

Result<std::vector<std::size_t>> order_of_emitters(const Scenario& scenario, const NameIndex& names) {
  const std::size_t count = scenario.emitters.size();
  std::vector<std::vector<std::size_t>> fired_by(count);  // those that wait for an emitter
  std::vector<std::size_t> waits(count), round(count), order;
  for (std::size_t i = 0; i < count; ++i)
    for (const ScenarioSub& sub : scenario.emitters[i].subs) {
      const std::optional<std::size_t> fires = names.find(sub.emitter);
      PHYSIM_ASSERT(fires.has_value());  // names are checked before
      if (*fires != i) fired_by[*fires].push_back(i), ++waits[i];
    }
  for (std::size_t i = 0; i < count; ++i)
    if (waits[i] == 0) order.push_back(i);
  for (std::size_t k = 0; k < order.size(); ++k)
    for (const std::size_t i : fired_by[order[k]]) {
      // In rounds over the list, each takes those that may exist by then.
      round[i] = std::max(round[i], round[order[k]] + (i < order[k] ? 1 : 0));
      if (--waits[i] == 0) order.push_back(i);
    }
  if (order.size() < count) {
    const auto left =
        static_cast<std::size_t>(std::ranges::find_if(waits, [](auto n) { return n > 0; }) - waits.begin());
    return Error{"emitters fire each other in a circle", scenario.emitters[left].def.name,
                 "an emitter may fire itself, and those that do not lead back to it"};
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(round[i], i); });
  return order;
}

}  // namespace physim
