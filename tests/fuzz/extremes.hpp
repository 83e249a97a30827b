// Extreme numbers, put into any structure of the public interface: most are legal, and all are far from what is usual.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "base/members.hpp"
#include "random_shots.hpp"

namespace physim::test {
namespace detail {

template <class T>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = true;
template <class T>
inline constexpr bool kIsList<std::optional<T>> = true;
template <class T, std::size_t n>
inline constexpr bool kIsList<std::array<T, n>> = true;
template <class T>
inline constexpr bool kIsVariant = false;
template <class... T>
inline constexpr bool kIsVariant<std::variant<T...>> = true;
template <class T>
inline constexpr bool kIsId = requires(T& x) {
  x.index;
};

}  // namespace detail

/// Calls f with every number of a structure, whatever holds it; ids, flags and enumerators are none.
template <class T, class F>
void for_each_number(T& x, const F& f) {
  if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T> || detail::kIsId<T>) {
  } else if constexpr (std::is_arithmetic_v<T>) {
    f(x);
  } else if constexpr (detail::kIsVariant<T>) {
    std::visit([&](auto& held) { for_each_number(held, f); }, x);
  } else if constexpr (requires { x.has_value(); }) {
    if (x) for_each_number(*x, f);
  } else if constexpr (detail::kIsList<T>) {
    for (auto& item : x) for_each_number(item, f);
  } else if constexpr (std::is_aggregate_v<T> && std::is_class_v<T>) {
    with_members(x, [&](auto&... member) { (for_each_number(member, f), ...); });
  }
}

/// A number far from x: mostly times a power of ten; now and then the ends of what a double holds, or none.
inline double extreme(Random& r, double x) {
  using Limits = std::numeric_limits<double>;
  constexpr double kEnds[] = {
      0,      -0.0,  Limits::min(),      Limits::denorm_min(), Limits::max(), Limits::infinity(),
      1e-300, 1e300, Limits::quiet_NaN()};
  constexpr double kReach[] = {2, 6, 15, 40, 160, 308};
  const double sign = r.one_in(8) ? -1 : 1;
  if (r.one_in(5)) return sign * kEnds[r.below(std::size(kEnds))];
  const double reach = kReach[r.below(std::size(kReach))];
  const double power = r.one_in(3) ? reach * (r.one_in(2) ? 1 : -1) : r.in(-reach, reach);
  return sign * (x == 0 ? 1 : x) * std::pow(10, power);
}
template <class Integer>
Integer extreme_count(Random& r) {
  constexpr Integer kMost = std::numeric_limits<Integer>::max();
  const Integer some[] = {0, 1, 2, 1000, 1 << 20, kMost, kMost - 1, static_cast<Integer>(kMost / 2 + 1)};
  return some[r.below(std::size(some))];
}

/// Puts one extreme number into a structure, and now and then more.
template <class Def>
void put_extremes(Random& r, Def& def) {
  int count = 0;
  for_each_number(def, [&](const auto&) { ++count; });
  if (count == 0) return;
  for (int left = r.one_in(3) ? 1 + r.below(4) : 1; left > 0; --left) {
    int place = r.below(count);
    for_each_number(def, [&]<class Number>(Number& x) {
      if (place-- != 0) return;
      if constexpr (std::is_floating_point_v<Number>)
        x = extreme(r, x);
      else if (r.one_in(4))
        x = extreme_count<Number>(r);
    });
  }
}

}  // namespace physim::test
