// SettingRow: the definition of a setting, which scenario files and studies read. The tests hold its range against
// check().
//
// A list of rows is a tuple, so that each row keeps the type of its member.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "base/assert.hpp"
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
  Range range{};                     // of numbers and components; the length of lists
  std::optional<Range> in_files{};   // what scenario files accept, where that differs
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

/// The unit of a row in SI; empty: none.
[[nodiscard]] std::string_view unit_of(const SettingRow& row);

}  // namespace physim
