// Settings of [world].
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

ValueRef rung_slot(const Scope& scope) {
  Fidelity& fidelity = scope.rung->fidelity;
  return Choice{fidelity_presets(),
                [&fidelity]() -> std::optional<std::size_t> {
                  for (std::size_t i = 0; i < fidelity_presets().size(); ++i)
                    if (*fidelity_preset(fidelity_presets()[i]) == fidelity) return i;
                  return std::nullopt;
                },
                [&fidelity](std::size_t i) { fidelity = *fidelity_preset(fidelity_presets()[i]); }};
}

constexpr Entry kWorldSettings[] = {
    {.path = "world.duration",
     .slot = PHYSIM_FIELD(scenario->world.duration),
     .doc = "of the run",
     .quantity = Quantity::time,
     .range = above(0)},
    {.path = "world.step",
     .slot = PHYSIM_FIELD(scenario->world.def.step),
     .doc = "fixed time step",
     .quantity = Quantity::time,
     .range = {.low = 0, .high = 10, .low_open = true}},
    {.path = "world.ground.mode",
     .slot = PHYSIM_FIELD(scenario->world.def.ground.mode),
     .doc = "what happens where a projectile reaches the ground",
     .shorthand = true},
    {.path = "world.ground.height",
     .slot = PHYSIM_FIELD(scenario->world.def.ground.height),
     .doc = "of the ground above the origin",
     .quantity = Quantity::length},
    {.path = "world.ground.restitution",
     .slot = PHYSIM_FIELD(scenario->world.def.ground.restitution),
     .doc = "times that of the projectile",
     .range = between(0, 1)},
    {.path = "world.ground.friction",
     .slot = PHYSIM_FIELD(scenario->world.def.ground.friction),
     .doc = "times that of the projectile",
     .range = at_least(0)},
    {.path = "world.wall",
     .slot = PHYSIM_FIELD(scenario->world.wall),
     .doc = "distance downrange of a wall that stops what reaches it; off: none",
     .quantity = Quantity::length,
     .none = "off"},
    {.path = "world.apex_events",
     .slot = PHYSIM_FIELD(scenario->world.def.apex_events),
     .doc = "tell when a projectile passes its highest point"},
    {.path = "world.pools",
     .slot = PHYSIM_RECORDS(scenario->world.def.pools, pool),
     .doc = "limits on projectiles; the first is that of shots that name none",
     .range = at_most(1000)},
    {.path = "world.pools.name", .slot = PHYSIM_FIELD(pool->name), .doc = "for shot.body.pool", .required = true},
    {.path = "world.pools.maximum",
     .slot = PHYSIM_FIELD(pool->maximum),
     .doc = "projectiles at once",
     .range = between(1, 4294967295.0)},
    {.path = "world.pools.when_full", .slot = PHYSIM_FIELD(pool->when_full), .doc = "what happens to the next one"},
    {.path = "world.detail.rungs",
     .slot = PHYSIM_RECORDS(scenario->world.def.detail.rungs, rung),
     .doc = "two or three rungs of fidelity, finest first, between which projectiles are moved",
     .range = at_most(3)},
    {.path = "world.detail.rungs.fidelity", .slot = rung_slot, .doc = "preset of the rung", .required = true},
    {.path = "world.detail.rungs.within",
     .slot = PHYSIM_FIELD(rung->within),
     .doc = "distance to the observer up to which it holds",
     .quantity = Quantity::length,
     .range = or_infinite(above(0))},
    {.path = "world.detail.rungs.younger",
     .slot = PHYSIM_FIELD(rung->younger),
     .doc = "age up to which it holds",
     .quantity = Quantity::time,
     .range = or_infinite(above(0))},
    {.path = "world.detail.hysteresis",
     .slot = PHYSIM_FIELD(scenario->world.def.detail.hysteresis),
     .doc = "part of a rung's distance by which it must be left before it changes",
     .range = {.low = 0, .high = 0.99}},
    {.path = "world.detail.layers",
     .slot = PHYSIM_FIELD(scenario->world.def.detail.layers),
     .doc = "bits of the projectiles that it rules",
     .range = kBits},
    {.path = "world.observer",
     .slot = PHYSIM_FIELD(scenario->world.observer),
     .doc = "that distances of detail are measured from",
     .quantity = Quantity::length},
    {.path = "world.threads",
     .slot = PHYSIM_FIELD(scenario->world.def.threading.threads),
     .doc = "0: all that the machine has; results do not depend on it",
     .range = at_most(1024)},
    {.path = "world.rows_per_thread",
     .slot = PHYSIM_FIELD(scenario->world.def.threading.rows_per_thread),
     .doc = "smaller worlds use fewer threads: one for every so many projectiles",
     .range = between(1, 4294967295.0)},
    {.path = "world.max_projectiles",
     .slot = PHYSIM_FIELD(scenario->world.def.max_projectiles),
     .doc = "at once; then no more are fired",
     .range = between(1, 4294967295.0)},
    {.path = "world.max_steps",
     .slot = PHYSIM_FIELD(scenario->world.def.max_steps),
     .doc = "of one frame in real time",
     .range = between(1, 1000000)},
    {.path = "world.time_scale",
     .slot = PHYSIM_FIELD(scenario->world.def.time_scale),
     .doc = "in real time: so many times as fast",
     .range = between(0, 1000)},
};

}  // namespace

std::span<const Entry> world_settings() { return kWorldSettings; }

}  // namespace physim
