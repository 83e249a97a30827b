// What users of Quat call. Quaternions from angles are computed in double for every number type.
#include "math/quat.hpp"

#include "base/ieee_mode.hpp"
#include "math/elementary.hpp"

namespace physim {

template <class T>
Quat<T> quat_from_axis_angle(const Vec3<T>& axis, T angle) {
  const IeeeMode mode;
  const Vec3d direction = normalized(vec_cast<double>(axis));
  if (direction == Vec3d{}) return {};
  const SinCos<double> half = sincos(0.5 * static_cast<double>(angle));
  return {static_cast<T>(half.cos), static_cast<T>(direction.x * half.sin), static_cast<T>(direction.y * half.sin),
          static_cast<T>(direction.z * half.sin)};
}

template <class T>
Quat<T> quat_from_yaw_pitch_roll(T yaw, T pitch, T roll) {
  const IeeeMode mode;
  const Quatd q = quat_from_axis_angle<double>({0, -1, 0}, yaw) * quat_from_axis_angle<double>({0, 0, 1}, pitch) *
                  quat_from_axis_angle<double>({1, 0, 0}, roll);
  return {static_cast<T>(q.w), static_cast<T>(q.x), static_cast<T>(q.y), static_cast<T>(q.z)};
}

#define PHYSIM_QUAT(T)                                        \
  template Quat<T> operator*(const Quat<T>&, const Quat<T>&); \
  template T norm_squared(const Quat<T>&);                    \
  template T norm(const Quat<T>&);                            \
  template Quat<T> normalized(const Quat<T>&);                \
  template Vec3<T> rotate(const Quat<T>&, const Vec3<T>&);    \
  template Quat<T> quat_from_axis_angle(const Vec3<T>&, T);   \
  template Quat<T> quat_from_yaw_pitch_roll(T, T, T);
PHYSIM_QUAT(float)
PHYSIM_QUAT(double)
#undef PHYSIM_QUAT

}  // namespace physim
