// Accelerations: what each effect does to a projectile at a moment.
#pragma once

#include "physim/vec3.hpp"

namespace physim {

/// Acceleration by effect. The effects add up to the total, the force on the projectile over its mass; but on the
/// `classic` integrator the total is the register of its loop: what the frame took over from the one before. Damping
/// acts there on the velocity by itself, so that `drag` tells it and the register does not hold it.
struct Accelerations {
  Vec3d gravity{};      ///< [m/s^2]
  Vec3d drag{};         ///< of `damping` ln(d) v, v through the air [m/s^2]
  Vec3d lift{};         ///< of balls, by their spin [m/s^2]
  Vec3d body{};         ///< by the attitude: drag of yaw, lift, Magnus force; of a yaw of repose too [m/s^2]
  Vec3d thrust{};       ///< of the motor [m/s^2]
  Vec3d coriolis{};     ///< [m/s^2]
  Vec3d centrifugal{};  ///< of a rotating round Earth, where it is no part of gravity [m/s^2]
  Vec3d applied{};      ///< by ProjectileDef::force, Environment::force and the generators of a world [m/s^2]
  Vec3d constraint{};   ///< what planar flight, frozen axes and the launch rail take up of all others [m/s^2]
  Vec3d total{};        ///< as it is flown [m/s^2]
};

}  // namespace physim
