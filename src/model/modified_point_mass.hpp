// Modified point mass: a spinning shell with its axis in its yaw of repose.
//
// What it models: a gyroscopically stable projectile, symmetric about its axis, which does not follow the bending
//   path at once: it stands at that small angle, mostly to the right for right-handed spin, at which the overturning
//   moment turns the angular momentum as fast as the path turns. Lift and Magnus force of this yaw give the drift; the
//   yaw brakes; the air brakes the spin. Beside the point only the spin is integrated.
// When to use it: range and drift of artillery and of rifle bullets with measured coefficients, at steps as long as a
//   point mass takes, hundreds of times longer than a rigid body's.
// When it is wrong: wherever the axis swings about its yaw of repose instead of standing in it: just behind the muzzle
//   (aerodynamic jump, initial yaw), in wind that changes at once, where the shell is not stable. Near the summit of
//   steep fire, where the air is thin and slow, the yaw grows beyond small angles; a sine above kLargestSine is held
//   there. The Magnus moment and the damping of pitch, which turn the yaw of repose by some hundredths of itself, are
//   left out, as in the standard; so is a change of the wind along the path.
// Symbols: u velocity through the air [m/s]; V = |u|; a0 acceleration without yaw [m/s^2]; Omega angular velocity of W
//   [rad/s]; alpha yaw of repose, across u, its length the sine of the angle [-]; x = alpha + sqrt(1 - alpha^2) u / V
//   the axis [-]; p spin [rad/s]; Ix moment of inertia about the axis [kg m^2]; T thrust [N]; rho, S, d, m, k and the
//   coefficients as in model/aero.hpp.
// Equations: M = rho S d / 2 CMa (u x alpha) V turns H = Ix p x as fast as u turns in I, so that
//     alpha = Ix p (u' x u) / (rho S d / 2 CMa V^4),  u' = a0 + Omega x u + L alpha + N (u x alpha),
//     L = rho S / 2m CLa V^2 + T / m,  N = rho S k d / 2m CNpa p.
//   This is linear in alpha. With n = (a0 + Omega x u) x u, G = Ix p and Q = rho S d / 2 CMa V^4 - G N V^2:
//     alpha = G (Q n + G L (n x u)) / (Q^2 + G^2 L^2 V^2).
//   CLa = CLa0 + CLa2 alpha^2 and CMa = CMa0 + CMa2 alpha^2, with the alpha of constant coefficients in the second
//   part. a = a0 + L alpha + N (u x alpha) - rho S / 2m CDd2 alpha^2 V u;  p' = rho S k d^2 / 2 V Clp p / Ix.
// Source: NATO STANAG 4355, The Modified Point Mass and Five Degrees of Freedom Trajectory Models (2009)
//   (there u' is that of the step before, here the equation is solved); R. F. Lieske, M. L. Reiter, Equations of Motion
//   for a Modified Point Mass Trajectory, BRL Report 1314 (1966).
#pragma once

#include "math/vec3.hpp"
#include "model/aero.hpp"

PHYSIM_ISA_BEGIN

/// The sine of 30 degrees.
inline constexpr double kLargestSine = 0.5;

/// What a yaw does, over that yaw.
template <class R>
struct YawEffects {
  R lift;    // L, without thrust [m/s^2]
  R magnus;  // N [1/s]
  R moment;  // rho S d / 2 CMa V^4 [N m (m/s)^2]
};

template <class R>
PHYSIM_INLINE YawEffects<R> yaw_effects(const Rotor<R>& b, const AirState<R>& air, const R& speed_squared,
                                        const R& spin, const R& lighter, const AeroCoefficients<R>& k,
                                        const R& sine_squared) {
  const R pressure = air.density * speed_squared;
  return {pressure * b.force_scale * lighter * (k.lift + k.lift_cubic * sine_squared),
          air.density * b.magnus_force_scale * lighter * k.magnus_force * spin,
          pressure * b.moment_scale * (k.pitching + k.pitching_cubic * sine_squared) * speed_squared};
}

/// The parts of alpha = G (Q n + G L (n x u)) / (Q^2 + G^2 L^2 V^2). n is across u, so that |alpha|^2 = G^2 n^2 /
/// below.
template <class R>
struct ReposeParts {
  R stiff;   // Q
  R turned;  // G L, with the thrust in L
  R below;
};
template <class R>
PHYSIM_INLINE ReposeParts<R> repose_parts(const YawEffects<R>& at, const R& thrust, const R& momentum,
                                          const R& speed_squared) {
  const R stiff = at.moment - momentum * at.magnus * speed_squared;
  const R turned = momentum * (at.lift + thrust);
  return {stiff, turned, max(stiff * stiff + turned * turned * speed_squared, constant<R>(1e-30))};
}

/// A shell's yaw of repose and what it does.
template <class R>
struct Repose {
  Vec3<R> yaw;           // alpha [-]
  Vec3<R> acceleration;  // that comes with it, without thrust [m/s^2]
  R spin_slope;          // p' [rad/s^2]
};

/// `turning`: a0 + Omega x u. `lighter`: the mass at launch over what is left of it. `thrust`: T / m of what is left.
template <class R, class S>
PHYSIM_INLINE Repose<R> repose(const Conditions<S>& c, const Rotor<R>& b, const AirState<R>& air, const Vec3<R>& u,
                               const R& spin, const Vec3<R>& turning, const R& lighter, const R& thrust) {
  const R speed_squared = length_squared(u);
  const R speed = sqrt(speed_squared);
  const R mach = speed * air.per_sound_speed;
  const R momentum = b.moments.x * spin;
  const Vec3<R> bending = cross(turning, u);
  const R strength = momentum * momentum * length_squared(bending);
  const R straight(S(0)), most = constant<R>(kLargestSine * kLargestSine);
  AeroCoefficients<R> k = b.coefficient;
  R cell(S(0));
  if (c.has_aero_tables) {
    cell = cell_of(c.curve_rows, b.mach, mach);
    coefficients_by_mach<ReposeCoefficients>(c, b, cell, mach, k);
    k.magnus_force = magnus_coefficient(c, b.magnus_force, cell, mach, straight);
  }
  YawEffects<R> at = yaw_effects(b, air, speed_squared, spin, lighter, k, straight);
  ReposeParts<R> parts = repose_parts(at, thrust, momentum, speed_squared);
  const R sine_squared = min(strength / parts.below, most);
  if (c.has_aero_angles) {
    const R angle = asin(sqrt(sine_squared));
    k.magnus_force = magnus_coefficient(c, b.magnus_force, cell, mach, angle * angle);
  }
  at = yaw_effects(b, air, speed_squared, spin, lighter, k, sine_squared);
  parts = repose_parts(at, thrust, momentum, speed_squared);
  // The sine is held at kLargestSine where |alpha| would be more: by what the vector is divided by.
  const R held = sqrt(strength * parts.below) * S(1 / kLargestSine);
  Repose<R> r;
  r.yaw = (bending * parts.stiff + cross(bending, u) * parts.turned) * (momentum / max(parts.below, held));
  const R braking = air.density * b.force_scale * lighter * k.drag_yaw * length_squared(r.yaw) * speed;
  r.acceleration = r.yaw * at.lift + cross(u, r.yaw) * at.magnus - u * braking;
  r.spin_slope = air.density * speed * b.roll_scale * k.roll_damping * spin * b.inverse_moments.x;
  return r;
}

/// The axis of a shell with a yaw, for a path through the air along a unit vector [-].
template <class R>
PHYSIM_INLINE Vec3<R> yawed_axis(const Vec3<R>& along, const Vec3<R>& yaw) {
  return along * sqrt(ScalarOf<R>(1) - length_squared(yaw)) + yaw;
}

PHYSIM_ISA_END
