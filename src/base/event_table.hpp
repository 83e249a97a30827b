// The table of events: a row for each EventKind. It gives the name of an event, what it watches, what reports it, and
// the order of events of one moment.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/assert.hpp"
#include "base/enumerators.hpp"
#include "physim/event.hpp"

namespace physim {

/// The number that an event waits for, less the value that it waits for, changes its sign in it.
enum class Watch : std::uint8_t {
  none,  // nothing is watched: a rule or a call of a world reports it
  height,
  climb_rate,
  range,
  mach,
  speed,
  time,
  ignition,
  burnout,
  rail,
};

/// Whether turning points of the number are looked for inside steps.
[[nodiscard]] PHYSIM_INLINE constexpr bool may_turn(Watch watch) {
  return watch == Watch::height || watch == Watch::range || watch == Watch::speed;
}

/// What must be there for it to happen.
enum class Needs : std::uint8_t { nothing, motor, rail };

/// Whether worlds report it without a request.
enum class InWorlds : std::uint8_t { never, always, with_apexes };  // WorldDef::apex_events

struct EventRow {
  EventKind kind;
  std::string_view name;
  Watch watch = Watch::none;
  bool waits_for_value = false;  // of the EventSpec that requests it; else for `value`
  double value = 0;              // [unit of what is watched]
  Needs needs = Needs::nothing;
  bool in_flights = false;  // flights report it without a request
  InWorlds in_worlds = InWorlds::never;
  Crossing direction = Crossing::any;  // which crossings count without a request
  std::uint8_t order = 0;              // in worlds, among events of one projectile at one time
};

constexpr auto kEventTable = [] {
  using K = EventKind;
  // Events that are reported only if an EventSpec requests them.
  const auto asked = [](EventKind kind, std::string_view name, Watch watch) {
    return EventRow{.kind = kind, .name = name, .watch = watch, .waits_for_value = true};
  };
  // What happens to every projectile that has a motor or a rail.
  const auto stop = [](EventKind kind, std::string_view name, Watch watch, Needs needs, std::uint8_t order) {
    return EventRow{.kind = kind,
                    .name = name,
                    .watch = watch,
                    .needs = needs,
                    .in_flights = true,
                    .in_worlds = InWorlds::always,
                    .direction = Crossing::rising,
                    .order = order};
  };
  // Events that a rule or a call of a world reports.
  const auto rule = [](EventKind kind, std::string_view name, std::uint8_t order) {
    return EventRow{.kind = kind, .name = name, .in_worlds = InWorlds::always, .order = order};
  };
  return std::array{
      asked(K::ground, "ground", Watch::height),
      EventRow{.kind = K::apex,
               .name = "apex",
               .watch = Watch::climb_rate,
               .in_flights = true,
               .in_worlds = InWorlds::with_apexes,
               .direction = Crossing::falling,
               .order = 6},
      asked(K::range, "range", Watch::range),
      asked(K::height, "height", Watch::height),
      asked(K::mach, "mach", Watch::mach),
      asked(K::speed, "speed", Watch::speed),
      asked(K::time, "time", Watch::time),
      stop(K::ignition, "ignition", Watch::ignition, Needs::motor, 18),
      stop(K::burnout, "burnout", Watch::burnout, Needs::motor, 19),
      stop(K::rail_exit, "rail_exit", Watch::rail, Needs::rail, 20),
      rule(K::spawned, "spawned", 1),
      rule(K::landed, "landed", 5),
      rule(K::bounced, "bounced", 7),
      rule(K::slept, "slept", 12),
      rule(K::woke, "woke", 14),
      rule(K::expired, "expired", 15),
      rule(K::retired, "retired", 16),
      rule(K::fidelity_changed, "fidelity_changed", 17),
      rule(K::hit, "hit", 4),
      rule(K::entered, "entered", 3),
      rule(K::left, "left", 11),
      rule(K::sensed, "sensed", 2),
      rule(K::ricocheted, "ricocheted", 8),
      rule(K::penetrated, "penetrated", 9),
      rule(K::stopped, "stopped", 10),
      rule(K::stayed, "stayed", 13),
  };
}();
constexpr std::size_t kEventKinds = kEventTable.size();

static_assert(has_row_for_each(kEventTable, &EventRow::kind), "a kind has no row");
static_assert(std::ranges::is_partitioned(kEventTable, [](const EventRow& row) { return row.watch != Watch::none; }),
              "kinds that an EventSpec may request come first");

/// Number of kinds that an EventSpec may request: the first ones.
constexpr std::size_t watchable_kinds() {
  std::size_t count = 0;
  while (count < kEventKinds && kEventTable[count].watch != Watch::none) ++count;
  return count;
}

[[nodiscard]] PHYSIM_INLINE constexpr const EventRow& row_of(EventKind kind) {
  PHYSIM_ASSERT(static_cast<std::size_t>(kind) < kEventKinds);
  return kEventTable[static_cast<std::size_t>(kind)];
}

/// Ignition, burnout or the end of the rail.
[[nodiscard]] constexpr bool is_of_motor_or_rail(EventKind kind) { return row_of(kind).needs != Needs::nothing; }

/// Whether an EventSpec may request it.
[[nodiscard]] constexpr bool is_watchable(EventKind kind) { return static_cast<std::size_t>(kind) < watchable_kinds(); }

}  // namespace physim
