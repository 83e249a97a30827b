// Quantities: what the numbers of settings measure.
#pragma once

namespace physim {

/// What a setting measures; decides the units that are accepted at the door.
enum class Quantity {
  number,
  length,
  mass,
  time,
  speed,
  angle,
  acceleration,
  force,
  pressure,
  temperature,
  density,
  ballistic_coefficient,
  linear_drag,
  quadratic_drag,
  angular_rate,
  energy,
  frequency,
  stiffness,
  volume,
  attraction,
  moment_of_inertia,
  area,
};
inline constexpr Quantity kLastQuantity = Quantity::area;

}  // namespace physim
