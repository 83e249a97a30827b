// Colliders: the projectiles that meet others, as a step begins.
#include "world/couple/pairs.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

[[nodiscard]] bool meets_others(const Slot& slot, const Kind& kind) {
  return kind.body.collision.others != 0 && slot.is(kAlive) && !slot.is(kPending);
}

/// One more; its vectors keep their memory from step to step.
Collider& next_collider(std::vector<Collider>& all, std::size_t at) {
  if (at == all.size()) return all.emplace_back();
  Collider& c = all[at];
  auto path = std::move(c.path);
  auto traces = std::move(c.traces);
  path.clear(), traces.clear();
  c = {};
  c.path = std::move(path), c.traces = std::move(traces);
  return c;
}

void list_colliders(const WorldImpl& world, std::vector<Collider>& all) {
  std::size_t count = 0;
  world.state.slots.each_alive([&](std::uint32_t index) {
    const Slot& slot = world.state.slots[index];
    const Kind& kind = world.registry.kind(slot.kind);
    if (!meets_others(slot, kind)) return;
    Collider& c = next_collider(all, count++);
    c.slot = index;
    c.cohort = slot.cohort;
    c.row = slot.row;
    c.kind = &kind;
    c.layers = world.layers_of(index);
    c.rested = world.state.slots.rest(index);
    c.sleeps = slot.is(kAsleep) && !slot.is(kStill & ~kAsleep);
    c.flies = !slot.is(kStill);
    if (!c.flies && !c.sleeps) return;
    PHYSIM_ASSERT(kind.flown.mass > 0);
    const Own* own = world.state.extras.find_own(index);
    c.mobility = free_axes(own ? own->frozen : kind.body.frozen) * (1 / kind.flown.mass);
  });
  all.resize(count);
}

}  // namespace

void begin_pairs(WorldImpl& world) {
  PairScratch& s = world.pairs;
  s.put.clear();
  s.piled.clear();
  s.chunk.events.clear();
  s.chunk.changes.clear();
  s.used = world.registry.kinds.meet_others();
  if (!s.used) return;
  list_colliders(world, s.colliders);
  s.used = s.colliders.size() > 1;
  s.before.assign(world.state.rows.size(), std::nullopt);
  if (!s.used) return;
  for (const Collider& c : s.colliders)
    if (c.flies && !s.before[c.cohort]) s.before[c.cohort] = world.state.rows[c.cohort];
}

}  // namespace physim
