#include "world/birth_batch.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include "prepare/grant.hpp"
#include "world/world_impl.hpp"

namespace physim {
namespace {

/// Somebody waits for births, or for ages, which may be reached in the step of the birth.
bool waits_for_the_young(const EmitterDef& def) {
  return std::ranges::any_of(
      def.subs, [](const SubEmitter& sub) { return sub.on == SubEvent::birth || sub.on == SubEvent::age; });
}
/// All that its launches say beside place and velocity is what holds for one without a rail.
bool has_plain_launch(const WorldImpl& world, const Kind& kind, const EmitterDef& def, double time) {
  Launch launch = def.launch;
  launch.velocity = Vec3d{1, 0, 0};
  return !(launch.rail_length > 0) && world.bore_of(kind, launch, time);
}
/// Nothing about one of the kind has to be noted apart.
bool is_plain_kind(const Kind& kind) {
  const BodyDef& body = kind.body;
  return body.cheapest_within == 0 && body.angular_velocity == Vec3d{} && !std::isfinite(body.despawn.older) &&
         (kind.flags & (kStill | kOwn)) == 0 && !has_motor(kind.projectile);
}

}  // namespace

BirthBatches::BirthBatches(WorldImpl& world, const SettleContext& context, double end)
    : w_(world), context_(context), end_(end) {}

const BirthPlan* BirthBatches::plan(std::uint32_t emitter) {
  if (plans_.size() <= emitter) plans_.resize(w_.state.emitters.size());
  std::optional<BirthPlan>& known = plans_[emitter];
  if (!known) known = find(emitter);
  return known->kind != 0 ? &*known : nullptr;
}

BirthPlan BirthBatches::find(std::uint32_t index) const {
  const Emitter& e = w_.state.emitters[index];
  const EmitterDef& def = e.def();
  if (!w_.state.generators.empty() || !e.emission->leaves_gravity() || waits_for_the_young(def)) return {};
  const std::uint32_t kind_index = w_.registry.kinds.find(def.kind);
  if (kind_index == 0) return {};
  const Kind& kind = w_.registry.kind(kind_index);
  if (!w_.registry.has_environment_of(kind) || !is_plain_kind(kind)) return {};
  if (!has_plain_launch(w_, kind, def, w_.state.clock.time())) return {};
  const Prepared& rung = kind.rungs.front();
  if (rung.in_use.fidelity.planar || rung.equivalent_drag || rung.rotor) return {};
  const bool driven = e.drives && rung.in_use.fidelity.motion == Motion::force;
  const FlightLaw& law = e.emission->flight();
  if (e.drives && (law.adds_velocity() || law.has_force() || law.scales_gravity())) return {};
  Slot slot;
  slot.flags = kind.flags;
  slot.set(kForced, driven);
  const std::uint16_t cohort = rung.cohort[slot.variant().index()];
  if (cohort >= w_.state.rows.size() || !w_.emitting.known.knows(context_, cohort)) return {};
  slot.set(kAlive, true);
  slot.set_status(LifeStatus::in_flight);
  return {.emission = e.emission.get(),
          .emitter = index,
          .kind = kind_index,
          .flags = slot.flags,
          .pool = kind.body.pool,
          .cohort = cohort,
          .body = &rung.body,
          .float32 = w_.state.rows[cohort].layout().float32,
          .law = driven ? &law : nullptr};
}

void BirthBatches::prepare(const BirthPlan& plan, BirthColumns& births) const {
  prepare_births(plan, context_, end_, w_.emitting.known, births);
}

std::size_t BirthBatches::room(const BirthPlan& plan, std::size_t departed) const {
  const auto left = [](std::uint64_t most, std::uint64_t there) { return most - std::min(most, there); };
  const Emitter& e = w_.state.emitters[plan.emitter];
  const std::uint64_t at_emitter = left(e.def().maximum, e.counts.alive + departed);
  const std::uint64_t in_world = left(w_.def.max_projectiles, w_.state.slots.alive());
  return static_cast<std::size_t>(std::min(
      {at_emitter, in_world, std::uint64_t{w_.state.pools.left(plan.pool)}, std::uint64_t{w_.room_for_events()}}));
}

std::size_t BirthBatches::bear(const BirthPlan& plan, BirthColumns& b, std::size_t most, const Particle& like) {
  PHYSIM_ASSERT(plan.kind != 0 && b.next < b.count);
  Emitter& e = w_.state.emitters[plan.emitter];
  if (b.number[b.next] != e.born) return 0;  // others were born between
  const std::uint32_t others = ~(b.plain >> b.next);
  const std::size_t plain = others == 0 ? BirthColumns::kLanes : static_cast<std::size_t>(__builtin_ctz(others));
  // The first of all rows says by itself what those of later ones are compared with.
  const std::size_t at_once = w_.state.rows[plan.cohort].size() == 0 ? 1 : BirthColumns::kLanes;
  take_places(plan, std::min({most, plain, b.count - b.next, at_once}));
  if (count_ == 0) return 0;
  come_alive(plan, b);
  if (plan.float32)
    put_rows(plan, b, std::get<0>(b.flights)), tell(plan, b, std::get<0>(b.flights));
  else
    put_rows(plan, b, std::get<1>(b.flights)), tell(plan, b, std::get<1>(b.flights));
  Particle particle = like;
  particle.emitter = plan.emitter;
  for (std::size_t i = 0; i < count_; ++i) {
    const std::size_t lane = b.next + i;
    particle.number = b.number[lane], particle.phase = b.phase[lane], particle.dies = b.dies[lane];
    w_.state.emitters.join(w_.state.slots.id_of(slots_[i]), particle, b.time[lane], end_);
  }
  e.born += count_;
  e.counts.born += count_;
  b.next += count_;
  return count_;
}

/// Slots and rows for so many, or for fewer where memory ends: the others are tried, and refused, one by one.
void BirthBatches::take_places(const BirthPlan& plan, std::size_t count) {
  SlotTable& table = w_.state.slots;
  Rows& rows = w_.state.rows[plan.cohort];
  count_ = 0;
  std::uint32_t index = 0;
  try {
    w_.make_room_for_events(w_.state.events.size() + count);
    for (; count_ < count; ++count_) {
      index = 0;
      index = table.take();
      const std::uint32_t row = rows.push(index);
      table[index].row = row;
      slots_[count_] = index;
      w_.state.emitters.prefetch(index);
    }
  } catch (const std::bad_alloc&) {
    if (index != 0) table.release(index, LifeStatus::unknown);
  }
}

void BirthBatches::come_alive(const BirthPlan& plan, const BirthColumns& b) {
  SlotTable& table = w_.state.slots;
  for (std::size_t i = 0; i < count_; ++i) {
    const std::uint32_t index = slots_[i];
    table.come_alive(index, plan.flags & ~std::uint32_t{kAlive});
    Slot& slot = table[index];
    slot.kind = plan.kind;
    slot.rung = 0;
    slot.cohort = plan.cohort;
    table.birth(index) = b.time[b.next + i];
    table.rest(index) = {};
    w_.state.pools.join(plan.pool, index);
    w_.registry.kinds.join(plan.kind);
  }
}

template <class S>
void BirthBatches::put_rows(const BirthPlan& plan, const BirthColumns& b, const NewbornFlights<S>& flights) {
  Rows& rows = w_.state.rows[plan.cohort];
  const auto fill = [&](std::uint32_t row, std::size_t lane) {
    const RowColumns<S>& c = rows.columns<S>();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c.previous[axis][row] = flights.x[axis][lane];
      c.position[axis][row] = flights.end_x[axis][lane];
      c.velocity[axis][row] = flights.end_v[axis][lane];
    }
    if (!rows.layout().clocked) return;
    c.offset[row] = static_cast<S>(b.age[lane]);
    c.born[row] = static_cast<S>(w_.state.clock.now());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c.field[kBodyNumber.launch.x[axis]][row] = flights.x[axis][lane];
      c.field[kBodyNumber.launch.v[axis]][row] = flights.v[axis][lane];
    }
  };
  const std::uint32_t first = rows.size() - static_cast<std::uint32_t>(count_);
  rows.write_fields(first, *plan.body);  // looks whether they are those of the others
  for (std::size_t i = 0; i < count_; ++i) {
    const std::uint32_t row = first + static_cast<std::uint32_t>(i);
    PHYSIM_ASSERT(rows.slot(row) == slots_[i]);
    for (const std::uint8_t number : rows.layout().fields) {
      S* const column = rows.columns<S>().field[number];
      column[row] = column[first];
    }
    fill(row, b.next + i);
    PHYSIM_ASSERT(rows.is_filled(row));
  }
}

template <class S>
void BirthBatches::tell(const BirthPlan& plan, const BirthColumns& b, const NewbornFlights<S>& flights) {
  const auto vector = [](const auto& of, std::size_t lane) {
    return Vec3d{double(of[0][lane]), double(of[1][lane]), double(of[2][lane])};
  };
  for (std::size_t i = 0; i < count_; ++i) {
    const std::size_t lane = b.next + i;
    Event& event = w_.state.events.emplace_back();
    event.kind = EventKind::spawned;
    event.id = w_.state.slots.id_of(slots_[i]);
    event.value = plan.emitter;
    event.time = b.time[lane];
    event.position = vector(flights.x, lane);
    event.velocity = vector(flights.v, lane);
  }
}

}  // namespace physim
