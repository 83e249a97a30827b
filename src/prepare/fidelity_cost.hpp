// What a fidelity costs: floating-point operations, counted in the models, so that costs are the same on every machine.
#pragma once

#include "physim/environment.hpp"
#include "physim/fidelity.hpp"
#include "physim/projectile.hpp"

namespace physim {

/// Operations of one step, as a lane of a pack spends them; float64 counts twice, because a register holds half as
/// many.
[[nodiscard]] double step_cost(const Fidelity& granted, const ProjectileDef& projectile,
                               const Environment& environment);

}  // namespace physim
