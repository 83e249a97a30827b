// Settings of worlds: [shot.body], how they treat a projectile; [world]; [[volley]].
#include <algorithm>

#include "scenario/settings_parts.hpp"
#include "settings/body_rows.hpp"

namespace physim {

template <>
std::span<const std::string_view> names_of<SpreadShape>() {
  static constexpr std::string_view names[] = {"normal", "uniform"};
  return names;
}

/// Axes by their bits.
template <>
std::span<const std::string_view> names_of<Axes>() {
  static constexpr std::string_view names[] = {"none", "x", "y", "xy", "z", "xz", "yz", "xyz"};
  return names;
}

namespace {

ValueRef rung_slot(const Scope& scope) {
  Fidelity& fidelity = scope.rung->fidelity;
  return choice_where(
      fidelity_presets(), [&fidelity](std::size_t i) { return *fidelity_preset(fidelity_presets()[i]) == fidelity; },
      [&fidelity](std::size_t i) { fidelity = *fidelity_preset(fidelity_presets()[i]); });
}

/// Another way to say interval.
ValueRef rate_slot(const Scope& scope) {
  return said_elsewhere([&volley = *scope.volley](double rate) { volley.interval = 1 / rate; });
}

/// What a hit does, but for asking: a file has nobody who answers.
ValueRef on_hit_slot(const Scope& scope) {
  OnHit& on_hit = scope.shot->body.collision.on_hit;
  Choice slot = choice(names_of<OnHit>().first(static_cast<std::size_t>(OnHit::ask)), on_hit);
  slot.get = [&on_hit] {
    return on_hit == OnHit::ask ? std::nullopt : std::optional(static_cast<std::size_t>(on_hit));
  };
  return slot;
}

#define PHYSIM_WORLD_DEF(field, ...) setting("world." #field, PHYSIM_FIELD(scenario->world.def.field), __VA_ARGS__)
#define PHYSIM_VOLLEY(...) PHYSIM_ROW("volley", volley, __VA_ARGS__)

constexpr Entry kPoolSettings[] = {
    PHYSIM_ROW("shot.body", shot, pool, "name of its pool, out of world.pools; empty: the first"),
};

constexpr Entry kWorldSettings[] = {
    PHYSIM_SCENARIO(world.duration, "of the run", Quantity::time, above(0)),
    PHYSIM_WORLD_DEF(step, "fixed time step", Quantity::time, Range{.low = 0, .high = 10, .low_open = true}),
    PHYSIM_WORLD_DEF(ground.mode, "what happens where a projectile reaches the ground", kShorthand),
    PHYSIM_WORLD_DEF(ground.height, "of the ground above the origin", Quantity::length),
    PHYSIM_WORLD_DEF(ground.restitution, "combined with that of the projectile", between(0, 1)),
    PHYSIM_WORLD_DEF(ground.friction, "combined with that of the projectile", at_least(0)),
    PHYSIM_WORLD_DEF(ground.combine.restitution,
                     "how it is combined with that of the projectile; of two rules the later one"),
    PHYSIM_WORLD_DEF(ground.combine.friction,
                     "how it is combined with that of the projectile; of two rules the later one"),
    PHYSIM_WORLD_DEF(ground.conveyor.velocity, "with which the ground runs; the part along it acts", Quantity::speed,
                     between(-1e6, 1e6), kShorthand),
    PHYSIM_SCENARIO(world.wall, "distance downrange of a wall that stops what reaches it; off: none", Quantity::length,
                    absent("off")),
    PHYSIM_WORLD_DEF(apex_events, "tell when a projectile passes its highest point"),
    PHYSIM_WORLD_DEF(pools, "limits on projectiles; the first is that of shots that name none", at_most(1000)),
    PHYSIM_ROW("world.pools", pool, name, "for shot.body.pool", kRequired),
    PHYSIM_ROW("world.pools", pool, maximum, "projectiles at once", between(1, 4294967295.0)),
    PHYSIM_ROW("world.pools", pool, when_full, "what happens to the next one"),
    PHYSIM_WORLD_DEF(detail.rungs, "two or three rungs of fidelity, finest first, between which projectiles are moved",
                     at_most(3)),
    setting("world.detail.rungs.fidelity", rung_slot, "preset of the rung", kRequired),
    PHYSIM_ROW("world.detail.rungs", rung, within, "distance to the observer up to which it holds", Quantity::length,
               or_infinite(above(0))),
    PHYSIM_ROW("world.detail.rungs", rung, younger, "age up to which it holds", Quantity::time, or_infinite(above(0))),
    PHYSIM_WORLD_DEF(detail.hysteresis, "part of a rung's distance by which it must be left before it changes",
                     between(0, 0.99)),
    PHYSIM_WORLD_DEF(detail.layers, "bits of the projectiles that it rules", kBits),
    PHYSIM_SCENARIO(world.observer, "that distances of detail are measured from", Quantity::length),
    setting("world.threads", PHYSIM_FIELD(scenario->world.def.threading.threads),
            "0: all that the machine has; results do not depend on it", at_most(1024)),
    setting("world.rows_per_thread", PHYSIM_FIELD(scenario->world.def.threading.rows_per_thread),
            "smaller worlds use fewer threads: one for every so many projectiles", between(1, 4294967295.0)),
    PHYSIM_WORLD_DEF(max_projectiles, "at once; then no more are fired", between(1, 4294967295.0)),
    PHYSIM_WORLD_DEF(max_steps, "of one frame in real time", between(1, 1000000)),
    PHYSIM_WORLD_DEF(time_scale, "in real time: so many times as fast", between(0, 1000)),
    setting("volley", PHYSIM_FIELD(scenario->volleys),
            "shots fired many times; a shot of no volley and no emitter is fired once, at the start", at_most(100000)),
    PHYSIM_VOLLEY(name, "in tables; default: volley-1, volley-2, ..."),
    PHYSIM_VOLLEY(shot, "name of the shot", kRequired),
    PHYSIM_VOLLEY(count, "launches", between(1, 1e8)),
    PHYSIM_VOLLEY(interval, "time between launches, each at its own moment; 0: all at once", Quantity::time,
                  at_least(0)),
    setting("volley.rate", rate_slot, "launches in a time, instead of interval", Quantity::frequency, above(0)),
    PHYSIM_VOLLEY(start, "time of the first launch", Quantity::time, at_least(0)),
    PHYSIM_VOLLEY(
        spread.shape,
        "normal: the numbers are standard deviations; uniform: half axes of an ellipse of directions, and bounds"),
    PHYSIM_VOLLEY(spread.horizontal, "of the direction, to both sides", Quantity::angle, kToBothSides),
    PHYSIM_VOLLEY(spread.vertical, "of the direction, up and down", Quantity::angle, kToBothSides),
    PHYSIM_VOLLEY(spread.speed, "of the speed; never below 0", Quantity::speed, at_least(0)),
    PHYSIM_VOLLEY(spread.position, "of the muzzle, by axis", Quantity::length, at_least(0)),
    PHYSIM_VOLLEY(seed, "of the spread: another seed, another scatter; each launch has numbers of its own",
                  between(0, 9007199254740992.0)),
};

BodyDef& body_in(const Scope& scope) { return scope.shot->body; }

std::vector<Entry> all_world_settings() {
  std::vector<Entry> list;
  add_rows<body_in, kBodyRows>(list, "shot.body.");
  add_rows<body_in, kContactRows>(list, "shot.body.");
  std::ranges::find(list, "shot.body.collision.on_hit", &Entry::path)->slot = on_hit_slot;
  add_rows<body_in, kDespawnRows>(list, "shot.body.");
  add_rows<body_in, kBoxRows>(list, "shot.body.");
  add_rows<body_in, kShownRows>(list, "shot.body.");
  add(list, kPoolSettings);
  add_rows<body_in, kCarriedRows>(list, "shot.body.");
  add(list, kWorldSettings);
  return list;
}

}  // namespace

std::span<const Entry> world_settings() {
  static const std::vector<Entry> all = all_world_settings();
  return all;
}

}  // namespace physim
