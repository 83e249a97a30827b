#include "scenario/names.hpp"

namespace physim {

std::string in_files(std::string text) {
  constexpr std::string_view kShot = "shot.", kLetters = "abcdefghijklmnopqrstuvwxyz";
  for (const std::string_view member : {"launch.", "projectile."})
    for (std::size_t at = 0; (at = text.find(member, at)) != text.npos; ++at) {
      const bool is_word = at == 0 || std::string_view(" \"'`(").find(text[at - 1]) != std::string_view::npos;
      const std::size_t end = at + member.size();
      const bool has_name = end < text.size() && kLetters.find(text[end]) != kLetters.npos;
      if (is_word && has_name) text.replace(at, member.size(), kShot);
    }
  return text;
}

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
