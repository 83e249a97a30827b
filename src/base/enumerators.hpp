// The number of values of an enumeration, found by the compiler, so that no list repeats which one is the last; and
// tables with a row for each of them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace physim {

/// True if a value is that of an enumerator: compilers write other values as "(Enum)7".
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

/// True if a table has one row for each value of an enumeration, in their order.
template <class Row, std::size_t count, class Enum>
consteval bool has_row_for_each(const std::array<Row, count>& table, Enum Row::*value) {
  for (std::size_t i = 0; i < count; ++i)
    if (static_cast<std::size_t>(table[i].*value) != i) return false;
  return count == kEnumerators<Enum>;
}

/// The names in the rows of a table, in their order.
template <const auto& table>
inline constexpr auto kNamesIn = [] {
  std::array<std::string_view, table.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = table[i].name;
  return names;
}();

}  // namespace physim
