// Vec3: three components of any number type, with every operation a particle engine needs.
#pragma once

#include <cmath>

#include "physim/macros.hpp"

namespace physim {

/// A vector of three components. World frame W: x downrange, y up, z right; right-handed.
/// T is float, double, or (inside the library) a pack of lanes.
template <class T>
struct Vec3 {
  T x{};  ///< [same unit for all three]
  T y{};  ///< [same unit for all three]
  T z{};  ///< [same unit for all three]

  PHYSIM_INLINE Vec3& operator+=(const Vec3& b) { return x = x + b.x, y = y + b.y, z = z + b.z, *this; }
  PHYSIM_INLINE Vec3& operator-=(const Vec3& b) { return x = x - b.x, y = y - b.y, z = z - b.z, *this; }
  PHYSIM_INLINE Vec3& operator*=(const T& s) { return x = x * s, y = y * s, z = z * s, *this; }

  /// Turns the vector to point the other way.
  PHYSIM_INLINE void invert() { x = -x, y = -y, z = -z; }
  /// Sets all components to zero.
  PHYSIM_INLINE void clear() { x = T{}, y = T{}, z = T{}; }
  /// Adds b scaled by s.
  PHYSIM_INLINE void add_scaled(const Vec3& b, const T& s) { x = x + b.x * s, y = y + b.y * s, z = z + b.z * s; }

  bool operator==(const Vec3&) const = default;
};

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

template <class T>
PHYSIM_INLINE Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
PHYSIM_INLINE Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
PHYSIM_INLINE Vec3<T> operator-(const Vec3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
PHYSIM_INLINE Vec3<T> operator*(const Vec3<T>& a, const T& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
PHYSIM_INLINE Vec3<T> operator*(const T& s, const Vec3<T>& a) {
  return {a.x * s, a.y * s, a.z * s};
}

/// Product component by component.
template <class T>
PHYSIM_INLINE Vec3<T> component_product(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
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
/// The vector of length one in the direction of a; zero stays zero.
template <class T>
PHYSIM_INLINE Vec3<T> normalized(const Vec3<T>& a) {
  const T len = length(a);
  return len > T{0} ? a * (T{1} / len) : a;
}
/// Scales a to length one in place; zero is left alone.
template <class T>
PHYSIM_INLINE void normalize(Vec3<T>& a) {
  a = normalized(a);
}

/// Conversion between number types.
template <class To, class From>
PHYSIM_INLINE Vec3<To> vec_cast(const Vec3<From>& a) {
  return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

}  // namespace physim
