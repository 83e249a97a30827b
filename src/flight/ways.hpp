// Ways to a target that a scene leaves open, and what stands in the others.
#pragma once

#include "physim/solve.hpp"

namespace physim {

/// Takes the solutions out of an answer that something stands in, and tells what; each is flown once more. An error
/// where such a flight is refused.
[[nodiscard]] Status keep_open_ways(const ProjectileDef& projectile, const Environment& environment,
                                    const Fidelity& fidelity, const Target& target, const AimOptions& options,
                                    Aim& answer);

}  // namespace physim
