// What the parts of the list of settings are written with: ranges, slots made from the types of fields.
#pragma once

#include "base/assert.hpp"
#include "model/ladder.hpp"
#include "scenario/schema.hpp"

namespace physim {

inline constexpr double kRightAngle = 1.5707963267948966;

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

// --------------------------------------------------------------------------------------------- slots from field types
template <class T>
ValueRef slot_of(T& value) {
  if constexpr (std::is_enum_v<T>) {
    Choice choice{names_of<T>(), [&value] { return std::optional(static_cast<std::size_t>(value)); },
                  [&value](std::size_t i) {
                    PHYSIM_ASSERT(i < names_of<T>().size());
                    value = static_cast<T>(i);
                  }};
    if constexpr (requires { row(T{}).doc; }) choice.doc = [](std::size_t i) { return row(static_cast<T>(i)).doc; };
    return choice;
  } else if constexpr (std::is_same_v<T, std::optional<double>>) {
    return OptionalNumber{[&value] { return value; }, [&value](std::optional<double> v) { value = v; }};
  } else if constexpr (std::is_same_v<T, std::uint32_t>) {
    return Integer{[&value] { return std::int64_t{value}; },
                   [&value](std::int64_t v) { value = static_cast<std::uint32_t>(v); }};
  } else {
    return &value;
  }
}

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
inline ValueRef curve_slot(std::vector<DragPoint>& curve) {
  return points(curve, &DragPoint::mach, &DragPoint::coefficient,
                {{"Mach number", "drag coefficient"}, {Quantity::number, Quantity::number}, {}, {}});
}

/// A list of tables; in the scope of an element, the pointer for its kind points to it.
template <class T>
ValueRef records(const Scope& outer, std::vector<T>& list, T* Scope::*pointer) {
  return Records{[&list] { return list.size(); }, [&list](std::size_t size) { list.resize(size); },
                 [&list, outer, pointer](std::size_t i) {
                   PHYSIM_ASSERT(i < list.size());
                   Scope inner = outer;
                   inner.*pointer = &list[i];
                   return inner;
                 }};
}

#define PHYSIM_FIELD(...) [](const Scope& s) { return slot_of(s.__VA_ARGS__); }
#define PHYSIM_RECORDS(list, pointer) [](const Scope& s) { return records(s, s.list, &Scope::pointer); }

// ------------------------------------------------------------------------- parts of the list in files of their own
[[nodiscard]] std::span<const Entry> magnus_settings();    // [shot.magnus], [shot.spin]
[[nodiscard]] std::span<const Entry> motor_settings();     // [shot.motor]
[[nodiscard]] std::span<const Entry> rotation_settings();  // [shot.inertia], [shot.aero], [shot.attitude]
[[nodiscard]] std::span<const Entry> body_settings();      // [shot.body]
[[nodiscard]] std::span<const Entry> world_settings();     // [world]
[[nodiscard]] std::span<const Entry> volley_settings();    // [[volley]]
[[nodiscard]] std::span<const Entry> force_settings();     // [[force]]
[[nodiscard]] std::span<const Entry> target_settings();    // [target]
[[nodiscard]] std::span<const Entry> expect_settings();    // [[expect]]

}  // namespace physim
