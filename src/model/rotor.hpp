// Turn: how a projectile is turned and turns. Rotor: the numbers of one projectile that only rotation models read.
//
// Both stand beside State and Body, and are touched only where the granted rotation is flown: point masses pay nothing
// for them.
//
// Source: none of its own; the models that read them say what the numbers mean.
#pragma once

#include "math/pack.hpp"
#include "physim/fidelity.hpp"
#include "physim/quat.hpp"

namespace physim {

/// The rotation is part of what is flown: every step moves a Turn too.
PHYSIM_INLINE constexpr bool turns(const Fidelity& f) { return f.rotation >= RotationModel::rigid_body; }

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

/// Every member is an R, so that a lane can be copied in and out field by field.
template <class R>
struct Rotor {
  Turn<R> launch;            // at time 0
  Vec3<R> moments;           // Ixx, Iyy, Izz [kg m^2]
  Vec3<R> products;          // Ixy, Ixz, Iyz of the tensor [kg m^2]
  Vec3<R> inverse_moments;   // of the inverse tensor, the same members [1/(kg m^2)]
  Vec3<R> inverse_products;  // [1/(kg m^2)]
};

template <class R>
inline constexpr int kRotorFields = sizeof(Rotor<R>) / sizeof(R);
inline constexpr unsigned kTurnFields = 7;

/// Memory that is not set to zero and holds nothing until it is written: what only some rungs use of a large structure.
template <class T>
union Unset {
  T value;

  PHYSIM_INLINE Unset() {}  // NOLINT: it is left as it is
  PHYSIM_INLINE T* operator->() { return &value; }
  PHYSIM_INLINE const T* operator->() const { return &value; }
  PHYSIM_INLINE T& operator*() { return value; }
  PHYSIM_INLINE const T& operator*() const { return value; }
};

}  // namespace physim
