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

/// Calls f with all members of x.
template <class T, class F>
constexpr decltype(auto) with_members(T& x, F&& f) {
  constexpr std::size_t n = kMemberCount<std::remove_const_t<T>>;
  static_assert(n >= 1 && n <= 26, "one more line below");
  if constexpr (n == 1) {
    auto& [a] = x;
    return f(a);
  }
  if constexpr (n == 2) {
    auto& [a, b] = x;
    return f(a, b);
  }
  if constexpr (n == 3) {
    auto& [a, b, c] = x;
    return f(a, b, c);
  }
  if constexpr (n == 4) {
    auto& [a, b, c, d] = x;
    return f(a, b, c, d);
  }
  if constexpr (n == 5) {
    auto& [a, b, c, d, e] = x;
    return f(a, b, c, d, e);
  }
  if constexpr (n == 6) {
    auto& [a, b, c, d, e, g] = x;
    return f(a, b, c, d, e, g);
  }
  if constexpr (n == 7) {
    auto& [a, b, c, d, e, g, h] = x;
    return f(a, b, c, d, e, g, h);
  }
  if constexpr (n == 8) {
    auto& [a, b, c, d, e, g, h, i] = x;
    return f(a, b, c, d, e, g, h, i);
  }
  if constexpr (n == 9) {
    auto& [a, b, c, d, e, g, h, i, j] = x;
    return f(a, b, c, d, e, g, h, i, j);
  }
  if constexpr (n == 10) {
    auto& [a, b, c, d, e, g, h, i, j, k] = x;
    return f(a, b, c, d, e, g, h, i, j, k);
  }
  if constexpr (n == 11) {
    auto& [a, b, c, d, e, g, h, i, j, k, l] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l);
  }
  if constexpr (n == 12) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m);
  }
  if constexpr (n == 13) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o);
  }
  if constexpr (n == 14) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p);
  }
  if constexpr (n == 15) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q);
  }
  if constexpr (n == 16) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r);
  }
  if constexpr (n == 17) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s);
  }
  if constexpr (n == 18) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t);
  }
  if constexpr (n == 19) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u);
  }
  if constexpr (n == 20) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v);
  }
  if constexpr (n == 21) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w);
  }
  if constexpr (n == 22) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y);
  }
  if constexpr (n == 23) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z);
  }
  if constexpr (n == 24) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa);
  }
  if constexpr (n == 25) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa, bb] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa, bb);
  }
  if constexpr (n == 26) {
    auto& [a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa, bb, cc] = x;
    return f(a, b, c, d, e, g, h, i, j, k, l, m, o, p, q, r, s, t, u, v, w, y, z, aa, bb, cc);
  }
}

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
