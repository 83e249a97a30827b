// Which events are looked for, and flights that end before their first step.
#include "prepare/watch_list.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/assert.hpp"
#include "model/acceleration.hpp"
#include "model/standard_atmosphere.hpp"
#include "solve/explicit_runge_kutta.hpp"

namespace physim {
namespace {

/// What cannot happen is not looked for: without motors and rails their numbers are not there.
bool may_happen(const EventRow& row, const Conditions<double>& c) {
  switch (row.needs) {
    case Needs::motor: return c.has_motor;
    case Needs::rail: return c.has_rail;
    case Needs::nothing: break;
  }
  return true;
}

/// Whether it is reported without a request.
bool is_told(const EventRow& row, Watcher watcher) {
  switch (watcher) {
    case Watcher::batch: return false;
    case Watcher::flight: return row.in_flights;
    case Watcher::world: return row.in_worlds == InWorlds::always;
    case Watcher::world_with_apexes: break;
  }
  return row.in_worlds != InWorlds::never;
}

/// An event that is reported anyway and that a spec requests again: reported once, it may end the flight.
Watched* told_anyway(WatchList& watch, const EventSpec& spec, const EventRow& row) {
  if (row.waits_for_value) return nullptr;
  for (int i = 0; i < watch.count; ++i) {
    const EventSpec& known = watch.item[i].spec;
    if (known.kind == spec.kind && (known.direction == spec.direction || spec.direction == Crossing::any))
      return &watch.item[i];
  }
  return nullptr;
}

bool has_dense_stages(const Fidelity& f) {
  return with_method(f.integrator, [](auto method) { return HasDenseStages<decltype(method)>; });
}

/// A Mach number needs air and wind, a speed needs what changes it where it turns, and some interpolants need more
/// slopes. A closed form flies on in the wind.
bool is_without_air(const WatchList& watch, const Fidelity& f) {
  if (f.motion == Motion::closed_form || turns(f) || has_dense_stages(f)) return false;
  return std::all_of(watch.item, watch.item + watch.count, [](const Watched& watched) {
    const Watch kind = row_of(watched.spec.kind).watch;
    return kind != Watch::mach && kind != Watch::speed;
  });
}

}  // namespace

bool has_lowest_altitude(const Fidelity& f) { return f.air == AirModel::isa && f.drag == DragModel::equation; }

WatchList prepare_watch(const Until& until, const Conditions<double>& c, Watcher watcher) {
  WatchList watch;
  watch.lands = watcher == Watcher::flight || watcher == Watcher::batch;
  const auto add = [&](const EventSpec& spec, Outcome outcome) {
    PHYSIM_ASSERT(watch.count < kMaxWatched);
    PHYSIM_ASSERT(row_of(spec.kind).watch != Watch::none);
    watch.item[watch.count++] = {spec, outcome};
  };
  if (until.ground) add({EventKind::ground, *until.ground, Crossing::falling, true}, Outcome::landed);
  if (until.range) add({EventKind::range, *until.range, Crossing::rising, true}, Outcome::reached_range);
  if (std::isfinite(until.time)) add({EventKind::time, until.time, Crossing::rising, true}, Outcome::time_limit);
  if (has_lowest_altitude(c.fidelity))
    add({EventKind::height, kLowestAltitude - c.altitude, Crossing::falling, true}, Outcome::left_domain);
  for (const EventRow& row : std::span(kEventTable).first<watchable_kinds()>())
    if (is_told(row, watcher) && may_happen(row, c)) add({row.kind, row.value, row.direction, false}, Outcome::event);
  for (EventSpec spec : until.events) {
    PHYSIM_ASSERT(is_watchable(spec.kind));
    const EventRow& row = row_of(spec.kind);
    if (!may_happen(row, c)) continue;
    if (!row.waits_for_value) spec.value = row.value;
    if (Watched* told = told_anyway(watch, spec, row))
      told->spec.terminal |= spec.terminal;
    else
      add(spec, Outcome::event);
  }
  watch.without_air = is_without_air(watch, c.fidelity);
  return watch;
}

bool ends_at_once(const Conditions<double>& c, const Body<double>& b, const Until& until, Outcome& outcome) {
  outcome = Outcome::left_domain;
  if (has_lowest_altitude(c.fidelity) && altitude(c, b.launch.x) <= kLowestAltitude) return true;
  outcome = Outcome::landed;
  if (!until.ground || height(c, b.launch.x) > *until.ground) return false;
  if (b.rail_phase < kOffRail && b.rail.y >= 0) return false;  // its rail stands on the ground
  const double climb = climb_rate(c, b.launch);
  if (climb != 0) return climb < 0;
  // Level on the ground: the first step shows whether the air lifts it, or else weight against what lifts it decides.
  const bool air_may_lift = c.fidelity.rotation != RotationModel::none || c.fidelity.wind != WindModel::off;
  if (air_may_lift && height(c, b.launch.x) == *until.ground) return false;
  Sum<double> sum;
  sum_effects(c, b, 0.0, b.launch, PointInVacuum{}, sum);
  return climb_rate(c, State<double>{b.launch.x, sum.total}) < 0;
}

}  // namespace physim
