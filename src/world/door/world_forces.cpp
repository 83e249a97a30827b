// Force generators of a world: coming, going, and whom they act on.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/restored.hpp"
#include "world/couple/world_impl.hpp"
#include "world/step/drive.hpp"

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
    if (state.slots.find(id)) f(id.index);
  const ProjectileId other = other_end(g.def.law);
  if (other && state.slots.find(other)) f(other.index);
  if (!has_group(g.def.target)) return;
  state.slots.each_alive([&](std::uint32_t slot) {
    if (is_in_group(g, registry, state, slot)) f(slot);
  });
}

}  // namespace

// --------------------------------------------------------------------------------------------------- who is forced
bool WorldImpl::is_target(std::uint32_t slot) const {
  if (state.generators.empty()) return false;
  if (state.generators.is_named(slot)) return true;
  return std::any_of(state.generators.groups().begin(), state.generators.groups().end(),
                     [&](std::uint32_t index) { return is_in_group(state.generators[index], registry, state, slot); });
}

bool WorldImpl::is_moved_by_forces(std::uint32_t index) const {
  const Slot& slot = state.slots[index];
  return registry.kind(slot.kind).on(slot.rung).in_use.fidelity.motion == Motion::force;
}

bool WorldImpl::feels_forces(std::uint32_t index) const {
  return (is_target(index) || state.emitters.law_of(index)) && is_moved_by_forces(index);
}

void WorldImpl::update_forced(std::uint32_t index) {
  Slot& slot = state.slots[index];
  const bool forced = feels_forces(index);
  if (slot.is(kForced) == forced) return;
  slot.set(kForced, forced);
  if (!placement.relocate(index)) slot.set(kForced, !forced);
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
    if (find(id)) state.generators.count(id.index, on);
  };
  for (const ProjectileId id : g.def.target.ids) count(id);
  if (const ProjectileId other = other_end(g.def.law)) count(other);
}

// --------------------------------------------------------------------------------------------------- begin and end
void WorldImpl::begin_generator(std::uint32_t index) {
  const Generator& g = state.generators[index];
  state.generators.begin(index, has_group(g.def.target));
  count_targets(g, true);
  stir_targets(g);
}

void WorldImpl::resume_generator(std::uint32_t index) {
  const Generator& g = state.generators[index];
  state.generators.resume(index, has_group(g.def.target));
  count_targets(g, true);
}

void WorldImpl::end_generator(std::uint32_t index) {
  const Generator gone = std::move(state.generators[index]);
  state.generators[index] = {.generation = gone.generation, .active = true};
  state.generators.erase(index);
  if (!gone.begun) return;
  count_targets(gone, false);
  stir_targets(gone);
}

void WorldImpl::begin_generators(double dt) {
  for (const std::uint32_t index : state.generators.order()) {
    const Generator& g = state.generators[index];
    if (!g.begun && g.start - state.clock.time() < (1 - kSameTime) * dt) begin_generator(index);
  }
}

void WorldImpl::end_generators() {
  forced_scratch.over.clear();
  for (const std::uint32_t index : state.generators.order()) {
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
  const ForceId id = state.generators.add(force, state.clock.time());
  auto& ids = state.generators[id.index].def.target.ids;
  std::sort(ids.begin(), ids.end(), by_slot);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (force.delay == 0) begin_generator(id.index);
  return id;
}

Result<ForceId> World::add_force(const ForceDef& force) {
  WorldImpl& w = impl();
  const Recorded<Call::add_force> call(w, force);
  if (call.is_refused()) return call.refusal();
  return call.returns(w.add_force(force));
}

Result<ForceId> Projectile::add_force(ForceLaw law) { return add_force(std::move(law), kInfinity); }

Result<ForceId> Projectile::add_force(ForceLaw law, double duration) {
  WorldImpl& w = world();
  const Recorded<Call::add_force_on> call(w, id_, law, duration);
  if (call.is_refused()) return call.refusal();
  ForceDef force;
  force.law = std::move(law);
  force.target.ids = {id_};
  force.duration = duration;
  return call.returns(w.add_force(force));
}

Status World::remove_force(ForceId force) {
  WorldImpl& w = impl();
  const Recorded<Call::remove_force> call(w, force);
  if (call.is_refused()) return call.refusal();
  if (!w.state.generators.find(force)) return Error{"it is gone already", "force", "is_active() tells"};
  w.end_generator(force.index);
  return {};
}

Status Projectile::remove_force(ForceId force) {
  const Recorded<Call::remove_force_from> call(world(), force, id_);
  if (call.is_refused()) return call.refusal();
  if (!world().state.generators.find(force)) return Error{"it is gone already", "force", "is_active() tells"};
  if (!world().find(id_)) return Error{"it is gone", "id", "is_alive() tells"};
  return world().remove_target(force, id_);
}

Status WorldImpl::remove_target(ForceId force, ProjectileId id) {
  Generator& g = state.generators[force.index];
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

bool World::is_active(ForceId force) const { return impl().state.generators.find(force) != nullptr; }
std::size_t World::force_count() const { return impl().state.generators.order().size(); }

std::size_t WorldImpl::felt_by(const Generator& g) const {
  std::vector<std::uint32_t> felt;
  each_target(g, registry, state, [&](std::uint32_t index) {
    const Slot& slot = state.slots[index];
    const bool feels = registry.kind(slot.kind).on(slot.rung).in_use.fidelity.motion == Motion::force;
    if (feels && !slot.is(kKinematic | kInfiniteMass)) felt.push_back(index);
  });
  std::ranges::sort(felt);
  return static_cast<std::size_t>(std::unique(felt.begin(), felt.end()) - felt.begin());
}

std::size_t World::felt_by(ForceId force) const {
  const Generator* g = impl().state.generators.find(force);
  return g ? impl().felt_by(*g) : 0;
}

// --------------------------------------------------------------------------------------------------- in a step
Vec3d WorldImpl::generator_force(std::uint32_t index, const BodyState& there, double* drag_rate) const {
  if (drag_rate) *drag_rate = 0;
  if (!is_target(index)) return {};
  ForceRows rows;
  rows.add(registry, state, index);
  ZoneDrag zones;
  ForceField field(registry, state, rows, zones);
  if (is_closed()) field.leave_functions_out();
  const Restored<const Gate*> asking(in_question, this);
  field.begin_step(state.clock.time(), state.clock.dt);
  rows.position[0] = there.position;
  rows.velocity[0] = there.velocity;
  field.evaluate_now();
  if (drag_rate) *drag_rate = rows.drag_rate[0];
  return rows.force[0];
}

Vec3d WorldImpl::emitter_push(std::uint32_t index) const {
  Drive drive(registry, state, index);
  if (!drive) return {};
  const Slot& slot = state.slots[index];
  drive.begin_step(registry.cohort(slot.cohort).key.fidelity.integrator, state.clock.time(), state.clock.dt);
  const BodyState now = state.state_of(slot);
  return drive.at(state.clock.time(), {now.position, now.velocity}).a;
}

void WorldImpl::step_forced(double dt) {
  const SettleContext context = settle_context(dt);
  state.counters.projectile_steps += step_forced_rows(context, forced_scratch);
}

}  // namespace physim
