// Departure: a projectile on its way, as it goes on in a world.
#pragma once

#include <optional>

#include "physim/quat.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// How a rigid body points and turns.
struct FlownAttitude {
  Quatd orientation{};       ///< q_WB: takes body axes (x forward, y up, z right) into W [-]
  Vec3d angular_velocity{};  ///< relative to inertial space, along body axes [rad/s]
};

/// What goes on in a world where it is: not launched there, but on its way already.
struct Departure {
  Vec3d position{};                         ///< in W [m]
  Vec3d velocity{};                         ///< in W [m/s]
  double age = 0;                           ///< since its launch: so long its motor and its own force have acted [s]
  Vec3d spin{};                             ///< of a ball, in W [rad/s]
  std::optional<FlownAttitude> attitude{};  ///< of a rigid body; none: along its path, without spin [-]
};

}  // namespace physim
