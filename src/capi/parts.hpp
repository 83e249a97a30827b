// Parts of worlds that defs and functions of the caller's bring.
#pragma once

#include "capi/objects.hpp"

namespace physim::capi {

/// The kind of a shot, with the launch that it has unless a call says otherwise.
[[nodiscard]] Result<KindId> add_kind(WorldObject& object, const Scenario& scenario, std::size_t shot,
                                      std::uint32_t environment = 0, std::uint32_t flags = 0);
/// The things of a scenario: their ids, and the scene itself for a world that does not fire by itself.
[[nodiscard]] Status add_things(WorldObject& object, const Scenario& scenario);

[[nodiscard]] CustomForce force_of(physim_force_function function, void* user);
/// Empty if there is no function.
[[nodiscard]] HitFunction hit_of(physim_hit_function function, void* user);

}  // namespace physim::capi
