// Rows that are settled by themselves, without the step that forced rows take together.
#pragma once

#include "world/couple/world_impl.hpp"

namespace physim {

/// Calls f with what a row of a slot is settled in; one that is forced feels generators as they are, held.
template <class F>
auto with_held_forces(const WorldImpl& world, const SettleContext& context, const Slot& slot, const F& f) {
  const WorldCohort& cohort = world.registry.cohort(slot.cohort);
  PHYSIM_ASSERT(slot.row < world.state.rows_of(slot).size());
  if (!cohort.key.forced) return f(context);
  const std::uint32_t index = world.state.slots.index_of(slot);
  const double per_mass = 1 / world.registry.kind(slot.kind).flown.mass;
  double drag_rate = 0;
  const Vec3d push = world.generator_force(index, world.state.state_of(slot), &drag_rate) * per_mass;
  SettleContext held = context;
  const auto with = [&]<class S>(TakenStep<S> taken) {
    taken.push[0] = taken.push[1] = {vec_cast<S>(push), static_cast<S>(drag_rate * per_mass)};
    taken.own_force = cohort.key.features.has_applied;
    held.taken = &taken;
    return f(held);
  };
  return cohort.layout.float32 ? with(TakenStep<float>{}) : with(TakenStep<double>{});
}

}  // namespace physim
