// Turn: how a projectile is turned and turns. Rotor: the numbers of one projectile that only rotation models read.
//
// Both stand beside State and Body, and are touched only where the granted rotation is flown: point masses pay nothing
// for them.
//
// Source: none; the models that read them say what the numbers mean.
#pragma once

#include "math/numbers.hpp"
#include "math/quat.hpp"
#include "physim/fidelity.hpp"

namespace physim {

/// The axis stands in its yaw of repose; only the spin is flown.
PHYSIM_INLINE constexpr bool is_in_repose(const Fidelity& f) {
  return f.rotation == RotationModel::modified_point_mass;
}

/// What the numbers mean is up to the rotation model:
///   rigid_body, quaternion form: w and u are q_WB [-], h is the angular velocity in I along body axes [rad/s];
///   rigid_body, axis form: w is the roll angle about the symmetry axis u [rad], u that axis in W [-], h the angular
///   momentum in I over the transverse moment of inertia, along W [rad/s].
template <class R>
struct Turn {
  R w;
  Vec3<R> u;
  Vec3<R> h;
};

/// Where a table lies among the rows of a cohort: see model/aero_tables.hpp.
template <class R>
struct Buckets {
  R row;    // the first one's
  R scale;  // buckets per unit
  R last;   // number of the last one
};
template <class R>
struct AngleTable {
  Buckets<R> buckets;  // of alpha^2
  R row;               // of the first cell
  R cells;             // by angle, of each cell by Mach number
};

/// Coefficients of AeroDef at one Mach number and angle: what a yaw of repose needs; with the damping across the axis,
/// which stand in rows by Mach number, two to a row; with Magnus' ones, which stand in tables of their own.
template <class R>
struct ReposeCoefficients {
  R drag_yaw;
  R lift;
  R lift_cubic;
  R pitching;
  R pitching_cubic;
  R roll_damping;
};
template <class R>
struct RowCoefficients : ReposeCoefficients<R> {
  R pitch_damping;
  R yaw_damping;
};
template <class R>
struct AeroCoefficients : RowCoefficients<R> {
  R magnus_force;
  R magnus_moment;
};

/// What a rotation model reads of a projectile but its launch.
template <class R>
struct RotorConstants {
  Vec3<R> moments;           // Ixx, Iyy, Izz [kg m^2]
  Vec3<R> products;          // Ixy, Ixz, Iyz of the tensor [kg m^2]
  Vec3<R> inverse_moments;   // of the inverse tensor, the same members [1/(kg m^2)]
  Vec3<R> inverse_products;  // [1/(kg m^2)]
  // Aerodynamics (model/aero.hpp); k is 1 where rates are made dimensionless by V, 1/2 where by 2V.
  R force_scale;                    // S / 2m [m^2/kg]
  R moment_scale;                   // S d / 2 [m^3]
  R pitch_scale;                    // k S d^2 / 2 [m^4]
  R yaw_scale;                      // pitch_scale, of the span if yaw damping is given separately [m^4]
  R roll_scale;                     // of the span [m^4]
  R magnus_force_scale;             // k S d / 2m [m^3/kg]
  R magnus_moment_scale;            // k S d^2 / 2 [m^4]
  R air_turns;                      // 1: damping is against the air, which turns with W; 0: against the fixed stars
  AeroCoefficients<R> coefficient;  // where they are constant
  Buckets<R> mach;
  R mach_row;  // of the first cell by Mach number
  AngleTable<R> magnus_force;
  AngleTable<R> magnus_moment;
};
template <class R>
struct Rotor : RotorConstants<R> {
  Turn<R> launch;  // at time 0
};

}  // namespace physim
