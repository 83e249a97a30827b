// The number of values of an enumeration, found by the compiler: no list repeats which one is the last.
#pragma once

#include <cstddef>
#include <string_view>

namespace physim {

/// Whether an enumerator has this value: compilers write others as "(Enum)7".
template <auto value>
consteval bool is_enumerator() {
  constexpr std::string_view text = __PRETTY_FUNCTION__;
  return text[text.rfind("value = ") + 8] != '(';
}

template <class Enum, std::size_t count = 0>
consteval std::size_t count_enumerators() {
  if constexpr (is_enumerator<static_cast<Enum>(count)>())
    return count_enumerators<Enum, count + 1>();
  else
    return count;
}

/// Number of values of an enumeration whose values are 0, 1, 2 ...
template <class Enum>
inline constexpr std::size_t kEnumerators = count_enumerators<Enum>();

}  // namespace physim
