// Piles: projectiles that lie on each other rest, sleep and wake together.
//
// A pile is a group of those that lie on each other at the end of a step. If all of them have rested for long enough,
// all sleep in one step. If one that sleeps wakes, moves or goes, those that sleep at it wake, and so on: what lay on
// it may fall. Kept from step to step are the time at rest of each and, of those that sleep, that they are in a pile.
#include <algorithm>

#include "world/couple/pairs.hpp"
#include "world/couple/world_impl.hpp"

namespace physim {
namespace {

/// Farther apart than by this part of their reach two do not touch, but for rounding [-].
constexpr double kTouching = 1e-6;

/// Whether two lie at each other.
[[nodiscard]] bool touch(const WorldImpl& world, std::uint32_t a, std::uint32_t b) {
  const Slot &one = world.state.slots[a], &other = world.state.slots[b];
  const CollisionDef& of_one = world.registry.kind(one.kind).body.collision;
  const CollisionDef& of_other = world.registry.kind(other.kind).body.collision;
  if (!meet_by_layers(of_one, world.layers_of(a), of_other, world.layers_of(b))) return false;
  const Vec3d x = world.state.state_of(one).position, y = world.state.state_of(other).position;
  const double reach = of_one.radius + of_other.radius;
  const double epsilon =
      std::max(world.state.rows_of(one).layout().epsilon(), world.state.rows_of(other).layout().epsilon());
  return reach > 0 && length(x - y) <= reach * (1 + kTouching) + 8 * epsilon * (length(x) + length(y));
}

/// Whether one of a pile has rested for long enough; counts the step just taken.
[[nodiscard]] bool has_rested(WorldImpl& world, const Piled& one) {
  WorldState& state = world.state;
  const Slot& slot = state.slots[one.slot];
  if (!slot.is(kAlive)) return false;
  if (slot.is(kStill)) return true;
  const CohortRules& rules = world.registry.cohort(slot.cohort).key.rules;
  const auto& c = world.registry.cohort(slot.cohort).conditions;
  Rest& rest = state.slots.rest(one.slot);
  const double speed = length(state.state_of(slot).velocity);
  if (one.is_carried || c.has_motor || c.has_rail || state.joints.of_slot(one.slot) || !(speed < rules.sleep_speed)) {
    rest.time = 0;
    return false;
  }
  rest = one.rested;
  rest.count(state.clock.steps - 1, state.clock.dt);
  return static_cast<double>(rest.time) >= rules.sleep_time;
}

}  // namespace

std::map<std::uint32_t, std::uint32_t> groups_of(const std::set<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
  std::map<std::uint32_t, std::uint32_t> next;  // of each, towards the first of its group
  const auto first_of = [&](std::uint32_t i) {
    while (next.at(i) != i) i = next[i] = next.at(next.at(i));
    return i;
  };
  for (const auto& [i, j] : pairs) {
    next.try_emplace(i, i), next.try_emplace(j, j);
    const std::uint32_t a = first_of(i), b = first_of(j);
    next[std::max(a, b)] = std::min(a, b);
  }
  for (auto& [i, first] : next) first = first_of(i);
  return next;
}

void rest_piles(WorldImpl& world) {
  const std::vector<Piled>& all = world.pairs.piled;
  for (auto one = all.begin(); one != all.end();) {
    const auto end = std::find_if(one, all.end(), [&](const Piled& other) { return other.pile != one->pile; });
    bool rest = true;
    for (auto each = one; each != end; ++each) rest = has_rested(world, *each) && rest;
    for (; one != end; ++one) {
      if (!rest) continue;
      world.put_to_sleep(one->slot);
      world.state.slots[one->slot].set(kPiled, true);
    }
  }
}

std::vector<std::uint32_t> WorldImpl::sleepers_at(std::uint32_t index) const {
  std::vector<std::uint32_t> found;
  if (!state.slots[index].is(kPiled)) return found;
  for (std::uint16_t c = 0; c < state.rows.size(); ++c) {
    const Rows& rows = state.rows[c];
    if (!registry.cohort(c).key.still) continue;
    for (std::uint32_t row = 0; row < rows.size(); ++row) {
      const std::uint32_t slot = rows.slot(row);
      if (slot != index && state.slots[slot].is(kAsleep) && state.slots[slot].is(kPiled) && touch(*this, index, slot))
        found.push_back(slot);
    }
  }
  std::ranges::sort(found);  // so that the order of rows does not matter
  return found;
}

void WorldImpl::wake_piled(std::vector<std::uint32_t> slots) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (!state.slots[slots[i]].is(kAsleep)) continue;
    const std::vector<std::uint32_t> beside = sleepers_at(slots[i]);
    slots.insert(slots.end(), beside.begin(), beside.end());
    wake_alone(slots[i]);
  }
}

void WorldImpl::disturb(const std::vector<std::uint32_t>& sleepers) {
  if (is_inside)
    pairs.disturbed.insert(pairs.disturbed.end(), sleepers.begin(), sleepers.end());
  else
    wake_piled(sleepers);
}

}  // namespace physim
