// The operations of Vec3 that round more than once, for the library's own code; its users call the copies in vec3.cpp.
#pragma once

#include <cmath>

#include "base/strict_math.hpp"
#include "physim/math.hpp"

namespace physim {

// A separate function: g++ 12 drops always_inline where the declaration within the class does not have it, and calls
// the member from the stage sums of kernels.
template <class T>
PHYSIM_INLINE void add_scaled(Vec3<T>& sum, const Vec3<T>& b, const T& s) {
  sum = {sum.x + b.x * s, sum.y + b.y * s, sum.z + b.z * s};
}
template <class T>
PHYSIM_INLINE T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
PHYSIM_INLINE Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
PHYSIM_INLINE T length_squared(const Vec3<T>& a) {
  return dot(a, a);
}
template <class T>
PHYSIM_INLINE T length(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
template <class T>
PHYSIM_INLINE Vec3<T> normalized(const Vec3<T>& a) {
  const T len = length(a);
  return len > T{0} ? a * (T{1} / len) : a;
}
template <class T>
PHYSIM_INLINE void normalize(Vec3<T>& a) {
  a = normalized(a);
}

}  // namespace physim
