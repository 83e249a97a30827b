// Quat: rotations as unit quaternions of any number type; computed inside the library (src/math/quat.hpp), as what
// rounds more than once in Vec3 is.
#pragma once

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
Quat<T> operator*(const Quat<T>& a, const Quat<T>& b);
/// The opposite rotation: q_BW = conjugate(q_WB).
template <class T>
PHYSIM_INLINE Quat<T> conjugate(const Quat<T>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}
template <class T>
T norm_squared(const Quat<T>& q);
template <class T>
T norm(const Quat<T>& q);
/// The rotation that q stands for, with norm one; zero becomes the identity.
template <class T>
Quat<T> normalized(const Quat<T>& q);
/// v turned by the unit quaternion q.
template <class T>
Vec3<T> rotate(const Quat<T>& q, const Vec3<T>& v);

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
