// Making worlds; projectiles coming and going.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <new>

#include "base/archive.hpp"
#include "base/ieee_mode.hpp"
#include "base/memory_lack.hpp"
#include "flight/zero.hpp"
#include "math/elementary.hpp"
#include "model/sight.hpp"
#include "prepare/check.hpp"
#include "prepare/conditions.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {

WorldImpl::WorldImpl(const WorldDef& definition) : def(definition), registry(definition) {
  if (def.pools.empty()) def.pools.emplace_back();
  static std::atomic<std::uint64_t> worlds = 0;
  state.owner = ++worlds;
  state.pools = Pools(def.pools);
  state.clock.dt = def.step;
  state.clock.time_scale = def.time_scale;
  state.detail = def.detail;
  def_hash = hash_of(def);
}

World::World() : World(WorldDef{}) {}
World::World(const WorldDef& def) : World(std::make_shared<WorldImpl>(def)) {}
World::World(std::shared_ptr<WorldImpl> impl) : impl_(std::move(impl)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

WorldImpl& World::impl() {
  if (!impl_) impl_ = std::make_shared<WorldImpl>(WorldDef{});
  return *impl_;
}
const WorldImpl& World::impl() const {
  static const WorldImpl empty{WorldDef{}};
  return impl_ ? *impl_ : empty;
}

Result<World> World::create(const WorldDef& def) {
  const IeeeMode mode;
  if (const Status status = check(def); !status) return status.error();
  return World(def);
}

// ------------------------------------------------------------------------------------------- kinds and environments
Result<KindId> World::add_kind(const ProjectileDef& projectile, const BodyDef& body) {
  WorldImpl& w = impl();
  const Recorded<Call::add_kind> call(w, projectile, body);
  if (call.is_refused()) return call.refusal();
  const Result<std::uint32_t> kind = w.find_or_add_kind(projectile, body);
  if (!kind) return kind.error();
  w.registry.kinds.keep(*kind);
  return call.returns(KindId{w.registry.kind(*kind).number});
}

Result<std::uint32_t> World::add_environment(const Environment& environment) {
  WorldImpl& w = impl();
  const Recorded<Call::add_environment> call(w, environment);
  if (call.is_refused()) return call.refusal();
  return call.returns(w.registry.add_environment(environment));
}

Status World::set_environment(std::uint32_t index, const Environment& environment) {
  WorldImpl& w = impl();
  const Recorded<Call::set_environment> call(w, index, environment);
  if (call.is_refused()) return call.refusal();
  const std::vector<ClosedFormLaw> before = w.placement.closed_forms();
  if (Status status = w.registry.set_environment(index, environment); !status) return status;
  w.state.slots.each_alive([&](std::uint32_t slot) {
    if (w.registry.kind(w.state.slots[slot].kind).body.environment == index)
      w.placement.follow_environment(slot, before);
  });
  return {};
}

// ------------------------------------------------------------------------------------------- slots
Own& WorldImpl::own(std::uint32_t slot) {
  const auto [at, added] = state.extras.own.try_emplace(slot);
  if (added) at->second = own_of(registry.kind(state.slots[slot].kind).body);
  return at->second;
}

Tags& WorldImpl::tags(std::uint32_t slot) {
  const auto [at, added] = state.extras.tags.try_emplace(slot);
  if (added) {
    const BodyDef& body = registry.kind(state.slots[slot].kind).body;
    at->second = {0, body.layers, body.colour, body.label};
  }
  return at->second;
}

std::uint32_t WorldImpl::layers_of(std::uint32_t slot) const { return physim::layers_of(registry, state, slot); }

// ------------------------------------------------------------------------------------------- coming
namespace {

Error no_kind() { return {"there is no such kind", "kind", "add_kind() makes one"}; }
Error no_environment() {
  return {"its environment is no longer there", "kind", "restore() took it back: add it again"};
}

/// An id in one register. If its halves are written one by one, a reader waits until both are in the
/// cache.
[[gnu::noinline]] ProjectileId whole_id(const SlotTable& slots, std::uint32_t index) { return slots.id_of(index); }

/// Where a launch starts, and how fast, number by number: a wider copy would wait for what the caller has just written.
BodyState start_of(const Launch& launch, double elevation) {
  const Vec3d& x = launch.position;
  const Vec3d v = launch.velocity ? *launch.velocity : launch_velocity(launch, sight_frame(launch), elevation);
  return {{x.x, x.y, x.z}, {v.x, v.y, v.z}};
}

}  // namespace

Status WorldImpl::make_room(std::uint32_t index) {
  const PoolDef& pool = def.pools[index];
  if (state.pools.is_full(index)) {
    if (!state.pools.replaces(index))
      return Error{"the pool '" + pool.name + "' is full", "body.pool",
                   "raise its maximum, or let it replace the oldest"};
    retire(state.pools.oldest(index), Reason::replaced);
  }
  if (state.slots.alive() >= def.max_projectiles)
    return Error{"the world is full", "world.max_projectiles", "raise it, or despawn some"};
  return {};
}

Environment WorldImpl::surroundings_of(const Kind& kind, double time) const {
  return as_launched_at(time, registry.environments()[kind.body.environment]);
}

/// The cheapest rung for a launch, of a kind that requests it.
Result<std::uint16_t> WorldImpl::rung_for(std::uint32_t kind_index, const Launch& launch, double time,
                                          const Coming& coming) {
  const Kind& kind = registry.kind(kind_index);
  PHYSIM_ASSERT(kind.body.cheapest_within != 0);
  Environment environment = surroundings_of(kind, time);
  environment.gravity.acceleration *= own_of(kind.body).gravity_scale * coming.gravity;
  Purpose purpose;
  purpose.error = kind.body.cheapest_within;
  purpose.time = kind.body.within_time;
  purpose.step = def.step;
  if (def.ground.mode != GroundMode::none) purpose.ground = def.ground.height;
  const bool is_driven = coming.emitter != 0 && state.emitters[coming.emitter].drives;
  if (is_driven || !state.generators.empty()) purpose.least_motion = Motion::force;
  const bool dragless = kind.body.drag_scale == 0;
  if (dragless) purpose.truth.drag = DragModel::off;
  purpose.tolerance.relative = def.tolerance.relative;
  purpose.tolerance.absolute = def.tolerance.absolute;
  const auto answer = answers.cheapest_within(dragless ? kind.projectile : kind.flown, launch, environment, purpose);
  if (!answer) return answer.error();
  FidelityNote why = (*answer)->note();
  // Each launch has its own answer there, and every other note would make its own rung.
  if (has_functions(environment)) why.reason = "the cheapest found for its launch, by the environment's functions then";
  const auto rung = registry.rung(kind_index, (*answer)->fidelity, &why);
  if (!rung) return Error{"there are too many rungs of this kind", "fidelity", "at most 4096"};
  return *rung;
}

Result<double> WorldImpl::bore_of(const Kind& kind, const Launch& launch, double time) const {
  if (const Status status = check(launch); !status) return status.error();
  if (const Status status = check(kind.flown, launch); !status) return status.error();
  if (launch.sight.zero_range <= 0) return launch.elevation;
  return elevation_of(kind.flown, launch, surroundings_of(kind, time), kind.projectile.fidelity);
}

namespace {

/// A slot whose projectile is on its way into the world. If memory ends before it has its row, all is taken back.
class Arriving {
 public:
  Arriving(WorldState& state, std::uint32_t index) : state_(state), index_(index) {}
  Arriving(const Arriving&) = delete;
  Arriving& operator=(const Arriving&) = delete;
  ~Arriving() {
    if (has_arrived_) return;
    if (pool_) state_.pools.leave(*pool_, index_);
    state_.extras.forget(index_);
    state_.slots.release(index_, LifeStatus::unknown);
  }
  void join(std::uint32_t pool) {
    state_.pools.join(pool, index_);
    pool_ = pool;
  }
  void arrived() { has_arrived_ = true; }

 private:
  WorldState& state_;
  std::uint32_t index_;
  std::optional<std::uint32_t> pool_;
  bool has_arrived_ = false;
};

}  // namespace

Result<ProjectileId> WorldImpl::spawn_of(std::uint32_t kind_index, const Launch& launch, const Coming& coming) {
  const Kind& kind = registry.kind(kind_index);
  const BodyDef& body = kind.body;
  const double launched = coming.moment.value_or(state.clock.time() + coming.delay);
  const Result<double> elevation = bore_of(kind, launch, launched);
  if (!elevation) return elevation.error();
  const BodyState at = start_of(launch, *elevation);
  if (!(coming.delay >= 0 && coming.delay < 1e15)) return Error{"must be zero or positive", "delay", "in s"};
  std::uint16_t rung = 0;
  if (body.cheapest_within != 0) {
    const auto cheapest = rung_for(kind_index, launch, launched, coming);
    if (!cheapest) return cheapest.error();
    rung = *cheapest;
  }
  const Precision precision = kind.on(rung).in_use.fidelity.precision;
  if (const Status status = check_fits(at.position, at.velocity, precision); !status) return status.error();
  if (state.pools.is_full(body.pool) || state.slots.alive() >= def.max_projectiles)
    if (const Status status = make_room(body.pool); !status) return status.error();

  const std::uint32_t index = state.slots.take();
  Arriving arriving(state, index);
  Slot& slot = state.slots[index];
  slot.kind = kind_index;
  slot.rung = rung;
  state.slots.come_alive(index, kind.flags);
  slot.set(kPending, coming.delay > 0);
  slot.set(kRailed, launch.rail_length > 0);
  slot.set_status(coming.delay > 0 ? LifeStatus::pending : LifeStatus::in_flight);
  if (slot.is(kOwn) || coming.gravity != 1) {
    Own& mine = own(index);
    mine.gravity_scale *= coming.gravity;
    for (const OwnPart& part : kOwnParts) slot.set(part.flag, part.differs(mine));
  }
  const bool is_driven = coming.emitter != 0 && state.emitters[coming.emitter].drives;
  const bool may_be_forced = !state.generators.empty() || !state.emitters.empty();
  slot.set(kForced, may_be_forced && (is_driven ? is_moved_by_forces(index) : feels_forces(index)));
  slot.cohort = placement.cohort_for(slot);
  if (slot.cohort == kNoCohort) return Error{"there are too many different rungs and rules", "world", "at most 65535"};
  state.slots.birth(index) = launched - coming.age;
  state.slots.rest(index) = {};
  const ProjectileId id = whole_id(state.slots, index);
  const bool turns = body.angular_velocity != Vec3d{};
  if (turns) state.extras.turning[index] = {Quatd{}, body.angular_velocity};
  if (std::isfinite(body.despawn.older)) state.old_age.add(launched + body.despawn.older, id);
  if (coming.delay > 0) state.launches.add(launched, id);
  state.events.reserve(2);  // of its launch
  arriving.join(body.pool);
  placement.place(index, at, launch, *elevation, coming.moment);
  arriving.arrived();
  if (turns) slot.set(kTurning, true);
  if (!(coming.delay > 0)) tell_launch(index, coming);
  return id;
}

/// Spawns after a look at the kind, and counts what is refused.
Result<ProjectileId> WorldImpl::spawn(KindId kind, const Launch& launch, const Coming& coming) {
  const std::uint32_t index = registry.kinds.find(kind);
  const bool has_place = index != 0 && registry.has_environment_of(registry.kind(index));
  if (has_place)
    registry.kinds.join(index);  // first: removing one to make room may empty another kind, which lets idle ones go
  Result<ProjectileId> id = has_place ? spawn_in_memory(index, launch, coming)
                                      : Result<ProjectileId>(index == 0 ? no_kind() : no_environment());
  if (id) return id;
  ++state.counters.refused;
  if (has_place) registry.kinds.leave(index, moments, living);
  return id;
}

Result<ProjectileId> WorldImpl::spawn_in_memory(std::uint32_t kind, const Launch& launch, const Coming& coming) {
  try {
    return spawn_of(kind, launch, coming);
  } catch (const std::bad_alloc&) {
    memory_lacked = true;
    return Error{"no memory for another projectile", "world", "lower max_projectiles"};
  }
}

Result<ProjectileId> WorldImpl::spawn(const ProjectileDef& projectile, const Launch& launch, const BodyDef& body,
                                      const Coming& coming) {
  const Result<std::uint32_t> kind = find_or_add_kind(projectile, body);
  if (!kind) {
    ++state.counters.refused;
    return kind.error();
  }
  Result<ProjectileId> id = spawn(KindId{registry.kind(*kind).number}, launch, coming);
  registry.kinds.forget_idle(living);
  return id;
}

Result<ProjectileId> World::spawn(KindId kind, const Launch& launch, double delay) {
  WorldImpl& w = impl();
  const Recorded<Call::spawn> call(w, kind, launch, delay);
  if (call.is_refused()) return call.refusal();
  Result<ProjectileId> id = w.spawn(kind, launch, {.delay = delay});
  call.returns(id ? *id : ProjectileId{});
  return id;
}

Result<ProjectileId> World::spawn(const ProjectileDef& projectile, const Launch& launch, const BodyDef& body,
                                  double delay) {
  WorldImpl& w = impl();
  const Recorded<Call::spawn_def> call(w, projectile, launch, body, delay);
  if (call.is_refused()) return call.refusal();
  Result<ProjectileId> id = w.spawn(projectile, launch, body, {.delay = delay});
  call.returns(id ? *id : ProjectileId{});
  return id;
}

std::size_t World::spawn(KindId kind, std::span<const Launch> launches, std::span<ProjectileId> ids) {
  ids = ids.first(std::min(ids.size(), launches.size()));
  WorldImpl& w = impl();
  const Recorded<Call::spawn_many> call(w, kind, launches, std::uint64_t{ids.size()});
  if (call.is_refused()) return 0;
  std::size_t spawned = 0;
  for (std::size_t i = 0; i < launches.size(); ++i) {
    const Result<ProjectileId> id = w.spawn(kind, launches[i], {});
    if (i < ids.size()) ids[i] = id ? *id : ProjectileId{};
    if (id) ++spawned;
  }
  call.returns(std::span<const ProjectileId>(ids));
  return spawned;
}

Status World::reserve(KindId kind, std::size_t count) {
  const IeeeMode mode;
  WorldImpl& w = impl();
  if (w.is_closed()) return from_inside();
  const std::uint32_t index = w.registry.kinds.find(kind);
  if (index == 0 || !w.registry.has_environment_of(w.registry.kind(index))) return no_kind();
  if (count > w.def.max_projectiles - std::min(w.state.slots.alive(), w.def.max_projectiles))
    return Error{"are more projectiles than the world holds", "count", "raise WorldDef::max_projectiles"};
  try {
    w.state.slots.reserve(count);
    Slot slot;
    slot.kind = index;
    slot.flags = w.registry.kind(index).flags;
    const std::uint16_t cohort = w.placement.cohort_for(slot);
    if (cohort == kNoCohort) return {};
    w.state.events.reserve(count + 1);  // a launch asks for room for two
    w.state.rows[cohort].reserve(w.state.rows[cohort].size() + count);
  } catch (const std::exception&) {  // no memory, or more than a list can ever have
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
  PHYSIM_ASSERT(slot.is(kAlive));
  const std::vector<std::uint32_t> beside = sleepers_at(index);
  placement.take_out(slot);
  state.pools.leave(registry.kind(slot.kind).body.pool, index);
  state.extras.forget(index);
  state.generators.forget(index);
  if (!state.joints.empty()) end_joints_of(*this, index);
  state.emitters.leave(index, status == LifeStatus::landed    ? &EmitterCounts::landed
                              : status == LifeStatus::expired ? &EmitterCounts::expired
                                                              : &EmitterCounts::taken);
  registry.kinds.leave(slot.kind, moments, living);
  state.slots.release(index, status);
  disturb(beside);
}

Status Projectile::despawn() {
  const Recorded<Call::despawn> call(world(), id_);
  if (call.is_refused()) return call.refusal();
  if (!world().find(id_)) return Error{"it is gone already", "id", ""};
  world().retire(id_.index, Reason::despawned);
  return {};
}

std::size_t World::despawn(std::span<const ProjectileId> ids) {
  WorldImpl& w = impl();
  const Recorded<Call::despawn_many> call(w, ids);
  if (call.is_refused()) return 0;
  std::size_t gone = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    w.prefetch(ids, i);
    if (!w.find(ids[i])) continue;
    w.retire(ids[i].index, Reason::despawned);
    ++gone;
  }
  return gone;
}

void World::clear() {
  WorldImpl& w = impl();
  const Recorded<Call::clear> call(w);
  if (call.is_refused()) return;
  w.state.slots.each_alive([&w](std::uint32_t slot) { w.retire(slot, Reason::despawned); });
}

}  // namespace physim
