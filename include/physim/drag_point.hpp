// DragPoint: one point of a drag curve.
#pragma once

namespace physim {

/// One point of a drag curve.
struct DragPoint {
  double mach = 0;         ///< Mach number [-]
  double coefficient = 0;  ///< drag coefficient Cd [-]

  bool operator==(const DragPoint&) const = default;
};

}  // namespace physim
