// Making worlds; projectiles coming and going.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>

#include "flight/zero.hpp"
#include "math/elementary.hpp"
#include "model/sight.hpp"
#include "prepare/check.hpp"
#include "world/world_impl.hpp"

namespace physim {

WorldImpl::WorldImpl(const WorldDef& definition) : def(definition), registry(definition) {
  if (def.pools.empty()) def.pools.emplace_back();
  static std::atomic<std::uint64_t> worlds = 0;
  state.owner = ++worlds;
  state.pools.resize(def.pools.size());
  state.clock.dt = def.step;
  state.clock.time_scale = def.time_scale;
  state.detail = def.detail;
}

World::World() : World(WorldDef{}) {}
World::World(const WorldDef& def) : impl_(std::make_unique<WorldImpl>(def)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const WorldDef& def) {
  if (const Status status = check(def); !status) return status.error();
  return World(def);
}

// ------------------------------------------------------------------------------------------- kinds and environments
Result<KindId> World::add_kind(const ProjectileDef& projectile, const BodyDef& body) {
  const Recorded<Call::add_kind> call(impl_->recorder, projectile, body);
  Result<KindId> added = impl_->registry.add_kind(projectile, body);
  if (added) call.returns(*added);
  return added;
}

Result<std::uint32_t> World::add_environment(const Environment& environment) {
  const Recorded<Call::add_environment> call(impl_->recorder, environment);
  auto added = impl_->registry.add_environment(environment);
  if (added) call.returns(*added);
  return added;
}

Status World::set_environment(std::uint32_t index, const Environment& environment) {
  WorldImpl& w = *impl_;
  const Recorded<Call::set_environment> call(w.recorder, index, environment);
  if (Status status = w.registry.set_environment(index, environment); !status) return status;
  for (std::uint32_t slot = 1; slot < w.state.slots.size(); ++slot)
    if (w.state.slots[slot].is(kAlive) && w.kind_of(w.state.slots[slot]).body.environment == index) w.relocate(slot);
  return {};
}

// ------------------------------------------------------------------------------------------- slots
const Own& WorldImpl::own_of(std::uint32_t slot) const {
  static const Own none{};
  const auto found = state.own.find(slot);
  return found == state.own.end() ? none : found->second;
}

Own& WorldImpl::own(std::uint32_t slot) {
  const auto [at, added] = state.own.try_emplace(slot);
  if (added) {
    const BodyDef& body = kind_of(state.slots[slot]).body;
    at->second = {body.use_gravity ? body.gravity_scale : 0.0, body.frozen, body.frozen_rotation};
  }
  return at->second;
}

Tags& WorldImpl::tags(std::uint32_t slot) {
  const auto [at, added] = state.tags.try_emplace(slot);
  if (added) {
    const BodyDef& body = kind_of(state.slots[slot]).body;
    at->second = {0, body.layers, body.colour, body.label};
  }
  return at->second;
}

std::uint32_t WorldImpl::layers_of(std::uint32_t slot) const { return physim::layers_of(registry, state, slot); }

std::uint32_t WorldImpl::take_slot() {
  if (state.first_free != 0) {
    const std::uint32_t slot = state.first_free;
    state.first_free = state.slots[slot].row;
    if (state.first_free == 0) state.last_free = 0;
    // Slots that were freed at random lie all over the memory: the next one is fetched while this one is filled.
    __builtin_prefetch(&state.slots[state.first_free]);
    __builtin_prefetch(&state.birth[state.first_free]);
    __builtin_prefetch(&state.rest[state.first_free]);
    return slot;
  }
  state.slots.emplace_back();
  state.birth.push_back(0);
  state.rest.emplace_back();
  if (!state.links.empty()) state.links.emplace_back();
  return static_cast<std::uint32_t>(state.slots.size() - 1);
}

/// Slots are used again in the order they became free, so that what became of a projectile is known for long.
void WorldImpl::free_slot(std::uint32_t slot) {
  state.slots[slot].row = 0;
  if (state.last_free != 0)
    state.slots[state.last_free].row = slot;
  else
    state.first_free = slot;
  state.last_free = slot;
}

// ------------------------------------------------------------------------------------------- pools
void WorldImpl::link_to_pool(std::uint32_t slot, std::uint32_t index) {
  Pool& pool = state.pools[index];
  ++pool.count;
  if (def.pools[index].when_full != WhenFull::replace_oldest) return;
  state.links.resize(state.slots.size());
  state.links[slot] = {pool.newest, 0};
  if (pool.newest != 0) state.links[pool.newest].newer = slot;
  pool.newest = slot;
  if (pool.oldest == 0) pool.oldest = slot;
}

void WorldImpl::unlink_from_pool(std::uint32_t slot, std::uint32_t index) {
  Pool& pool = state.pools[index];
  --pool.count;
  if (def.pools[index].when_full != WhenFull::replace_oldest) return;
  const PoolLink link = state.links[slot];
  (link.older != 0 ? state.links[link.older].newer : pool.oldest) = link.newer;
  (link.newer != 0 ? state.links[link.newer].older : pool.newest) = link.older;
}

Status WorldImpl::make_room(std::uint32_t index) {
  const PoolDef& pool = def.pools[index];
  if (state.pools[index].count >= pool.maximum) {
    if (pool.when_full == WhenFull::refuse)
      return Error{"the pool '" + pool.name + "' is full", "body.pool",
                   "raise its maximum, or let it replace the oldest"};
    retire(state.pools[index].oldest, Reason::replaced);
  }
  if (state.alive >= def.max_projectiles)
    return Error{"the world is full", "world.max_projectiles", "raise it, or despawn some"};
  return {};
}

// ------------------------------------------------------------------------------------------- coming
void WorldImpl::push_due(std::vector<Due>& heap, double time, std::uint32_t slot) {
  heap.push_back({time, id_of(slot)});
  std::push_heap(heap.begin(), heap.end(), is_later);
}

/// The cheapest rung for a launch, where the kind asks for it; its own otherwise.
Result<std::uint16_t> WorldImpl::rung_for(std::uint32_t kind_index, const Launch& launch) {
  const Kind& kind = registry.kind(kind_index);
  if (kind.body.cheapest_within == 0) return std::uint16_t{0};
  Environment environment = registry.environments()[kind.body.environment];
  environment.gravity.acceleration *= kind.body.use_gravity ? kind.body.gravity_scale : 0.0;
  Purpose purpose;
  purpose.error = kind.body.cheapest_within;
  purpose.time = kind.body.within_time;
  purpose.step = def.step;
  if (def.ground.mode != GroundMode::none) purpose.ground = def.ground.height;
  if (!state.force_order.empty()) purpose.least_motion = Motion::force;
  const bool dragless = kind.body.drag_scale == 0;
  if (dragless) purpose.truth.drag = DragModel::off;
  purpose.tolerance.relative = def.tolerance.relative;
  purpose.tolerance.absolute = def.tolerance.absolute;
  const auto answer = answers.cheapest_within(dragless ? kind.projectile : kind.flown, launch, environment, purpose);
  if (!answer) return answer.error();
  const FidelityNote why = (*answer)->note();
  const auto rung = registry.rung(kind_index, (*answer)->fidelity, &why);
  if (!rung) return Error{"there are too many rungs of this kind", "fidelity", "at most 4096"};
  return *rung;
}

Result<ProjectileId> WorldImpl::spawn(std::uint32_t kind_index, const Launch& launch, double delay) {
  const Kind& kind = registry.kind(kind_index);
  Status status = check(launch);
  if (status) status = check(kind.flown, launch);
  if (status && !(delay >= 0 && delay < 1e15)) status = Error{"must be zero or positive", "delay", "in s"};
  if (!status) return status.error();
  BodyState at{launch.position, {}};
  if (launch.velocity) {
    at.velocity = *launch.velocity;
  } else {
    const Environment& environment = registry.environments()[kind.body.environment];
    const auto elevation = elevation_of(kind.flown, launch, environment, kind.projectile.fidelity);
    if (!elevation) return elevation.error();
    at.velocity = launch_velocity(launch, sight_frame(launch), *elevation);
  }
  const auto rung = rung_for(kind_index, launch);
  if (!rung) return rung.error();
  Slot wanted;
  wanted.kind = kind_index;
  wanted.rung = *rung;
  status = fits(wanted, at);
  if (status) status = make_room(kind.body.pool);
  if (!status) return status.error();
  const std::uint32_t index = take_slot();
  Slot& slot = state.slots[index];
  ++slot.generation;
  slot.kind = kind_index;
  slot.rung = *rung;
  const BodyDef& body = kind.body;
  slot.flags = kAlive | (body.kinematic ? kKinematic : 0u) | (body.infinite_mass ? kInfiniteMass : 0u) |
               (delay > 0 ? kPending : 0u) | (body.can_sleep ? 0u : kSleepless) |
               (body.gravity_scale != 1 || !body.use_gravity ? kScaled : 0u) |
               (body.frozen != Axes::none ? kFrozen : 0u) | (launch.rail_length > 0 ? kRailed : 0u);
  slot.set_smoothing(body.smoothing);
  slot.set_status(delay > 0 ? LifeStatus::pending : LifeStatus::in_flight);
  if (slot.is(kScaled | kFrozen)) own(index);
  if (feels_forces(index)) slot.flags |= kForced;
  const std::uint16_t cohort = cohort_for(slot);
  if (cohort == kNoCohort) {
    slot.flags = 0;
    free_slot(index);
    return Error{"there are too many different rungs and rules", "world", "at most 65535"};
  }
  slot.cohort = cohort;
  const double now = state.clock.time();
  state.birth[index] = now + delay;
  state.rest[index] = {};
  ++state.alive;
  link_to_pool(index, body.pool);
  place(index, at, launch);
  if (body.angular_velocity != Vec3d{}) {
    slot.flags |= kTurning;
    state.turning[index] = {Quatd{}, body.angular_velocity};
  }
  if (std::isfinite(body.despawn.older)) push_due(state.old_age, now + delay + body.despawn.older, index);
  if (delay > 0)
    push_due(state.pending, now + delay, index);
  else
    tell_launch(index);
  return id_of(index);
}

/// The same, with a look at the kind first, and counted where it is refused.
Result<ProjectileId> WorldImpl::spawn(KindId kind, const Launch& launch, double delay) {
  Result<ProjectileId> id = [&]() -> Result<ProjectileId> {
    if (!registry.has_kind(kind)) return Error{"there is no such kind", "kind", "add_kind() makes one"};
    if (!registry.has_environment_of(kind))
      return Error{"its environment is no longer there", "kind", "restore() took it back: add it again"};
    try {
      return spawn(kind.index, launch, delay);
    } catch (const std::bad_alloc&) {
      return Error{"no memory for another projectile", "world", "lower max_projectiles"};
    }
  }();
  if (!id) ++state.counters.refused;
  return id;
}

Result<ProjectileId> World::spawn(KindId kind, const Launch& launch, double delay) {
  WorldImpl& w = *impl_;
  const Recorded<Call::spawn> call(w.recorder, kind, launch, delay);
  Result<ProjectileId> id = w.spawn(kind, launch, delay);
  call.returns(id ? *id : ProjectileId{});
  return id;
}

Result<ProjectileId> World::spawn(const ProjectileDef& projectile, const Launch& launch, const BodyDef& body,
                                  double delay) {
  const Recorded<Call::spawn_def> call(impl_->recorder, projectile, launch, body, delay);
  const Result<KindId> kind = add_kind(projectile, body);
  if (!kind) {
    ++impl_->state.counters.refused;
    return kind.error();
  }
  Result<ProjectileId> id = spawn(*kind, launch, delay);
  call.returns(id ? *id : ProjectileId{});
  return id;
}

std::size_t World::spawn(KindId kind, std::span<const Launch> launches, std::span<ProjectileId> ids) {
  ids = ids.first(std::min(ids.size(), launches.size()));
  const Recorded<Call::spawn_many> call(impl_->recorder, kind, launches, std::uint64_t{ids.size()});
  std::size_t spawned = 0;
  for (std::size_t i = 0; i < launches.size(); ++i) {
    const Result<ProjectileId> id = impl_->spawn(kind, launches[i], 0);
    if (i < ids.size()) ids[i] = id ? *id : ProjectileId{};
    if (id) ++spawned;
  }
  call.returns(std::span<const ProjectileId>(ids));
  return spawned;
}

Status World::reserve(KindId kind, std::size_t count) {
  WorldImpl& w = *impl_;
  if (!w.registry.has_environment_of(kind)) return Error{"there is no such kind", "kind", "add_kind() makes one"};
  try {
    const std::size_t slots = w.state.slots.size() + count;
    w.state.slots.reserve(slots);
    w.state.birth.reserve(slots);
    w.state.rest.reserve(slots);
    w.state.events.reserve(w.state.events.size() + count);
    Slot slot;
    slot.kind = kind.index;
    const BodyDef& body = w.registry.kind(kind.index).body;
    slot.set(kSleepless, !body.can_sleep);
    slot.set(kScaled, body.gravity_scale != 1 || !body.use_gravity);
    slot.set(kFrozen, body.frozen != Axes::none);
    const std::uint16_t cohort = w.cohort_for(slot);
    if (cohort != kNoCohort) w.state.rows[cohort].reserve(w.state.rows[cohort].size() + count);
  } catch (const std::bad_alloc&) {
    return Error{"no memory for so many projectiles", "world.reserve", "reserve fewer"};
  }
  return {};
}

// ------------------------------------------------------------------------------------------- going
void WorldImpl::retire(std::uint32_t index, Reason reason) {
  tell(EventKind::retired, index, reason);
  remove(index, LifeStatus::retired);
}

void WorldImpl::remove(std::uint32_t index, LifeStatus status) {
  Slot& slot = state.slots[index];
  take_out(slot);
  unlink_from_pool(index, kind_of(slot).body.pool);
  state.own.erase(index);
  state.tags.erase(index);
  if (!state.forces_on.empty()) state.forces_on.erase(index);
  if (slot.is(kTurning)) state.turning.erase(index);
  slot.flags = 0;
  slot.set_status(status);
  --state.alive;
  free_slot(index);
}

Status Projectile::despawn() {
  const Recorded<Call::despawn> call(world().recorder, id_);
  if (!world().find(id_)) return Error{"it is gone already", "id", ""};
  world().retire(id_.index, Reason::despawned);
  return {};
}

std::size_t World::despawn(std::span<const ProjectileId> ids) {
  const Recorded<Call::despawn_many> call(impl_->recorder, ids);
  std::size_t gone = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    impl_->prefetch(ids, i);
    if (!impl_->find(ids[i])) continue;
    impl_->retire(ids[i].index, Reason::despawned);
    ++gone;
  }
  return gone;
}

void World::clear() {
  const Recorded<Call::clear> call(impl_->recorder);
  for (std::uint32_t slot = 1; slot < impl_->state.slots.size(); ++slot)
    if (impl_->state.slots[slot].is(kAlive)) impl_->retire(slot, Reason::despawned);
}

}  // namespace physim
