// Emitters of a scenario as those of a world.
#pragma once

#include <vector>

#include "scenario/names.hpp"
#include "scenario/scenario.hpp"

namespace physim {

/// All of an emitter but what only its world knows: kinds, whom it follows, and the ids of its subs' emitters.
[[nodiscard]] EmitterDef def_of(const ScenarioEmitter& emitter);

/// The emitters in an order in which each comes after those that its subs name, but for itself, as a world wants them.
/// An error where several fire each other in a circle; its place is the name of one of them.
[[nodiscard]] Result<std::vector<std::size_t>> order_of_emitters(const Scenario& scenario, const NameIndex& names);

}  // namespace physim
