// Reading: states, forces, and what is carried along.
#include <algorithm>
#include <limits>

#include "math/elementary.hpp"
#include "world/world_impl.hpp"

namespace physim {

bool World::is_alive(ProjectileId id) const { return impl_->find(id) != nullptr; }

LifeStatus World::status(ProjectileId id) const {
  const auto& slots = impl_->state.slots;
  if (id.index == 0 || id.index >= slots.size() || slots[id.index].generation != id.generation)
    return LifeStatus::unknown;
  return slots[id.index].status();
}

std::size_t World::size() const { return impl_->state.alive; }

std::vector<ProjectileId> World::ids() const {
  std::vector<ProjectileId> all;
  all.reserve(size());
  for (std::uint32_t slot = 1; slot < impl_->state.slots.size(); ++slot)
    if (impl_->state.slots[slot].is(kAlive)) all.push_back(impl_->id_of(slot));
  return all;
}

const std::optional<Error>& World::error() const { return impl_->error; }

Vec3d World::position(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  return slot ? impl_->rows_of(*slot).position(slot->row) : Vec3d{};
}
Vec3d World::velocity(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  return slot ? impl_->rows_of(*slot).velocity(slot->row) : Vec3d{};
}
BodyState World::state(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  return slot ? impl_->state_of(*slot) : BodyState{};
}
void World::states(std::span<const ProjectileId> ids, std::span<BodyState> into) const {
  const std::size_t count = std::min(ids.size(), into.size());
  for (std::size_t i = 0; i < count; ++i) into[i] = state(ids[i]);
}
Vec3d World::previous_position(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  if (!slot) return {};
  return slot->is(kStill) ? impl_->rows_of(*slot).position(slot->row) : impl_->rows_of(*slot).previous(slot->row);
}

Vec3d World::render_position(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  if (!slot) return {};
  const Rows& rows = impl_->rows_of(*slot);
  const Vec3d now = rows.position(slot->row);
  if (slot->is(kStill)) return now;
  const Clock& clock = impl_->state.clock;
  if (slot->smoothing() == Smoothing::extrapolate) return now + rows.velocity(slot->row) * clock.left_over;
  if (slot->smoothing() == Smoothing::none) return now;
  const Vec3d before = rows.previous(slot->row);
  return before + (now - before) * std::min(clock.left_over / impl_->def.step, 1.0);
}

void World::segments(std::vector<Segment>& into) const {
  into.clear();
  for (std::uint16_t c = 0; c < impl_->state.rows.size(); ++c) {
    if (impl_->registry.cohort(c).key.still) continue;
    const Rows& rows = impl_->state.rows[c];
    for (std::uint32_t row = 0; row < rows.size(); ++row)
      into.push_back({impl_->id_of(rows.slot(row)), rows.previous(row), rows.position(row)});
  }
}

double World::age(ProjectileId id) const {
  return impl_->find(id) ? std::max(0.0, time() - impl_->state.birth[id.index]) : 0.0;
}
double World::mass(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  if (!slot) return 0;
  if (slot->is(kInfiniteMass)) return std::numeric_limits<double>::infinity();
  return mass_of(impl_->registry, impl_->state, *slot);
}
double World::inverse_mass(ProjectileId id) const {
  const double m = mass(id);
  return m > 0 ? 1 / m : 0;
}

Accelerations World::accelerations(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  if (!slot || slot->is(kInfiniteMass)) return {};
  const Body<double> b = impl_->body_of(*slot);
  const Conditions<double>& c = impl_->registry.cohort(slot->cohort).conditions;
  const Fidelity& f = c.fidelity;
  const BodyState now = impl_->state_of(*slot);
  const State<double> s{now.position, now.velocity};
  Accelerations a;
  a.gravity = weight_per_mass(c, b, s.x);
  const double t = impl_->clock_of(*slot);
  if (f.drag != DragModel::off) a.drag = air_now(c, b, t, s);
  if (spins(f)) {
    SpinningAir<double> air;
    spinning_air(c, b, t, s, air);
    a.lift = air.lift * lighter(c, b, t);
    a.drag -= a.lift;
  }
  const Rows& rows = impl_->rows_of(*slot);
  if (turns(f) && c.has_aero) a.body = attitude_force(c, b, rows.rotor(slot->row), t, s, rows.turn(slot->row));
  if (is_turning(f.earth)) a.coriolis = coriolis(c, s.v);
  if (throws_out(f)) a.centrifugal = centrifugal(c, s.x);
  if (impl_->registry.cohort(slot->cohort).key.features.applied) a.applied = applied_now(c, b, t);
  if (c.has_motor) {
    const bool turning = turns(f);
    const Rotor<double> rotor = turning ? rows.rotor(slot->row) : Rotor<double>{};
    a.thrust = thrust(b, t, nose(c, b, rotor, t, s, turning ? rows.turn(slot->row) : Turn<double>{}));
  }
  if (f.motion == Motion::force) a.applied += impl_->generator_force(id.index) * inverse_mass(id);
  a.total = a.gravity + a.drag + a.coriolis + a.centrifugal + a.applied + a.body;
  if (spins(f)) a.total += a.lift;
  if (c.has_motor) a.total += a.thrust;
  if (c.has_frozen) a.total = component_product(a.total, b.free);
  if (c.has_rail) a.rail = on_rail(b, a.total) - a.total;
  a.total += a.rail;
  return a;
}
Vec3d World::resultant_force(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  return slot ? accelerations(id).total * (slot->is(kInfiniteMass) ? 0 : mass(id)) : Vec3d{};
}
double World::mach(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  if (!slot) return 0;
  const Conditions<double>& c = impl_->registry.cohort(slot->cohort).conditions;
  const BodyState now = impl_->state_of(*slot);
  const State<double> s{now.position, now.velocity};
  return length(air_velocity(c, s)) * air_state(c, s.x).per_sound_speed;
}

KindId World::kind(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  return {slot ? slot->kind : 0};
}
const ProjectileDef* World::definition(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  return slot ? &impl_->kind_of(*slot).projectile : nullptr;
}
Quatd World::orientation(ProjectileId id) const {
  if (impl_->find(id))
    if (const auto flown = impl_->attitude(id.index)) return flown->q_WB;
  const auto found = impl_->find(id) ? impl_->state.turning.find(id.index) : impl_->state.turning.end();
  return found == impl_->state.turning.end() ? Quatd{} : found->second.orientation;
}
Vec3d World::angular_velocity(ProjectileId id) const {
  if (const Slot* slot = impl_->find(id))
    if (const auto flown = impl_->attitude(id.index))
      return rotate(flown->q_WB, flown->omega - impl_->omega_of_W(*slot, flown->q_WB));
  const auto found = impl_->find(id) ? impl_->state.turning.find(id.index) : impl_->state.turning.end();
  return found == impl_->state.turning.end() ? Vec3d{} : found->second.angular_velocity;
}

std::uint64_t World::user_data(ProjectileId id) const {
  const auto found = impl_->find(id) ? impl_->state.tags.find(id.index) : impl_->state.tags.end();
  return found == impl_->state.tags.end() ? 0 : found->second.user_data;
}
std::uint32_t World::layers(ProjectileId id) const { return impl_->find(id) ? impl_->layers_of(id.index) : 0; }
std::uint32_t World::colour(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  if (!slot) return 0;
  const auto found = impl_->state.tags.find(id.index);
  return found == impl_->state.tags.end() ? impl_->kind_of(*slot).body.colour : found->second.colour;
}
std::string World::label(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  if (!slot) return {};
  const auto found = impl_->state.tags.find(id.index);
  return found == impl_->state.tags.end() ? impl_->kind_of(*slot).body.label : found->second.label;
}

std::span<const WorldEvent> World::events() const { return impl_->state.events; }
const WorldCounters& World::counters() const { return impl_->state.counters; }
const WorldDef& World::def() const { return impl_->def; }

std::vector<CohortInfo> World::cohorts() const {
  std::vector<CohortInfo> list;
  for (std::uint16_t c = 0; c < impl_->state.rows.size(); ++c) {
    const CohortKey& key = impl_->registry.cohort(c).key;
    if (impl_->state.rows[c].size() > 0)
      list.push_back({key.fidelity, impl_->state.rows[c].size(), !key.still, key.forced});
  }
  return list;
}

std::size_t World::memory() const {
  const WorldState& s = impl_->state;
  std::size_t bytes = s.slots.capacity() * sizeof(Slot) + s.birth.capacity() * sizeof(double) +
                      s.rest.capacity() * sizeof(Rest) + s.links.capacity() * sizeof(PoolLink) +
                      (s.pending.capacity() + s.old_age.capacity()) * sizeof(Due);
  for (const Rows& rows : s.rows) bytes += rows.bytes();
  return bytes;
}

}  // namespace physim
