// Force generators of a world: coming, going, and whom they act on.
#include <algorithm>
#include <cmath>

#include "world/world_impl.hpp"

namespace physim {
namespace {

bool by_slot(ProjectileId a, ProjectileId b) {
  return a.index != b.index ? a.index < b.index : a.generation < b.generation;
}

bool contains(const std::vector<ProjectileId>& ids, ProjectileId id) {
  return std::binary_search(ids.begin(), ids.end(), id, by_slot);
}

/// Calls f with the slot of everyone alive whom a generator acts on or ends at; maybe twice.
template <class F>
void each_target(const Generator& g, const Registry& registry, const WorldState& state, const F& f) {
  for (const ProjectileId id : g.def.target.ids)
    if (state.find(id)) f(id.index);
  const ProjectileId other = other_end(g.def.law);
  if (other && state.find(other)) f(other.index);
  if (!has_group(g.def.target)) return;
  for (std::uint32_t slot = 1; slot < state.slots.size(); ++slot)
    if (state.slots[slot].is(kAlive) && is_in_group(g, registry, state, slot)) f(slot);
}

}  // namespace

// --------------------------------------------------------------------------------------------------- who is forced
bool WorldImpl::is_target(std::uint32_t slot) const {
  if (state.force_order.empty()) return false;
  if (state.forces_on.contains(slot)) return true;
  return std::any_of(state.group_forces.begin(), state.group_forces.end(),
                     [&](std::uint32_t index) { return is_in_group(state.generators[index], registry, state, slot); });
}

bool WorldImpl::feels_forces(std::uint32_t index) const {
  if (state.force_order.empty()) return false;
  const Slot& slot = state.slots[index];
  return kind_of(slot).rungs[slot.rung].in_use.fidelity.motion == Motion::force && is_target(index);
}

void WorldImpl::update_forced(std::uint32_t index) {
  Slot& slot = state.slots[index];
  const bool forced = feels_forces(index);
  if (slot.is(kForced) == forced) return;
  slot.set(kForced, forced);
  if (!relocate(index)) slot.set(kForced, !forced);
}

void WorldImpl::stir(std::uint32_t index) {
  const bool felt = state.slots[index].is(kForced);
  update_forced(index);
  if (state.slots[index].is(kAsleep) && (felt || state.slots[index].is(kForced))) wake(index);
}

void WorldImpl::stir_targets(const Generator& g) {
  each_target(g, registry, state, [this](std::uint32_t slot) { stir(slot); });
}

void WorldImpl::count_targets(const Generator& g, bool on) {
  const auto count = [&](ProjectileId id) {
    if (!find(id)) return;
    if (on) {
      ++state.forces_on[id.index];
    } else if (const auto at = state.forces_on.find(id.index); at != state.forces_on.end() && --at->second == 0) {
      state.forces_on.erase(at);
    }
  };
  for (const ProjectileId id : g.def.target.ids) count(id);
  if (const ProjectileId other = other_end(g.def.law)) count(other);
}

// --------------------------------------------------------------------------------------------------- begin and end
void WorldImpl::begin_generator(std::uint32_t index) {
  Generator& g = state.generators[index];
  g.begun = true;
  count_targets(g, true);
  if (has_group(g.def.target)) state.group_forces.push_back(index);
  stir_targets(g);
}

void WorldImpl::end_generator(std::uint32_t index) {
  Generator& g = state.generators[index];
  std::erase(state.force_order, index);
  if (g.begun) {
    count_targets(g, false);
    std::erase(state.group_forces, index);
    stir_targets(g);
  }
  const std::uint32_t generation = g.generation + 1;
  g = {};
  g.generation = generation;
  state.free_generators.push_back(index);
}

void WorldImpl::begin_generators(double dt) {
  for (const std::uint32_t index : state.force_order) {
    const Generator& g = state.generators[index];
    if (!g.begun && g.start - state.clock.time() < (1 - kSameTime) * dt) begin_generator(index);
  }
}

void WorldImpl::end_generators() {
  forced_scratch.over.clear();
  for (const std::uint32_t index : state.force_order) {
    const Generator& g = state.generators[index];
    const ForceTarget& target = g.def.target;
    const ProjectileId other = other_end(g.def.law);
    const bool nobody = !has_group(target) && std::none_of(target.ids.begin(), target.ids.end(),
                                                           [this](ProjectileId id) { return find(id) != nullptr; });
    const bool over = g.end - state.clock.time() <= kSameTime * state.clock.dt;
    if (over || nobody || (other && !find(other))) forced_scratch.over.push_back(index);
  }
  for (const std::uint32_t index : forced_scratch.over) end_generator(index);
}

// --------------------------------------------------------------------------------------------------- the public door
Status WorldImpl::refuses(const ForceDef& force) const {
  if (Status status = check(force); !status) return status;
  const ForceTarget& target = force.target;
  if (target.kind && !registry.has_kind(target.kind))
    return Error{"there is no such kind", "force.target.kind", "add_kind() makes one"};
  for (std::size_t i = 0; i < target.ids.size(); ++i)
    if (!find(target.ids[i]))
      return Error{"it is gone", "force.target.ids[" + std::to_string(i) + "]", "is_alive() tells"};
  const ProjectileId other = other_end(force.law);
  if (other && !find(other)) return Error{"it is gone", "force.other", "is_alive() tells"};
  return {};
}

Result<ForceId> WorldImpl::add_force(const ForceDef& force) {
  if (const Status status = refuses(force); !status) return status.error();
  std::uint32_t index;
  if (state.free_generators.empty()) {
    index = static_cast<std::uint32_t>(state.generators.size());
    state.generators.emplace_back();
  } else {
    index = state.free_generators.back();
    state.free_generators.pop_back();
  }
  Generator& g = state.generators[index];
  g.active = true;
  g.def = force;
  auto& ids = g.def.target.ids;
  std::sort(ids.begin(), ids.end(), by_slot);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  g.start = state.clock.time() + force.delay;
  g.end = g.start + force.duration;
  const ForceId id{index, g.generation};
  state.force_order.push_back(index);
  if (force.delay == 0) begin_generator(index);
  return id;
}

Result<ForceId> World::add_force(const ForceDef& force) {
  const Recorded<Call::add_force> call(impl_->recorder, force);
  Result<ForceId> added = impl_->add_force(force);
  if (added) call.returns(*added);
  return added;
}

Result<ForceId> Projectile::add_force(ForceLaw law, double duration) {
  WorldImpl& w = world();
  const Recorded<Call::add_force_on> call(w.recorder, id_, law, duration);
  ForceDef force;
  force.law = std::move(law);
  force.target.ids = {id_};
  force.duration = duration;
  Result<ForceId> added = w.add_force(force);
  if (added) call.returns(*added);
  return added;
}

Generator* WorldImpl::find(ForceId force) {
  if (force.index == 0 || force.index >= state.generators.size()) return nullptr;
  Generator& g = state.generators[force.index];
  return g.active && g.generation == force.generation ? &g : nullptr;
}

Status World::remove_force(ForceId force) {
  const Recorded<Call::remove_force> call(impl_->recorder, force);
  if (!impl_->find(force)) return Error{"it is gone already", "force", "is_active() tells"};
  impl_->end_generator(force.index);
  return {};
}

Status Projectile::remove_force(ForceId force) {
  const Recorded<Call::remove_force_from> call(world().recorder, force, id_);
  if (!world().find(force)) return Error{"it is gone already", "force", "is_active() tells"};
  if (!world().find(id_)) return Error{"it is gone", "id", "is_alive() tells"};
  return world().remove_target(force, id_);
}

Status WorldImpl::remove_target(ForceId force, ProjectileId id) {
  Generator& g = *find(force);
  auto& ids = g.def.target.ids;
  const bool named = contains(ids, id);
  const bool in_group = is_in_group(g, registry, state, id.index);
  if (!named && !in_group) return Error{"it does not act on it", "id", "it acts on its targets"};
  if (named && ids.size() == 1 && !has_group(g.def.target)) {
    end_generator(force.index);
    return {};
  }
  if (g.begun) count_targets(g, false);
  if (named) ids.erase(std::lower_bound(ids.begin(), ids.end(), id, by_slot));
  if (in_group) g.except.push_back(id);
  if (g.begun) count_targets(g, true);
  if (g.begun) stir(id.index);
  return {};
}

bool World::is_active(ForceId force) const { return impl_->find(force) != nullptr; }
std::size_t World::force_count() const { return impl_->state.force_order.size(); }

// --------------------------------------------------------------------------------------------------- in a step
Vec3d WorldImpl::generator_force(std::uint32_t index) const {
  if (!is_target(index)) return {};
  ForceRows rows;
  rows.add(registry, state, index);
  ForceField field(registry, state, rows, forced_scratch.zones);
  field.begin_step(state.clock.dt);
  const BodyState now = state_of(state.slots[index]);
  rows.position[0] = now.position;
  rows.velocity[0] = now.velocity;
  field.evaluate(0);
  return rows.force[0];
}

void WorldImpl::step_forced(double dt) {
  const SettleContext context{&def, &registry, &state, dt, state.clock.now(), state.clock.time()};
  state.counters.projectile_steps += step_forced_rows(context, forced_scratch);
}

}  // namespace physim
