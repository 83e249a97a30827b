// Settings of [target].
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

constexpr Entry kTargetSettings[] = {
    {.path = "target.position",
     .slot = PHYSIM_FIELD(scenario->target.position),
     .doc = "where the target of `physim aim` is when the shot is fired: x downrange, y up, z right",
     .quantity = Quantity::length},
    {.path = "target.velocity",
     .slot = PHYSIM_FIELD(scenario->target.velocity),
     .doc = "how it moves then",
     .quantity = Quantity::speed},
    {.path = "target.acceleration",
     .slot = PHYSIM_FIELD(scenario->target.acceleration),
     .doc = "of the target, constant",
     .quantity = Quantity::acceleration},
    {.path = "target.tolerance",
     .slot = PHYSIM_FIELD(scenario->target.tolerance),
     .doc = "a path that passes so near hits the target",
     .quantity = Quantity::length,
     .range = above(0)},
    {.path = "target.arc",
     .slot = PHYSIM_FIELD(scenario->target.arc),
     .doc = "the solution of the shortest or of the longest time of flight, or both"},
};

}  // namespace

std::span<const Entry> target_settings() { return kTargetSettings; }

}  // namespace physim
