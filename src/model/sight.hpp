// The line of sight: where a launcher points and what range, drop and windage are measured against.
//
// What it models: a sight above the bore, its line inclined by the look angle, launcher and sight rolled by the cant.
// Symbols: f unit vector along the line of sight, r horizontal to its right, u perpendicular to both, upwards; A
//   azimuth, L look angle, c cant (clockwise from behind), e elevation of the bore above the line of sight [rad]; h
//   sight height [m].
// Equations: f = (cos L cos A, sin L, cos L sin A), r = (-sin A, 0, cos A), u = r x f; canted up n = u cos c + r sin c;
//   bore = f cos e + n sin e; the line of sight starts at muzzle + h n.
//   range = (x - muzzle) . f, drop = (x - start) . u, windage = (x - start) . r.
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), sec. 3.4-3.6 (flat fire over inclined lines of sight);
// geometry.
#pragma once

#include "physim/projectile.hpp"

namespace physim {

struct SightFrame {
  Vec3d muzzle;
  Vec3d start;    // of the line of sight
  Vec3d forward;  // f
  Vec3d up;       // u
  Vec3d right;    // r
  Vec3d canted;   // n
};

[[nodiscard]] SightFrame sight_frame(const Launch& launch);

/// Unit vector along the bore for a bore elevation above the horizon [rad], or along a given velocity.
[[nodiscard]] Vec3d launch_direction(const Launch& launch, const SightFrame& sight, double elevation);
/// Speed at the muzzle [m/s].
[[nodiscard]] double launch_speed(const Launch& launch);
/// Velocity at the muzzle, where the bore points along a unit vector.
[[nodiscard]] Vec3d velocity_along(const Launch& launch, const Vec3d& bore);
/// Velocity at the muzzle for a bore elevation above the horizon [rad]; `sight` is the launch's frame.
[[nodiscard]] Vec3d launch_velocity(const Launch& launch, const SightFrame& sight, double elevation);

}  // namespace physim
