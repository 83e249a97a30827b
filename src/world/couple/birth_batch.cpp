#include "world/couple/birth_batch.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "base/memory_lack.hpp"
#include "prepare/grant.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// True if particles of an emitter differ in place, velocity and time alone, nothing is noted of a single one,
/// and no sub-emitter waits for what may come in the step of the birth: births and ages.
bool are_alike(const WorldImpl& world, const Kind& kind, const EmitterDef& def, double time) {
  const BodyDef& body = kind.body;
  const bool is_plain = body.cheapest_within == 0 && body.angular_velocity == Vec3d{} &&
                        !std::isfinite(body.despawn.older) && (kind.flags & (kStill | kOwn)) == 0 &&
                        !has_motor(kind.projectile);
  const auto is_early = [](const SubEmitter& sub) { return sub.on == SubEvent::birth || sub.on == SubEvent::age; };
  Launch launch = def.launch;
  launch.velocity = Vec3d{1, 0, 0};
  return is_plain && !std::ranges::any_of(def.subs, is_early) && !(launch.rail_length > 0) &&
         world.bore_of(kind, launch, time);
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
  if (!w_.state.generators.empty() || !e.emission->leaves_gravity()) return {};
  const std::uint32_t kind_index = w_.registry.kinds.find(def.kind);
  if (kind_index == 0) return {};
  const Kind& kind = w_.registry.kind(kind_index);
  if (!w_.registry.has_environment_of(kind) || !are_alike(w_, kind, def, w_.state.clock.time())) return {};
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
  const std::size_t own = left(e.def().maximum, e.counts.alive + departed);
  const std::size_t shared = left(w_.def.max_projectiles, w_.state.slots.alive());
  return std::min({own, shared, std::size_t{w_.state.pools.left(plan.pool)}, w_.room_for_events()});
}

std::size_t BirthBatches::plain(const BirthPlan& plan, const BirthColumns& b) const {
  PHYSIM_ASSERT(plan.kind != 0 && b.next < b.count);
  if (b.number[b.next] != w_.state.emitters[plan.emitter].born) return 0;  // other births came in between
  const std::uint32_t others = ~(b.plain >> b.next);
  const std::size_t plain = others == 0 ? BirthColumns::kLanes : static_cast<std::size_t>(__builtin_ctz(others));
  // The first of all rows gives the values to which later ones are compared.
  const std::size_t at_once = w_.state.rows[plan.cohort].size() == 0 ? 1 : BirthColumns::kLanes;
  return std::min({plain, b.count - b.next, at_once});
}

std::size_t BirthBatches::bear(const BirthPlan& plan, BirthColumns& b, std::size_t most, const Particle& like) {
  const std::size_t count = take_places(plan, std::min(most, plain(plan, b)));
  if (count == 0) return 0;
  come_alive(plan, b, count);
  const auto put = [&](const auto& flights) {
    put_rows(plan, b, flights, count);
    join(plan, b, like, count);
    tell(plan, b, flights, count);
  };
  plan.float32 ? put(std::get<0>(b.flights)) : put(std::get<1>(b.flights));
  Emitter& e = w_.state.emitters[plan.emitter];
  e.born += count;
  e.counts.born += count;
  b.next += count;
  return count;
}

/// Takes `most` slots and rows, or fewer if memory ends: the other births are tried, and refused, one by one.
std::size_t BirthBatches::take_places(const BirthPlan& plan, std::size_t most) {
  PHYSIM_ASSERT(most <= slot_.size() && plan.cohort < w_.state.rows.size());
  SlotTable& table = w_.state.slots;
  std::size_t count = 0;
  std::uint32_t index = 0;
  try {
    w_.state.events.reserve(most);
    for (; count < most; ++count) {
      index = 0;
      index = table.take();
      const std::uint32_t row = w_.state.rows[plan.cohort].push(index);
      table[index].row = row;
      slot_[count] = index, row_[count] = row;
      w_.state.emitters.prefetch(index);
    }
  } catch (const std::bad_alloc&) {
    memory_lacked = true;
    if (index != 0) table.release(index, LifeStatus::unknown);
  }
  return count;
}

void BirthBatches::come_alive(const BirthPlan& plan, const BirthColumns& b, std::size_t count) {
  PHYSIM_ASSERT(count > 0 && b.next + count <= b.count);
  SlotTable& table = w_.state.slots;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t index = slot_[i];
    table.come_alive(index, plan.flags & ~std::uint32_t{kAlive});
    Slot& slot = table[index];
    slot.kind = plan.kind;
    slot.rung = 0;
    slot.cohort = plan.cohort;
    table.birth(index) = b.time[b.next + i];
    table.rest(index) = {};
  }
  w_.registry.kinds.join(plan.kind, static_cast<std::uint32_t>(count));
}

template <class S>
void BirthBatches::put_rows(const BirthPlan& plan, const BirthColumns& b, const FlownParts<S>& flights,
                            std::size_t count) {
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
  const std::uint32_t first = row_[0];
  rows.write_fields(first, *plan.body);  // compares them with those of the other rows
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t row = row_[i];
    PHYSIM_ASSERT(rows.slot(row) == slot_[i]);
    for (const std::uint8_t number : rows.layout().fields) {
      S* const column = rows.columns<S>().field[number];
      column[row] = column[first];
    }
    fill(row, b.next + i);
    PHYSIM_ASSERT(rows.is_filled(row));
  }
}

void BirthBatches::join(const BirthPlan& plan, const BirthColumns& b, Particle like, std::size_t count) {
  like.emitter = plan.emitter;
  w_.state.emitters.join_each(like, count, end_, [&](std::size_t i) {
    const std::size_t lane = b.next + i;
    return Joining{w_.state.slots.id_of(slot_[i]), b.number[lane], b.phase[lane], b.dies[lane], b.time[lane]};
  });
}

/// In order of time, which pools that replace their oldest keep, too.
template <class S>
void BirthBatches::tell(const BirthPlan& plan, const BirthColumns& b, const FlownParts<S>& flights, std::size_t count) {
  w_.state.events.add_each(count, [&](std::size_t i) {
    const std::size_t lane = b.next + i;
    const auto vector = [lane](const auto& of) {
      return vec_cast<double>(Vec3<S>{of[0][lane], of[1][lane], of[2][lane]});
    };
    w_.state.pools.join(plan.pool, slot_[i]);
    return PlainEvent{EventKind::spawned, Reason::none,     w_.state.slots.id_of(slot_[i]), plan.emitter, b.time[lane],
                      vector(flights.x),  vector(flights.v)};
  });
}

}  // namespace physim
