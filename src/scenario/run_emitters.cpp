// Emitters of a run: those of its scenario added to its world, and their particles by group.
#include "scenario/emitter_maker.hpp"
#include "scenario/suggest.hpp"
#include "scenario/world_run_impl.hpp"

namespace physim {

Status WorldRun::Impl::add_emitters() {
  const auto order = order_of_emitters(scenario, names.emitters);
  PHYSIM_ASSERT(order.ok());  // circles are refused when a scenario is read
  for (const std::size_t i : *order) {
    const ScenarioEmitter& emitter = scenario.emitters[i];
    const Result<EmitterDef> def = in_world(i);
    if (!def) return def.error();
    const Result<EmitterId> added = world.add_emitter(*def);
    if (!added) return with_place(added.error(), scenario.file + ": emitter " + in_quotes(emitter.def.name));
    group_of(i).emitter = *added;
  }
  return {};
}

/// The emitters of a run are the last of its groups.
WorldGroup& WorldRun::Impl::group_of(std::size_t emitter) {
  PHYSIM_ASSERT(emitter < scenario.emitters.size());
  return groups[groups.size() - scenario.emitters.size() + emitter];
}

/// An emitter with the kinds and ids of this run's world, which has those that its subs name.
Result<EmitterDef> WorldRun::Impl::in_world(std::size_t index) {
  const ScenarioEmitter& emitter = scenario.emitters[index];
  const std::size_t shot = index_of_shot(emitter.shot);
  const Launch& launch = scenario.shots[shot].launch;
  EmitterDef def = def_of(emitter);
  def.kind = group_of(index).kind;
  def.launch.rail_length = launch.rail_length;
  def.launch.attitude = launch.attitude;
  def.launch.spin = launch.spin;
  if (!emitter.follows.empty()) def.follows = lone[index_of_shot(emitter.follows)];
  if (!emitter.tracer.empty()) {
    const Result<KindId> tracer = kind_of(index_of_shot(emitter.tracer));
    if (!tracer) return tracer.error();
    def.gun.tracer = *tracer;
  }
  for (std::size_t i = 0; i < def.subs.size(); ++i)  // none yet: it fires itself
    def.subs[i].emitter = group_of(*names.emitters.find(emitter.subs[i].emitter)).emitter;
  return def;
}

const std::size_t* WorldRun::Impl::group_fired_by(std::uint32_t emitter) {
  const auto known = group_of_emitter.find(emitter);
  if (known != group_of_emitter.end() && groups[known->second].emitter.index == emitter) return &known->second;
  group_of_emitter.clear();
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (groups[i].emitter) group_of_emitter.emplace(groups[i].emitter.index, i);
  const auto found = group_of_emitter.find(emitter);
  return found != group_of_emitter.end() ? &found->second : nullptr;
}

/// The track of what an emitter fired; null where none did.
Track* WorldRun::Impl::adopt(const Event& born) {
  const auto index = static_cast<std::uint32_t>(born.value);  // of the emitter
  const std::size_t* const fired = index == 0 ? nullptr : group_fired_by(index);
  if (fired == nullptr) return nullptr;
  if (tracks.size() <= born.id.index) tracks.resize(born.id.index + std::size_t{1});
  const std::size_t group = *fired;
  if (const Track& before = tracks[born.id.index]; before.generation != 0)
    taken_over.emplace(ProjectileId{born.id.index, before.generation}, before);
  tracks[born.id.index] = {born.id.generation, {group, ++launches}, false, born.time, born.position};
  return &tracks[born.id.index];
}

}  // namespace physim
