// The members of a struct, in the order in which it declares them: its definition is their one list.
//
// Archives, hashes, keys and casts are written for members in general. A struct that gains one needs no line anywhere,
// and none of them can forget it. Works on aggregates without bases, arrays or anonymous members; for those with arrays
// kMemberCount is given beside them, and a wrong count does not compile.
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace physim {
namespace detail {

template <class T>
inline constexpr bool kIsOptional = false;
template <class T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// Each stands for a member while members are counted. Optionals apart: they can be made of what they may hold, too.
struct AnyClass {
  template <class T>
  requires(std::is_class_v<T> && !kIsOptional<T>) operator T() const;  // NOLINT: it is any of them
};
struct AnyOptional {
  template <class T>
  operator std::optional<T>() const;  // NOLINT
};
struct AnyNumber {
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_pointer_v<T>) operator T() const;  // NOLINT
};

/// How many members can be given, when those before are given by `Before`.
template <class T, class... Before>
constexpr std::size_t count_members() {
  if constexpr (requires { T{Before{}..., AnyClass{}}; })
    return count_members<T, Before..., AnyClass>();
  else if constexpr (requires { T{Before{}..., AnyOptional{}}; })
    return count_members<T, Before..., AnyOptional>();
  else if constexpr (requires { T{Before{}..., AnyNumber{}}; })
    return count_members<T, Before..., AnyNumber>();
  else
    return sizeof...(Before);
}

}  // namespace detail

template <class T>
inline constexpr std::size_t kMemberCount = detail::count_members<T>();

// Where there are `count` members: their names in a structured binding, which takes as many as there are.
#define PHYSIM_TAKE(count, ...) \
  if constexpr (n == (count)) { \
    auto& [__VA_ARGS__] = x;    \
    return f(__VA_ARGS__);      \
  }

/// Calls f with all members of x.
template <class T, class F>
constexpr decltype(auto) with_members(T& x, F&& f) {
  constexpr std::size_t n = kMemberCount<std::remove_const_t<T>>;
  static_assert(n <= 28, "one more line below");
  if constexpr (n == 0) return f();
  // clang-format off
  PHYSIM_TAKE(1, a)
  PHYSIM_TAKE(2, a, b)
  PHYSIM_TAKE(3, a, b, c)
  PHYSIM_TAKE(4, a, b, c, d)
  PHYSIM_TAKE(5, a, b, c, d, e)
  PHYSIM_TAKE(6, a, b, c, d, e, g)
  PHYSIM_TAKE(7, a, b, c, d, e, g, h)
  PHYSIM_TAKE(8, a, b, c, d, e, g, h, i)
  PHYSIM_TAKE(9, a, b, c, d, e, g, h, i, j)
  PHYSIM_TAKE(10, a, b, c, d, e, g, h, i, j, k)
  PHYSIM_TAKE(11, a, b, c, d, e, g, h, i, j, k, l)
  PHYSIM_TAKE(12, a, b, c, d, e, g, h, i, j, k, l, m)
  PHYSIM_TAKE(13, a, b, c, d, e, g, h, i, j, k, l, m, o)
  PHYSIM_TAKE(14, a, b, c, d, e, g, h, i, j, k, l, m, o, p)
  PHYSIM_TAKE(15, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q)
  PHYSIM_TAKE(16, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r)
  PHYSIM_TAKE(17, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s)
  PHYSIM_TAKE(18, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t)
  PHYSIM_TAKE(19, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u)
  PHYSIM_TAKE(20, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v)
  PHYSIM_TAKE(21, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w)
  PHYSIM_TAKE(22, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y)
  PHYSIM_TAKE(23, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z)
  PHYSIM_TAKE(24, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa)
  PHYSIM_TAKE(25, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa, bb)
  PHYSIM_TAKE(26, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa, bb, cc)
  PHYSIM_TAKE(27, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa, bb, cc, dd)
  PHYSIM_TAKE(28, a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa, bb, cc, dd, ee)
  // clang-format on
}
#undef PHYSIM_TAKE

/// Gives every member of a structure to its twin of another precision.
template <class From, class To>
constexpr void cast_members(const From& from, To& to) {
  if constexpr (std::is_array_v<From>) {
    for (std::size_t i = 0; i < std::extent_v<From>; ++i) cast_members(from[i], to[i]);
  } else if constexpr (std::is_same_v<From, To>) {
    to = from;
  } else if constexpr (std::is_floating_point_v<From>) {
    to = static_cast<To>(from);
  } else {
    with_members(from, [&](const auto&... source) {
      with_members(to, [&](auto&... twin) { (cast_members(source, twin), ...); });
    });
  }
}

}  // namespace physim
