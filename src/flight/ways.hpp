// Ways to a target that a scene leaves open, and what stands in the others.
#pragma once

#include "physim/solve.hpp"

namespace physim {

/// Removes the solutions from an answer that something obstructs, and notes what does; each is flown once more. An
/// error if such a flight is refused.
[[nodiscard]] Status keep_open_ways(const ProjectileDef& projectile, const Environment& environment,
                                    const Fidelity& fidelity, const Target& target, const AimOptions& options,
                                    Aim& answer);

}  // namespace physim
