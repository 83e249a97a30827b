// SettingRow: what is known about a setting. Scenario files, studies and the checks of input all read the same rows.
//
// A list of rows is a tuple, so that each row keeps the type of its member: a check over a list compiles to comparisons
// with constants, as if it were written by hand.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "base/checker.hpp"
#include "physim/flight.hpp"
#include "physim/units.hpp"
#include "settings/range.hpp"

namespace physim {

using LaunchColumn = std::span<const double> LaunchColumns::*;
using WeatherColumn = std::span<const double> Weather::*;

struct SettingRow {
  std::string_view path;  // below what has the setting: "drag.k1"
  std::string_view doc;   // one line
  Quantity quantity = Quantity::number;
  std::string_view unit{};           // empty: the SI unit of the quantity
  Range range{};                     // of numbers and components; the length of lists; the values of enumerators
  std::optional<Range> in_files{};   // what scenario files accept, where that differs
  std::string_view hint{};           // of an error; empty: made from doc and unit
  std::string_view none = "none";    // how the absence of an optional value is written
  bool required = false;             // no default
  bool shorthand = false;            // its table may be written as this value alone
  bool starts = false;               // a choice of presets, which other settings of its table change
  bool live = false;                 // worlds can change it for one projectile in flight
  bool of_contact = false;           // of how a shot meets things, which single flights read, too
  bool uncertain = false;            // studies can draw it; of lists: each number of an item
  bool by_factor = false;            // studies can draw a factor of all items, too
  bool drawn_above_zero = false;     // a study has no use for a draw that is not above zero, though 0 is in range
  bool is_key = false;               // of items: what the other numbers depend on
  bool is_place = false;             // of items: a key; its differences are distances between items
  LaunchColumn launch_columns[3]{};  // where studies draw it, by component, if launches have a column for it
  WeatherColumn weather_columns[3]{};

  /// Whether studies refuse a draw at or below zero.
  [[nodiscard]] constexpr bool is_above_zero() const {
    return drawn_above_zero || (range.low >= 0 && !range.contains(0));
  }
};

/// A row and the member that it is about. `elements`: the rows of an item, of a list.
template <class Get, class Elements = std::tuple<>>
struct MemberRow : SettingRow {
  Get get;
  const Elements* elements;
};

/// The rows of an item of list `i`.
template <const auto& rows, std::size_t i>
inline constexpr const auto& kItemRows = *std::get<i>(rows).elements;

namespace setting_rows {

/// Sets a member of a row.
template <class T>
struct With {
  T SettingRow::*member;
  T value;
};
constexpr With<std::optional<Range>> in_files(const Range& range) { return {&SettingRow::in_files, range}; }
constexpr With<std::string_view> hint(std::string_view text) { return {&SettingRow::hint, text}; }
constexpr With<std::string_view> own_unit(std::string_view text) { return {&SettingRow::unit, text}; }
constexpr With<std::string_view> absent(std::string_view word) { return {&SettingRow::none, word}; }

template <class Columns>
struct DrawnInto {
  std::span<const double> Columns::*columns[3];
};
template <class Columns>
constexpr DrawnInto<Columns> drawn_into(std::span<const double> Columns::*x, std::span<const double> Columns::*y = {},
                                        std::span<const double> Columns::*z = {}) {
  return {{x, y, z}};
}

inline constexpr bool SettingRow::*kRequired = &SettingRow::required, SettingRow::*kShorthand = &SettingRow::shorthand,
                      SettingRow::*kPreset = &SettingRow::starts, SettingRow::*kLive = &SettingRow::live,
                      SettingRow::*kContact = &SettingRow::of_contact, SettingRow::*kUncertain = &SettingRow::uncertain,
                      SettingRow::*kByFactor = &SettingRow::by_factor,
                      SettingRow::*kDrawnAboveZero = &SettingRow::drawn_above_zero,
                      SettingRow::*kKey = &SettingRow::is_key, SettingRow::*kPlace = &SettingRow::is_place;

constexpr void say(SettingRow& row, Quantity quantity) { row.quantity = quantity; }
constexpr void say(SettingRow& row, const Range& range) { row.range = range; }
template <class T>
constexpr void say(SettingRow& row, const With<T>& with) {
  row.*with.member = with.value;
}
constexpr void say(SettingRow& row, bool SettingRow::*trait) {
  row.*trait = true;
  row.is_key = row.is_key || row.is_place;
}
template <class Columns>
constexpr void say(SettingRow& row, const DrawnInto<Columns>& drawn) {
  row.uncertain = true;
  for (int i = 0; i < 3; ++i)
    if constexpr (std::is_same_v<Columns, Weather>)
      row.weather_columns[i] = drawn.columns[i];
    else
      row.launch_columns[i] = drawn.columns[i];
}
/// The last value of an enumeration: a cast can make others.
template <class Enum>
requires std::is_enum_v<Enum>
constexpr void say(SettingRow& row, Enum last) { row.range = {.low = 0, .high = static_cast<double>(last)}; }

inline constexpr std::tuple<> kNoItems;

/// A row; `said` is what else there is to say about the setting, in any order.
template <class Get, class Items, class... Said>
constexpr MemberRow<Get, Items> row_of(std::string_view path, Get get, const Items& items, std::string_view doc,
                                       Said... said) {
  MemberRow<Get, Items> row{{.path = path, .doc = doc}, get, &items};
  (say(row, said), ...);
  PHYSIM_ASSERT(row.range.low <= row.range.high);
  return row;
}

/// A row of a member; its path is how C++ names it.
#define PHYSIM_SETTING(member, ...) PHYSIM_SETTING_AS(#member, member, kNoItems, __VA_ARGS__)
/// A row of a list; its items have their own rows.
#define PHYSIM_SETTING_LIST(member, items, ...) PHYSIM_SETTING_AS(#member, member, items, __VA_ARGS__)
#define PHYSIM_SETTING_AS(path, member, items, ...) \
  row_of(                                           \
      path, [](auto& owner) -> auto& { return owner.member; }, items, __VA_ARGS__)

}  // namespace setting_rows

// ---------------------------------------------------------------------------------------------------------------
// checks
/// Whether a range leaves out no value of an integral type.
template <class T>
constexpr bool is_whole_type(const Range& range) {
  return range.low <= static_cast<double>(std::numeric_limits<T>::min()) &&
         range.high >= static_cast<double>(std::numeric_limits<T>::max());
}

/// Whether what a row is about is in its range.
template <class T>
PHYSIM_INLINE_ALWAYS bool is_in_range(const SettingRow& row, const T& value) {
  const Range& range = row.range;
  if constexpr (std::is_same_v<T, double>)
    return range.contains(value);
  else if constexpr (std::is_same_v<T, Vec3d>)
    return range.contains(value.x) & range.contains(value.y) & range.contains(value.z);
  else if constexpr (std::is_same_v<T, std::optional<double>> || std::is_same_v<T, std::optional<Vec3d>>)
    return !value || is_in_range(row, *value);
  else if constexpr (std::is_enum_v<T>)
    return static_cast<unsigned>(value) <= static_cast<unsigned>(range.high);
  else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
    return is_whole_type<T>(range) || range.contains(static_cast<double>(value));
  else
    return true;
}

PHYSIM_INLINE_ALWAYS double sum_of(double x) { return x; }
PHYSIM_INLINE_ALWAYS double sum_of(const Vec3d& v) { return v.x + v.y + v.z; }

/// Looks at the members of `count` rows from the row `first` on. Clears `good` if one is out of bounds. Returns the sum
/// of those that may be any number, added in pairs: it is finite only if each of them is.
template <const auto& rows, std::size_t first, std::size_t count, class Owner>
PHYSIM_INLINE_ALWAYS double look_at_rows(const Owner& owner, bool& good) {
  if constexpr (count > 1) {
    const double sum = look_at_rows<rows, first, count / 2>(owner, good);
    return sum + look_at_rows<rows, first + count / 2, count - count / 2>(owner, good);
  } else {
    static constexpr const auto& row = std::get<first>(rows);
    const auto& value = row.get(owner);
    if constexpr (row.range.is_any_number() && requires { sum_of(value); }) return sum_of(value);
    good &= is_in_range(row, value);
    return -0.0;  // which a sum keeps out at no cost, whatever the other number is
  }
}

/// Whether all members that lists of rows are about are surely in range: by sums, which may overflow.
template <const auto&... rows, class Owner>
PHYSIM_INLINE_ALWAYS bool are_in_range(const Owner& owner) {
  bool good = true;
  const double sum = (look_at_rows<rows, 0, std::tuple_size_v<std::decay_t<decltype(rows)>>>(owner, good) + ...);
  return good & (sum - sum == 0);
}

/// The unit of a row in SI; empty: none.
[[nodiscard]] std::string_view unit_of(const SettingRow& row);
/// "must lie between 0 and 1, not 60"
[[nodiscard]] std::string range_error(const SettingRow& row, double value);
/// The hint of an error about a row: "in kg: of the projectile".
[[nodiscard]] std::string hint_of(const SettingRow& row);

/// The number of a value that is out of a range: the first one of a vector.
template <class T>
double bad_number(const Range& range, const T& value) {
  if constexpr (std::is_same_v<T, Vec3d>)
    return !range.contains(value.x) ? value.x : !range.contains(value.y) ? value.y : value.z;
  else if constexpr (requires { *value; })
    return bad_number(range, *value);
  else if constexpr (std::is_arithmetic_v<T>)
    return static_cast<double>(value);
  else
    return 0;  // texts and lists are never out of range
}

/// The first member of a list of rows that is out of range.
struct OutOfRange {
  const SettingRow* row = nullptr;  // null: there is none
  double value = 0;
  bool is_enumerator = false;
};
template <const auto& rows, class Owner>
[[gnu::noinline, gnu::cold]] OutOfRange first_out_of_range(const Owner& owner) {
  OutOfRange first;
  const auto look = [&](const auto& row) {
    const auto& value = row.get(owner);
    if (first.row || is_in_range(row, value)) return;
    first = {&row, bad_number(row.range, value), std::is_enum_v<std::decay_t<decltype(value)>>};
  };
  std::apply([&](const auto&... row) { (look(row), ...); }, rows);
  return first;
}
/// Its error. `place`: what stands before the path of the row, or the place of the item that the row is of.
[[nodiscard]] Status error_of(const OutOfRange& first, const InputPlace& place, bool is_item);

/// Refuses the first member that is out of the range of its row. `before`: what stands before its path, "launch.".
template <const auto&... rows, class Owner>
PHYSIM_INLINE_ALWAYS void check_rows(Checker& c, const Owner& owner, const InputPlace& before) {
  if (are_in_range<rows...>(owner)) return;
  (c.also(error_of(first_out_of_range<rows>(owner), before, false)), ...);
}
/// Refuses the first item of a list that has a number out of range.
template <const auto& rows, class Item>
void check_items(Checker& c, const std::vector<Item>& items, InputPlace::Text list) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!are_in_range<rows>(items[i])) c.also(error_of(first_out_of_range<rows>(items[i]), InputPlace(list, i), true));
}

}  // namespace physim
