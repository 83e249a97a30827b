// Mathematics: vectors, rotations, columns of numbers in memory, and the few macros of the library.
#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <type_traits>

// ---------------------------------------------------------------------------------------------------------------------
// The few macros of the library.

/// PHYSIM_INLINE forces inlining in kernel files, which are compiled once per instruction set (the compiler defines
/// PHYSIM_ISA for them alone): no copy of a small function may be left that the linker could share with code for an
/// older processor. Everywhere else it is `inline`, for smaller programs that compile sooner; there
/// PHYSIM_INLINE_ALWAYS forces it for the sums of a step, and PHYSIM_FLAT for all that the acceleration calls: without
/// them a flight by fixed steps takes half as long again. A lambda has PHYSIM_INLINE_LAMBDA behind its parameters.
/// Small kernels, of which there is one copy, are called.
#if (defined(__GNUC__) || defined(__clang__)) && !defined(PHYSIM_SMALL_KERNELS)
#define PHYSIM_INLINE_ALWAYS [[gnu::always_inline]] inline
#define PHYSIM_INLINE_LAMBDA __attribute__((always_inline))
#define PHYSIM_FLAT [[gnu::flatten]]
#else
#define PHYSIM_INLINE_ALWAYS inline
#define PHYSIM_INLINE_LAMBDA
#define PHYSIM_FLAT
#endif
#ifdef PHYSIM_ISA
#define PHYSIM_INLINE PHYSIM_INLINE_ALWAYS
#else
#define PHYSIM_INLINE inline
#endif

/// Enumerators are names: none is less than another. Rungs are compared by their level (RungInfo).
#define PHYSIM_UNORDERED(Enum)          \
  bool operator<(Enum, Enum) = delete;  \
  bool operator<=(Enum, Enum) = delete; \
  bool operator>(Enum, Enum) = delete;  \
  bool operator>=(Enum, Enum) = delete;

namespace physim {

// ---------------------------------------------------------------------------------------------------------------------
// kInfinity: the default of every limit, which means no limit.

/// Positive infinity, by its bits: where a program is compiled with -ffast-math, compilers warn of infinities that are
/// written as such.
inline constexpr double kInfinity = std::bit_cast<double>(std::uint64_t{0x7ff0000000000000});

// ---------------------------------------------------------------------------------------------------------------------
// Vec3: three components of any number type, with every operation a particle engine needs.
//
// Operations that round each component once are computed where they are called. Those that round more than once are
// compiled inside the library (src/math/vec3.hpp): their bits do not depend on the flags of the code that includes this
// header, neither on -ffast-math nor on the fused multiply-add that -march=native allows.

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

// ---------------------------------------------------------------------------------------------------------------------
// Quat: rotations as unit quaternions of any number type; computed inside the library (src/math/quat.hpp), as what
// rounds more than once in Vec3 is.

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

/// q_WB of a body with its nose `yaw` to the right of x and `pitch` up, rolled by `roll`, right side down, all in
/// [rad]. Order: yaw about -y (down), then pitch about the new z (right), then roll about the new x (forward).
template <class T>
Quat<T> quat_from_yaw_pitch_roll(T yaw, T pitch, T roll);

// ---------------------------------------------------------------------------------------------------------------------
// Columns in the caller's memory: values that lie side by side, or as members of structs of the caller's own.

/// A destination of values, written one after the other: a span, vector or array of them, or a member of each struct in
/// one, as vertices of a renderer are. It owns nothing: what is gone before the column is used, as a vector without a
/// name, is refused.
template <class T>
class Column {
  static_assert(!std::is_const_v<T>, "columns are written");
  template <class R>
  static constexpr bool kStays = std::is_lvalue_reference_v<R> || std::ranges::borrowed_range<R>;

 public:
  constexpr Column() = default;
  /// Values side by side.
  template <class R>
  requires(!std::is_same_v<std::remove_cvref_t<R>, Column> && kStays<R> &&
           std::is_constructible_v<std::span<T>, R&>) constexpr Column(R&& values) {
    const std::span<T> all(values);
    first_ = all.data();
    size_ = all.size();
  }
  /// A member of each struct: Column<Vec3d>{sprites, &Sprite::position}.
  template <class R, class S>
  requires(kStays<R>&& std::is_constructible_v<std::span<S>, R&>) constexpr Column(R&& structs, T S::*member) {
    const std::span<S> all(structs);
    if (!all.empty()) first_ = &(all.front().*member);
    size_ = all.size();
    stride_ = sizeof(S);
  }
  /// `size` values, each `stride` bytes behind the one before: a multiple of alignof(T), and at least sizeof(T).
  constexpr Column(T* first, std::size_t size, std::size_t stride = sizeof(T))
      : first_(first), size_(size), stride_(stride) {}

  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
  [[nodiscard]] constexpr std::size_t size() const { return size_; }
  /// Bytes from one value to the next.
  [[nodiscard]] constexpr std::size_t stride() const { return stride_; }
  [[nodiscard]] T& operator[](std::size_t i) const {
    void* const first = first_;
    void* const at = static_cast<std::byte*>(first) + i * stride_;
    return *static_cast<T*>(at);
  }

 private:
  T* first_ = nullptr;
  std::size_t size_ = 0;
  std::size_t stride_ = sizeof(T);
};

}  // namespace physim
