// The operations of Quat, for the library's own code; its users call the copies in quat.cpp.
#pragma once

#include <cmath>

#include "math/vec3.hpp"
#include "physim/math.hpp"

namespace physim {

template <class T>
PHYSIM_INLINE Quat<T> operator*(const Quat<T>& a, const Quat<T>& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
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
template <class T>
PHYSIM_INLINE Quat<T> normalized(const Quat<T>& q) {
  const T n = norm(q);
  if (!(n > T{0})) return {};
  const T s = T{1} / n;
  return {q.w * s, q.x * s, q.y * s, q.z * s};
}
template <class T>
PHYSIM_INLINE Vec3<T> rotate(const Quat<T>& q, const Vec3<T>& v) {
  // q v q* = v + w t + u x t with q = (w, u) and t = 2 u x v
  const Vec3<T> u{q.x, q.y, q.z};
  const Vec3<T> t = cross(u, v) * T(2);
  return v + t * q.w + cross(u, t);
}

}  // namespace physim
