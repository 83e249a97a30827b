// The events that flights and worlds look for in their steps.
#pragma once

#include "solve/watch.hpp"

namespace physim {

/// Whether a flight ends at the lower end of the standard atmosphere.
[[nodiscard]] bool has_lowest_altitude(const Fidelity& granted);

/// What looks for events. Some are reported without a request: the table of events says by which watchers.
enum class Watcher : std::uint8_t { batch, flight, world, world_with_apexes };

/// Ground, range, time (where it is finite) and the lower end of the air as terminal events; the reported events; then
/// the requested ones.
[[nodiscard]] WatchList prepare_watch(const Until& until, const Conditions<double>& conditions, Watcher watcher);

/// Whether a flight is over before it begins, and how it ends then: it starts on or below the ground and descends, or
/// below the air.
[[nodiscard]] bool ends_at_once(const Conditions<double>& conditions, const Body<double>& body, const Until& until,
                                Outcome& outcome);

}  // namespace physim
