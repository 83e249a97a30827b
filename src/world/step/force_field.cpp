#include "world/step/force_field.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "model/force_laws.hpp"

namespace physim {
namespace {

/// The rows of one partner are summed in their order, and a user function sees it: it must not be that of the rows.
bool order_matters(const ForceLaw& law) { return std::holds_alternative<CustomForce>(law) || other_end(law); }

/// The part of a step in which a generator acts, 0..1.
struct ActingPart {
  double from;
  double to;

  ActingPart(const Generator& g, double time, double dt) : from((g.start - time) / dt), to((g.end - time) / dt) {
    if (from < kSameTime) from = 0;
    if (to > 1 - kSameTime) to = 1;
  }
  [[nodiscard]] double length() const { return to - from; }
};

}  // namespace

double gravity_scale_of(const Registry& registry, const WorldState& state, std::uint32_t slot) {
  const double own = state.slots[slot].is(kOwn) ? state.extras.own_of(slot).gravity_scale : 1;
  return registry.kind(state.slots[slot].kind).projectile.gravity_scale * own;
}

double mass_of(const Registry& registry, const WorldState& state, const Slot& slot) {
  const Kind& kind = registry.kind(slot.kind);
  if (!registry.cohort(slot.cohort).conditions.has_motor) return kind.projectile.mass;
  Body<double> body = kind.rungs[slot.rung].body;
  state.rows[slot.cohort].read_fields(slot.row, body);
  return mass_at(body, state.row_clock(slot));
}

std::uint32_t layers_of(const Registry& registry, const WorldState& state, std::uint32_t slot) {
  const Tags* tags = state.extras.find_tags(slot);
  return tags ? tags->layers : registry.kind(state.slots[slot].kind).body.layers;
}

ProjectileId other_end(const ForceLaw& law) {
  const ProjectileId* other = other_end_of(law);
  return other != nullptr ? *other : ProjectileId{};
}

bool is_in_group(const Generator& g, const Registry& registry, const WorldState& state, std::uint32_t slot) {
  const ForceTarget& target = g.def.target;
  if (!has_group(target)) return false;
  const bool inside = target.layers == ForceTarget::everything().layers ||
                      (target.kind && target.kind.index == registry.kind(state.slots[slot].kind).number) ||
                      (target.layers & layers_of(registry, state, slot)) != 0;
  if (!inside || g.except.empty()) return inside;
  return std::find(g.except.begin(), g.except.end(), state.slots.id_of(slot)) == g.except.end();
}

void ForceRows::clear() {
  first_of_cohort.clear();
  id.clear();
  mass.clear();
  def.clear();
}

void ForceRows::add(const Registry& registry, const WorldState& state, std::uint32_t slot) {
  const ProjectileDef& projectile = registry.kind(state.slots[slot].kind).projectile;
  id.push_back(state.slots.id_of(slot));
  mass.push_back(mass_of(registry, state, state.slots[slot]));
  def.push_back(&projectile);
}

std::uint32_t ForceField::row_of(ProjectileId id) const {
  const Slot* slot = state_.slots.find(id);
  if (!slot) return kNotInStage;
  if (rows_.first_of_cohort.empty()) return rows_.id[0] == id ? 0 : kNotInStage;
  PHYSIM_ASSERT(slot->cohort < rows_.first_of_cohort.size());
  const std::uint32_t first = rows_.first_of_cohort[slot->cohort];
  return first == kNotInStage ? kNotInStage : first + slot->row;
}

// --------------------------------------------------------------------------------------------------- who feels what
void ForceField::begin_step(double time, double dt) {
  PHYSIM_ASSERT(dt > 0);
  time_ = time;
  dt_ = dt;
  rows_.members.clear();
  rows_.pushes.clear();
  const auto rows = rows_.id.size();
  rows_.position.resize(rows);
  rows_.velocity.resize(rows);
  rows_.force.resize(rows);
  has_zones_ = has_ages_ = false;
  for (const std::uint32_t index : state_.generators.order()) {
    const Generator& g = state_.generators[index];
    if (without_functions_ && std::holds_alternative<CustomForce>(g.def.law)) continue;
    if (without_pairs_ && other_end(g.def.law)) continue;
    const ActingPart acts(g, time_, dt);
    if (acts.from < 1 - kSameTime && acts.to > kSameTime) list(index);
  }
}

void ForceField::list(std::uint32_t index) {
  const Generator& g = state_.generators[index];
  const ForceTarget& target = g.def.target;
  auto& members = rows_.members;
  const auto first = static_cast<std::uint32_t>(members.size());
  if (has_group(target))
    for (std::uint32_t row = 0; row < rows_.id.size(); ++row)
      if (is_in_group(g, registry_, state_, rows_.id[row].index)) members.push_back(row);
  for (const ProjectileId id : target.ids) {
    const std::uint32_t row = row_of(id);
    if (row != kNotInStage && !is_in_group(g, registry_, state_, id.index)) members.push_back(row);
  }
  const auto by_slot = [this](std::uint32_t a, std::uint32_t b) { return rows_.id[a].index < rows_.id[b].index; };
  if (order_matters(g.def.law) && !std::is_sorted(members.begin() + first, members.end(), by_slot))
    std::sort(members.begin() + first, members.end(), by_slot);
  const auto last = static_cast<std::uint32_t>(members.size());
  if (last > first) rows_.pushes.push_back({index, first, last, {}});
  if (const ProjectileId other = other_end(g.def.law)) list_backwards(index, other);
  has_zones_ = has_zones_ || std::holds_alternative<WindZone>(g.def.law);
  has_ages_ = has_ages_ || std::holds_alternative<Thrust>(g.def.law);
}

/// Targets that are not here (asleep, kinematic, under another integrator) pull at the other end where that is here.
void ForceField::list_backwards(std::uint32_t index, ProjectileId other) {
  const std::uint32_t row = row_of(other);
  if (row == kNotInStage) return;
  for (const ProjectileId id : state_.generators[index].def.target.ids) {
    if (!state_.slots.find(id) || row_of(id) != kNotInStage) continue;
    const auto first = static_cast<std::uint32_t>(rows_.members.size());
    rows_.members.push_back(row);
    rows_.pushes.push_back({index, first, first + 1, id});
  }
}

// --------------------------------------------------------------------------------------------------- a stage
void ForceField::begin_stage(double place) {
  PHYSIM_ASSERT(place >= 0 && place <= 1);
  PHYSIM_ASSERT(rows_.position.size() == rows_.id.size() && rows_.mass.size() == rows_.id.size());
  place_ = place;
  rows_.force.assign(rows_.id.size(), Vec3d{});
  rows_.drag_rate.assign(rows_.id.size(), 0.0);
  if (has_zones_) rows_.in_zone.assign(rows_.id.size(), 0);
  if (has_ages_) {
    rows_.age.resize(rows_.id.size());
    for (std::size_t row = 0; row < rows_.id.size(); ++row)
      rows_.age[row] = time_ + place * dt_ - state_.slots.birth(rows_.id[row].index);
  }
}

void ForceField::evaluate(double place) {
  begin_stage(place);
  for (const Push& push : rows_.pushes) {
    const ActingPart acts(state_.generators[push.generator], time_, dt_);
    if (acts.length() < 1)
      add_part(push, acts.from + place * acts.length(), acts.length());
    else
      add(push, place);
  }
}

void ForceField::evaluate_now() {
  begin_stage(0);
  for (const Push& push : rows_.pushes)
    if (ActingPart(state_.generators[push.generator], time_, dt_).from == 0) add(push, 0);
}

/// With the part of its force that is the part of the step in which it acts, asked for in the course of that part: its
/// impulse is exact, with every integrator.
void ForceField::add_part(const Push& push, double place, double part) {
  const std::vector<Vec3d> force = rows_.force;
  const std::vector<double> drag_rate = rows_.drag_rate;
  add(push, place);
  for (std::size_t row = 0; row < force.size(); ++row) {
    rows_.force[row] = force[row] + (rows_.force[row] - force[row]) * part;
    rows_.drag_rate[row] = drag_rate[row] + (rows_.drag_rate[row] - drag_rate[row]) * part;
  }
}

void ForceField::add(const Push& push, double place) {
  const Generator& g = state_.generators[push.generator];
  const double time = time_ + place * dt_, since = time - g.start;
  ForceStage stage{time,      rows_.id,  rows_.position, rows_.velocity, rows_.mass,
                   rows_.age, rows_.def, rows_.in_zone,  rows_.force,    rows_.drag_rate};
  const ForceClock clock{std::abs(since) < kSameTime * dt_ ? 0 : since, bool(g.def.target.kind)};
  const auto sum = [&](const ForceLaw& law) { add_force(law, clock, members_of(push), *this, stage, rows_.scratch); };
  if (!push.from) return sum(g.def.law);
  ForceLaw backwards = g.def.law;
  PHYSIM_ASSERT(other_end_of(backwards) != nullptr);
  *other_end_of(backwards) = push.from;
  sum(backwards);
}

bool ForceField::is_sound(std::uint32_t row) const {
  const Vec3d& x = rows_.position[row];
  const Vec3d& v = rows_.velocity[row];
  return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z) && std::isfinite(v.x) && std::isfinite(v.y) &&
         std::isfinite(v.z);
}

/// A row with a NaN leaves at the end of the step; until then it must not reach others.
std::span<const std::uint32_t> ForceField::members_of(const Push& push) {
  PHYSIM_ASSERT(push.first < push.last && push.last <= rows_.members.size());
  const std::span<const std::uint32_t> all(rows_.members.data() + push.first, push.last - push.first);
  if (rows_.sound) return all;
  rows_.sound_members.clear();
  for (const std::uint32_t row : all)
    if (is_sound(row)) rows_.sound_members.push_back(row);
  return rows_.sound_members;
}

// --------------------------------------------------------------------------------------------------- surroundings
/// One that is not among the rows is taken to go straight on for the step.
Partner ForceField::partner(ProjectileId id) const {
  const Slot* slot = state_.slots.find(id);
  if (!slot) return {};
  const std::uint32_t row = row_of(id);
  if (row != kNotInStage) return rows_.sound || is_sound(row) ? Partner{true, row, {}} : Partner{};
  const Rows& its = state_.rows[slot->cohort];
  const Vec3d v = its.velocity(slot->row);
  const Vec3d way = slot->is(kStill) ? Vec3d{} : v * (place_ * dt_);
  return {true, kNotInStage, {its.position(slot->row) + way, v}};
}

Vec3d ForceField::drag_equation(std::uint32_t row, double density, const Vec3d& u) const {
  const Kind& kind = registry_.kind(state_.slots[rows_.id[row].index].kind);
  constexpr std::size_t kMostInZones = 1024;
  if (zones_.index.size() >= kMostInZones) zones_ = {};  // most of these are gone by now
  if (!zones_.drag) zones_.drag.emplace();
  const auto [known, is_new] = zones_.index.try_emplace(kind.number);
  if (is_new) known->second = zones_.drag->add(kind.flown);
  return zones_.drag->force(known->second, rows_.mass[row], density, u);
}

Surroundings::OwnDrag ForceField::own_drag(std::uint32_t row) const {
  const Slot& slot = state_.slots[rows_.id[row].index];
  const Conditions<double>& c = registry_.cohort(slot.cohort).conditions;
  Body<double> body = registry_.kind(slot.kind).rungs[slot.rung].body;
  const Rows& rows = state_.rows[slot.cohort];
  rows.read_fields(slot.row, body);
  const State<double> s{rows_.position[row], rows_.velocity[row]};
  const double t = rows.layout().clocked ? state_.row_clock(slot) + place_ * dt_ : 0;  // as the stage knows it
  BrakedSum<double> air{};
  PointInAir{}.add_air(c, body, t, s, air);
  return {air.total * rows_.mass[row], drag_rate_of(air.drag, air.through_air) * rows_.mass[row]};
}

}  // namespace physim
