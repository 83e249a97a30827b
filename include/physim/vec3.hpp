// Vec3: three components of any number type, with every operation a particle engine needs.
//
// What rounds each component once is computed where it is called. What rounds more than once is compiled inside the
// library (src/math/vec3.hpp): its bits do not depend on the flags of whoever includes this header, neither on
// -ffast-math nor on the fused multiply-add that -march=native allows.
#pragma once

#include <cassert>
#include <cstddef>
#include <type_traits>

#include "physim/macros.hpp"

namespace physim {

/// A vector of three components. World frame W: x downrange, y up, z right; right-handed.
/// T is float, double, or (inside the library) a pack of lanes.
template <class T>
struct Vec3 {
  T x{};  ///< [same unit for all three]
  T y{};  ///< [same unit for all three]
  T z{};  ///< [same unit for all three]

  /// Component 0, 1 or 2: x, y or z. Any other index is a mistake of the caller's.
  PHYSIM_INLINE T& operator[](std::size_t i) {
    assert(i < 3);
    return i == 0 ? x : i == 1 ? y : z;
  }
  PHYSIM_INLINE const T& operator[](std::size_t i) const {
    assert(i < 3);
    return i == 0 ? x : i == 1 ? y : z;
  }

  PHYSIM_INLINE Vec3& operator+=(const Vec3& b) { return x = x + b.x, y = y + b.y, z = z + b.z, *this; }
  PHYSIM_INLINE Vec3& operator-=(const Vec3& b) { return x = x - b.x, y = y - b.y, z = z - b.z, *this; }
  PHYSIM_INLINE Vec3& operator*=(const T& s) { return x = x * s, y = y * s, z = z * s, *this; }

  /// Turns the vector to point the other way.
  PHYSIM_INLINE void invert() { x = -x, y = -y, z = -z; }
  /// Sets all components to zero.
  PHYSIM_INLINE void clear() { x = T{}, y = T{}, z = T{}; }
  /// Adds b scaled by s.
  void add_scaled(const Vec3& b, const T& s);

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
/// Scaled by any number that is, or becomes, a T: `v * 2`.
template <class T>
PHYSIM_INLINE Vec3<T> operator*(const Vec3<T>& a, const std::type_identity_t<T>& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
PHYSIM_INLINE Vec3<T> operator*(const std::type_identity_t<T>& s, const Vec3<T>& a) {
  return {a.x * s, a.y * s, a.z * s};
}

/// Product component by component.
template <class T>
PHYSIM_INLINE Vec3<T> component_product(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b);
template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b);
template <class T>
T length_squared(const Vec3<T>& a);
template <class T>
T length(const Vec3<T>& a);
/// The vector of length one in the direction of a; zero stays zero.
template <class T>
Vec3<T> normalized(const Vec3<T>& a);
/// Scales a to length one in place; zero is left alone.
template <class T>
void normalize(Vec3<T>& a);

/// Conversion between number types.
template <class To, class From>
PHYSIM_INLINE Vec3<To> vec_cast(const Vec3<From>& a) {
  return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

}  // namespace physim
