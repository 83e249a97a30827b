// Changes to projectiles between steps: state, switches, sleep, fidelity, things carried along.
#include <cmath>

#include "base/checker.hpp"
#include "physim/names.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"
#include "world/world_impl.hpp"

namespace physim {
namespace {

Error gone() { return {"it is gone", "id", "is_alive() tells"}; }
Error not_finite(const char* place) { return {"must have three finite components", place, ""}; }

}  // namespace

void World::Impl::tell(WorldEventKind kind, std::uint32_t slot, Reason reason) {
  const BodyState at = state_of(state.slots[slot]);
  state.events.push_back({kind, reason, id_of(slot), state.clock.time(), at.position, at.velocity});
}

void World::Impl::tell_launch(std::uint32_t index) {
  tell(WorldEventKind::spawned, index);
  const Kind& kind = kind_of(state.slots[index]);
  const bool burns = registry.cohort(state.slots[index].cohort).conditions.has_motor && has_motor(kind.projectile);
  if (burns && kind.projectile.motor.ignition_delay == 0) tell(WorldEventKind::ignition, index);
}

// ------------------------------------------------------------------------------------------- sleep
bool World::Impl::put_to_sleep(std::uint32_t index) {
  Slot& slot = state.slots[index];
  if (slot.is(kStill)) return false;
  slot.set(kAsleep, true);
  relocate(index);
  set_row_state(index, {state_of(slot).position, {}});
  stop_turning(index);
  tell(WorldEventKind::slept, index);
  return true;
}

bool World::Impl::wake(std::uint32_t index) {
  Slot& slot = state.slots[index];
  state.rest[index] = {};
  if (!slot.is(kAsleep | kStuck)) return false;
  slot.set(kAsleep | kStuck, false);
  slot.set_status(LifeStatus::in_flight);
  relocate(index);
  tell(WorldEventKind::woke, index);
  return true;
}

bool World::sleep(ProjectileId id) {
  const Recorded<Call::sleep> call(impl_->recorder, id);
  if (!impl_->find(id)) return impl_->refuse(gone());
  return impl_->put_to_sleep(id.index);
}
bool World::wake(ProjectileId id) {
  const Recorded<Call::wake> call(impl_->recorder, id);
  if (!impl_->find(id)) return impl_->refuse(gone());
  return impl_->wake(id.index);
}
bool World::is_asleep(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  return slot && slot->is(kAsleep);
}

// ------------------------------------------------------------------------------------------- state
bool World::Impl::fits(const Slot& slot, const BodyState& at) {
  if (kind_of(slot).rungs[slot.rung].in_use.fidelity.precision == Precision::float64) return true;
  const BodyState rounded{vec_cast<double>(vec_cast<float>(at.position)),
                          vec_cast<double>(vec_cast<float>(at.velocity))};
  if (finite(rounded.position) && finite(rounded.velocity)) return true;
  return refuse({"is too large for float32", finite(rounded.position) ? "velocity" : "position", "ask for float64"});
}

bool World::Impl::change_state(ProjectileId id, const BodyState& to) {
  if (!find(id)) return refuse(gone());
  if (!finite(to.position)) return refuse(not_finite("position"));
  if (!finite(to.velocity)) return refuse(not_finite("velocity"));
  if (!fits(*find(id), to)) return false;
  wake(id.index);
  set_row_state(id.index, to);
  return true;
}

bool World::set_position(ProjectileId id, const Vec3d& position) {
  const Recorded<Call::set_position> call(impl_->recorder, id, position);
  const Slot* slot = impl_->find(id);
  return impl_->change_state(id, {position, slot ? impl_->state_of(*slot).velocity : Vec3d{}});
}
bool World::set_velocity(ProjectileId id, const Vec3d& velocity) {
  const Recorded<Call::set_velocity> call(impl_->recorder, id, velocity);
  const Slot* slot = impl_->find(id);
  return impl_->change_state(id, {slot ? impl_->state_of(*slot).position : Vec3d{}, velocity});
}
bool World::set_state(ProjectileId id, const BodyState& state) {
  const Recorded<Call::set_state> call(impl_->recorder, id, state);
  return impl_->change_state(id, state);
}

bool World::apply_impulse(ProjectileId id, const Vec3d& impulse) {
  const Recorded<Call::apply_impulse> call(impl_->recorder, id, impulse);
  const Slot* slot = impl_->find(id);
  if (!slot) return impl_->refuse(gone());
  if (!finite(impulse)) return impl_->refuse(not_finite("impulse"));
  if (slot->is(kKinematic | kInfiniteMass | kPending))
    return impl_->refuse({"nothing pushes it", "id", "it is kinematic, pending or of infinite mass"});
  const BodyState at = impl_->state_of(*slot);
  return impl_->change_state(id, {at.position, at.velocity + impulse * inverse_mass(id)});
}

bool World::set_angular_velocity(ProjectileId id, const Vec3d& omega) {
  const Recorded<Call::set_angular_velocity> call(impl_->recorder, id, omega);
  Slot* slot = impl_->find(id);
  if (!slot) return impl_->refuse(gone());
  if (!finite(omega)) return impl_->refuse(not_finite("omega"));
  if (auto flown = impl_->attitude(id.index)) {
    flown->omega = rotate(conjugate(flown->q_WB), omega) + impl_->omega_of_W(*slot, flown->q_WB);
    impl_->wake(id.index);
    return impl_->set_attitude(id.index, *flown), true;
  }
  slot->set(kTurning, true);
  impl_->state.turning[id.index].angular_velocity = omega;
  return true;
}

// ------------------------------------------------------------------------------------------- switches
bool World::Impl::set_flag(ProjectileId id, std::uint32_t flag, bool on) {
  Slot* slot = find(id);
  if (!slot) return refuse(gone());
  wake(id.index);
  slot->set(flag, on);
  return relocate(id.index);
}

bool World::set_gravity_scale(ProjectileId id, double scale) {
  const Recorded<Call::set_gravity_scale> call(impl_->recorder, id, scale);
  if (!impl_->find(id)) return impl_->refuse(gone());
  if (!std::isfinite(scale)) return impl_->refuse({"must be a finite number", "scale", "1 is all of gravity"});
  impl_->own(id.index).gravity_scale = scale;
  if (!impl_->set_flag(id, kScaled, scale != 1)) return false;
  impl_->rewrite_row(id.index);
  return true;
}
bool World::set_use_gravity(ProjectileId id, bool use) {
  const Recorded<Call::set_use_gravity> call(impl_->recorder, id, use);
  const Slot* slot = impl_->find(id);
  if (!slot) return impl_->refuse(gone());
  const double scale = impl_->kind_of(*slot).body.gravity_scale;
  return set_gravity_scale(id, use ? (scale == 0 ? 1 : scale) : 0);
}
bool World::set_kinematic(ProjectileId id, bool kinematic) {
  const Recorded<Call::set_kinematic> call(impl_->recorder, id, kinematic);
  return impl_->set_flag(id, kKinematic, kinematic);
}
bool World::is_kinematic(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  return slot && slot->is(kKinematic);
}
bool World::set_frozen(ProjectileId id, Axes position_axes, Axes rotation_axes) {
  const Recorded<Call::set_frozen> call(impl_->recorder, id, position_axes, rotation_axes);
  if (!impl_->find(id)) return impl_->refuse(gone());
  Own& own = impl_->own(id.index);
  own.frozen = position_axes;
  own.frozen_rotation = rotation_axes;
  if (!impl_->set_flag(id, kFrozen, position_axes != Axes::none)) return false;
  impl_->rewrite_row(id.index);
  return true;
}
bool World::set_can_sleep(ProjectileId id, bool can) {
  const Recorded<Call::set_can_sleep> call(impl_->recorder, id, can);
  return impl_->set_flag(id, kSleepless, !can);
}

bool World::set_smoothing(ProjectileId id, Smoothing smoothing) {
  const Recorded<Call::set_smoothing> call(impl_->recorder, id, smoothing);
  Slot* slot = impl_->find(id);
  if (!slot) return impl_->refuse(gone());
  slot->set_smoothing(smoothing);
  return true;
}
bool World::set_user_data(ProjectileId id, std::uint64_t data) {
  const Recorded<Call::set_user_data> call(impl_->recorder, id, data);
  if (!impl_->find(id)) return impl_->refuse(gone());
  impl_->tags(id.index).user_data = data;
  return true;
}
bool World::set_layers(ProjectileId id, std::uint32_t layers) {
  const Recorded<Call::set_layers> call(impl_->recorder, id, layers);
  if (!impl_->find(id)) return impl_->refuse(gone());
  impl_->tags(id.index).layers = layers;
  impl_->update_forced(id.index);
  return true;
}
bool World::set_colour(ProjectileId id, std::uint32_t rgba) {
  const Recorded<Call::set_colour> call(impl_->recorder, id, rgba);
  if (!impl_->find(id)) return impl_->refuse(gone());
  impl_->tags(id.index).colour = rgba;
  return true;
}
bool World::set_label(ProjectileId id, const std::string& label) {
  const Recorded<Call::set_label> call(impl_->recorder, id, label);
  if (!impl_->find(id)) return impl_->refuse(gone());
  impl_->tags(id.index).label = label;
  return true;
}

// ------------------------------------------------------------------------------------------- fidelity
bool World::Impl::change_fidelity(std::uint32_t index, const Fidelity& asked) {
  const auto rung = registry.rung(state.slots[index].kind, asked);
  if (!rung) return refuse({"there are too many rungs of this kind", "fidelity", "at most 4096"});
  return change_rung(index, *rung);
}

bool World::Impl::change_rung(std::uint32_t index, std::uint16_t rung) {
  Slot& slot = state.slots[index];
  if (rung == slot.rung) return true;
  const std::uint16_t before = slot.rung;
  slot.rung = rung;
  // What lies in float32 now fits every rung.
  if (!rows_of(slot).layout().float32 && !fits(slot, state_of(slot))) return slot.rung = before, false;
  const bool forced_before = slot.is(kForced);
  slot.set(kForced, feels_forces(index));
  if (!relocate(index)) return slot.rung = before, slot.set(kForced, forced_before), false;
  tell(WorldEventKind::fidelity_changed, index);
  return true;
}

bool World::set_fidelity(ProjectileId id, const Fidelity& fidelity) {
  const Recorded<Call::set_fidelity> call(impl_->recorder, id, fidelity);
  if (!impl_->find(id)) return impl_->refuse(gone());
  return impl_->change_fidelity(id.index, fidelity);
}

std::size_t World::set_fidelity(std::span<const ProjectileId> ids, const Fidelity& fidelity) {
  const Recorded<Call::set_fidelity_many> call(impl_->recorder, ids, fidelity);
  Impl& w = *impl_;
  std::size_t changed = 0;
  std::uint32_t kind = 0;  // looked up last, and its rung
  std::optional<std::uint16_t> rung;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    w.prefetch(ids, i);
    const Slot* slot = w.find(ids[i]);
    if (!slot) continue;
    if (slot->kind != kind || !rung) rung = w.registry.rung(kind = slot->kind, fidelity);
    if (rung ? w.change_rung(ids[i].index, *rung) : w.change_fidelity(ids[i].index, fidelity)) ++changed;
  }
  return changed;
}

FidelityInUse World::fidelity_in_use(ProjectileId id) const {
  const Slot* slot = impl_->find(id);
  if (!slot) return {};
  FidelityInUse in_use = impl_->kind_of(*slot).rungs[slot->rung].in_use;
  const Fidelity& f = in_use.fidelity;
  const std::string integrator(name(f.integrator));
  const std::string motion(name(f.motion));
  if (slot->is(kForced) && is_adaptive(f.integrator))
    in_use.notes.push_back({"integrator", integrator, integrator,
                            "generators act on it: the world's step is one step, whatever its error"});
  if (f.motion != Motion::force && impl_->is_target(id.index))
    in_use.notes.push_back({"motion", motion, motion, "generators are not felt: only motion 'force' knows forces"});
  return in_use;
}

void World::set_observer(const Vec3d& position) {
  const Recorded<Call::set_observer> call(impl_->recorder, position);
  if (finite(position)) impl_->state.observer = position;
}

}  // namespace physim
