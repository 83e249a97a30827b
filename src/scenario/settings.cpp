// The list of all settings of scenario files: one row each, in src/settings, here and in the files settings_*.cpp.
// Adding a setting is adding a row.
#include "base/event_table.hpp"
#include "scenario/expectation.hpp"
#include "scenario/settings_parts.hpp"
#include "scenario/units.hpp"
#include "settings/environment_rows.hpp"
#include "settings/flight_rows.hpp"

namespace physim {
namespace {

ValueRef event_kind_slot(const Scope& scope) {
  return choice(names_of<EventKind>().first(watchable_kinds()), scope.event->kind);
}

ValueRef figure_slot(const Scope& scope) {
  std::string& quantity = scope.expect->quantity;
  return choice_where(
      figure_names(), [&quantity](std::size_t i) { return figure_names()[i] == quantity; },
      [&quantity](std::size_t i) { quantity = figure_names()[i]; });
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
  return choice_where(
      kNames, [&expect](std::size_t i) { return expect.at == kMoments[i]; },
      [&expect](std::size_t i) { expect.at = kMoments[i], expect.at_value = 0; });
}

Quantity quantity_of_expectation(const Scope& scope) {
  const Figure* figure = find_figure(scope.expect->quantity);
  return figure ? figure->quantity : Quantity::number;
}

#define PHYSIM_EXPECT(...) PHYSIM_ROW("expect", expect, __VA_ARGS__)

constexpr Entry kFileSettings[] = {
    setting("physim", PHYSIM_FIELD(format[0]), "format version of the file", between(1, 1), kRequired),
    PHYSIM_SCENARIO(title, "what the scenario shows"),
    PHYSIM_SCENARIO(source, "where its figures come from"),
};

constexpr Entry kRunSettings[] = {
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
    PHYSIM_EXPECT(thing, "of hits and passages: name of what is hit or passed; empty: all"),
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
    add(list, kFileSettings);
    add_rows<environment_in, kGroundRows>(list, "environment.");
    add_rows<environment_in, kAirRows>(list, "environment.");
    add_rows<environment_in, kScaleHeightRows>(list, "environment.");
    add_rows<environment_in, kWindRows>(list, "environment.");
    add_rows<environment_in, kEarthRows>(list, "environment.");
    for (const std::span<const Entry> part : {shot_settings(), world_settings(), force_settings(), scene_settings(),
                                              emitter_settings(), joint_settings(), study_settings()})
      add(list, part);
    add_rows<tolerance_in, kToleranceRows>(list, "tolerance.");
    add_rows<until_in, kUntilRows>(list, "until.");
    add(list, kRunSettings);
    PHYSIM_ASSERT(list.front().path == "physim");  // the version is read first
    return list;
  }();
  return all;
}

}  // namespace physim
