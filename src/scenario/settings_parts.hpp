// What the list of settings is written with: ranges, slots made from the types of fields, rows.
#pragma once

#include <deque>
#include <utility>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "model/ladder.hpp"
#include "scenario/schema.hpp"

namespace physim {

using namespace setting_rows;

inline constexpr Range kCurveKeys = {.low = 0, .high = 10'000};  // of a curve or gradient of an emitter
inline constexpr Range kBelowRightAngle = {.low = 0, .high = kRightAngle, .words = "0 .. 90 deg"};
inline constexpr Range kToBothSides = {.low = 0, .high = 2 * kRightAngle, .words = "0 .. 180 deg"};

// --------------------------------------------------------------------------------------------- slots from field types
/// Points as pairs: two members of an item, each with a row.
template <class List, class First, class Second>
ValueRef points(List& list, const First& first, const Second& second) {
  return Points{{first.doc, second.doc},
                {first.quantity, second.quantity},
                [&list, first = first.get, second = second.get] {
                  Points::Pairs pairs;
                  for (auto& point : list) pairs.emplace_back(first(point), second(point));
                  return pairs;
                },
                [&list, first = first.get, second = second.get](const Points::Pairs& pairs) {
                  list.clear();
                  for (const auto& [x, y] : pairs) list.emplace_back(), first(list.back()) = x, second(list.back()) = y;
                },
                {first.range, second.range}};
}
inline constexpr auto kCurveKeyRows = std::tuple{
    PHYSIM_SETTING(at, "part of the span", kFraction),
    PHYSIM_SETTING(value, "value"),
};
inline ValueRef points_of(Curve& curve) {
  return points(curve, std::get<0>(kCurveKeyRows), std::get<1>(kCurveKeyRows));
}

/// A list of tables; in the scope of an element, the pointer for its kind points to it.
template <class T>
ValueRef records(const Scope& outer, std::vector<T>& list) {
  return Records{[&list] { return list.size(); }, [&list](std::size_t size) { list.resize(size); },
                 [&list, outer](std::size_t i) {
                   PHYSIM_ASSERT(i < list.size());
                   Scope inner = outer;
                   std::get<T*&>(inner.pointers()) = &list[i];
                   return inner;
                 }};
}

/// One of several names; their places in the list are the values.
template <class T>
Choice choice(std::span<const std::string_view> names, T& value) {
  return {names, [&value] { return std::optional(static_cast<std::size_t>(value)); },
          [=, &value](std::size_t i) {
            PHYSIM_ASSERT(i < names.size());
            value = static_cast<T>(i);
          }};
}

/// ... the one that is there is the first for which `is` holds; none: no name fits what is there.
template <class Is, class Set>
Choice choice_where(std::span<const std::string_view> names, Is is, Set set) {
  return {names,
          [=]() -> std::optional<std::size_t> {
            for (std::size_t i = 0; i < names.size(); ++i)
              if (is(i)) return i;
            return std::nullopt;
          },
          [=](std::size_t i) {
            PHYSIM_ASSERT(i < names.size());
            set(i);
          }};
}

/// A number that other settings say, too, which alone are written.
template <class Set>
ValueRef said_elsewhere(Set set) {
  return OptionalNumber{[] { return std::optional<double>(); },
                        [set](std::optional<double> value) {
                          if (value) set(*value);
                        }};
}

template <class T>
ValueRef slot_of(const Scope& scope, T& value) {
  if constexpr (std::is_enum_v<T>) {
    Choice slot = choice(names_of<T>(), value);
    if constexpr (requires { row(T{}).doc; }) slot.doc = [](std::size_t i) { return row(static_cast<T>(i)).doc; };
    return slot;
  } else if constexpr (std::is_same_v<T, std::optional<double>>) {
    return OptionalNumber{[&value] { return value; }, [&value](std::optional<double> v) { value = v; }};
  } else if constexpr (std::is_same_v<T, std::optional<std::uint64_t>>) {
    return OptionalInteger{[&value] { return value ? std::optional(static_cast<std::int64_t>(*value)) : std::nullopt; },
                           [&value](std::optional<std::int64_t> v) {
                             PHYSIM_ASSERT(!v || *v >= 0);  // by the range of the setting
                             value = v ? std::optional(static_cast<std::uint64_t>(*v)) : std::nullopt;
                           }};
  } else if constexpr (std::is_constructible_v<ValueRef, T*>) {
    return &value;
  } else if constexpr (std::is_integral_v<T>) {
    return Integer{[&value] { return static_cast<std::int64_t>(value); },
                   [&value](std::int64_t v) {
                     PHYSIM_ASSERT(std::in_range<T>(v));  // by the range of the setting
                     value = static_cast<T>(v);
                   }};
  } else if constexpr (requires { points_of(value); }) {
    return points_of(value);
  } else {
    return records(scope, value);
  }
}

// ---------------------------------------------------------------------------------------------------------------- rows
/// A quantity that another setting decides; `unit` says which: "of the kind".
struct QuantityBy {
  Quantity (*quantity)(const Scope&);
  std::string_view unit;
};
/// Another setting decides whether there is a value to write.
struct WhereTrue {
  bool (*is_there)(const Scope&);
};
constexpr void say(Entry& entry, WhereTrue where) { entry.is_there = where.is_there; }
constexpr void say(Entry& entry, QuantityBy by) {
  entry.quantity_by = by.quantity;
  entry.unit_by = by.unit;
}

/// A row of the list; `said` is what else there is to say about the setting, in any order.
template <class... Said>
constexpr Entry setting(std::string_view path, ValueRef (*slot)(const Scope&), std::string_view doc, Said... said) {
  Entry entry{{.path = path, .doc = doc}, slot};
  (say(entry, said), ...);
  return entry;
}

template <class Item, class Pointers>
inline constexpr bool kIsAmong = false;
template <class Item, class... Pointers>
inline constexpr bool kIsAmong<Item, std::tuple<Pointers...>> = (std::is_same_v<Item*&, Pointers> || ...);
/// Items that a file has as tables.
template <class Item>
concept ItemOfScope = kIsAmong<Item, decltype(std::declval<Scope&>().pointers())>;
template <ItemOfScope Item>
Item& item_of(const Scope& scope) {
  Scope own = scope;
  PHYSIM_ASSERT(std::get<Item*&>(own.pointers()) != nullptr);
  return *std::get<Item*&>(own.pointers());
}

/// Items that a file has as pairs of numbers.
template <class Item>
inline constexpr bool kIsPair =
    std::is_same_v<Item, DragPoint> || std::is_same_v<Item, ThrustPoint> || std::is_same_v<Item, PropellantPoint>;

/// The slot of row `i`; its member is in what `owner` finds.
template <auto owner, const auto& rows, std::size_t i>
ValueRef slot_of_row(const Scope& scope) {
  auto& value = std::get<i>(rows).get(owner(scope));
  if constexpr (requires { requires kIsPair<std::decay_t<decltype(value.front())>>; })
    return points(value, std::get<0>(kItemRows<rows, i>), std::get<1>(kItemRows<rows, i>));
  else
    return slot_of(scope, value);
}

template <class List>
concept ListOfItems = ItemOfScope<typename List::value_type>;

template <auto owner, const auto& rows>
void add_rows(std::vector<Entry>& list, const std::string& before);

/// Adds the entry of row `i`. It is no lambda of add_rows(): clang 19 does not survive that.
template <auto owner, const auto& rows, std::size_t i>
void add_row(std::vector<Entry>& list, const std::string& before) {
  static std::deque<std::string> paths;  // what the entries refer to
  const auto& row = std::get<i>(rows);
  paths.push_back(before + std::string(row.path));
  Entry& entry = list.emplace_back(Entry{row, slot_of_row<owner, rows, i>});
  entry.path = paths.back();
  entry.range = row.in_files.value_or(row.range);
  using List = std::decay_t<decltype(row.get(owner(Scope{})))>;
  if constexpr (ListOfItems<List>)
    add_rows<item_of<typename List::value_type>, kItemRows<rows, i>>(list, paths.back() + ".");
}

/// Adds entries of rows, and behind each list those of its items where these are tables. `before`: what stands before
/// the paths of the rows in a file.
template <auto owner, const auto& rows>
void add_rows(std::vector<Entry>& list, const std::string& before) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (add_row<owner, rows, i>(list, before), ...); }
  (std::make_index_sequence<std::tuple_size_v<std::decay_t<decltype(rows)>>>());
}

inline void add(std::vector<Entry>& list, std::span<const Entry> more) {
  list.insert(list.end(), more.begin(), more.end());
}

inline ProjectileDef& projectile_in(const Scope& scope) { return scope.shot->projectile; }
inline Launch& launch_in(const Scope& scope) { return scope.shot->launch; }
inline Fidelity& fidelity_in(const Scope& scope) { return scope.shot->projectile.fidelity; }
inline Tolerance& tolerance_in(const Scope& scope) { return scope.scenario->tolerance; }
inline Until& until_in(const Scope& scope) { return scope.scenario->until; }
inline Environment& environment_in(const Scope& scope) { return scope.scenario->environment; }

#define PHYSIM_FIELD(...) [](const Scope& s) { return slot_of(s, s.__VA_ARGS__); }
/// A row of a table with keys that are called as the fields of what a pointer of Scope points to.
#define PHYSIM_ROW(table, pointer, field, ...) setting(table "." #field, PHYSIM_FIELD(pointer->field), __VA_ARGS__)
/// A row of what a scenario calls as its file does.
#define PHYSIM_SCENARIO(field, ...) setting(#field, PHYSIM_FIELD(scenario->field), __VA_ARGS__)
/// Rows of how something is turned (ScenarioRotation).
#define PHYSIM_ROTATION(table, pointer)                                                                       \
  PHYSIM_ROW(table, pointer, rotation.axis, "that it is turned about, instead of yaw, pitch and roll"),       \
      PHYSIM_ROW(table, pointer, rotation.angle, "about the axis, right-handed", Quantity::angle, kTurn),     \
      PHYSIM_ROW(table, pointer, rotation.yaw, "of its x axis, to the right, first", Quantity::angle, kTurn), \
      PHYSIM_ROW(table, pointer, rotation.pitch, "of its x axis, up, second", Quantity::angle, kTurn),        \
      PHYSIM_ROW(table, pointer, rotation.roll, "about its x axis, right side down, third", Quantity::angle, kTurn)
/// Rows of where something is at a time (ScenarioKey).
#define PHYSIM_KEYS(table)                                                                                   \
  PHYSIM_ROW(table, key, time, "of the world; without one, since the launch", Quantity::time),               \
      PHYSIM_ROW(table, key, position, "of its origin then", Quantity::length), PHYSIM_ROTATION(table, key), \
      PHYSIM_ROW(table, key, velocity, "of its origin then, for curve = \"smooth\"", Quantity::speed)

// ------------------------------------------------------------------------- parts of the list in files of their own
[[nodiscard]] std::span<const Entry> shot_settings();     // [[shot]], but for [shot.body]
[[nodiscard]] std::span<const Entry> world_settings();    // [shot.body], [world], [[volley]]
[[nodiscard]] std::span<const Entry> force_settings();    // [[force]]
[[nodiscard]] std::span<const Entry> scene_settings();    // [[material]], [[shape]], [[thing]]
[[nodiscard]] std::span<const Entry> emitter_settings();  // [[emitter]]
[[nodiscard]] std::span<const Entry> joint_settings();    // [[joint]]
[[nodiscard]] std::span<const Entry> study_settings();    // [study]

/// Names of the kinds of a [[shape]].
[[nodiscard]] std::span<const std::string_view> shape_kinds();

}  // namespace physim
