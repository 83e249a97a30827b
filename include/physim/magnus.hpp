// MagnusDef: lift and drag of a ball that spins, by formula or by a table.
#pragma once

#include <vector>

#include "physim/infinity.hpp"

namespace physim {

/// What the second key of a table of coefficients is.
enum class SpinMeasure {
  rate,       ///< spin across the path [rad/s]
  parameter,  ///< spin parameter S: speed of the surface over speed through the air [-]
};

/// Drag and lift coefficient at a speed and a spin.
struct MagnusPoint {
  double speed = 0;  ///< through the air [m/s]
  double spin = 0;   ///< as MagnusDef::measure says [rad/s or -]
  double drag = 0;   ///< drag coefficient Cd [-]
  double lift = 0;   ///< lift coefficient Cl [-]

  bool operator==(const MagnusPoint&) const = default;
};

/// Lift and drag of a spinning ball. Without a table: Cl = lift S / (lift_base + lift_saturation S), and the Cd of
/// DragDef plus drag_per_spin times the spin; S = r |omega x u| / u^2. With one: both by the table.
struct MagnusDef {
  double lift = 0;                          ///< 0 without a table: no lift [-]
  double lift_base = 1;                     ///< > 0 [-]
  double lift_saturation = 0;               ///< [-]
  double drag_per_spin = 0;                 ///< added to Cd for each rad/s of spin [s]
  std::vector<MagnusPoint> table{};         ///< every speed with every spin, in any order; straight lines between [-]
  SpinMeasure measure = SpinMeasure::rate;  ///< of the table [-]
  double decay_time = kInfinity;            ///< in which the spin falls to 1/e [s]

  bool operator==(const MagnusDef&) const = default;
};

}  // namespace physim
