#include "scenario/names.hpp"

namespace physim {

ScenarioNames::ScenarioNames(const Scenario& scenario) {
  for (const ScenarioShot& shot : scenario.shots) shots.add(shot.projectile.name);
  for (const ScenarioThing& thing : scenario.things) things.add(thing.name);
  for (const PoolDef& pool : scenario.world.def.pools) pools.add(pool.name);
  for (const Volley& volley : scenario.volleys) {
    volleys.add(volley.name);
    of_volleys.insert(volley.shot);
  }
  for (const ScenarioEmitter& emitter : scenario.emitters) {
    emitters.add(emitter.def.name);
    of_emitters.insert(emitter.shot);
    if (!emitter.tracer.empty()) of_emitters.insert(emitter.tracer);
  }
}

std::vector<std::string_view> ScenarioNames::lone_shots() const {
  std::vector<std::string_view> names;
  for (const std::string_view name : shots.all())
    if (is_alone(name)) names.push_back(name);
  return names;
}

std::vector<std::string_view> ScenarioNames::groups() const {
  std::vector<std::string_view> names = lone_shots();
  names.insert(names.end(), volleys.all().begin(), volleys.all().end());
  names.insert(names.end(), emitters.all().begin(), emitters.all().end());
  return names;
}

}  // namespace physim
