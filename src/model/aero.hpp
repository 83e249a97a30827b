// Aerodynamic force and moment of a body with an attitude.
//
// What it models: drag of yaw, lift, overturning moment, damping of pitch, yaw and roll, Magnus force and moment, each
//   by a coefficient that depends on the Mach number; lift and overturning also on the sine of the angle of attack,
//   Magnus on its square. Drag at zero yaw is that of DragDef (model/drag.hpp), at this rung as at all others.
// When to use it: shells and bullets with measured coefficients, finned rockets, tumbling bricks.
// When it is wrong: bodies without symmetry of rotation get no side force and no moments from their shape but damping;
//   angles of attack beyond those that were measured; CMq + CMadot stand as one sum against the rate of the axis.
// Symbols: u velocity through the air [m/s]; V = |u|; rho [kg/m^3]; x unit vector along the body's axis; s, c sine and
//   cosine of the angle of attack; A its square [rad^2]; p spin, omega_t rate across the axis [rad/s]; S area, d
//   length [m]; m mass [kg]; k 1 where rates are p d / V, 1/2 where p d / 2V.
// Equations: F / m = rho S / 2m (-CDd2 s^2 V u + CLa (V^2 x - (u.x) u) + k d CNpa p (u x x)), CLa = CLa0 + CLa2 s^2;
//   M = rho S d / 2 (CMa V (u x x) + k d (V CMq omega_t + V Clp p x + CMpa p (V x x (u x x) / V))),
//   CMa = CMa0 + CMa2 s^2; damping of bodies without symmetry: Cmq, Cnr, Clp about each axis with its own length.
// Source: R. L. McCoy, Modern Exterior Ballistics (1999), ch. 2 (the coefficients and their signs) and ch. 9 (their
//   vector forms).
#pragma once

#include "math/row_table.hpp"
#include "math/vec3.hpp"
#include "model/air.hpp"
#include "model/rigid_body.hpp"

PHYSIM_ISA_BEGIN

// ------------------------------------------------------------------------------------------- coefficients
/// The number of borders at or below a value.
template <class R, class S>
PHYSIM_INLINE R cell_of(const S* rows, const Buckets<R>& b, const R& value) {
  const R bucket = floor_small(clamp(value * b.scale, R(S(0)), b.last));
  R column[4];
  row_columns(rows, b.row + bucket, column);
  return column[0] + select(value >= column[1], R(S(1)), R(S(0)));
}

template <class R, class S>
PHYSIM_INLINE R magnus_coefficient(const Conditions<S>& c, const AngleTable<R>& t, const R& mach_cell, const R& mach,
                                   const R& angle_squared) {
  R row = t.row + mach_cell * t.cells;
  if (c.has_aero_angles) row += cell_of(c.curve_rows, t.buckets, angle_squared);
  R f[4];
  row_columns(c.curve_rows, row, f);
  return (f[0] + f[1] * angle_squared) + mach * (f[2] + f[3] * angle_squared);
}

/// Some of the coefficients by Mach number, the first ones of each row.
template <template <class> class Some, class R, class S>
PHYSIM_INLINE void coefficients_by_mach(const Conditions<S>& c, const Rotor<R>& b, const R& mach_cell, const R& mach,
                                        Some<R>& k) {
  constexpr int kPairs = int(kNumbers<Some> / 2);
  static_assert(kNumbers<Some> % 2 == 0 && kNumbers<Some> <= kNumbers<RowCoefficients>);
  R* value = numbers(k);
  const R row = b.mach_row + mach_cell * S(kNumbers<RowCoefficients> / 2);
  for (int pair = 0; pair < kPairs; ++pair) {
    R f[4];
    row_columns(c.curve_rows, row + S(pair), f);
    value[2 * pair] = f[0] + f[1] * mach;
    value[2 * pair + 1] = f[2] + f[3] * mach;
  }
}

template <class R, class S>
PHYSIM_NOINLINE AeroCoefficients<R> aero_coefficients(const Conditions<S>& c, const Rotor<R>& b, const R& mach,
                                                      const R& angle_squared) {
  AeroCoefficients<R> k = b.coefficient;
  if (!c.has_aero_tables) return k;
  PHYSIM_ASSERT(c.curve_rows != nullptr && c.has_aero);
  const R cell = cell_of(c.curve_rows, b.mach, mach);
  coefficients_by_mach<RowCoefficients>(c, b, cell, mach, k);
  k.magnus_force = magnus_coefficient(c, b.magnus_force, cell, mach, angle_squared);
  k.magnus_moment = magnus_coefficient(c, b.magnus_moment, cell, mach, angle_squared);
  return k;
}

// ------------------------------------------------------------------------------------------- force and moment
template <class R>
struct AeroLoad {
  Vec3<R> acceleration;  // [m/s^2]
  Vec3<R> moment;        // [N m]
};

/// Everything but damping across the axis. Vectors in W or along body axes, all in the same.
template <class R, class S>
PHYSIM_NOINLINE AeroLoad<R> aero_load(const Conditions<S>& c, const Rotor<R>& b, const AirState<R>& air,
                                      const Vec3<R>& u, const Vec3<R>& x, const R& spin, AeroCoefficients<R>& k) {
  const R v_squared = length_squared(u);
  const R speed = sqrt(v_squared);
  const Vec3<R> across = cross(u, x);  // V s
  const R along = dot(u, x);           // V c
  const R sine_squared = length_squared(across) / max(v_squared, constant<R>(1e-30));
  R angle_squared(S(0));
  if (c.has_aero_angles) {
    const R angle = atan2(sqrt(length_squared(across)), along);
    angle_squared = angle * angle;
  }
  k = aero_coefficients(c, b, speed * air.per_sound_speed, angle_squared);
  const R lift = k.lift + k.lift_cubic * sine_squared;
  const R pitching = k.pitching + k.pitching_cubic * sine_squared;
  const R force = air.density * b.force_scale;
  AeroLoad<R> load;
  load.acceleration = x * (force * lift * v_squared) -
                      u * (force * (lift * along + k.drag_yaw * sine_squared * speed)) +
                      across * (air.density * b.magnus_force_scale * k.magnus_force * spin);
  load.moment = across * (air.density * speed * b.moment_scale * pitching) +
                (u - x * along) * (air.density * b.magnus_moment_scale * k.magnus_moment * spin) +
                x * (air.density * speed * b.roll_scale * k.roll_damping * spin);
  return load;
}

/// Omega as damping feels it: nothing where it is against the fixed stars.
template <class R, class S>
PHYSIM_INLINE Vec3<R> omega_of_air(const Conditions<S>& c, const Rotor<R>& b) {
  return {c.omega.x * b.air_turns, c.omega.y * b.air_turns, c.omega.z * b.air_turns};
}

/// The axis form: vectors along W.
template <class R, class S>
PHYSIM_INLINE AeroLoad<R> axis_aero(const Conditions<S>& c, const Rotor<R>& b, const AirState<R>& air, const Vec3<R>& u,
                                    const Turn<R>& t) {
  const Vec3<R> x = t.u * (S(1) / length(t.u));
  const R along = dot(t.h, x);
  R spin = along * (b.moments.y * b.inverse_moments.x);
  Vec3<R> across = t.h - x * along;
  if (is_turning(c.fidelity.earth)) {
    const Vec3<R> omega = omega_of_air(c, b);
    const R omega_along = dot(omega, x);
    spin -= omega_along;
    across -= omega - x * omega_along;
  }
  AeroCoefficients<R> k;
  AeroLoad<R> load = aero_load(c, b, air, u, x, spin, k);
  load.moment += across * (air.density * length(u) * b.pitch_scale * k.pitch_damping);
  return load;
}

/// The quaternion form: the acceleration along W, the moment along body axes.
template <class R, class S>
PHYSIM_INLINE AeroLoad<R> quaternion_aero(const Conditions<S>& c, const Rotor<R>& b, const AirState<R>& air,
                                          const Vec3<R>& u, const Turn<R>& t) {
  const R zero(S(0));
  const Vec3<R> u_B = turned_by(R(-t.w), t.u, u);
  Vec3<R> rate = t.h;
  if (is_turning(c.fidelity.earth)) rate -= turned_by(R(-t.w), t.u, omega_of_air(c, b));
  AeroCoefficients<R> k;
  AeroLoad<R> load = aero_load(c, b, air, u_B, Vec3<R>{R(S(1)), zero, zero}, rate.x, k);
  const R pressure = air.density * length(u);
  load.moment.y += pressure * b.yaw_scale * k.yaw_damping * rate.y;
  load.moment.z += pressure * b.pitch_scale * k.pitch_damping * rate.z;
  load.acceleration = turned_by(t.w, t.u, load.acceleration);
  return load;
}

template <class R, class S>
PHYSIM_INLINE AeroLoad<R> body_aero(const Conditions<S>& c, const Rotor<R>& b, const AirState<R>& air, const Vec3<R>& u,
                                    const Turn<R>& t) {
  return is_axis_form(c.fidelity) ? axis_aero(c, b, air, u, t) : quaternion_aero(c, b, air, u, t);
}

PHYSIM_ISA_END
