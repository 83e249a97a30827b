// Environment and granted rungs, ready to compute.
#pragma once

#include "model/conditions.hpp"

namespace physim {

/// Pools of curves and flags of what some projectile has come with the projectiles.
[[nodiscard]] Conditions<double> prepare_conditions(const Environment& environment, const Fidelity& granted);
/// Without tables, whose rows are other ones in float.
[[nodiscard]] Conditions<float> to_float(const Conditions<double>& conditions);

}  // namespace physim
