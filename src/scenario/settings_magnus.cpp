// Settings of [shot.magnus] and [shot.spin]: balls that spin.
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

Quantity quantity_of_spin(const Scope& scope) {
  const bool by_rate = scope.shot->projectile.magnus.measure == SpinMeasure::rate;
  return by_rate ? Quantity::angular_rate : Quantity::number;
}

constexpr Entry kMagnusSettings[] = {
    {.path = "shot.spin.backspin",
     .slot = PHYSIM_FIELD(shot->launch.spin.backspin),
     .doc = "of a ball at launch: lifts it; negative: topspin",
     .quantity = Quantity::angular_rate},
    {.path = "shot.spin.sidespin",
     .slot = PHYSIM_FIELD(shot->launch.spin.sidespin),
     .doc = "of a ball at launch: turns its path to the right",
     .quantity = Quantity::angular_rate},
    {.path = "shot.spin.gyrospin",
     .slot = PHYSIM_FIELD(shot->launch.spin.gyrospin),
     .doc = "of a ball at launch, about its path, clockwise seen from behind; lifts nothing",
     .quantity = Quantity::angular_rate},
    {.path = "shot.magnus.lift",
     .slot = PHYSIM_FIELD(shot->projectile.magnus.lift),
     .doc = "lift coefficient: lift S / (lift_base + lift_saturation S), S the spin parameter"},
    {.path = "shot.magnus.lift_base",
     .slot = PHYSIM_FIELD(shot->projectile.magnus.lift_base),
     .doc = "see lift",
     .range = above(0)},
    {.path = "shot.magnus.lift_saturation",
     .slot = PHYSIM_FIELD(shot->projectile.magnus.lift_saturation),
     .doc = "see lift",
     .range = at_least(0)},
    {.path = "shot.magnus.drag_per_spin",
     .slot = PHYSIM_FIELD(shot->projectile.magnus.drag_per_spin),
     .doc = "added to the drag coefficient for each rad/s of spin",
     .quantity = Quantity::time,
     .range = at_least(0)},
    {.path = "shot.magnus.measure",
     .slot = PHYSIM_FIELD(shot->projectile.magnus.measure),
     .doc = "what the spins of the table are"},
    {.path = "shot.magnus.table",
     .slot = PHYSIM_RECORDS(shot->projectile.magnus.table, magnus_point),
     .doc = "drag and lift by speed and spin, every speed with every spin, instead of the formula",
     .range = at_most(10000)},
    {.path = "shot.magnus.table.speed",
     .slot = PHYSIM_FIELD(magnus_point->speed),
     .doc = "through the air",
     .quantity = Quantity::speed,
     .range = at_least(0)},
    {.path = "shot.magnus.table.spin",
     .slot = PHYSIM_FIELD(magnus_point->spin),
     .doc = "a rate, or a spin parameter",
     .range = at_least(0),
     .quantity_by = quantity_of_spin,
     .unit_by = "of the measure"},
    {.path = "shot.magnus.table.drag",
     .slot = PHYSIM_FIELD(magnus_point->drag),
     .doc = "drag coefficient there",
     .range = at_least(0)},
    {.path = "shot.magnus.table.lift", .slot = PHYSIM_FIELD(magnus_point->lift), .doc = "lift coefficient there"},
    {.path = "shot.magnus.decay_time",
     .slot = PHYSIM_FIELD(shot->projectile.magnus.decay_time),
     .doc = "in which the spin falls to 1/e",
     .quantity = Quantity::time,
     .range = or_infinite(above(0))},
};

}  // namespace

std::span<const Entry> magnus_settings() { return kMagnusSettings; }

}  // namespace physim
