// The list of all settings of scenario files: one row each, here and in the files settings_*.cpp. Adding a setting is
// adding a row.
#include "base/event_table.hpp"
#include "scenario/expectation.hpp"
#include "scenario/settings_parts.hpp"
#include "scenario/units.hpp"

namespace physim {
namespace {

ValueRef event_kind_slot(const Scope& scope) {
  return choice(names_of<EventKind>().first(watchable_kinds()), scope.event->kind);
}

ValueRef figure_slot(const Scope& scope) {
  std::string& quantity = scope.expect->quantity;
  return Choice{figure_names(),
                [&quantity] {
                  const Figure* figure = find_figure(quantity);
                  return figure ? std::optional<std::size_t>(figure - figures().data()) : std::nullopt;
                },
                [&quantity](std::size_t i) {
                  PHYSIM_ASSERT(i < figure_names().size());
                  quantity = figure_names()[i];
                }};
}

/// expect.at.time and the like: present when the expectation looks there.
template <ExpectAt at>
ValueRef at_slot(const Scope& scope) {
  Expectation& expect = *scope.expect;
  return OptionalNumber{[&expect] { return expect.at == at ? std::optional(expect.at_value) : std::nullopt; },
                        [&expect](std::optional<double> value) {
                          if (value) expect.at = at, expect.at_value = *value;
                        }};
}

ValueRef moment_slot(const Scope& scope) {
  static constexpr std::string_view kNames[] = {"end", "apex", "rail_exit", "burnout"};
  static constexpr ExpectAt kMoments[] = {ExpectAt::end, ExpectAt::apex, ExpectAt::rail_exit, ExpectAt::burnout};
  Expectation& expect = *scope.expect;
  return Choice{kNames,
                [&expect]() -> std::optional<std::size_t> {
                  for (std::size_t i = 0; i < std::size(kMoments); ++i)
                    if (expect.at == kMoments[i]) return i;
                  return std::nullopt;
                },
                [&expect](std::size_t i) {
                  PHYSIM_ASSERT(i < std::size(kMoments));
                  expect.at = kMoments[i], expect.at_value = 0;
                }};
}

Quantity quantity_of_expectation(const Scope& scope) {
  const Figure* figure = find_figure(scope.expect->quantity);
  return figure ? figure->quantity : Quantity::number;
}

#define PHYSIM_ENVIRONMENT(field, ...) PHYSIM_SCENARIO(environment.field, __VA_ARGS__)
#define PHYSIM_EXPECT(...) PHYSIM_ROW("expect", expect, __VA_ARGS__)

constexpr Entry kFileSettings[] = {
    setting("physim", PHYSIM_FIELD(format[0]), "format version of the file", between(1, 1)),
    PHYSIM_SCENARIO(title, "what the scenario shows"),
    PHYSIM_SCENARIO(source, "where its figures come from"),
    PHYSIM_ENVIRONMENT(altitude, "altitude of the origin of the world frame above sea level, or above the ellipsoid",
                       Quantity::length, between(-5000, 1e9)),
    PHYSIM_ENVIRONMENT(gravity.model, "gravity field that is there", kShorthand),
    PHYSIM_ENVIRONMENT(gravity.acceleration, "gravity at sea level, downwards, of constant and inverse_square",
                       Quantity::acceleration),
    PHYSIM_ENVIRONMENT(gravity.radius, "distance of sea level from the Earth's centre", Quantity::length, above(0)),
    PHYSIM_ENVIRONMENT(atmosphere.model, "air that is there", kShorthand),
    PHYSIM_ENVIRONMENT(atmosphere.temperature, "at the station; none: standard", Quantity::temperature,
                       between(150, 350)),
    PHYSIM_ENVIRONMENT(atmosphere.pressure, "at the station, not reduced to sea level; none: standard",
                       Quantity::pressure, between(100, 120000)),
    PHYSIM_ENVIRONMENT(atmosphere.humidity, "relative humidity at the station; none: dry", between(0, 1)),
    PHYSIM_ENVIRONMENT(atmosphere.station_altitude, "altitude of the station above sea level; none: that of the origin",
                       Quantity::length, between(-5000, 80000)),
    PHYSIM_ENVIRONMENT(atmosphere.density, "at the origin, overrides all else for constant and exponential air",
                       Quantity::density, at_least(0)),
    PHYSIM_ENVIRONMENT(atmosphere.sound_speed, "at the origin, overrides all else for constant and exponential air",
                       Quantity::speed, above(0)),
    PHYSIM_ENVIRONMENT(atmosphere.scale_height, "of exponential air", Quantity::length, above(0)),
    PHYSIM_ENVIRONMENT(wind.velocity, "velocity of the air; (0, 0, -4) blows from the right", Quantity::speed),
    PHYSIM_ENVIRONMENT(wind.profile, "wind by height or range, at rising places, held outside", at_most(32)),
    PHYSIM_ROW("environment.wind.profile", wind_point, at, "height above the origin, or distance downrange",
               Quantity::length),
    PHYSIM_ROW("environment.wind.profile", wind_point, velocity, "velocity of the air there", Quantity::speed),
    PHYSIM_ENVIRONMENT(wind.by, "what the profile is read by"),
    PHYSIM_ENVIRONMENT(wind.interpolation, "how the profile is read between its points"),
    PHYSIM_ENVIRONMENT(earth.latitude, "of the origin, north positive", Quantity::angle, kHalfTurn),
    PHYSIM_ENVIRONMENT(earth.longitude, "of the origin, east positive", Quantity::angle, kTurn),
    PHYSIM_ENVIRONMENT(earth.azimuth, "compass direction of the x axis, clockwise from north", Quantity::angle, kTurn),
    PHYSIM_ENVIRONMENT(earth.rotation_rate, "of the Earth", Quantity::angular_rate),
};

constexpr Entry kRunSettings[] = {
    PHYSIM_SCENARIO(
        tolerance.relative,
        "adaptive integrators: error per step relative to position and velocity; none: 1e-9, in float32 2e-6",
        at_least(0)),
    PHYSIM_SCENARIO(tolerance.absolute,
                    "adaptive integrators: error per step where these are near zero, in m and m/s; both add as squares",
                    at_least(0)),
    PHYSIM_SCENARIO(
        tolerance.step,
        "of fixed-step integrators; 0: heun and rk4 find it by pilot flights, the others take 1/60 s or less",
        Quantity::time, at_least(0)),
    PHYSIM_SCENARIO(tolerance.position_error, "what pilot flights keep along the whole flight", Quantity::length,
                    above(0)),
    PHYSIM_SCENARIO(tolerance.max_step, "adaptive integrators never step further", Quantity::time,
                    or_infinite(above(0))),
    PHYSIM_SCENARIO(tolerance.max_steps, "then the flight ends", between(1, 1e9)),
    PHYSIM_SCENARIO(until.ground, "height of the ground above the origin; off: no ground", Quantity::length,
                    Absent{"off"}),
    PHYSIM_SCENARIO(until.time, "the flight ends after this time", Quantity::time, above(0)),
    PHYSIM_SCENARIO(until.range, "the flight ends at this range along the line of sight", Quantity::length, above(0)),
    PHYSIM_SCENARIO(until.events, "further events to look for", at_most(24)),
    setting("until.events.kind", event_kind_slot, "what is watched", kRequired),
    PHYSIM_ROW("until.events", event, value, "that is crossed",
               QuantityBy{[](const Scope& scope) { return quantity_of_value(scope.event->kind); }, "of the kind"}),
    PHYSIM_ROW("until.events", event, direction, "which crossings count"),
    PHYSIM_ROW("until.events", event, terminal, "the event ends the flight"),
    PHYSIM_ROW("output", scenario, ranges,
               "of the range card; also \"100 m .. 1000 m step 100 m\" or { from, to, step }", Quantity::length,
               at_least(0)),
    PHYSIM_SCENARIO(target.position,
                    "where the target of `physim aim` is when the shot is fired: x downrange, y up, z right",
                    Quantity::length),
    PHYSIM_SCENARIO(target.velocity, "how it moves then", Quantity::speed),
    PHYSIM_SCENARIO(target.acceleration, "of the target, constant", Quantity::acceleration),
    PHYSIM_SCENARIO(target.tolerance, "a path that passes so near hits the target", Quantity::length, above(0)),
    PHYSIM_SCENARIO(target.arc, "the solution of the shortest or of the longest time of flight, or both"),
    PHYSIM_SCENARIO(expect, "figures that should come out", at_most(100000)),
    PHYSIM_EXPECT(shot, "name of the shot; empty: every shot"),
    PHYSIM_EXPECT(thing, "of hits: name of what is hit; empty: all that is hit"),
    setting("expect.at.moment", moment_slot, "where to look: a moment", kShorthand),
    setting("expect.at.time", at_slot<ExpectAt::time>, "where to look: time since launch", Quantity::time, at_least(0)),
    setting("expect.at.range", at_slot<ExpectAt::range>,
            "where to look: first crossing of a range along the line of sight", Quantity::length, at_least(0)),
    setting("expect.at.height", at_slot<ExpectAt::height>, "where to look: first crossing of a height",
            Quantity::length),
    setting("expect.quantity", figure_slot, "figure to look at", kRequired),
    PHYSIM_EXPECT(equals, "value expected", QuantityBy{quantity_of_expectation, "of the quantity"}, kRequired),
    PHYSIM_EXPECT(within, "distance allowed", at_least(0), QuantityBy{quantity_of_expectation, "of the quantity"},
                  kRequired),
    PHYSIM_EXPECT(published, "the figure was published: pictures over time show it as a ring, others as a cross"),
    PHYSIM_EXPECT(source, "why it should be true"),
};

}  // namespace

std::span<const Entry> entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> list;
    for (const std::span<const Entry> part :
         {std::span<const Entry>(kFileSettings), shot_settings(), world_settings(), force_settings(), scene_settings(),
          emitter_settings(), joint_settings(), study_settings(), std::span<const Entry>(kRunSettings)})
      list.insert(list.end(), part.begin(), part.end());
    PHYSIM_ASSERT(list.front().path == "physim");  // the version is read first
    return list;
  }();
  return all;
}

}  // namespace physim
