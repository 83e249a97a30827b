// Quat: rotations as unit quaternions of any number type.
#pragma once

#include <cmath>

#include "physim/macros.hpp"
#include "physim/vec3.hpp"

namespace physim {

/// A quaternion w + x i + y j + z k; of length one, a rotation. q_WB takes the components of a vector in the body frame
/// B into the world frame W: v_W = rotate(q_WB, v_B). Rotations chain as frames do: q_WC = q_WB * q_BC.
/// T is float, double, or (inside the library) a pack of lanes.
template <class T>
struct Quat {
  T w{1};  ///< [-] cosine of half the angle
  T x{0};  ///< [-] axis times the sine of half the angle, for x, y and z
  T y{0};  ///< [-]
  T z{0};  ///< [-]

  bool operator==(const Quat&) const = default;
};

using Quatf = Quat<float>;
using Quatd = Quat<double>;

/// First b, then a.
template <class T>
PHYSIM_INLINE Quat<T> operator*(const Quat<T>& a, const Quat<T>& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
/// The opposite rotation: q_BW = conjugate(q_WB).
template <class T>
PHYSIM_INLINE Quat<T> conjugate(const Quat<T>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}
template <class T>
PHYSIM_INLINE T norm_squared(const Quat<T>& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}
template <class T>
PHYSIM_INLINE T norm(const Quat<T>& q) {
  using std::sqrt;
  return sqrt(norm_squared(q));
}
/// The rotation that q stands for, with norm one; zero becomes the identity.
template <class T>
PHYSIM_INLINE Quat<T> normalized(const Quat<T>& q) {
  const T n = norm(q);
  if (!(n > T{0})) return {};
  const T s = T{1} / n;
  return {q.w * s, q.x * s, q.y * s, q.z * s};
}
/// v turned by the unit quaternion q.
template <class T>
PHYSIM_INLINE Vec3<T> rotate(const Quat<T>& q, const Vec3<T>& v) {
  // q v q* = v + w t + u x t with q = (w, u) and t = 2 u x v
  const Vec3<T> u{q.x, q.y, q.z};
  const Vec3<T> t = cross(u, v) * T(2);
  return v + t * q.w + cross(u, t);
}

/// The right-handed turn by `angle` [rad] about `axis` (any length; a zero axis gives the identity). For float and
/// double; computed in double with the library's own sine and cosine, so that every platform gets the same bits.
template <class T>
Quat<T> quat_from_axis_angle(const Vec3<T>& axis, T angle);

/// q_WB of a body whose nose points `yaw` to the right of x, `pitch` up, and which is rolled by `roll`, right side
/// down, all in [rad]. Order: yaw about -y (down), then pitch about the new z (right), then roll about the new x
/// (forward).
template <class T>
Quat<T> quat_from_yaw_pitch_roll(T yaw, T pitch, T roll);

}  // namespace physim
