// What the list of settings is written with: ranges, slots made from the types of fields, rows.
#pragma once

#include <utility>

#include "base/assert.hpp"
#include "math/angles.hpp"
#include "model/ladder.hpp"
#include "scenario/schema.hpp"

namespace physim {

// -------------------------------------------------------------------------------------------------------------- ranges
constexpr Range above(double low) { return {.low = low, .low_open = true}; }
constexpr Range at_least(double low) { return {.low = low}; }
constexpr Range at_most(double high) { return {.low = 0, .high = high}; }
constexpr Range between(double low, double high) { return {.low = low, .high = high}; }
constexpr Range or_infinite(Range range) {
  range.infinite = true;
  return range;
}
inline constexpr Range kHalfTurn = {.low = -kRightAngle, .high = kRightAngle, .words = "-90 deg .. 90 deg"};
inline constexpr Range kTurn = {.low = -4 * kRightAngle, .high = 4 * kRightAngle, .words = "-360 deg .. 360 deg"};
inline constexpr Range kBits = {.low = 0, .high = 4294967295.0};
inline constexpr Range kFraction = {.low = 0, .high = 1};
inline constexpr Range kCurveKeys = {.low = 0, .high = 10'000};  // of a curve or gradient of an emitter
inline constexpr Range kBelowRightAngle = {.low = 0, .high = kRightAngle, .words = "0 .. 90 deg"};
inline constexpr Range kToBothSides = {.low = 0, .high = 2 * kRightAngle, .words = "0 .. 180 deg"};

// --------------------------------------------------------------------------------------------- slots from field types
/// Points as pairs of two of their fields.
template <class Point>
ValueRef points(std::vector<Point>& list, double Point::*first, double Point::*second, Points described) {
  described.get = [&list, first, second] {
    Points::Pairs pairs;
    for (const Point& point : list) pairs.emplace_back(point.*first, point.*second);
    return pairs;
  };
  described.set = [&list, first, second](const Points::Pairs& pairs) {
    list.clear();
    for (const auto& [x, y] : pairs) list.emplace_back(), list.back().*first = x, list.back().*second = y;
  };
  return described;
}
inline ValueRef points_of(std::vector<DragPoint>& list) {
  return points(list, &DragPoint::mach, &DragPoint::coefficient,
                {{"Mach number", "drag coefficient"}, {Quantity::number, Quantity::number}, {}, {}});
}
inline ValueRef points_of(std::vector<ThrustPoint>& list) {
  return points(list, &ThrustPoint::time, &ThrustPoint::force,
                {{"time", "thrust"}, {Quantity::time, Quantity::force}, {}, {}});
}
inline ValueRef points_of(std::vector<PropellantPoint>& list) {
  return points(list, &PropellantPoint::time, &PropellantPoint::mass,
                {{"time", "mass"}, {Quantity::time, Quantity::mass}, {}, {}});
}
inline ValueRef points_of(Curve& curve) {
  return points(
      curve, &CurveKey::at, &CurveKey::value,
      {{"part of the span", "value"}, {Quantity::number, Quantity::number}, {}, {}, {{.low = 0, .high = 1}, {}}});
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

/// One of several names, whose places in the list are the values.
template <class T>
Choice choice(std::span<const std::string_view> names, T& value) {
  return {names, [&value] { return std::optional(static_cast<std::size_t>(value)); },
          [=, &value](std::size_t i) {
            PHYSIM_ASSERT(i < names.size());
            value = static_cast<T>(i);
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
/// How the absence of a value is written.
struct Absent {
  std::string_view word;
};
enum class Trait { required, shorthand, preset, live, contact };
inline constexpr Trait kRequired = Trait::required, kShorthand = Trait::shorthand, kPreset = Trait::preset,
                       kLive = Trait::live, kContact = Trait::contact;

constexpr void say(Entry& entry, Quantity quantity) { entry.quantity = quantity; }
constexpr void say(Entry& entry, const Range& range) { entry.range = range; }
constexpr void say(Entry& entry, Absent absent) { entry.none = absent.word; }
constexpr void say(Entry& entry, WhereTrue where) { entry.is_there = where.is_there; }
constexpr void say(Entry& entry, Trait trait) {
  switch (trait) {
    case Trait::required: entry.required = true; return;
    case Trait::shorthand: entry.shorthand = true; return;
    case Trait::preset: entry.starts = true; return;
    case Trait::live: entry.live = true; return;
    case Trait::contact: entry.of_contact = true; return;
  }
}
constexpr void say(Entry& entry, QuantityBy by) {
  entry.quantity_by = by.quantity;
  entry.unit_by = by.unit;
}

/// A row of the list; `said` is what else there is to say about the setting, in any order.
template <class... Said>
constexpr Entry setting(std::string_view path, ValueRef (*slot)(const Scope&), std::string_view doc, Said... said) {
  Entry entry{.path = path, .slot = slot, .doc = doc};
  (say(entry, said), ...);
  return entry;
}

#define PHYSIM_FIELD(...) [](const Scope& s) { return slot_of(s, s.__VA_ARGS__); }
/// A row of a table whose keys are called as the fields of what a pointer of Scope points to.
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

}  // namespace physim
