#include "world/birth_batch.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

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
  return std::min(static_cast<std::size_t>(left(e.def().maximum, e.counts.alive + departed)), shared_room(plan));
}

std::size_t BirthBatches::shared_room(const BirthPlan& plan) const {
  const std::size_t alive = w_.state.slots.alive(), most = w_.def.max_projectiles;
  return std::min({most - std::min(most, alive), std::size_t{w_.state.pools.left(plan.pool)}, w_.room_for_events()});
}

std::size_t BirthBatches::plain(const BirthPlan& plan, const BirthColumns& b) const {
  PHYSIM_ASSERT(plan.kind != 0 && b.next < b.count);
  if (b.number[b.next] != w_.state.emitters[plan.emitter].born) return 0;  // others were born between
  const std::uint32_t others = ~(b.plain >> b.next);
  const std::size_t plain = others == 0 ? BirthColumns::kLanes : static_cast<std::size_t>(__builtin_ctz(others));
  // The first of all rows says by itself what those of later ones are compared with.
  const std::size_t at_once = w_.state.rows[plan.cohort].size() == 0 ? 1 : BirthColumns::kLanes;
  return std::min({plain, b.count - b.next, at_once});
}

std::size_t BirthBatches::bear(const BirthPlan& plan, BirthColumns& b, std::size_t most, const Particle& like) {
  static constexpr std::array<std::uint8_t, BirthColumns::kLanes> kOneLine{};
  alone_.plan = &plan, alone_.births = &b, alone_.like = like;
  return bear(std::span(&alone_, 1), std::span(kOneLine).first(std::min(most, plain(plan, b))));
}

std::size_t BirthBatches::bear(std::span<BirthLine> lines, std::span<const std::uint8_t> order) {
  for (BirthLine& line : lines) line.count = 0;
  if (order.empty()) return 0;
  order = order.first(take_places(lines, order));
  for (const BirthLine& line : lines) {
    if (line.count == 0) continue;
    come_alive(line);
    if (line.plan->float32)
      put_rows(line, std::get<0>(line.births->flights));
    else
      put_rows(line, std::get<1>(line.births->flights));
    join(line);
  }
  tell(lines, order);
  for (const BirthLine& line : lines) {
    Emitter& e = w_.state.emitters[line.plan->emitter];
    e.born += line.count;
    e.counts.born += line.count;
    line.births->next += line.count;
  }
  return order.size();
}

/// Slots and rows for so many, or for fewer where memory ends: the others are tried, and refused, one by one.
std::size_t BirthBatches::take_places(std::span<BirthLine> lines, std::span<const std::uint8_t> order) {
  SlotTable& table = w_.state.slots;
  std::size_t count = 0;
  std::uint32_t index = 0;
  try {
    const auto in_float = static_cast<std::size_t>(
        std::ranges::count_if(order, [&](std::uint8_t at) { return lines[at].plan->float32; }));
    w_.state.events.reserve(in_float, order.size() - in_float);
    for (; count < order.size(); ++count) {
      BirthLine& line = lines[order[count]];
      index = 0;
      index = table.take();
      const std::uint32_t row = w_.state.rows[line.plan->cohort].push(index);
      table[index].row = row;
      line.slot[line.count] = index, line.row[line.count] = row;
      ++line.count;
      w_.state.emitters.prefetch(index);
    }
  } catch (const std::bad_alloc&) {
    if (index != 0) table.release(index, LifeStatus::unknown);
  }
  return count;
}

void BirthBatches::come_alive(const BirthLine& line) {
  SlotTable& table = w_.state.slots;
  const BirthPlan& plan = *line.plan;
  for (std::size_t i = 0; i < line.count; ++i) {
    const std::uint32_t index = line.slot[i];
    table.come_alive(index, plan.flags & ~std::uint32_t{kAlive});
    Slot& slot = table[index];
    slot.kind = plan.kind;
    slot.rung = 0;
    slot.cohort = plan.cohort;
    table.birth(index) = line.births->time[line.births->next + i];
    table.rest(index) = {};
  }
  w_.registry.kinds.join(plan.kind, static_cast<std::uint32_t>(line.count));
}

template <class S>
void BirthBatches::put_rows(const BirthLine& line, const NewbornFlights<S>& flights) {
  Rows& rows = w_.state.rows[line.plan->cohort];
  const BirthColumns& b = *line.births;
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
  const std::uint32_t first = line.row[0];
  rows.write_fields(first, *line.plan->body);  // looks whether they are those of the others
  for (std::size_t i = 0; i < line.count; ++i) {
    const std::uint32_t row = line.row[i];
    PHYSIM_ASSERT(rows.slot(row) == line.slot[i]);
    for (const std::uint8_t number : rows.layout().fields) {
      S* const column = rows.columns<S>().field[number];
      column[row] = column[first];
    }
    fill(row, b.next + i);
    PHYSIM_ASSERT(rows.is_filled(row));
  }
}

void BirthBatches::join(const BirthLine& line) {
  const BirthColumns& b = *line.births;
  Particle like = line.like;
  like.emitter = line.plan->emitter;
  w_.state.emitters.join_each(like, line.count, end_, [&](std::size_t i) {
    const std::size_t lane = b.next + i;
    return Joining{w_.state.slots.id_of(line.slot[i]), b.number[lane], b.phase[lane], b.dies[lane], b.time[lane]};
  });
}

/// In order of time, which pools that replace their oldest keep, too.
void BirthBatches::tell(std::span<BirthLine> lines, std::span<const std::uint8_t> order) {
  bool in_float = true;
  for (BirthLine& line : lines) {
    in_float = in_float && line.plan->float32;
    line.count = 0;
  }
  const auto join_pool = [&](const BirthLine& line) {
    w_.state.pools.join(line.plan->pool, line.slot[line.count]);
    return PlainEvent{EventKind::spawned, Reason::none, w_.state.slots.id_of(line.slot[line.count]), line.plan->emitter,
                      line.births->time[line.births->next + line.count]};
  };
  const auto vector = [](const BirthLine& line, const auto& of) {
    const std::size_t lane = line.births->next + line.count;
    return Vec3{of[0][lane], of[1][lane], of[2][lane]};
  };
  if (in_float)
    return w_.state.events.add_each<float>(order.size(), [&](std::size_t i) {
      BirthLine& line = lines[order[i]];
      const auto& flights = std::get<0>(line.births->flights);
      const Told<float> told{join_pool(line), vector(line, flights.x), vector(line, flights.v)};
      ++line.count;
      return told;
    });
  for (const std::uint8_t at : order) {
    BirthLine& line = lines[at];
    const auto add = [&](const auto& flights) {
      w_.state.events.add(join_pool(line), vector(line, flights.x), vector(line, flights.v));
    };
    line.plan->float32 ? add(std::get<0>(line.births->flights)) : add(std::get<1>(line.births->flights));
    ++line.count;
  }
}

}  // namespace physim
