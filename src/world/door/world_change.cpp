// Changes to projectiles between steps: state, switches, sleep, fidelity, things carried along.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/checker.hpp"
#include "base/ieee_mode.hpp"
#include "physim/names.hpp"
#include "prepare/check.hpp"
#include "prepare/grant.hpp"
#include "world/core/check.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {

namespace {

Error gone() { return {"it is gone", "id", "is_alive() tells"}; }
Error not_finite(const char* place) { return {"must have three finite components", place, ""}; }

}  // namespace

void WorldImpl::tell(EventKind kind, std::uint32_t slot, Reason reason, std::optional<double> moment,
                     std::uint32_t value) {
  if (!may_keep_event()) return;
  const Slot& who = state.slots[slot];
  const Rows& rows = state.rows_of(who);
  rows.visit([&, row = who.row](const auto& c) {
    state.events.add({kind,
                      reason,
                      {slot, who.generation},
                      value,
                      moment ? *moment : state.clock.time(),
                      vec_cast<double>(Rows::numbers_at(c.position, row)),
                      vec_cast<double>(Rows::numbers_at(c.velocity, row))});
  });
}

bool WorldImpl::may_keep_event() {
  if (room_for_events() > 0) return true;
  ++state.counters.dropped_events;
  return false;
}

void WorldImpl::keep_events(std::span<const PlainEvent> told) {
  const std::size_t kept = std::min(told.size(), room_for_events());
  state.counters.dropped_events += told.size() - kept;
  state.events.add_each(kept, [&](std::size_t i) -> const PlainEvent& { return told[i]; });
}

std::size_t WorldImpl::room_for_events() const {
  if (is_inside) return EventList::kMost - std::min(EventList::kMost, state.events.size());
  const std::size_t of_calls = std::max(kMostEventsOfCalls, 2 * std::size_t{state.slots.alive()});
  const std::size_t most = state.events_of_step + of_calls;
  return most - std::min(most, state.events.size());
}

void WorldImpl::forget_events() {
  state.events.clear();
  state.events_of_step = 0;
  given_events.clear();
  state.joints.events.clear();
}

void WorldImpl::tell_launch(std::uint32_t index, const Coming& coming) {
  tell(EventKind::spawned, index, Reason::none, coming.moment, coming.emitter);
  const Kind& kind = registry.kind(state.slots[index].kind);
  const bool burns = registry.cohort(state.slots[index].cohort).conditions.has_motor && has_motor(kind.projectile);
  if (burns && coming.age == 0 && kind.projectile.motor.ignition_delay == 0)
    tell(EventKind::ignition, index, Reason::none, coming.moment);
}

// ------------------------------------------------------------------------------------------- sleep
bool WorldImpl::put_to_sleep(std::uint32_t index) {
  Slot& slot = state.slots[index];
  if (slot.is(kStill)) return false;
  slot.set(kAsleep, true);
  is_stirred = false;
  placement.relocate(index);
  placement.set_row_state(index, {state.state_of(slot).position, {}});
  placement.stop_turning(index);
  tell(EventKind::slept, index);
  return true;
}

bool WorldImpl::wake_alone(std::uint32_t index, std::optional<double> moment) {
  Slot& slot = state.slots[index];
  state.slots.rest(index) = {};
  if (!slot.is(kAsleep | kStuck)) return false;
  slot.set(kAsleep | kStuck | kPiled, false);
  slot.set_status(LifeStatus::in_flight);
  placement.relocate(index);
  tell(EventKind::woke, index, Reason::none, moment);
  return true;
}

bool WorldImpl::wake(std::uint32_t index) {
  const std::vector<std::uint32_t> beside = sleepers_at(index);
  const bool woke = wake_alone(index);
  disturb(beside);
  return woke;
}

Status Projectile::sleep() {
  const Recorded<Call::sleep> call(world(), id_);
  if (call.is_refused()) return call.refusal();
  if (!world().find(id_)) return gone();
  if (!world().put_to_sleep(id_.index)) return Error{"it stands still already", "id", "is_asleep() tells"};
  return {};
}
Status Projectile::wake() {
  const Recorded<Call::wake> call(world(), id_);
  if (call.is_refused()) return call.refusal();
  if (!world().find(id_)) return gone();
  if (!world().wake(id_.index)) return Error{"it is awake already", "id", "is_asleep() tells"};
  return {};
}
bool ProjectileView::is_asleep() const {
  const Slot* slot = world_->find(id_);
  return slot && slot->is(kAsleep);
}

// ------------------------------------------------------------------------------------------- state
Status WorldImpl::fits(const Slot& slot, const BodyState& at) const {
  return check_fits(at.position, at.velocity, registry.kind(slot.kind).on(slot.rung).in_use.fidelity.precision);
}

Status WorldImpl::change_state(ProjectileId id, const BodyState& to) {
  const Slot* slot = find(id);
  if (!slot) return gone();
  if (!finite(to.position)) return not_finite("position");
  if (!finite(to.velocity)) return not_finite("velocity");
  if (Status status = fits(*slot, to); !status) return status;
  wake(id.index);
  placement.jump(id.index, to);
  return {};
}

Status Projectile::set_position(const Vec3d& position) {
  const Recorded<Call::set_position> call(world(), id_, position);
  if (call.is_refused()) return call.refusal();
  const Slot* slot = world().find(id_);
  return world().change_state(id_, {position, slot ? world().state.state_of(*slot).velocity : Vec3d{}});
}
Status Projectile::set_velocity(const Vec3d& velocity) {
  const Recorded<Call::set_velocity> call(world(), id_, velocity);
  if (call.is_refused()) return call.refusal();
  const Slot* slot = world().find(id_);
  return world().change_state(id_, {slot ? world().state.state_of(*slot).position : Vec3d{}, velocity});
}
Status Projectile::set_state(const BodyState& state) {
  const Recorded<Call::set_state> call(world(), id_, state);
  if (call.is_refused()) return call.refusal();
  return world().change_state(id_, state);
}

Status Projectile::apply_impulse(const Vec3d& impulse) {
  const Recorded<Call::apply_impulse> call(world(), id_, impulse);
  if (call.is_refused()) return call.refusal();
  const Slot* slot = world().find(id_);
  if (!slot) return gone();
  if (!finite(impulse)) return not_finite("impulse");
  if (slot->is(kKinematic | kInfiniteMass | kPending))
    return Error{"nothing pushes it", "id", "it is kinematic, pending or of infinite mass"};
  const BodyState at = world().state.state_of(*slot);
  return world().change_state(id_, {at.position, at.velocity + impulse * inverse_mass()});
}

Status Projectile::set_angular_velocity(const Vec3d& omega) {
  const Recorded<Call::set_angular_velocity> call(world(), id_, omega);
  if (call.is_refused()) return call.refusal();
  Slot* slot = world().find(id_);
  if (!slot) return gone();
  if (!finite(omega)) return not_finite("omega");
  if (auto flown = world().placement.attitude(id_.index)) {
    flown->omega = rotate(conjugate(flown->q_WB), omega) + world().placement.omega_of_W(*slot, flown->q_WB);
    world().wake(id_.index);
    world().placement.set_attitude(id_.index, *flown);
    return {};
  }
  slot->set(kTurning, true);
  world().state.extras.turning[id_.index].angular_velocity = omega;
  return {};
}

// ------------------------------------------------------------------------------------------- switches
Status WorldImpl::set_flag(ProjectileId id, std::uint32_t flag, bool on) {
  Slot* slot = find(id);
  if (!slot) return gone();
  wake(id.index);
  const std::uint32_t before = slot->flags;
  slot->set(flag, on);
  Status status = placement.relocate(id.index);
  if (!status) slot->flags = before;
  return status;
}

Status WorldImpl::change_own(std::uint32_t index, const Own& to) {
  wake(index);
  Slot& slot = state.slots[index];
  const std::uint32_t flags_before = slot.flags;
  const Own before = std::exchange(own(index), to);
  for (const OwnPart& part : kOwnParts) slot.set(part.flag, part.differs(to));
  if (Status status = placement.relocate(index); !status) {
    slot.flags = flags_before;
    own(index) = before;
    return status;
  }
  placement.rewrite_row(index);
  return {};
}

BodyDef ProjectileView::body() const {
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  BodyDef body = world_->registry.kind(slot->kind).body;
  if (const Own* own = world_->state.extras.find_own(id_.index)) put_own(*own, body);
  body.kinematic = slot->is(kKinematic);
  body.can_sleep = !slot->is(kSleepless);
  body.smoothing = slot->smoothing();
  body.layers = layers();
  body.colour = colour();
  body.label = label();
  return body;
}

template <class T>
Status WorldImpl::change_tag(ProjectileId id, T Tags::*tag, const T& to) {
  if (!find(id)) return gone();
  tags(id.index).*tag = to;
  return {};
}

Status Projectile::set_body(const BodyDef& to) {
  const Recorded<Call::set_body> call(world(), id_, to);
  if (call.is_refused()) return call.refusal();
  WorldImpl& w = world();
  if (!w.find(id_)) return gone();
  if (Status status = check(to, w.def, w.registry.environments().size()); !status) return status;
  const BodyDef from = body();
  BodyDef reached = from;
  put_own(own_of(to), reached);
  reached.gravity_scale = to.gravity_scale;  // with use_gravity two ways to say one number
  reached.use_gravity = to.use_gravity;
  copy_switches(to, reached);
  if (reached != to) return Error{"has another member that is not live", "body", "BodyDef says which can change"};
  Status status;
  if (own_of(to) != own_of(from)) status = w.change_own(id_.index, own_of(to));
  if (status && to.kinematic != from.kinematic) status = set_kinematic(to.kinematic);
  if (status && to.can_sleep != from.can_sleep) status = set_can_sleep(to.can_sleep);
  if (status && to.smoothing != from.smoothing) status = set_smoothing(to.smoothing);
  if (status && to.layers != from.layers) status = set_layers(to.layers);
  if (status && to.colour != from.colour) status = set_colour(to.colour);
  if (status && to.label != from.label) status = set_label(to.label);
  return status;
}

Status Projectile::set_gravity_scale(double scale) {
  const Recorded<Call::set_gravity_scale> call(world(), id_, scale);
  if (call.is_refused()) return call.refusal();
  if (!world().find(id_)) return gone();
  if (!std::isfinite(scale)) return Error{"must be a finite number", "scale", "1 is all of gravity"};
  Own own = world().own(id_.index);
  own.gravity_scale = scale;
  return world().change_own(id_.index, own);
}
Status Projectile::set_use_gravity(bool use) {
  const Recorded<Call::set_use_gravity> call(world(), id_, use);
  if (call.is_refused()) return call.refusal();
  const Slot* slot = world().find(id_);
  if (!slot) return gone();
  const double scale = world().registry.kind(slot->kind).body.gravity_scale;
  return set_gravity_scale(use ? (scale == 0 ? 1 : scale) : 0);
}
Status Projectile::set_kinematic(bool kinematic) {
  const Recorded<Call::set_kinematic> call(world(), id_, kinematic);
  if (call.is_refused()) return call.refusal();
  return world().set_flag(id_, kKinematic, kinematic);
}
bool ProjectileView::is_kinematic() const {
  const Slot* slot = world_->find(id_);
  return slot && slot->is(kKinematic);
}
Status Projectile::set_frozen(Axes position_axes, Axes rotation_axes) {
  const Recorded<Call::set_frozen> call(world(), id_, position_axes, rotation_axes);
  if (call.is_refused()) return call.refusal();
  if (Status status = check(position_axes, "position_axes"); !status) return status;
  if (Status status = check(rotation_axes, "rotation_axes"); !status) return status;
  if (!world().find(id_)) return gone();
  Own own = world().own(id_.index);
  own.frozen = position_axes;
  own.frozen_rotation = rotation_axes;
  return world().change_own(id_.index, own);
}
Status Projectile::set_can_sleep(bool can) {
  const Recorded<Call::set_can_sleep> call(world(), id_, can);
  if (call.is_refused()) return call.refusal();
  return world().set_flag(id_, kSleepless, !can);
}

Status Projectile::set_smoothing(Smoothing smoothing) {
  const Recorded<Call::set_smoothing> call(world(), id_, smoothing);
  if (call.is_refused()) return call.refusal();
  if (Status status = check(smoothing, "smoothing"); !status) return status;
  Slot* slot = world().find(id_);
  if (!slot) return gone();
  slot->set_smoothing(smoothing);
  return {};
}
Status Projectile::set_user_data(std::uint64_t data) {
  const Recorded<Call::set_user_data> call(world(), id_, data);
  if (call.is_refused()) return call.refusal();
  return world().change_tag(id_, &Tags::user_data, data);
}
Status Projectile::set_layers(std::uint32_t layers) {
  const Recorded<Call::set_layers> call(world(), id_, layers);
  if (call.is_refused()) return call.refusal();
  Status status = world().change_tag(id_, &Tags::layers, layers);
  if (status) world().update_forced(id_.index);
  return status;
}
Status Projectile::set_colour(std::uint32_t rgba) {
  const Recorded<Call::set_colour> call(world(), id_, rgba);
  if (call.is_refused()) return call.refusal();
  return world().change_tag(id_, &Tags::colour, rgba);
}
Status Projectile::set_label(const std::string& label) {
  const Recorded<Call::set_label> call(world(), id_, label);
  if (call.is_refused()) return call.refusal();
  return world().change_tag(id_, &Tags::label, label);
}

// ------------------------------------------------------------------------------------------- what it is
Status WorldImpl::change_projectile(ProjectileId id, const std::function<void(ProjectileDef&)>& change) {
  const Slot* slot = find(id);
  if (!slot) return gone();
  const Kind& from = registry.kind(slot->kind);
  ProjectileDef to = from.projectile;
  change(to);
  if (to == from.projectile) return {};
  if (has_motor(from.projectile))
    return Error{"has a motor", "projectile", "its tables say how its mass and its drag change"};
  ProjectileDef reached = from.projectile;
  reached.mass = to.mass;
  reached.diameter = to.diameter;
  reached.drag = to.drag;
  if (Status status = check(to); !status) return status;  // first: a NaN differs from itself
  if (reached != to)
    return Error{"has another member that is not live", "projectile", "ProjectileDef says which can change"};
  const Result<std::uint32_t> kind = find_or_add_kind(to, from.body);
  if (!kind) return kind.error();
  Status status = change_kind(id.index, *kind);
  registry.kinds.forget_idle(living);
  return status;
}

/// To a kind of the same body.
Status WorldImpl::change_kind(std::uint32_t index, std::uint32_t kind) {
  Slot& slot = state.slots[index];
  const Prepared& now = registry.kind(slot.kind).on(slot.rung);
  const auto rung = registry.rung(kind, now.asked, now.chosen ? &*now.chosen : nullptr);
  if (!rung) return Error{"there are too many rungs of this kind", "fidelity", "at most 4096"};
  wake(index);
  const Slot before = slot;
  slot.kind = kind;
  slot.rung = *rung;
  slot.set(kForced, feels_forces(index));
  if (Status status = placement.relocate(index); !status) return slot = before, status;
  placement.rewrite_row(index);
  registry.kinds.join(kind);  // first: the one that it leaves may go
  registry.kinds.leave(before.kind, moments, living);
  return {};
}

Status Projectile::set_projectile(const ProjectileDef& projectile) {
  const Recorded<Call::set_projectile> call(world(), id_, projectile);
  if (call.is_refused()) return call.refusal();
  return world().change_projectile(id_, [&](ProjectileDef& p) { p = projectile; });
}
Status Projectile::set_mass(double mass) {
  const Recorded<Call::set_mass> call(world(), id_, mass);
  if (call.is_refused()) return call.refusal();
  return world().change_projectile(id_, [&](ProjectileDef& p) { p.mass = mass; });
}
Status Projectile::set_drag(const DragDef& drag) {
  const Recorded<Call::set_drag> call(world(), id_, drag);
  if (call.is_refused()) return call.refusal();
  return world().change_projectile(id_, [&](ProjectileDef& p) { p.drag = drag; });
}
Status Projectile::set_damping(double damping) {
  const Recorded<Call::set_damping> call(world(), id_, damping);
  if (call.is_refused()) return call.refusal();
  return world().change_projectile(id_, [&](ProjectileDef& p) { p.drag.damping = damping; });
}

// ------------------------------------------------------------------------------------------- fidelity
Status WorldImpl::change_fidelity(std::uint32_t index, const Fidelity& asked) {
  const auto rung = registry.rung(state.slots[index].kind, asked);
  if (!rung) return Error{"there are too many rungs of this kind", "fidelity", "at most 4096"};
  return change_rung(index, *rung);
}

Status WorldImpl::change_rung(std::uint32_t index, std::uint16_t rung) {
  Slot& slot = state.slots[index];
  PHYSIM_ASSERT(slot.is(kAlive) && rung < registry.kind(slot.kind).rungs.size());
  if (rung == slot.rung) return {};
  const Slot before = slot;
  slot.rung = rung;
  // What lies in float32 now fits every rung.
  if (!state.rows_of(slot).layout().float32)
    if (Status status = fits(slot, state.state_of(slot)); !status) return slot = before, status;
  slot.set(kForced, feels_forces(index));
  if (Status status = placement.relocate(index); !status) return slot = before, status;
  tell(EventKind::fidelity_changed, index);
  return {};
}

Status Projectile::set_fidelity(const Fidelity& fidelity) {
  const Recorded<Call::set_fidelity> call(world(), id_, fidelity);
  if (call.is_refused()) return call.refusal();
  if (!world().find(id_)) return gone();
  if (Status status = check(Tolerance{}, fidelity); !status) return status;
  return world().change_fidelity(id_.index, fidelity);
}

std::size_t World::set_fidelity(std::span<const ProjectileId> ids, const Fidelity& fidelity) {
  WorldImpl& w = impl();
  const Recorded<Call::set_fidelity_many> call(w, ids, fidelity);
  if (call.is_refused() || !check(Tolerance{}, fidelity)) return 0;
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

FidelityInUse ProjectileView::fidelity_in_use() const {
  const IeeeMode mode;
  const Slot* slot = world_->find(id_);
  if (!slot) return {};
  FidelityInUse in_use = world_->registry.kind(slot->kind).rungs[slot->rung].in_use;
  const Fidelity& f = in_use.fidelity;
  const std::string integrator(name(f.integrator));
  const std::string motion(name(f.motion));
  if (slot->is(kForced) && is_adaptive(f.integrator))
    in_use.notes.push_back({"integrator", integrator, integrator,
                            "generators or its emitter act on it: the world's step is one step, whatever its error"});
  if (f.motion != Motion::force && world_->is_target(id_.index))
    in_use.notes.push_back({"motion", motion, motion, "generators are not felt: only motion 'force' knows forces"});
  if (f.motion != Motion::force && world_->state.emitters.law_of(id_.index))
    in_use.notes.push_back(
        {"motion", motion, motion, "its emitter's flight is not felt: only motion 'force' knows forces"});
  return in_use;
}

Status World::set_observer(const Vec3d& position) {
  WorldImpl& w = impl();
  const Recorded<Call::set_observer> call(w, position);
  if (call.is_refused()) return call.refusal();
  if (!finite(position)) return not_finite("position");
  w.state.observer = position;
  return {};
}

}  // namespace physim
