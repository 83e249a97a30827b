// Reading: states, forces, and what is carried along.
#include <algorithm>
#include <limits>

#include "base/ieee_mode.hpp"
#include "math/elementary.hpp"
#include "model/jerk.hpp"
#include "model/magnus.hpp"
#include "solve/watch.hpp"
#include "world/couple/surface_motion.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {

bool ProjectileView::is_alive() const { return world_->find(id_) != nullptr; }

LifeStatus ProjectileView::status() const {
  const SlotTable& slots = world_->state.slots;
  const bool known = id_ && id_.index < slots.size() && slots[id_.index].generation == id_.generation;
  return known ? slots[id_.index].status() : LifeStatus::unknown;
}

std::size_t World::size() const { return impl().state.slots.alive(); }

std::vector<ProjectileId> World::ids() const {
  std::vector<ProjectileId> all;
  ids(all);
  return all;
}

void World::ids(std::vector<ProjectileId>& into) const {
  const SlotTable& slots = impl().state.slots;
  into.clear();
  into.reserve(slots.alive());
  slots.each_alive([&](std::uint32_t slot) { into.push_back(slots.id_of(slot)); });
}

Vec3d ProjectileView::position_of(const WorldImpl* world, ProjectileId id) {
  const IeeeMode mode;
  const Slot* slot = world->find(id);
  return slot ? world->state.rows_of(*slot).position(slot->row) : Vec3d{};
}
Vec3d ProjectileView::velocity_of(const WorldImpl* world, ProjectileId id) {
  const IeeeMode mode;
  const Slot* slot = world->find(id);
  return slot ? world->state.rows_of(*slot).velocity(slot->row) : Vec3d{};
}
BodyState ProjectileView::state_of(const WorldImpl* world, ProjectileId id) {
  const IeeeMode mode;
  const Slot* slot = world->find(id);
  return slot ? world->state.state_of(*slot) : BodyState{};
}

void World::states(std::span<const ProjectileId> ids, std::span<BodyState> into) const {
  const IeeeMode mode;
  const std::size_t count = std::min(ids.size(), into.size());
  for (std::size_t i = 0; i < count; ++i) into[i] = (*this)[ids[i]].state();
}
void World::render_positions(std::span<const ProjectileId> ids, std::span<Vec3d> into) const {
  const IeeeMode mode;
  const std::size_t count = std::min(ids.size(), into.size());
  for (std::size_t i = 0; i < count; ++i) {
    impl().prefetch(ids, i);
    into[i] = (*this)[ids[i]].render_position();
  }
}
Vec3d ProjectileView::previous_position() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  return slot->is(kStill) ? world_->state.rows_of(*slot).position(slot->row)
                          : world_->state.rows_of(*slot).previous(slot->row);
}

Vec3d ProjectileView::render_position() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  const Rows& rows = world_->state.rows_of(*slot);
  const Vec3d now = rows.position(slot->row);
  if (slot->is(kStill)) return now;
  const Clock& clock = world_->state.clock;
  if (slot->smoothing() == Smoothing::extrapolate) return now + rows.velocity(slot->row) * clock.left_over;
  if (slot->smoothing() == Smoothing::none) return now;
  const Vec3d before = rows.previous(slot->row);
  return before + (now - before) * std::min(clock.left_over / world_->def.step, 1.0);
}

void World::segments(std::vector<Segment>& into) const {
  const IeeeMode mode;
  into.clear();
  for (std::uint16_t c = 0; c < impl().state.rows.size(); ++c) {
    if (impl().registry.cohort(c).key.still) continue;
    const Rows& rows = impl().state.rows[c];
    const std::size_t first = into.size();
    into.resize(first + rows.size());
    rows.visit([&](const auto& columns) {
      for (std::uint32_t row = 0; row < rows.size(); ++row)
        into[first + row] = {impl().state.slots.id_of(rows.slot(row)), Rows::at(columns.previous, row),
                             Rows::at(columns.position, row)};
    });
  }
}

void World::columns(std::vector<WorldColumns>& into) const {
  const IeeeMode mode;
  into.clear();
  for (std::uint16_t c = 0; c < impl().state.rows.size(); ++c) {
    const Rows& rows = impl().state.rows[c];
    const std::size_t count = rows.size();
    PHYSIM_ASSERT(count <= impl().state.slots.size());
    if (count == 0) continue;
    const bool still = impl().registry.cohort(c).key.still;
    rows.visit([&]<class S>(const RowColumns<S>& from) {
      ColumnsOf<S> columns{.index = {rows.slots(), count}};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        columns.position[axis] = {from.position[axis], count};
        columns.previous[axis] = {still ? from.position[axis] : from.previous[axis], count};
        columns.velocity[axis] = {from.velocity[axis], count};
      }
      into.emplace_back(columns);
    });
  }
}

ProjectileId World::id_at(std::uint32_t index) const {
  const SlotTable& slots = impl().state.slots;
  return index > 0 && index < slots.size() && slots[index].is(kAlive) ? slots.id_of(index) : ProjectileId{};
}

double ProjectileView::age() const {
  const IeeeMode mode;
  return world_->find(id_) ? std::max(0.0, world_->state.clock.time() - world_->state.slots.birth(id_.index)) : 0.0;
}
double ProjectileView::mass() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  if (!slot) return 0;
  if (slot->is(kInfiniteMass)) return std::numeric_limits<double>::infinity();
  return mass_of(world_->registry, world_->state, *slot);
}
double ProjectileView::inverse_mass() const {
  const IeeeMode mode;
  const double m = mass();
  return m > 0 ? 1 / m : 0;
}

Accelerations ProjectileView::accelerations() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  if (!slot || slot->is(kInfiniteMass)) return {};
  const FreeMotion free(*world_, *slot);
  const BodyState now = world_->state.state_of(*slot);
  const Rows& rows = world_->state.rows_of(*slot);
  Accelerations a = free({now.position, now.velocity});
  std::optional<Vec3d> on;  // a surface, or where it rests
  if (slot->is(kAsleep | kStuck))
    on = Vec3d{};
  else if (!slot->is(kStill) && !world_->is_closed() && !world_->state.joints.of_slot(id_.index))
    on = acceleration_on_surface(*world_, *slot, free.body(), [&](const State<double>& s) { return free(s).total; });
  if (on)
    a.constraint += *on - a.total, a.total = *on;
  else if (rows.layout().carried)  // the original's register, as in Flight
    a.total = rows.visit([&](const auto& columns) { return Rows::at(columns.carried, slot->row); });
  return a;
}

Vec3d ProjectileView::jerk() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  if (!slot || slot->is(kInfiniteMass)) return {};
  const WorldCohort& cohort = world_->registry.cohort(slot->cohort);
  const BodyState now = world_->state.state_of(*slot);
  const double t = world_->placement.clock_of(*slot), per_mass = inverse_mass();
  Body<double> b = world_->placement.body_of(*slot);
  PushChange change;
  if (cohort.key.forced) {
    const Vec3d force = world_->generator_force(id_.index, now);
    const Vec3d push = world_->emitter_push(id_.index);
    add_push(cohort.conditions, {t, t}, t, force * per_mass + push, cohort.key.features.has_applied, b);
    change = [this, force, per_mass](const State<double>& s) {
      return (world_->generator_force(id_.index, {s.x, s.v}) - force) * per_mass;
    };
  }
  const Rows& rows = world_->state.rows_of(*slot);
  const bool turning = rows.layout().turning;
  return jerk_of(cohort.conditions, b, turning ? rows.rotor(slot->row) : Rotor<double>{}, t,
                 {now.position, now.velocity}, turning ? rows.turn(slot->row) : Turn<double>{}, change);
}
Vec3d ProjectileView::resultant_force() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  return slot ? accelerations().total * (slot->is(kInfiniteMass) ? 0 : mass()) : Vec3d{};
}
double ProjectileView::mach() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  if (!slot) return 0;
  const Conditions<double>& c = world_->registry.cohort(slot->cohort).conditions;
  const BodyState now = world_->state.state_of(*slot);
  const State<double> s{now.position, now.velocity};
  double mach;
  mach_number(c, world_->placement.body_of(*slot), world_->placement.clock_of(*slot), s, mach);
  return mach;
}

KindId ProjectileView::kind() const {
  const Slot* slot = world_->find(id_);
  return {slot ? world_->registry.kind(slot->kind).number : 0};
}
const ProjectileDef* ProjectileView::definition() const {
  const Slot* slot = world_->find(id_);
  return slot ? &world_->registry.kind(slot->kind).projectile : nullptr;
}
Quatd ProjectileView::orientation() const {
  const IeeeMode mode;
  if (!is_alive()) return {};
  if (const auto flown = world_->placement.attitude(id_.index)) return flown->q_WB;
  const Turning* turning = world_->state.extras.find_turning(id_.index);
  return turning ? turning->orientation : Quatd{};
}
Vec3d ProjectileView::angular_velocity() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  if (const auto flown = world_->placement.attitude(id_.index))
    return rotate(flown->q_WB, flown->omega - world_->placement.omega_of_W(*slot, flown->q_WB));
  if (spins(world_->registry.cohort(slot->cohort).key.fidelity))
    return spin_at(world_->placement.body_of(*slot), world_->placement.clock_of(*slot));
  const Turning* turning = world_->state.extras.find_turning(id_.index);
  return turning ? turning->angular_velocity : Vec3d{};
}

std::uint64_t ProjectileView::user_data() const {
  const Tags* tags = is_alive() ? world_->state.extras.find_tags(id_.index) : nullptr;
  return tags ? tags->user_data : 0;
}
std::uint32_t ProjectileView::layers() const { return is_alive() ? world_->layers_of(id_.index) : 0; }
std::uint32_t ProjectileView::colour() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return 0;
  const Tags* tags = world_->state.extras.find_tags(id_.index);
  return tags ? tags->colour : world_->registry.kind(slot->kind).body.colour;
}
std::string ProjectileView::label() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  const Tags* tags = world_->state.extras.find_tags(id_.index);
  return tags ? tags->label : world_->registry.kind(slot->kind).body.label;
}

std::span<const Event> World::events() const {
  const WorldImpl& w = impl();
  const IeeeMode mode;
  const std::lock_guard lock(w.showing);
  return w.state.events.all(w.given_events);
}
void World::forget_events() {
  if (!impl().is_closed()) impl().forget_events();
}
const WorldCounters& World::counters() const { return impl().state.counters; }
const WorldDef& World::def() const { return impl().def; }

std::vector<CohortInfo> World::cohorts() const {
  std::vector<CohortInfo> list;
  for (std::uint16_t c = 0; c < impl().state.rows.size(); ++c) {
    const CohortKey& key = impl().registry.cohort(c).key;
    if (impl().state.rows[c].size() > 0)
      list.push_back({key.fidelity, impl().state.rows[c].size(), !key.still, key.forced});
  }
  return list;
}

namespace {

std::size_t events_bytes(const WorldImpl& w) {
  const std::lock_guard lock(w.showing);
  std::size_t bytes = w.state.events.bytes();
  for (const auto& events : w.given_events) bytes += events.capacity() * sizeof(Event);
  return bytes;
}

}  // namespace

std::size_t World::memory() const {
  const WorldImpl& w = impl();
  const WorldState& s = w.state;
  std::size_t bytes = s.slots.bytes() + s.pools.bytes() + s.launches.bytes() + s.old_age.bytes() + s.extras.bytes() +
                      s.generators.bytes() + s.emitters.bytes() + s.joints.bytes() + w.registry.bytes() +
                      events_bytes(w);
  for (const Rows& rows : s.rows) bytes += sizeof(Rows) + rows.bytes();
  return bytes;
}

}  // namespace physim
