// Which events are looked for, and flights that end before their first step.
#include "prepare/watch_list.hpp"

#include <cmath>

#include "base/assert.hpp"
#include "model/acceleration.hpp"
#include "model/standard_atmosphere.hpp"

namespace physim {
namespace {

bool waits_for_no_value(EventKind kind) { return kind == EventKind::apex || kind >= EventKind::ignition; }

/// What cannot happen is not looked for: without motors and rails their numbers are not there.
bool may_happen(EventKind kind, const Conditions<double>& c) {
  if (kind == EventKind::ignition || kind == EventKind::burnout) return c.has_motor;
  return kind != EventKind::rail_exit || c.has_rail;
}

}  // namespace

bool has_lowest_altitude(const Fidelity& f) { return f.air == AirModel::isa && f.drag == DragModel::equation; }

WatchList prepare_watch(const Until& until, const Conditions<double>& c, const ToldEvents& told) {
  WatchList watch{};
  const auto add = [&](const EventSpec& spec, Outcome outcome) {
    PHYSIM_ASSERT(watch.count < kMaxWatched);
    watch.item[watch.count++] = {spec, outcome};
  };
  const auto tell = [&](EventKind kind, Crossing direction) {
    if (may_happen(kind, c)) add({kind, 0, direction, false}, Outcome::event);
  };
  if (until.ground) add({EventKind::ground, *until.ground, Crossing::falling, true}, Outcome::landed);
  if (until.range) add({EventKind::range, *until.range, Crossing::rising, true}, Outcome::reached_range);
  if (std::isfinite(until.time)) add({EventKind::time, until.time, Crossing::rising, true}, Outcome::time_limit);
  if (has_lowest_altitude(c.fidelity))
    add({EventKind::height, kLowestAltitude - c.altitude, Crossing::falling, true}, Outcome::left_domain);
  if (told.apex) tell(EventKind::apex, Crossing::falling);
  if (told.stops)
    for (const EventKind kind : {EventKind::ignition, EventKind::burnout, EventKind::rail_exit})
      tell(kind, Crossing::rising);
  for (EventSpec spec : until.events) {
    if (!may_happen(spec.kind, c)) continue;
    if (waits_for_no_value(spec.kind)) spec.value = 0;
    add(spec, Outcome::event);
  }
  return watch;
}

std::optional<Outcome> ends_at_once(const Conditions<double>& c, const Body<double>& b, const Until& until) {
  if (has_lowest_altitude(c.fidelity) && altitude(c, b.launch.x) <= kLowestAltitude) return Outcome::left_domain;
  if (!until.ground || height(c, b.launch.x) > *until.ground) return std::nullopt;
  if (b.rail_phase < kOffRail && b.rail.y >= 0) return std::nullopt;  // its rail stands on the ground
  const double climb = climb_rate(c, b.launch);
  // Level at the start: weight against thrust decides.
  const Vec3d push = c.has_applied ? applied(c, b, 0.0) : Vec3d{};
  const Vec3d swing = throws_out(c.fidelity) ? centrifugal(c, b.launch.x) : Vec3d{};
  const double climb_later = climb_rate(c, State<double>{b.launch.x, gravity(c, b.launch.x) + swing + push});
  if (climb < 0 || (climb == 0 && climb_later < 0)) return Outcome::landed;
  return std::nullopt;
}

}  // namespace physim
