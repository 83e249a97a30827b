// Reading: states, forces, and what is carried along.
#include <algorithm>
#include <limits>

#include "math/elementary.hpp"
#include "world/world_impl.hpp"

namespace physim {

bool ProjectileView::is_alive() const { return world_->find(id_) != nullptr; }

LifeStatus ProjectileView::status() const {
  const auto& slots = world_->state.slots;
  if (id_.index == 0 || id_.index >= slots.size() || slots[id_.index].generation != id_.generation)
    return LifeStatus::unknown;
  return slots[id_.index].status();
}

std::size_t World::size() const { return impl_->state.alive; }

std::vector<ProjectileId> World::ids() const {
  std::vector<ProjectileId> all;
  all.reserve(size());
  for (std::uint32_t slot = 1; slot < impl_->state.slots.size(); ++slot)
    if (impl_->state.slots[slot].is(kAlive)) all.push_back(impl_->id_of(slot));
  return all;
}

Vec3d ProjectileView::position() const {
  const Slot* slot = world_->find(id_);
  return slot ? world_->rows_of(*slot).position(slot->row) : Vec3d{};
}
Vec3d ProjectileView::velocity() const {
  const Slot* slot = world_->find(id_);
  return slot ? world_->rows_of(*slot).velocity(slot->row) : Vec3d{};
}
BodyState ProjectileView::state() const {
  const Slot* slot = world_->find(id_);
  return slot ? world_->state_of(*slot) : BodyState{};
}
void World::states(std::span<const ProjectileId> ids, std::span<BodyState> into) const {
  const std::size_t count = std::min(ids.size(), into.size());
  for (std::size_t i = 0; i < count; ++i) into[i] = (*this)[ids[i]].state();
}
Vec3d ProjectileView::previous_position() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  return slot->is(kStill) ? world_->rows_of(*slot).position(slot->row) : world_->rows_of(*slot).previous(slot->row);
}

Vec3d ProjectileView::render_position() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  const Rows& rows = world_->rows_of(*slot);
  const Vec3d now = rows.position(slot->row);
  if (slot->is(kStill)) return now;
  const Clock& clock = world_->state.clock;
  if (slot->smoothing() == Smoothing::extrapolate) return now + rows.velocity(slot->row) * clock.left_over;
  if (slot->smoothing() == Smoothing::none) return now;
  const Vec3d before = rows.previous(slot->row);
  return before + (now - before) * std::min(clock.left_over / world_->def.step, 1.0);
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

double ProjectileView::age() const {
  return world_->find(id_) ? std::max(0.0, world_->state.clock.time() - world_->state.birth[id_.index]) : 0.0;
}
double ProjectileView::mass() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return 0;
  if (slot->is(kInfiniteMass)) return std::numeric_limits<double>::infinity();
  return mass_of(world_->registry, world_->state, *slot);
}
double ProjectileView::inverse_mass() const {
  const double m = mass();
  return m > 0 ? 1 / m : 0;
}

Accelerations ProjectileView::accelerations() const {
  const Slot* slot = world_->find(id_);
  if (!slot || slot->is(kInfiniteMass)) return {};
  const WorldCohort& cohort = world_->registry.cohort(slot->cohort);
  const Conditions<double>& c = cohort.conditions;
  const double t = world_->clock_of(*slot);
  Body<double> b = world_->body_of(*slot);
  if (cohort.key.forced)
    add_push(c, t, world_->generator_force(id_.index) * inverse_mass(), cohort.key.features.has_applied, b);
  const BodyState now = world_->state_of(*slot);
  const Rows& rows = world_->rows_of(*slot);
  const bool turning = rows.layout().turning;
  return accelerations_of(c, b, turning ? rows.rotor(slot->row) : Rotor<double>{}, t, {now.position, now.velocity},
                          turning ? rows.turn(slot->row) : Turn<double>{});
}
Vec3d ProjectileView::resultant_force() const {
  const Slot* slot = world_->find(id_);
  return slot ? accelerations().total * (slot->is(kInfiniteMass) ? 0 : mass()) : Vec3d{};
}
double ProjectileView::mach() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return 0;
  const Conditions<double>& c = world_->registry.cohort(slot->cohort).conditions;
  const BodyState now = world_->state_of(*slot);
  const State<double> s{now.position, now.velocity};
  return length(air_velocity(c, s)) * air_state(c, s.x).per_sound_speed;
}

KindId ProjectileView::kind() const {
  const Slot* slot = world_->find(id_);
  return {slot ? slot->kind : 0};
}
const ProjectileDef* ProjectileView::definition() const {
  const Slot* slot = world_->find(id_);
  return slot ? &world_->kind_of(*slot).projectile : nullptr;
}
Quatd ProjectileView::orientation() const {
  if (world_->find(id_))
    if (const auto flown = world_->attitude(id_.index)) return flown->q_WB;
  const auto found = world_->find(id_) ? world_->state.turning.find(id_.index) : world_->state.turning.end();
  return found == world_->state.turning.end() ? Quatd{} : found->second.orientation;
}
Vec3d ProjectileView::angular_velocity() const {
  if (const Slot* slot = world_->find(id_))
    if (const auto flown = world_->attitude(id_.index))
      return rotate(flown->q_WB, flown->omega - world_->omega_of_W(*slot, flown->q_WB));
  const auto found = world_->find(id_) ? world_->state.turning.find(id_.index) : world_->state.turning.end();
  return found == world_->state.turning.end() ? Vec3d{} : found->second.angular_velocity;
}

std::uint64_t ProjectileView::user_data() const {
  const auto found = world_->find(id_) ? world_->state.tags.find(id_.index) : world_->state.tags.end();
  return found == world_->state.tags.end() ? 0 : found->second.user_data;
}
std::uint32_t ProjectileView::layers() const { return world_->find(id_) ? world_->layers_of(id_.index) : 0; }
std::uint32_t ProjectileView::colour() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return 0;
  const auto found = world_->state.tags.find(id_.index);
  return found == world_->state.tags.end() ? world_->kind_of(*slot).body.colour : found->second.colour;
}
std::string ProjectileView::label() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  const auto found = world_->state.tags.find(id_.index);
  return found == world_->state.tags.end() ? world_->kind_of(*slot).body.label : found->second.label;
}

std::span<const Event> World::events() const { return impl_->state.events; }
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
