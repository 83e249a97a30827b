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

#include "math/elementary.hpp"
#include "math/vec3.hpp"
#include "physim/projectile.hpp"

PHYSIM_ISA_BEGIN

/// Zero gives zero and one exactly, whatever its sign. Most launches look straight ahead: one number at a time then
/// computes nothing.
template <class R>
PHYSIM_INLINE SinCos<R> sincos_of(const R& angle) {
  using S = ScalarOf<R>;
  const auto zero = angle == R(S(0));
  if (all(zero)) return {R(S(0)), R(S(1))};
  const SinCos<R> found = sincos(angle);
  return {select(zero, R(S(0)), found.sin), select(zero, R(S(1)), found.cos)};
}

/// Unit vectors of a line of sight.
template <class R>
struct SightAxes {
  Vec3<R> forward;  // f
  Vec3<R> right;    // r
  Vec3<R> up;       // u
  Vec3<R> canted;   // n

  SightAxes() = default;
  PHYSIM_INLINE SightAxes(const SinCos<R>& azimuth, const SinCos<R>& look, const SinCos<R>& cant)
      : forward{look.cos * azimuth.cos, look.sin, look.cos * azimuth.sin},
        right{-azimuth.sin, R(ScalarOf<R>(0)), azimuth.cos},
        up(cross(right, forward)),
        canted(up * cant.cos + right * cant.sin) {}

  /// The bore, by its elevation above the line of sight.
  PHYSIM_INLINE Vec3<R> bore(const SinCos<R>& above) const { return forward * above.cos + canted * above.sin; }
};

PHYSIM_ISA_END

namespace physim {

struct SightFrame : SightAxes<double> {
  Vec3d muzzle;
  Vec3d start;  // of the line of sight

  SightFrame() = default;
  SightFrame(const SinCos<double>& azimuth, const SinCos<double>& look, const SinCos<double>& cant, const Vec3d& at,
             double height)
      : SightAxes<double>(azimuth, look, cant), muzzle(at), start(at + canted * height) {}
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
