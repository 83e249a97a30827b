// The list of all settings of scenario files: one entry each. Adding a setting is adding an entry here.
#include "base/event_table.hpp"
#include "physim/presets.hpp"
#include "scenario/settings_parts.hpp"

namespace physim {
namespace {

constexpr Range kAltitude = {.low = -5000, .high = 1e9};

ValueRef preset_slot(const Scope& scope) {
  Fidelity& fidelity = scope.shot->projectile.fidelity;
  return Choice{fidelity_presets(), [] { return std::optional<std::size_t>(); },  // its fields say all that it says
                [&fidelity](std::size_t i) { fidelity = *fidelity_preset(fidelity_presets()[i]); }};
}

ValueRef projectile_preset_slot(const Scope& scope) {
  ScenarioShot& shot = *scope.shot;
  return Choice{projectile_presets(), [] { return std::optional<std::size_t>(); },  // its fields say all that it says
                [&shot](std::size_t i) {
                  const ProjectilePreset preset = *projectile_preset(projectile_presets()[i]);
                  const std::string name = shot.projectile.name;
                  shot.projectile = preset.projectile;
                  shot.projectile.name = name;
                  shot.body = preset.body;
                  shot.launch.speed = preset.speed;
                }};
}

/// Comes before the other keys of the table, which then say what errors are measured against.
ValueRef cheapest_within_slot(const Scope& scope) {
  ScenarioShot& shot = *scope.shot;
  return OptionalNumber{[&shot] { return shot.cheapest_within; },
                        [&shot](std::optional<double> error) {
                          shot.cheapest_within = error;
                          if (error) shot.projectile.fidelity = Fidelity::reference();
                        }};
}

ValueRef event_kind_slot(const Scope& scope) {
  EventKind& kind = scope.event->kind;
  return Choice{names_of<EventKind>().first(watchable_kinds()),
                [&kind] { return std::optional(static_cast<std::size_t>(kind)); },
                [&kind](std::size_t i) { kind = static_cast<EventKind>(i); }};
}

Quantity quantity_of_event(const Scope& scope) {
  switch (row_of(scope.event->kind).watch) {
    case Watch::height:
    case Watch::range: return Quantity::length;
    case Watch::speed: return Quantity::speed;
    case Watch::time: return Quantity::time;
    case Watch::none:
    case Watch::climb_rate:
    case Watch::mach:
    case Watch::ignition:
    case Watch::burnout:
    case Watch::rail: break;
  }
  return Quantity::number;
}

// ------------------------------------------------------------------------------------------------------------ the list
constexpr Entry kFileSettings[] = {
    {.path = "physim", .slot = PHYSIM_FIELD(format[0]), .doc = "format version of the file", .range = between(1, 1)},
    {.path = "title", .slot = PHYSIM_FIELD(scenario->title), .doc = "what the scenario shows"},
    {.path = "source", .slot = PHYSIM_FIELD(scenario->source), .doc = "where its figures come from"},
};

constexpr Entry kEnvironmentSettings[] = {
    {.path = "environment.altitude",
     .slot = PHYSIM_FIELD(scenario->environment.altitude),
     .doc = "altitude of the origin of the world frame above sea level, or above the ellipsoid",
     .quantity = Quantity::length,
     .range = kAltitude},
    {.path = "environment.gravity.model",
     .slot = PHYSIM_FIELD(scenario->environment.gravity.model),
     .doc = "gravity field that is there",
     .shorthand = true},
    {.path = "environment.gravity.acceleration",
     .slot = PHYSIM_FIELD(scenario->environment.gravity.acceleration),
     .doc = "gravity at sea level, downwards, of constant and inverse_square",
     .quantity = Quantity::acceleration},
    {.path = "environment.gravity.radius",
     .slot = PHYSIM_FIELD(scenario->environment.gravity.radius),
     .doc = "distance of sea level from the Earth's centre",
     .quantity = Quantity::length,
     .range = above(0)},
    {.path = "environment.atmosphere.model",
     .slot = PHYSIM_FIELD(scenario->environment.atmosphere.model),
     .doc = "air that is there",
     .shorthand = true},
    {.path = "environment.atmosphere.temperature",
     .slot = PHYSIM_FIELD(scenario->environment.atmosphere.temperature),
     .doc = "at the station; none: standard",
     .quantity = Quantity::temperature,
     .range = between(150, 350)},
    {.path = "environment.atmosphere.pressure",
     .slot = PHYSIM_FIELD(scenario->environment.atmosphere.pressure),
     .doc = "at the station, not reduced to sea level; none: standard",
     .quantity = Quantity::pressure,
     .range = between(100, 120000)},
    {.path = "environment.atmosphere.humidity",
     .slot = PHYSIM_FIELD(scenario->environment.atmosphere.humidity),
     .doc = "relative humidity at the station; none: dry",
     .range = between(0, 1)},
    {.path = "environment.atmosphere.station_altitude",
     .slot = PHYSIM_FIELD(scenario->environment.atmosphere.station_altitude),
     .doc = "altitude of the station above sea level; none: that of the origin",
     .quantity = Quantity::length,
     .range = between(-5000, 80000)},
    {.path = "environment.atmosphere.density",
     .slot = PHYSIM_FIELD(scenario->environment.atmosphere.density),
     .doc = "at the origin, overrides all else for constant and exponential air",
     .quantity = Quantity::density,
     .range = at_least(0)},
    {.path = "environment.atmosphere.sound_speed",
     .slot = PHYSIM_FIELD(scenario->environment.atmosphere.sound_speed),
     .doc = "at the origin, overrides all else for constant and exponential air",
     .quantity = Quantity::speed,
     .range = above(0)},
    {.path = "environment.atmosphere.scale_height",
     .slot = PHYSIM_FIELD(scenario->environment.atmosphere.scale_height),
     .doc = "of exponential air",
     .quantity = Quantity::length,
     .range = above(0)},
    {.path = "environment.wind.velocity",
     .slot = PHYSIM_FIELD(scenario->environment.wind.velocity),
     .doc = "velocity of the air; (0, 0, -4) blows from the right",
     .quantity = Quantity::speed},
    {.path = "environment.wind.profile",
     .slot = PHYSIM_RECORDS(scenario->environment.wind.profile, wind_point),
     .doc = "wind by height or range, at rising places, held outside",
     .range = at_most(32)},
    {.path = "environment.wind.profile.at",
     .slot = PHYSIM_FIELD(wind_point->at),
     .doc = "height above the origin, or distance downrange",
     .quantity = Quantity::length},
    {.path = "environment.wind.profile.velocity",
     .slot = PHYSIM_FIELD(wind_point->velocity),
     .doc = "velocity of the air there",
     .quantity = Quantity::speed},
    {.path = "environment.wind.by",
     .slot = PHYSIM_FIELD(scenario->environment.wind.by),
     .doc = "what the profile is read by"},
    {.path = "environment.wind.interpolation",
     .slot = PHYSIM_FIELD(scenario->environment.wind.interpolation),
     .doc = "how the profile is read between its points"},
    {.path = "environment.earth.latitude",
     .slot = PHYSIM_FIELD(scenario->environment.earth.latitude),
     .doc = "of the origin, north positive",
     .quantity = Quantity::angle,
     .range = kHalfTurn},
    {.path = "environment.earth.longitude",
     .slot = PHYSIM_FIELD(scenario->environment.earth.longitude),
     .doc = "of the origin, east positive",
     .quantity = Quantity::angle,
     .range = kTurn},
    {.path = "environment.earth.azimuth",
     .slot = PHYSIM_FIELD(scenario->environment.earth.azimuth),
     .doc = "compass direction of the x axis, clockwise from north",
     .quantity = Quantity::angle,
     .range = kTurn},
    {.path = "environment.earth.rotation_rate",
     .slot = PHYSIM_FIELD(scenario->environment.earth.rotation_rate),
     .doc = "of the Earth",
     .quantity = Quantity::angular_rate},
};

constexpr Entry kShotSettings[] = {
    {.path = "shot",
     .slot = PHYSIM_RECORDS(scenario->shots, shot),
     .doc = "the projectiles and their launches",
     .range = between(1, 100000)},
    {.path = "shot.name",
     .slot = PHYSIM_FIELD(shot->projectile.name),
     .doc = "in tables and overrides, different for each shot; default: shot-1, shot-2, ..."},
    {.path = "shot.preset",
     .slot = projectile_preset_slot,
     .doc = "a projectile to start from (physim list presets); the other keys change it"},
    {.path = "shot.mass",
     .slot = PHYSIM_FIELD(shot->projectile.mass),
     .doc = "of the projectile",
     .quantity = Quantity::mass,
     .range = above(0)},
    {.path = "shot.diameter",
     .slot = PHYSIM_FIELD(shot->projectile.diameter),
     .doc = "reference diameter: the reference area is pi d^2 / 4",
     .quantity = Quantity::length,
     .range = above(0)},
    {.path = "shot.length",
     .slot = PHYSIM_FIELD(shot->projectile.length),
     .doc = "of the projectile, for its stability; 0: not known",
     .quantity = Quantity::length,
     .range = at_least(0)},
    {.path = "shot.twist",
     .slot = PHYSIM_FIELD(shot->projectile.twist),
     .doc = "rifling, length of one turn, right-handed positive; 0: no spin",
     .quantity = Quantity::length},
    {.path = "shot.drag.table",
     .slot = PHYSIM_FIELD(shot->projectile.drag.table),
     .doc = "source of the drag coefficient"},
    {.path = "shot.drag.coefficient",
     .slot = PHYSIM_FIELD(shot->projectile.drag.coefficient),
     .doc = "drag coefficient of table = \"constant\"",
     .range = at_least(0)},
    {.path = "shot.drag.curve",
     .slot = [](const Scope& s) { return curve_slot(s.shot->projectile.drag.curve); },
     .doc = "[Mach number, drag coefficient] of table = \"custom\", Mach numbers rising",
     .range = at_most(100000)},
    {.path = "shot.drag.ballistic_coefficient",
     .slot = PHYSIM_FIELD(shot->projectile.drag.ballistic_coefficient),
     .doc = "m / (i d^2); 0: from mass, diameter and form factor",
     .quantity = Quantity::ballistic_coefficient,
     .range = at_least(0)},
    {.path = "shot.drag.bands",
     .slot = PHYSIM_RECORDS(shot->projectile.drag.bands, band),
     .doc = "ballistic coefficients by speed, instead of one",
     .range = at_most(8)},
    {.path = "shot.drag.bands.above",
     .slot = PHYSIM_FIELD(band->above),
     .doc = "air speed from which the band holds",
     .quantity = Quantity::speed,
     .range = at_least(0)},
    {.path = "shot.drag.bands.ballistic_coefficient",
     .slot = PHYSIM_FIELD(band->ballistic_coefficient),
     .doc = "m / (i d^2) of the band",
     .quantity = Quantity::ballistic_coefficient,
     .range = above(0),
     .required = true},
    {.path = "shot.drag.form_factor",
     .slot = PHYSIM_FIELD(shot->projectile.drag.form_factor),
     .doc = "drag coefficient of the projectile over that of the table",
     .range = above(0)},
    {.path = "shot.drag.damping",
     .slot = PHYSIM_FIELD(shot->projectile.drag.damping),
     .doc = "part of the velocity kept after one second",
     .range = {.low = 0, .high = 1, .low_open = true}},
    {.path = "shot.drag.k1",
     .slot = PHYSIM_FIELD(shot->projectile.drag.k1),
     .doc = "linear drag: force -(k1 + k2 |v|) v",
     .quantity = Quantity::linear_drag,
     .range = at_least(0)},
    {.path = "shot.drag.k2",
     .slot = PHYSIM_FIELD(shot->projectile.drag.k2),
     .doc = "quadratic drag; 0 with k1 = 0: from the drag equation at launch",
     .quantity = Quantity::quadratic_drag,
     .range = at_least(0)},
    {.path = "shot.force",
     .slot = PHYSIM_FIELD(shot->projectile.force),
     .doc = "a constant force on the projectile, such as thrust",
     .quantity = Quantity::force},
    {.path = "shot.force_duration",
     .slot = PHYSIM_FIELD(shot->projectile.force_duration),
     .doc = "how long the force acts, from launch",
     .quantity = Quantity::time,
     .range = or_infinite(at_least(0))},
    {.path = "shot.position",
     .slot = PHYSIM_FIELD(shot->launch.position),
     .doc = "of the muzzle: x downrange, y up, z right",
     .quantity = Quantity::length},
    {.path = "shot.speed",
     .slot = PHYSIM_FIELD(shot->launch.speed),
     .doc = "at the muzzle",
     .quantity = Quantity::speed,
     .range = at_least(0)},
    {.path = "shot.elevation",
     .slot = PHYSIM_FIELD(shot->launch.elevation),
     .doc = "of the bore above the horizon; with a zero range it must stay 0",
     .quantity = Quantity::angle,
     .range = kHalfTurn},
    {.path = "shot.azimuth",
     .slot = PHYSIM_FIELD(shot->launch.azimuth),
     .doc = "of the plane of fire, from x to the right",
     .quantity = Quantity::angle,
     .range = kTurn},
    {.path = "shot.velocity",
     .slot = PHYSIM_FIELD(shot->launch.velocity),
     .doc = "instead of speed, elevation and azimuth",
     .quantity = Quantity::speed},
    {.path = "shot.rail_length",
     .slot = PHYSIM_FIELD(shot->launch.rail_length),
     .doc = "it moves only forwards along the bore until it has come so far; 0: no rail",
     .quantity = Quantity::length,
     .range = at_least(0)},
    {.path = "shot.sight.height",
     .slot = PHYSIM_FIELD(shot->launch.sight.height),
     .doc = "of the sight above the bore, at the muzzle",
     .quantity = Quantity::length},
    {.path = "shot.sight.look_angle",
     .slot = PHYSIM_FIELD(shot->launch.sight.look_angle),
     .doc = "of the line of sight above the horizon",
     .quantity = Quantity::angle,
     .range = kHalfTurn},
    {.path = "shot.sight.cant",
     .slot = PHYSIM_FIELD(shot->launch.sight.cant),
     .doc = "roll of launcher and sight, clockwise seen from behind",
     .quantity = Quantity::angle,
     .range = kTurn},
    {.path = "shot.sight.zero_range",
     .slot = PHYSIM_FIELD(shot->launch.sight.zero_range),
     .doc = "the bore is elevated to hit the line of sight there; 0: it is not",
     .quantity = Quantity::length,
     .range = at_least(0)},
    {.path = "shot.sight.zero_in_calm_air",
     .slot = PHYSIM_FIELD(shot->launch.sight.zero_in_calm_air),
     .doc = "the zero was shot without wind"},
};

constexpr Entry kFidelitySettings[] = {
    {.path = "shot.fidelity.cheapest_within",
     .slot = cheapest_within_slot,
     .doc =
         "flies the cheapest fidelity that stays this near to what the other keys say; without them, to the reference",
     .quantity = Quantity::length,
     .range = above(0)},
    {.path = "shot.fidelity.preset",
     .slot = preset_slot,
     .doc = "a preset to start from; further keys change it",
     .shorthand = true},
    {.path = "shot.fidelity.motion",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.motion),
     .doc = "how the equations of motion are treated"},
    {.path = "shot.fidelity.integrator",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.integrator),
     .doc = "how they are stepped through time"},
    {.path = "shot.fidelity.gravity",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.gravity),
     .doc = "model of gravity"},
    {.path = "shot.fidelity.drag", .slot = PHYSIM_FIELD(shot->projectile.fidelity.drag), .doc = "model of drag"},
    {.path = "shot.fidelity.air",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.air),
     .doc = "model of air density and sound speed"},
    {.path = "shot.fidelity.wind", .slot = PHYSIM_FIELD(shot->projectile.fidelity.wind), .doc = "model of wind"},
    {.path = "shot.fidelity.earth",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.earth),
     .doc = "shape and rotation of the Earth"},
    {.path = "shot.fidelity.rotation",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.rotation),
     .doc = "effects of the projectile's spin"},
    {.path = "shot.fidelity.body_form",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.body_form),
     .doc = "how the attitude of a rigid body is computed"},
    {.path = "shot.fidelity.precision",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.precision),
     .doc = "number type of the computation"},
    {.path = "shot.fidelity.interpolation",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.interpolation),
     .doc = "how a drag curve is read between its points"},
    {.path = "shot.fidelity.planar",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.planar),
     .doc = "confine the flight to the vertical plane of fire"},
    {.path = "shot.fidelity.aerodynamic_jump",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.aerodynamic_jump),
     .doc = "with rotation spin_drift: crosswind at the muzzle turns the path up or down (Litz)"},
    {.path = "shot.fidelity.original_one_shot_forces",
     .slot = PHYSIM_FIELD(shot->projectile.fidelity.original_one_shot_forces),
     .doc = "classic only: forces act for one frame and never stop, as in the original"},
};

constexpr Entry kRunSettings[] = {
    {.path = "tolerance.relative",
     .slot = PHYSIM_FIELD(scenario->tolerance.relative),
     .doc = "adaptive integrators: error per step relative to position and velocity; none: 1e-9, in float32 1e-5",
     .range = at_least(0)},
    {.path = "tolerance.absolute",
     .slot = PHYSIM_FIELD(scenario->tolerance.absolute),
     .doc = "adaptive integrators: error per step where these are near zero, in m and m/s; both add as squares",
     .range = at_least(0)},
    {.path = "tolerance.step",
     .slot = PHYSIM_FIELD(scenario->tolerance.step),
     .doc = "of fixed-step integrators; 0: heun and rk4 find it by a pilot flight, the others take 1/60 s",
     .quantity = Quantity::time,
     .range = at_least(0)},
    {.path = "tolerance.position_error",
     .slot = PHYSIM_FIELD(scenario->tolerance.position_error),
     .doc = "what the pilot flight aims for at the end of the flight",
     .quantity = Quantity::length,
     .range = above(0)},
    {.path = "tolerance.max_step",
     .slot = PHYSIM_FIELD(scenario->tolerance.max_step),
     .doc = "adaptive integrators never step further",
     .quantity = Quantity::time,
     .range = or_infinite(above(0))},
    {.path = "tolerance.max_steps",
     .slot = PHYSIM_FIELD(scenario->tolerance.max_steps),
     .doc = "then the flight ends",
     .range = between(1, 1e9)},
    {.path = "until.ground",
     .slot = PHYSIM_FIELD(scenario->until.ground),
     .doc = "height of the ground above the origin; off: no ground",
     .quantity = Quantity::length,
     .none = "off"},
    {.path = "until.time",
     .slot = PHYSIM_FIELD(scenario->until.time),
     .doc = "the flight ends after this time",
     .quantity = Quantity::time,
     .range = above(0)},
    {.path = "until.range",
     .slot = PHYSIM_FIELD(scenario->until.range),
     .doc = "the flight ends at this range along the line of sight",
     .quantity = Quantity::length,
     .range = above(0)},
    {.path = "until.events",
     .slot = PHYSIM_RECORDS(scenario->until.events, event),
     .doc = "further events to look for",
     .range = at_most(24)},
    {.path = "until.events.kind", .slot = event_kind_slot, .doc = "what is watched", .required = true},
    {.path = "until.events.value",
     .slot = PHYSIM_FIELD(event->value),
     .doc = "that is crossed",
     .quantity_by = quantity_of_event,
     .unit_by = "of the kind"},
    {.path = "until.events.direction", .slot = PHYSIM_FIELD(event->direction), .doc = "which crossings count"},
    {.path = "until.events.terminal", .slot = PHYSIM_FIELD(event->terminal), .doc = "the event ends the flight"},
    {.path = "output.ranges",
     .slot = PHYSIM_FIELD(scenario->ranges),
     .doc = "of the range card; also \"100 m .. 1000 m step 100 m\" or { from, to, step }",
     .quantity = Quantity::length,
     .range = at_least(0)},
};

}  // namespace

std::span<const Entry> entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> list;
    for (const std::span<const Entry> part :
         {std::span<const Entry>(kFileSettings), std::span<const Entry>(kEnvironmentSettings),
          std::span<const Entry>(kShotSettings), magnus_settings(), motor_settings(), rotation_settings(),
          std::span<const Entry>(kFidelitySettings), body_settings(), world_settings(), volley_settings(),
          force_settings(), std::span<const Entry>(kRunSettings), target_settings(), expect_settings()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

}  // namespace physim
